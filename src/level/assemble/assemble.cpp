#include "level/assemble/assemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geometry/elementary.h"
#include "level/assemble/amend.h"
#include "level/assemble/checks.h"
#include "level/assemble/dress_assembly.h"
#include "level/assemble/mirror_duplicates.h"
#include "level/assemble/motion_assembly.h"
#include "level/assemble/pinball_assembly.h"
#include "level/assemble/pool_assembly.h"
#include "level/assemble/resolve_names.h"
#include "level/assemble/rule_assembly.h"
#include "level/assemble/symbol_table.h"
#include "level/assemble/world_assembly.h"
#include "level/fill/fill.h"

namespace carom {
namespace {

class Assembly {
  public:
    Assembly(const LoadOptions& options, Scene& scene, Context& context)
        : options_(options), scene_(scene), context_(context), ir_(context.ir) {}

    void run() {
        remove_mirror_duplicates(ir_);
        names_ = resolve_names(context_);
        check_terms(context_);
        const std::size_t items = ir_.balls.size() + ir_.capsules.size();
        if (context_.reporter.has_errors() && items > most_checked_with_errors) return;
        if (ir_.balls.size() > most_checked_with_errors && ir_.amendments.empty()) {
            check_crowd(names_, context_);
            if (context_.reporter.has_errors()) return;
        }
        const bool is_large = items_to_come() > most_checked_with_errors;
        if (is_large && has_unknown_names()) return;
        collect_stated_balls();
        if (is_large && has_early_overlap()) return;
        add_fills();
        SymbolTable symbols(ir_, names_, context_);
        symbols.name_balls(bindings());
        MotionAssembly motions(names_, context_);
        motions.check_names();
        SeesawAssembly seesaws(options_, names_, context_);
        seesaws.check_names();
        amended_ = amend(balls_, symbols, context_);
        motions.place_edges(level_rate(options_, ir_));
        seesaws.place_edges();
        if (amended_.is_removed.empty())
            check_start(balls_, names_, context_);
        else
            check_start(present_balls(), names_, context_);
        check_precision(balls_, names_, level_rate(options_, ir_), context_);
        PinballAssembly table(names_, context_);
        table.collect_devices();
        RuleAssembly rules(table, names_, balls_, context_);
        rules.check();
        // A missing part may be one whose statement has an error.
        if (!context_.reporter.has_errors()) table.check(balls_);
        check_pool(balls_, options_, context_);
        if (context_.reporter.has_errors()) {
            symbols.check_references();
            return;
        }
        WorldAssembly(options_, names_, balls_, amended_, context_).fill_in(scene_);
        symbols.fill_in(scene_);
        motions.fill_in(scene_);
        seesaws.fill_in(scene_.world);
        fill_in_pool(balls_, symbols.world_zones(), scene_, context_);
        table.fill_in(balls_, scene_, symbols.world_zones());
        fill_in_dress(balls_, names_, symbols.world_zones(), scene_, context_);
        rules.fill_in(scene_, symbols.world_zones());
        if (context_.reporter.has_errors()) return;
        check_flippers(balls_, names_, context_);
        check_gaps(balls_, names_, context_);
        remove_balls();
    }

  private:
    // Of a level with errors that has more items than this, no more errors are looked for.
    static constexpr std::size_t most_checked_with_errors = 100'000;

    StartingBall starting_ball(std::size_t i) const {
        const BallIr spec = ir_.balls[i];
        const ResolvedBalls& of = names_.balls[static_cast<std::size_t>(spec.binding)];
        const Kind& kind = names_.kinds[of.kind];
        StartingBall ball;
        ball.position = spec.position;
        ball.velocity = spec.velocity;
        ball.radius = spec.radius.value_or(kind.radius);
        ball.position += spec.racked * (2.0 * ball.radius + spec.gap);
        const FillDefaults kinds = defaults_of(of.kind);
        ball.mass =
            spec.mass.value_or(kinds.mass.value_or(kinds.density * pi * ball.radius * ball.radius));
        ball.restitution = spec.restitution.value_or(kind.restitution);
        ball.spec = static_cast<int>(i);
        ball.kind = of.kind;
        ball.binding = spec.binding;
        ball.origin = spec.origin;
        return ball;
    }

    FillDefaults defaults_of(ClassIndex kind) const {
        FillDefaults defaults;
        defaults.radius = names_.kinds[kind].radius;
        if (kind >= ir_.kinds.size()) return defaults;
        defaults.mass = ir_.kinds[kind].mass;
        defaults.density = ir_.kinds[kind].density.value_or(1.0);
        return defaults;
    }

    // Collects all balls but those of fills, in the order of the file.
    void collect_stated_balls() {
        balls_.reserve(ir_.balls.size());
        for (std::size_t i = 0; i < ir_.balls.size(); ++i) {
            if (is_valid(ir_.balls.shared_part(i).binding)) balls_.push_back(starting_ball(i));
        }
    }

    std::uint64_t items_to_come() const {
        std::uint64_t items = ir_.balls.size() + ir_.capsules.size();
        for (const FillIr& fill : ir_.fills)
            items += fill.count;
        return items;
    }

    bool is_valid(int binding) const {
        return names_.balls[static_cast<std::size_t>(binding)].is_valid;
    }

    // The bindings of the stated balls.
    std::vector<int> stated_bindings() const {
        std::vector<int> bindings;
        bindings.reserve(ir_.balls.size());
        for (std::size_t i = 0; i < ir_.balls.size(); ++i)
            if (const int binding = ir_.balls.shared_part(i).binding; is_valid(binding))
                bindings.push_back(binding);
        return bindings;
    }

    std::vector<int> bindings() const {
        std::vector<int> bindings;
        bindings.reserve(balls_.size());
        for (const StartingBall& ball : balls_)
            bindings.push_back(ball.binding);
        return bindings;
    }

    // Of a large level: what can be refused without its balls, which take most of the time and
    // memory. What is reported here is not reported again.
    bool has_unknown_names() {
        SymbolTable symbols(ir_, names_, context_);
        symbols.name_balls(stated_bindings());
        symbols.check_references();
        return context_.reporter.has_errors();
    }

    // Of a large level: whether its stated balls have an error that needs neither the balls of
    // fills nor a world.
    bool has_early_overlap() {
        if (ir_.amendments.empty() && !ir_.fills.empty()) check_start(balls_, names_, context_);
        return context_.reporter.has_errors();
    }

    // Places the balls of fills around everything else, and inserts them in the order of the file.
    void add_fills() {
        // The place of a fill depends on items that may have errors.
        if (ir_.fills.empty() || context_.reporter.has_errors()) return;
        const std::vector<StartingBall> placed = std::exchange(balls_, {});
        Obstacles obstacles;
        std::vector<ClassIndex> owners;
        for (const CapsuleIr& edge : ir_.capsules)
            obstacles.capsules.push_back(edge.shape);
        for (const StartingBall& ball : placed) {
            obstacles.discs.push_back({ball.position, ball.radius});
            owners.push_back(ball.kind);
        }
        std::size_t taken = 0;
        for (std::size_t i = 0; i < ir_.fills.size(); ++i) {
            const FillIr& fill = ir_.fills[i];
            while (taken < fill.balls_before)
                balls_.push_back(placed[taken++]);
            if (!add_fill(fill, names_.fills[i].kind, obstacles, owners)) break;
        }
        while (taken < placed.size())
            balls_.push_back(placed[taken++]);
    }

    // The obstacles that a ball of this kind must not overlap. `all` has the capsules in the order
    // of ir_.capsules, and the discs in the order of `owners`, their kinds.
    Obstacles solid_to(ClassIndex kind, const Obstacles& all,
                       const std::vector<ClassIndex>& owners) const {
        Obstacles solid;
        if (ir_.settings.may_overlap) return {{}, {}, false};
        solid.each_other = names_.kinds_collide(kind, kind);
        for (std::size_t i = 0; i < all.discs.size(); ++i) {
            if (names_.kinds_collide(kind, owners[i])) solid.discs.push_back(all.discs[i]);
        }
        for (std::size_t i = 0; i < all.capsules.size(); ++i) {
            if (names_.kind_collides_with(kind, material_of(ir_.capsules[i]))) {
                solid.capsules.push_back(all.capsules[i]);
            }
        }
        return solid;
    }

    ClassIndex material_of(const CapsuleIr& edge) const {
        return names_.edges[static_cast<std::size_t>(edge.binding)].material;
    }

    // `owners` has the kinds of the discs among the obstacles. False: the fill has an error.
    bool add_fill(const FillIr& fill, ClassIndex kind, Obstacles& obstacles,
                  std::vector<ClassIndex>& owners) {
        FillObstacles around{obstacles, {}};
        if (ir_.settings.may_overlap || !names_.all_collide()) {
            around.solid = [&] { return solid_to(kind, obstacles, owners); };
        }
        const auto filled = place_fill(fill, defaults_of(kind), around, context_);
        if (!filled) return false;
        for (const FilledBall& from : *filled) {
            StartingBall ball;
            ball.position = from.position;
            ball.velocity = from.velocity;
            ball.radius = from.radius;
            ball.mass = from.mass;
            ball.restitution = fill.restitution.value_or(names_.kinds[kind].restitution);
            ball.kind = kind;
            ball.origin = fill.origin;
            balls_.push_back(ball);
            obstacles.discs.push_back({ball.position, ball.radius});
            owners.push_back(kind);
        }
        return true;
    }

    // The ids of the others stay, as in play. The level starts without these balls, so it does not
    // count as a removal.
    void remove_balls() {
        for (std::size_t i = 0; i < balls_.size(); ++i)
            if (amended_.removes(i))
                remove_ball(scene_.world, BallId{static_cast<std::uint32_t>(i)});
        scene_.world.edit_ledger().removed.clear();
    }

    // Without the removed ones, which keep their numbers until the world is made.
    std::vector<StartingBall> present_balls() const {
        std::vector<StartingBall> present;
        for (std::size_t i = 0; i < balls_.size(); ++i)
            if (!amended_.removes(i)) present.push_back(balls_[i]);
        return present;
    }

    const LoadOptions& options_;
    Scene& scene_;
    Context& context_;
    LevelIr& ir_;
    ResolvedNames names_;
    std::vector<StartingBall> balls_;
    Amended amended_;
};

}  // namespace

void assemble(const LoadOptions& options, Scene& scene, Context& context) {
    context.seed = options.seed.value_or(context.ir.settings.seed.value_or(0));
    Assembly(options, scene, context).run();
}

}  // namespace carom

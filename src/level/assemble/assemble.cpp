#include "level/assemble/assemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "geometry/elementary.h"
#include "level/assemble/amend.h"
#include "level/assemble/checks.h"
#include "level/assemble/curves.h"
#include "level/assemble/dress_assembly.h"
#include "level/assemble/fill.h"
#include "level/assemble/mirror_duplicates.h"
#include "level/assemble/motion_assembly.h"
#include "level/assemble/pinball_assembly.h"
#include "level/assemble/pool_assembly.h"
#include "level/assemble/resolve_names.h"
#include "level/assemble/rule_assembly.h"
#include "level/assemble/symbol_table.h"

// This file is over 320 lines because it holds one idea, the order in which a scene comes about.
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
        motions.place_edges(rate());
        seesaws.place_edges();
        if (amended_.is_removed.empty())
            check_start(balls_, names_, context_);
        else
            check_start(present_balls(), names_, context_);
        check_precision(balls_, names_, rate(), context_);
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
        make_world();
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

    double rate() const { return options_.rate.value_or(own_rate()); }

    // Flippers need short ticks, so a game of pinball has a higher default rate.
    double own_rate() const {
        constexpr double pinball_rate = 1000.0;
        return ir_.settings.rate.value_or(ir_.settings.table.is_game ? pinball_rate
                                                                     : World{}.rate());
    }

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

    void make_world() {
        World& world = scene_.world;
        const LevelSettings& s = ir_.settings;
        world.edit_definition().seed = context_.seed;
        world.edit_definition().rate = rate();
        world.edit_definition().kinds = names_.kinds;
        world.edit_definition().materials = names_.materials;
        make_model(world.edit_definition().model);
        world.edit_definition().need = s.need;
        if (world.model().filtered) world.edit_definition().meets = names_.collision_matrix;
        for (const StartingBall& ball : balls_) {
            BallSpec spec;
            if (ball.spec >= 0) spec = ir_.balls[static_cast<std::size_t>(ball.spec)];
            spec.kind = ball.kind;
            spec.position = ball.position;
            spec.velocity = ball.velocity;
            spec.radius = ball.radius;
            spec.mass = ball.mass;
            spec.restitution = ball.restitution;
            const std::size_t i = world.balls().size();
            if (!amended_.spin.empty() && amended_.spin[i]) spec.spin = *amended_.spin[i];
            if (!amended_.roll.empty() && amended_.roll[i]) spec.roll = *amended_.roll[i];
            add_ball(world, spec);
        }
        for (const CapsuleIr& edge : ir_.capsules) {
            add_capsule(world, edge.shape, material_of(edge), edge.side);
        }
        join_curves(ir_, world);
        for (std::size_t i = 0; i < ir_.emitters.size(); ++i) {
            Emitter emitter = ir_.emitters[i].emitter;
            emitter.kind = names_.emitters[i].kind;
            world.edit_emitters().push_back(emitter);
        }
        scene_.kind_names = names_.kind_names;
        scene_.material_names = names_.material_names;
        scene_.solver = options_.solver ? options_.solver : s.solver;
        scene_.game = s.game.value_or("sandbox");
        scene_.overridden = !options_.overrides.empty() ||
                            (options_.solver && options_.solver != s.solver) ||
                            (options_.rate && options_.rate != own_rate()) ||
                            (options_.seed && *options_.seed != s.seed.value_or(0));
        make_outlines();
        scene_.view = view();
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

    ClassIndex material_of(const CapsuleIr& edge) const {
        return names_.edges[static_cast<std::size_t>(edge.binding)].material;
    }

    void make_model(Model& model) const {
        const LevelSettings& s = ir_.settings;
        model.gravity = s.gravity;
        model.drag = s.drag;
        model.stop_speed = s.stop_speed;
        model.speed_limit = s.speed_limit;
        model.scatter = s.scatter;
        model.spin = s.spin;
        model.cloth = s.cloth;
        model.modulus = s.modulus;
        constexpr double solid_ball = 0.4;
        if (s.cloth) model.spin = s.inertia.value_or(solid_ball);
        if (s.wrap) model.wrap = s.world;
        model.inelastic = is_inelastic();
        model.one_way = std::ranges::any_of(ir_.devices, [](const DeviceIr& d) {
            return d.device.kind == DeviceKind::droptarget || d.device.kind == DeviceKind::post;
        });
        model.filtered = !names_.all_collide();
        model.ball_ball = names_.some_balls_collide();
        model.ball_edge = names_.some_edges_collide();
    }

    bool is_inelastic() const {
        const auto loses = [](double restitution) { return restitution < 1.0; };
        if (std::ranges::any_of(balls_, loses, &StartingBall::restitution)) return true;
        for (const ResolvedBalls& of : names_.emitters) {
            if (loses(names_.kinds[of.kind].restitution)) return true;
        }
        for (const CapsuleIr& edge : ir_.capsules) {
            const Material& material = names_.materials[material_of(edge)];
            if (loses(material.restitution) || material.soften > 0.0) return true;
        }
        return false;
    }

    void make_outlines() {
        std::map<int, std::vector<CapsuleId>> outlines;
        for (std::size_t i = 0; i < ir_.capsules.size(); ++i) {
            const int chain = ir_.capsules[i].chain;
            if (!ir_.chains[static_cast<std::size_t>(chain)].is_closed) continue;
            outlines[chain].push_back(scene_.world.capsules().id[i]);
        }
        for (auto& [chain, capsules] : outlines)
            scene_.outlines.push_back(std::move(capsules));
    }

    // The box that the level declares as its world, else the bounds of everything; never empty.
    Box view() const {
        if (ir_.settings.world) return *ir_.settings.world;
        std::optional<Box> all;
        const auto add = [&](const Box& box) { all = all ? join(*all, box) : box; };
        for (const CapsuleIr& edge : ir_.capsules)
            add(bounds(edge.shape));
        for (const StartingBall& ball : balls_)
            add(bounds(Disc{ball.position, ball.radius}));
        for (const Emitter& emitter : scene_.world.emitters()) {
            add(bounds(Disc{emitter.at, names_.kinds[emitter.kind].radius}));
        }
        if (!all) return {{-10.0, -10.0}, {10.0, 10.0}};
        const Vec2 extent = size(*all);
        const double most = std::max(extent.x, extent.y);
        const double margin = most > 0.0 ? 0.0 : 10.0;
        Box box = grow(*all, margin);
        if (extent.x < 1e-3 * most) box = join(box, grow({center(box), center(box)}, 0.5 * most));
        if (extent.y < 1e-3 * most) box = join(box, grow({center(box), center(box)}, 0.5 * most));
        return box;
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

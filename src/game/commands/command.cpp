#include "game/commands/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "game/commands/picking.h"
#include "geometry/closest.h"

namespace carom {
namespace {

using namespace command;
using Refusal = std::optional<std::string>;

/// Bodies that lie in each other by less than this share of a ball's radius only touch.
constexpr double touching = 1e-9;

bool is_finite(Vec2 v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

Refusal unless_ball(const World& world, BallId id) {
    if (index_of(world, id)) return std::nullopt;
    return fmt::format("there is no ball {}", number(id));
}

Refusal unless_capsule(const World& world, CapsuleId id) {
    if (index_of(world, id)) return std::nullopt;
    return fmt::format("there is no edge {}", number(id));
}

Refusal unless_movable(const World& world, CapsuleId id) {
    if (auto why = unless_capsule(world, id)) return why;
    if (!std::ranges::count(world.flippers, id, &Flipper::capsule)) return std::nullopt;
    return "a flipper moves by its button alone";
}

Refusal unless_finite(bool finite, std::string_view what) {
    if (finite) return std::nullopt;
    return fmt::format("{} is not a number", what);
}

/// How deep a ball would lie in an edge; negative: how far they are apart.
double depth(const World& world, const Disc& ball, const Capsule& edge) {
    const Vec2 middle = (edge.start + edge.end) * 0.5;
    const Disc beside{middle + offset(world, middle, ball.center), ball.radius};
    return -separation(beside, edge);
}

Refusal obstacle(const World& world, const Disc& disc, ClassIndex kind,
                 std::optional<BallId> itself = std::nullopt) {
    const double allowed = touching * disc.radius;
    const Balls& balls = world.balls;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (balls.id[i] == itself) continue;
        if (!kinds_meet(world, kind, balls.kind[i])) continue;
        const double apart = length(offset(world, disc.center, balls.position[i]));
        if (disc.radius + balls.radius[i] - apart > allowed)
            return fmt::format("it would overlap ball {}", number(balls.id[i]));
    }
    const Capsules& capsules = world.capsules;
    for (std::size_t i = 0; i < capsules.size(); ++i) {
        if (!kind_meets_material(world, kind, capsules.material[i])) continue;
        if (depth(world, disc, capsules.shape[i]) > allowed)
            return fmt::format("it would overlap edge {}", number(capsules.id[i]));
    }
    return std::nullopt;
}

Refusal refused(const World& world, const Strike& strike) {
    if (auto why = unless_ball(world, strike.ball)) return why;
    if (auto why = unless_finite(is_finite(strike.velocity), "the speed")) return why;
    const double side = strike.side;
    const double follow = strike.follow;
    constexpr double most = Strike::most_offset;
    if (!(side * side + follow * follow <= most * most))
        return fmt::format("the tip slips off further than {} of the radius from the middle", most);
    if (side != 0.0 && !world.model.spin) return "balls do not spin here";
    if (follow != 0.0 && !world.model.cloth) return "there is no cloth to follow or draw on";
    return std::nullopt;
}

Refusal refused(const World& world, const HoldBall& hold) {
    if (auto why = unless_ball(world, hold.ball)) return why;
    return unless_finite(is_finite(hold.target), "the place");
}

Refusal refused(const World& world, const DropBall& drop) {
    if (std::ranges::count(world.held_balls, drop.ball, &HeldBall::id)) return std::nullopt;
    return fmt::format("ball {} is not held", number(drop.ball));
}

Refusal refused(const World& world, const HoldCapsule& hold) {
    if (auto why = unless_movable(world, hold.capsule)) return why;
    return unless_finite(is_finite(hold.start_target) && is_finite(hold.end_target), "the place");
}

Refusal refused(const World& world, const DropCapsule& drop) {
    if (std::ranges::count(world.held_capsules, drop.capsule, &HeldCapsule::id))
        return std::nullopt;
    return fmt::format("edge {} is not held", number(drop.capsule));
}

Refusal refused(const World& world, const AddBall& add) {
    const BallSpec& spec = add.spec;
    if (spec.kind >= world.kinds.size()) return fmt::format("there is no kind {}", spec.kind);
    const double radius = spec.radius.value_or(world.kinds[spec.kind].radius);
    const double mass = spec.mass.value_or(world.kinds[spec.kind].mass);
    const double restitution = spec.restitution.value_or(world.kinds[spec.kind].restitution);
    if (auto why = unless_finite(is_finite(spec.position), "the place")) return why;
    if (auto why = unless_finite(is_finite(spec.velocity), "the speed")) return why;
    if (auto why = unless_finite(std::isfinite(spec.spin), "the spin")) return why;
    if (!(radius > 0.0) || !std::isfinite(radius)) return "its radius must be positive";
    if (!(mass > 0.0) || !std::isfinite(mass) || !std::isfinite(1.0 / mass))
        return "its mass must be positive";
    if (!(restitution >= 0.0 && restitution <= 1.0)) return "its restitution must be in 0..1";
    return obstacle(world, {spec.position, radius}, spec.kind);
}

Refusal refused(const World& world, const RemoveBall& remove) {
    return unless_ball(world, remove.ball);
}

Refusal obstacle(const World& world, const Capsule& edge, ClassIndex material) {
    const Balls& balls = world.balls;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (!kind_meets_material(world, balls.kind[i], material)) continue;
        if (depth(world, {balls.position[i], balls.radius[i]}, edge) > touching * balls.radius[i])
            return fmt::format("it would lie on ball {}", number(balls.id[i]));
    }
    return std::nullopt;
}

Refusal refused(const World& world, const PlaceBall& place) {
    if (auto why = unless_ball(world, place.ball)) return why;
    if (auto why = unless_finite(is_finite(place.position), "the place")) return why;
    const std::size_t index = *index_of(world, place.ball);
    return obstacle(world, {place.position, world.balls.radius[index]}, world.balls.kind[index],
                    place.ball);
}

Refusal refused(const World& world, const PlaceCapsule& place) {
    if (auto why = unless_movable(world, place.capsule)) return why;
    if (auto why = unless_finite(is_finite(place.start) && is_finite(place.end), "the place"))
        return why;
    const std::size_t index = *index_of(world, place.capsule);
    return obstacle(world, {place.start, place.end, world.capsules.shape[index].radius},
                    world.capsules.material[index]);
}

Refusal refused(const World& world, const AddCapsule& add) {
    const Capsule& edge = add.shape;
    if (add.material >= world.materials.size())
        return fmt::format("there is no material {}", add.material);
    if (auto why = unless_finite(is_finite(edge.start) && is_finite(edge.end), "the place"))
        return why;
    if (!(edge.radius >= 0.0) || !std::isfinite(edge.radius))
        return "its radius must not be negative";
    return obstacle(world, edge, add.material);
}

Refusal refused(const World& world, const RemoveCapsule& remove) {
    return unless_capsule(world, remove.capsule);
}

Refusal refused(const World&, const SetGravity& set) {
    return unless_finite(!set.gravity || is_finite(*set.gravity), "gravity");
}

Refusal refused(const World& world, const SetSolver& set) {
    if (!std::ranges::count(solvers_available(), set.settings.kind))
        return fmt::format("this carom has no solver {}", name(set.settings.kind));
    if (!supports(set.settings.kind, world.model))
        return fmt::format("solver {} does not know cloth", name(set.settings.kind));
    if (!are_in_range(set.settings)) return "updates, steps and substeps must be in 1..1000";
    return std::nullopt;
}

Refusal refused(const World&, const Press&) {
    return "there is no game that has buttons";
}

Refusal refused(const World&, const Pull&) {
    return "there is no game that has a plunger";
}

Refusal refused_without_rules() {
    return "there is no game of pool that has rules";
}

Refusal refused(const World&, const CallShot&) {
    return refused_without_rules();
}

Refusal refused(const World&, const Decide&) {
    return refused_without_rules();
}

Refusal refused(const World&, const RackAgain&) {
    return refused_without_rules();
}

/// Where something with this id is, or belongs, in a list in ascending order of id.
template <typename Held, typename Id>
auto place_of(std::vector<Held>& held, Id id) {
    return std::ranges::lower_bound(held, id, {}, &Held::id);
}

template <typename Held>
void take(std::vector<Held>& all, const Held& hold) {
    const auto place = place_of(all, hold.id);
    if (place != all.end() && place->id == hold.id)
        *place = hold;
    else
        all.insert(place, hold);
}

/// A player can bring together what could not meet when the level was loaded, and then the model
/// must know it.
void widen_model(World& world) {
    for (const ClassIndex kind : world.balls.kind) {
        for (std::size_t other = 0; other < world.kinds.size() && !world.model.ball_ball; ++other)
            world.model.ball_ball = kinds_meet(world, kind, static_cast<ClassIndex>(other));
        for (const ClassIndex material : world.capsules.material) {
            if (world.model.ball_edge) break;
            world.model.ball_edge = kind_meets_material(world, kind, material);
        }
        if (world.model.ball_ball && world.model.ball_edge) return;
    }
}

struct Obey {
    World& world;

    void operator()(const Strike& strike) const {
        const std::size_t i = *index_of(world, strike.ball);
        world.balls.velocity[i] = strike.velocity;
        // An impulse m v at that height and side gives the angular momentum m v r times either.
        if (world.model.cloth)
            world.balls.roll[i] = strike.velocity * (strike.follow / *world.model.spin);
        if (world.model.cloth || strike.side != 0.0)
            world.balls.spin[i] =
                strike.side * length(strike.velocity) / (*world.model.spin * world.balls.radius[i]);
    }
    void operator()(const HoldBall& hold) const {
        take(world.held_balls, HeldBall{hold.ball, hold.target});
    }
    void operator()(const DropBall& drop) const {
        std::erase_if(world.held_balls, [&](const HeldBall& h) { return h.id == drop.ball; });
    }
    void operator()(const HoldCapsule& hold) const {
        take(world.held_capsules, HeldCapsule{hold.capsule, hold.start_target, hold.end_target});
    }
    void operator()(const DropCapsule& drop) const {
        std::erase_if(world.held_capsules,
                      [&](const HeldCapsule& h) { return h.id == drop.capsule; });
    }
    void operator()(const PlaceBall& place) const {
        world.balls.position[*index_of(world, place.ball)] = place.position;
        const auto held = place_of(world.held_balls, place.ball);
        if (held != world.held_balls.end() && held->id == place.ball) held->target = place.position;
    }
    void operator()(const PlaceCapsule& place) const {
        Capsule& shape = world.capsules.shape[*index_of(world, place.capsule)];
        shape = {place.start, place.end, shape.radius};
        const auto held = place_of(world.held_capsules, place.capsule);
        if (held != world.held_capsules.end() && held->id == place.capsule)
            *held = {place.capsule, place.start, place.end};
    }
    void operator()(const AddBall& add) const {
        add_ball(world, add.spec);
        widen_model(world);
    }
    void operator()(const RemoveBall& remove) const { remove_ball(world, remove.ball); }
    void operator()(const AddCapsule& add) const {
        add_capsule(world, add.shape, add.material, add.side);
        widen_model(world);
    }
    void operator()(const RemoveCapsule& remove) const { remove_capsule(world, remove.capsule); }
    void operator()(const SetGravity& set) const { world.model.gravity = set.gravity; }
    void operator()(const SetSolver&) const {}
    void operator()(const Press&) const {}
    void operator()(const Pull&) const {}
    void operator()(const CallShot&) const {}
    void operator()(const Decide&) const {}
    void operator()(const RackAgain&) const {}
};

bool is_drop(const Command& command) {
    return std::holds_alternative<DropBall>(command) ||
           std::holds_alternative<DropCapsule>(command);
}

bool is_hold(const Command& command) {
    return std::holds_alternative<HoldBall>(command) ||
           std::holds_alternative<HoldCapsule>(command);
}

bool is_place(const Command& command) {
    return std::holds_alternative<PlaceBall>(command) ||
           std::holds_alternative<PlaceCapsule>(command);
}

/// The ball or edge that a command moves by hand; none for other commands.
struct Moved {
    std::size_t how = 0;
    std::uint32_t what = 0;

    friend bool operator==(const Moved&, const Moved&) = default;
};

std::optional<Moved> moved(const Command& command) {
    const std::size_t how = command.index();
    if (const auto* c = std::get_if<HoldBall>(&command)) return Moved{how, number(c->ball)};
    if (const auto* c = std::get_if<HoldCapsule>(&command)) return Moved{how, number(c->capsule)};
    if (const auto* c = std::get_if<PlaceBall>(&command)) return Moved{how, number(c->ball)};
    if (const auto* c = std::get_if<PlaceCapsule>(&command)) return Moved{how, number(c->capsule)};
    return std::nullopt;
}

}  // namespace

std::optional<std::string> refusal(const World& world, const Command& command) {
    return std::visit([&](const auto& c) { return refused(world, c); }, command);
}

void obey(World& world, const Command& command) {
    std::visit(Obey{world}, command);
}

bool continues_gesture(const Command& earlier, const Command& later) {
    if (std::holds_alternative<CallShot>(earlier))
        return std::holds_alternative<CallShot>(later) || std::holds_alternative<Strike>(later);
    const bool hand_was_closed = is_hold(earlier) || is_place(earlier);
    const bool hand_goes_on = is_hold(later) || is_place(later);
    return hand_was_closed ? hand_goes_on || is_drop(later) : is_drop(earlier) && is_drop(later);
}

bool moves_capsule(const Command& command) {
    return std::holds_alternative<HoldCapsule>(command) ||
           std::holds_alternative<PlaceCapsule>(command);
}

bool moves_same_hand(const Command& earlier, const Command& later) {
    const auto what = moved(earlier);
    return what && what == moved(later);
}

}  // namespace carom

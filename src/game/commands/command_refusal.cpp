#include <fmt/format.h>

#include <algorithm>

#include "game/commands/command.h"
#include "game/commands/picking.h"
#include "geometry/closest.h"
#include "physics/world/images.h"
#include "physics/world/quantities.h"

/// The commands that a world refuses, and why.
namespace carom {
namespace {

using namespace command;
using Refusal = std::optional<std::string>;

/// Bodies that overlap by less than this share of a ball's radius only touch.
constexpr double touching = 1e-9;

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
    if (std::ranges::count(world.flippers(), id, &Flipper::capsule))
        return "a flipper moves by its button alone";
    if (is_moved_by_mover(world, id)) return "this edge moves by itself";
    if (seesaw_of(world, id)) return "balls alone turn a seesaw";
    return std::nullopt;
}

// Of a number or of a vector.
Refusal unless_quantity(const auto& value, std::string_view what) {
    if (is_quantity(value)) return std::nullopt;
    return fmt::format("{} is out of range: quantities go up to 1e18", what);
}

Refusal unless_in_torus(const World& world, const Capsule& edge) {
    if (has_all_images(world.model(), edge)) return std::nullopt;
    return "the edge would reach too far out of the wrapped world";
}

/// The depth to which a ball overlaps an edge; negative: the distance between them.
double depth(const World& world, const Disc& ball, const Capsule& edge) {
    const Vec2 middle = (edge.start + edge.end) * 0.5;
    const Disc beside{middle + offset(world, middle, ball.center), ball.radius};
    return -separation(beside, edge);
}

constexpr std::string_view blocked = "Blocked: it would overlap";

/// A body in the way.
struct Obstacle {
    std::string name;  ///< "ball 4"
    Vec2 place;
};

std::optional<Obstacle> obstacle(const World& world, const Disc& disc, ClassIndex kind,
                                 std::optional<BallId> itself = std::nullopt) {
    const double allowed = touching * disc.radius;
    const Balls& balls = world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (balls.id[i] == itself) continue;
        if (!kinds_meet(world, kind, balls.kind[i])) continue;
        const double apart = length(offset(world, disc.center, balls.position[i]));
        if (disc.radius + balls.radius[i] - apart > allowed)
            return Obstacle{fmt::format("ball {}", number(balls.id[i])), balls.position[i]};
    }
    const Capsules& capsules = world.capsules();
    for (std::size_t i = 0; i < capsules.size(); ++i) {
        if (!kind_meets_material(world, kind, capsules.material[i])) continue;
        if (depth(world, disc, capsules.shape[i]) > allowed)
            return Obstacle{fmt::format("edge {}", number(capsules.id[i])),
                            (capsules.shape[i].start + capsules.shape[i].end) * 0.5};
    }
    return std::nullopt;
}

std::optional<Obstacle> obstacle(const World& world, const Capsule& edge, ClassIndex material) {
    const Balls& balls = world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (!kind_meets_material(world, balls.kind[i], material)) continue;
        if (depth(world, {balls.position[i], balls.radius[i]}, edge) > touching * balls.radius[i])
            return Obstacle{fmt::format("ball {}", number(balls.id[i])), balls.position[i]};
    }
    return std::nullopt;
}

Capsule moved(const World& world, CapsuleId edge, Vec2 start, Vec2 end) {
    return {start, end, world.capsules().shape[*index_of(world, edge)].radius};
}

// What is in the way of a command. Pre: its bodies and classes exist, its numbers are finite.

std::optional<Obstacle> obstacle_of(const World& world, const AddBall& add) {
    const double radius = add.spec.radius.value_or(world.kinds()[add.spec.kind].radius);
    return obstacle(world, Disc{add.spec.position, radius}, add.spec.kind);
}

std::optional<Obstacle> obstacle_of(const World& world, const PlaceBall& place) {
    const std::size_t index = *index_of(world, place.ball);
    return obstacle(world, Disc{place.position, world.balls().radius[index]},
                    world.balls().kind[index], place.ball);
}

std::optional<Obstacle> obstacle_of(const World& world, const PlaceCapsule& place) {
    return obstacle(world, moved(world, place.capsule, place.start, place.end),
                    world.capsules().material[*index_of(world, place.capsule)]);
}

std::optional<Obstacle> obstacle_of(const World& world, const AddCapsule& add) {
    return obstacle(world, add.shape, add.material);
}

template <typename Other>
std::optional<Obstacle> obstacle_of(const World&, const Other&) {
    return std::nullopt;
}

Refusal blocked_by(const std::optional<Obstacle>& found) {
    if (!found) return std::nullopt;
    return fmt::format("{} {}", blocked, found->name);
}

Refusal refused(const World& world, const Strike& strike) {
    if (auto why = unless_ball(world, strike.ball)) return why;
    if (auto why = unless_quantity(strike.velocity, "the speed")) return why;
    const double side = strike.side;
    const double follow = strike.follow;
    constexpr double most = Strike::most_offset;
    if (!(side * side + follow * follow <= most * most))
        return fmt::format("the tip is {:.4g} radii off the middle, and would slip off beyond {}",
                           length(Vec2{side, follow}), most);
    if (side != 0.0 && !world.model().spin) return "balls do not spin here";
    if (follow != 0.0 && !world.model().cloth) return "there is no cloth to follow or draw on";
    return std::nullopt;
}

Refusal refused(const World& world, const HoldBall& hold) {
    if (auto why = unless_ball(world, hold.ball)) return why;
    return unless_quantity(hold.target, "the place");
}

Refusal refused(const World& world, const DropBall& drop) {
    if (is_held(world, drop.ball)) return std::nullopt;
    return fmt::format("ball {} is not held", number(drop.ball));
}

Refusal refused(const World& world, const HoldCapsule& hold) {
    if (auto why = unless_movable(world, hold.capsule)) return why;
    if (auto why = unless_quantity(hold.start_target, "the place")) return why;
    if (auto why = unless_quantity(hold.end_target, "the place")) return why;
    return unless_in_torus(world, moved(world, hold.capsule, hold.start_target, hold.end_target));
}

Refusal refused(const World& world, const DropCapsule& drop) {
    if (is_held(world, drop.capsule)) return std::nullopt;
    return fmt::format("edge {} is not held", number(drop.capsule));
}

Refusal refused(const World& world, const AddBall& add) {
    const BallSpec& spec = add.spec;
    if (spec.kind >= world.kinds().size()) return fmt::format("there is no kind {}", spec.kind);
    const double radius = spec.radius.value_or(world.kinds()[spec.kind].radius);
    const double mass = spec.mass.value_or(world.kinds()[spec.kind].mass);
    const double restitution = spec.restitution.value_or(world.kinds()[spec.kind].restitution);
    if (auto why = unless_quantity(spec.position, "the place")) return why;
    if (auto why = unless_quantity(spec.velocity, "the speed")) return why;
    if (auto why = unless_quantity(spec.spin, "the spin")) return why;
    if (!is_positive_quantity(radius)) return "its radius must be in 1e-18..1e18";
    if (!is_positive_quantity(mass)) return "its mass must be in 1e-18..1e18";
    if (!(restitution >= 0.0 && restitution <= 1.0)) return "its restitution must be in 0..1";
    return blocked_by(obstacle_of(world, add));
}

Refusal refused(const World& world, const RemoveBall& remove) {
    return unless_ball(world, remove.ball);
}

Refusal refused(const World& world, const PlaceBall& place) {
    if (auto why = unless_ball(world, place.ball)) return why;
    if (auto why = unless_quantity(place.position, "the place")) return why;
    return blocked_by(obstacle_of(world, place));
}

Refusal refused(const World& world, const PlaceCapsule& place) {
    if (auto why = unless_movable(world, place.capsule)) return why;
    if (auto why = unless_quantity(place.start, "the place")) return why;
    if (auto why = unless_quantity(place.end, "the place")) return why;
    if (auto why = unless_in_torus(world, moved(world, place.capsule, place.start, place.end)))
        return why;
    return blocked_by(obstacle_of(world, place));
}

Refusal refused(const World& world, const AddCapsule& add) {
    const Capsule& edge = add.shape;
    if (add.material >= world.materials().size())
        return fmt::format("there is no material {}", add.material);
    if (auto why = unless_quantity(edge.start, "the place")) return why;
    if (auto why = unless_quantity(edge.end, "the place")) return why;
    if (!(edge.radius >= 0.0)) return "its radius must not be negative";
    if (auto why = unless_quantity(edge.radius, "its radius")) return why;
    if (auto why = unless_in_torus(world, edge)) return why;
    return blocked_by(obstacle_of(world, add));
}

Refusal refused(const World& world, const RemoveCapsule& remove) {
    return unless_capsule(world, remove.capsule);
}

Refusal refused(const World& world, const SetGravity& set) {
    // As in a level: a cloth has gravity of its own, which presses balls on it.
    if (set.gravity && world.model().cloth) return "A table with a cloth is level";
    return unless_quantity(set.gravity.value_or(Vec2{}), "gravity");
}

Refusal refused(const World& world, const SetSolver& set) {
    if (!std::ranges::count(solvers_available(), set.settings.kind))
        return fmt::format("this carom has no solver {}", name(set.settings.kind));
    if (!supports(set.settings.kind, world.model()))
        return fmt::format("solver {} does not know {}", name(set.settings.kind),
                           world.model().cloth ? "cloth" : "seesaws");
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

Refusal refused(const World&, const TimeOut&) {
    return refused_without_rules();
}

Refusal refused(const World&, const Concede&) {
    return refused_without_rules();
}

}  // namespace

std::optional<std::string> refusal(const World& world, const Command& command) {
    return std::visit([&](const auto& c) { return refused(world, c); }, command);
}

std::optional<std::string> refusal_of_cue(Vec2 velocity, double most_power) {
    constexpr double rounding = 1e-9;
    const double speed = length(velocity);
    if (!(speed > 0.0)) return "the cue does not move";
    if (speed > most_power * (1.0 + rounding))
        return fmt::format("the cue gives at most {:g} m/s", most_power);
    return std::nullopt;
}

std::optional<Vec2> obstacle_to(const World& world, const Command& command) {
    const auto why = refusal(world, command);
    if (!why || !why->starts_with(blocked)) return std::nullopt;  // its numbers are not to be used
    return std::visit([&](const auto& c) { return obstacle_of(world, c); }, command)->place;
}

}  // namespace carom

#include <algorithm>
#include <cmath>

#include "game/pinball/pinball_table.h"
#include "geometry/closest.h"
#include "geometry/elementary.h"
#include "physics/world/random.h"

// Devices that move balls elsewhere: holes and magnets, which hold them for a while, and ramps to
// other layers.
namespace carom {
namespace {

// A hole scatters the balls it ejects; otherwise every shot from it would be equal.
constexpr double hole_scatter = 0.05;  // radians to either side

void send_on(Pinball game, const PinballState::Held& held, std::size_t ball) {
    const Device& hole = game.table().devices[held.device];
    if (hole.kind == DeviceKind::magnet) return;  // it lets go, and the ball rolls off
    const double angle = random_between(-hole_scatter, hole_scatter, game.world.seed(),
                                        RandomStream::player, number(held.ball), game.now());
    const auto [sine, cosine] = sin_cos(angle);
    game.world.edit_balls().velocity[ball] =
        (hole.direction * cosine + perpendicular(hole.direction) * sine) * hole.most_speed;
    if (hole.to > 0) set_layer(game.world, held.ball, hole.to);
}

// A magnet pulls the ball to its centre by its velocity, so that collisions still count; a ball in
// a hole lies still.
void hold(Pinball game, const Device& device, std::size_t ball) {
    constexpr double pull_time = 0.02;  // s in which 63 % of the way to the centre is covered
    World& world = game.world;
    if (device.kind == DeviceKind::magnet) {
        const Vec2 away = device.place - world.balls().position[ball];
        world.edit_balls().velocity[ball] = away / pull_time;
    } else {
        world.edit_balls().position[ball] = device.place;
        world.edit_balls().velocity[ball] = {};
    }
    if (world.model().spin) world.edit_balls().spin[ball] = 0.0;
}

// The speed across a ramp of a ball that has climbed it; negative: it rolls back. A height takes as
// much kinetic energy from each ball, so squares of speeds subtract.
double speed_above(double speed, double needed) {
    const double left = speed * speed - needed * needed;
    return left > 0.0 ? std::sqrt(left) : -speed;
}

std::uint8_t layer_of(const World& world, std::size_t ball) {
    return world.kinds()[world.balls().kind[ball]].layer;
}

}  // namespace

bool take_in(Pinball game, std::uint32_t device, BallId ball) {
    const Device& hole = game.table().devices[device];
    const bool is_magnet = hole.kind == DeviceKind::magnet && game.state.is_lit[device] != 0;
    if (!is_magnet && hole.kind != DeviceKind::hole) return false;
    if (std::ranges::count(game.state.held, device, &PinballState::Held::device) > 0) return false;
    const std::uint64_t until =
        hole.keeps ? PinballState::keeps_until_released : game.now() + game.ticks(hole.hold);
    game.state.held.push_back({device, ball, until});
    return true;
}

void release(Pinball game, const DeviceGroup& group) {
    for (PinballState::Held& held : game.state.held) {
        if (std::ranges::count(group.devices, held.device) == 0) continue;
        held.until = game.now();
        // At once: whether the turn goes on may depend on it, where the last ball has just drained.
        std::erase(game.state.locked, held.ball);
    }
}

void update_holes(Pinball game) {
    World& world = game.world;
    std::erase_if(game.state.held, [&](const PinballState::Held& held) {
        const auto index = index_of(world, held.ball);
        if (!index) return true;
        if (game.now() >= held.until) {
            send_on(game, held, *index);
            return true;
        }
        hold(game, game.table().devices[held.device], *index);
        return false;
    });
}

bool is_held(const PinballState& state, BallId ball) {
    return std::ranges::count(state.held, ball, &PinballState::Held::ball) > 0;
}

// A ball's layer follows from its position alone, so there is no state. A ball can go back down a
// ramp that it went up, but not up one that it came down.
void cross_ramps(Pinball game) {
    World& world = game.world;
    for (std::uint32_t device = 0; device < game.table().devices.size(); ++device) {
        const Device& ramp = game.table().devices[device];
        if (ramp.kind != DeviceKind::ramp) continue;
        const Capsule& shape = world.zones()[*ramp.zone].shape;
        for (std::size_t i = 0; i < world.balls().size(); ++i) {
            const Vec2 at = world.balls().position[i];
            const std::uint8_t layer = layer_of(world, i);
            if ((layer != ramp.from && layer != ramp.to) || !is_inside(shape, at)) continue;
            const bool has_passed = dot(at - ramp.place, ramp.direction) > 0.0;
            const double speed = dot(world.balls().velocity[i], ramp.direction);
            const bool is_climb = ramp.least_speed > 0.0;
            if (has_passed && layer == ramp.from && is_climb) {
                if (!(speed > 0.0)) continue;  // it is rolling back
                const double above = speed_above(speed, ramp.least_speed);
                world.edit_balls().velocity[i] += ramp.direction * (above - speed);
                if (above < 0.0) continue;
            }
            if (has_passed && layer == ramp.from) {
                set_layer(world, world.balls().id[i], ramp.to);
                apply_rules(game, device, RuleEvent::enter);
            } else if (!has_passed && layer == ramp.to && ramp.to > ramp.from) {
                set_layer(world, world.balls().id[i], ramp.from);
                if (!is_climb || !(speed < 0.0)) continue;
                const double below = std::sqrt(speed * speed + ramp.least_speed * ramp.least_speed);
                world.edit_balls().velocity[i] -= ramp.direction * (below + speed);
            }
        }
    }
}

}  // namespace carom

#include <algorithm>

#include "game/pinball/pinball_table.h"
#include "geometry/closest.h"
#include "geometry/elementary.h"
#include "physics/world/random.h"

// Devices that move balls elsewhere: holes, which hold them for a while, and ramps to other layers.
namespace carom {
namespace {

// A hole scatters the balls it ejects; otherwise every shot from it would be equal.
constexpr double hole_scatter = 0.05;  // radians to either side

void send_on(Pinball game, const PinballState::Held& held, std::size_t ball) {
    const Device& hole = game.table().devices[held.device];
    const double angle = random_between(-hole_scatter, hole_scatter, game.world.seed(),
                                        RandomStream::player, number(held.ball), game.now());
    const auto [sine, cosine] = sin_cos(angle);
    game.world.edit_balls().velocity[ball] =
        (hole.direction * cosine + perpendicular(hole.direction) * sine) * hole.most_speed;
}

std::uint8_t layer_of(const World& world, std::size_t ball) {
    return world.kinds()[world.balls().kind[ball]].layer;
}

}  // namespace

void take_into_hole(Pinball game, std::uint32_t device, BallId ball) {
    const Device& hole = game.table().devices[device];
    game.state.held.push_back({device, ball, game.now() + game.ticks(hole.hold)});
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
        world.edit_balls().position[*index] = game.table().devices[held.device].place;
        world.edit_balls().velocity[*index] = {};
        if (world.model().spin) world.edit_balls().spin[*index] = 0.0;
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
            if (has_passed && layer == ramp.from) {
                set_layer(world, world.balls().id[i], ramp.to);
                apply_rules(game, device, RuleEvent::enter);
            } else if (!has_passed && layer == ramp.to && ramp.to > ramp.from) {
                set_layer(world, world.balls().id[i], ramp.from);
            }
        }
    }
}

}  // namespace carom

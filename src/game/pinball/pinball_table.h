#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "game/pinball/pinball_state.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// The parts of a game of pinball that its files share.
namespace carom {

/// A table, the world that stands on it, and the state of the game, while a tick is followed.
struct Pinball {
    const Scene& scene;
    World& world;
    PinballState& state;

    const PinballTable& table() const { return scene.table; }
    std::uint64_t now() const { return world.tick; }
    /// At least one tick.
    std::uint64_t ticks(double seconds) const {
        const double ticks = seconds * world.rate + 0.5;
        return ticks < 1.0 ? 1 : static_cast<std::uint64_t>(ticks);
    }
    /// Of the table's own ball: what speeds and lengths that no level states are measured by.
    double radius() const {
        return scene.world.balls.size() > 0 ? scene.world.balls.radius[0] : 1.0;
    }
    bool is_scoring() const {
        return table().is_game && state.phase == PinballState::Phase::playing && !state.is_tilted;
    }
    void say(std::string message, double seconds) {
        state.message = std::move(message);
        state.message_until = now() + ticks(seconds);
    }
};

/// Lights that go on or off (pinball_rules.cpp).
void set_lit(Pinball game, std::uint32_t device, bool is_lit);

/// Lights whose time is over go off (pinball_rules.cpp).
void watch_lights(Pinball game);

/// What happened to a device, told to the rules (pinball_rules.cpp).
void tell_rules(Pinball game, std::uint32_t device, Rule::When when);

/// Targets that shall stand again do as soon as no ball is in the way (pinball_devices.cpp).
void raise_targets(Pinball game);
void hit_devices(Pinball game, std::span<const Contact> contacts);
void visit_zones(Pinball game);
void turn_spinners(Pinball game);

// pinball_ways.cpp
void take_into_hole(Pinball game, std::uint32_t device, BallId ball);
void work_holes(Pinball game);
bool is_held(const PinballState& state, BallId ball);
void cross_ramps(Pinball game);

/// Sends what lies on a plunger, with this share of its speed. False: nothing did.
bool launch(Pinball game, double pull);

/// The saver is on for so long from now, at least.
void save_for(Pinball game, double seconds);

}  // namespace carom

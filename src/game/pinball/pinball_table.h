#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "game/pinball/pinball_state.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// Declarations shared by the files of pinball.
namespace carom {

/// A table, its world, and the state of the game, while the rules process a tick.
struct Pinball {
    const Scene& scene;
    World& world;
    PinballState& state;

    const PinballTable& table() const { return scene.table; }
    std::uint64_t now() const { return world.tick(); }
    /// A time in whole ticks, at least one.
    std::uint64_t ticks(double seconds) const {
        const double ticks = seconds * world.rate() + 0.5;
        return ticks < 1.0 ? 1 : static_cast<std::uint64_t>(ticks);
    }
    /// The radius of the table's first ball: the unit for speeds and lengths that levels leave out.
    double radius() const {
        return scene.world.balls().size() > 0 ? scene.world.balls().radius[0] : 1.0;
    }
    bool is_scoring() const {
        return table().is_game && state.phase == PinballState::Phase::playing && !state.is_tilted;
    }
    void say(std::string message, double seconds) {
        state.message = std::move(message);
        state.message_since = now();
        state.message_until = now() + ticks(seconds);
    }
};

/// Switches a light on, without a time limit, or off (pinball_rules.cpp).
void set_lit(Pinball game, std::uint32_t device, bool is_lit);

/// Switches off lights whose time has expired (pinball_rules.cpp).
void expire_lights(Pinball game);

/// Applies the rules to an event of a device (pinball_rules.cpp).
void apply_rules(Pinball game, std::uint32_t device, RuleEvent event);
/// Applies the rules to an event that has no subject: launch, drain, the begin of a turn.
void apply_rules(Pinball game, RuleEvent moment);
/// Begins a game and a turn where one is due, and ends timers.
void run_rules(Pinball game);
/// Tells of an extra ball, once the message before it has been shown for a while.
void tell_extra_ball(Pinball game);
/// Notes that the goal of the level is reached, if it has one.
void note_goal(Pinball game);

/// Raises drop targets that are due, once no ball is in the way (pinball_devices.cpp).
void raise_targets(Pinball game);
void hit_devices(Pinball game, std::span<const Contact> contacts);
void visit_zones(Pinball game);
void update_spinners(Pinball game);

/// Opens and shuts gates and posts as their lights say; a post shuts once no ball is in the way.
void update_openings(Pinball game);

// pinball_holes.cpp
/// Lets a hole, or a magnet that is lit, take the ball. False: it is neither, or holds one already.
bool take_in(Pinball game, std::uint32_t device, BallId ball);
/// Lets go what a group of holes and magnets holds, which is in play from now on.
void release(Pinball game, const DeviceGroup& group);
void update_holes(Pinball game);
bool is_held(const PinballState& state, BallId ball);
void cross_ramps(Pinball game);

// pinball_balls.cpp
/// Notes which balls have come to lie in locks, and which are locked.
void update_locks(Pinball game);
/// Balls that can drain: neither captive nor locked.
std::size_t balls_in_play(Pinball game);
/// Balls that are not captive, those that are to be served included.
std::size_t all_balls(Pinball game);
/// Serves a ball at the start of the level's first ball, as soon as there is room.
void serve(Pinball game);
/// Launches a tilted ball that lies on the plunger, so that it ends without the player.
void launch_tilted_ball(Pinball game);
void begin_game_again(Pinball game);
/// Ends the ball in play once all have drained; serves another if the last one has been locked.
void count_drained(Pinball game);
void go_on_after_count(Pinball game);

/// While the only ball lies on a plunger and waits for the player, time stands for the ball saver,
/// the timers of the rules, and lights that go out by themselves.
void wait_for_launch(Pinball game);

/// Launches the balls on a plunger with this share of its speed. False: there are none.
bool launch(Pinball game, double pull);

/// Extends the ball saver to at least this long from now.
void save_for(Pinball game, double seconds);

}  // namespace carom

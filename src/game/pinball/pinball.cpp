#include "game/pinball/pinball.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "game/pinball/pinball_players.h"
#include "game/pinball/pinball_search.h"
#include "game/pinball/pinball_table.h"
#include "game/rules/rules.h"
#include "geometry/closest.h"
#include "physics/world/random.h"

namespace carom {
namespace {

using Phase = PinballState::Phase;

constexpr double full_pull = 1.0;  // s until the plunger is pulled all the way
// The range of automatic launches, as shares of the plunger's travel.
constexpr double least_own_pull = 0.5;
constexpr double most_own_pull = 0.9;

constexpr double settling_time = 4.0;

constexpr double nudge_time = 0.1;    // s
constexpr double nudge_speed = 20.0;  // radii a second that a nudge gives to a ball
// The tilt meter, as in Space Cadet: it rises while the table is nudged, and falls otherwise.
constexpr double meter_rise = 4.0;  // 1/s
constexpr double meter_fall = 1.0;
constexpr double meter_warns = 0.5;
constexpr double meter_tilts = 1.0;

bool are_flippers_alive(const PinballState& state) {
    return !state.is_tilted && state.phase != Phase::over;
}

void move_flippers(Pinball game) {
    const bool alive = are_flippers_alive(game.state);
    const std::vector<Button>& buttons = game.table().flipper_buttons;
    for (std::size_t i = 0; i < game.world.flippers().size() && i < buttons.size(); ++i)
        game.world.edit_flippers()[i].is_pressed =
            alive && game.state.is_down[static_cast<std::size_t>(buttons[i])];
}

// Lane change: rotates the lights of rollovers, so that a player can steer them to the ball.
void change_lanes(Pinball game, bool to_the_right) {
    for (const DeviceGroup& group : game.table().groups) {
        if (group.kind != DeviceKind::rollover || group.devices.size() < 2) continue;
        std::vector<std::uint32_t> across = group.devices;
        std::ranges::stable_sort(across, {},
                                 [&](std::uint32_t d) { return game.table().devices[d].place.x; });
        std::vector<std::uint8_t> lit;
        for (const std::uint32_t device : across)
            lit.push_back(game.state.is_lit[device]);
        std::rotate(lit.begin(), to_the_right ? lit.end() - 1 : lit.begin() + 1, lit.end());
        for (std::size_t i = 0; i < across.size(); ++i)
            game.state.is_lit[across[i]] = lit[i];
    }
}

void tilt(Pinball game) {
    game.state.is_tilted = true;
    game.state.bonus = 0;
    game.state.save_until = 0;
    game.say("TILT", 4.0);
}

void begin_nudge(Pinball game, Vec2 way) {
    game.state.nudge_until = game.now() + game.ticks(nudge_time);
    game.state.nudge = way * (nudge_speed * game.radius() / nudge_time);
}

void push_table(Pinball game) {
    PinballState& state = game.state;
    const double step = game.world.tick_length();
    const double before = state.tilt_meter;
    if (game.now() <= state.nudge_until) {
        for (std::size_t i = 0; i < game.world.balls().size(); ++i)
            if (!state.is_tilted) game.world.edit_balls().velocity[i] += state.nudge * step;
        state.tilt_meter += meter_rise * step;
    } else {
        state.tilt_meter = std::max(0.0, state.tilt_meter - meter_fall * step);
    }
    if (!game.is_scoring()) return;
    if (before < meter_warns && state.tilt_meter >= meter_warns) {
        ++state.warnings;
        game.say("DANGER", 1.5);
    }
    if (state.tilt_meter >= meter_tilts || state.warnings > game.table().warnings) tilt(game);
}

// A player's launch of the only ball starts the ball saver: the first, and one after a plunge too
// weak to leave the lane.
void note_launch(Pinball game, bool by_player) {
    apply_rules(game, RuleEvent::launch);
    const bool is_first = !std::exchange(game.state.is_launched, true);
    if (is_first || (by_player && balls_in_play(game) == 1)) save_for(game, game.table().save);
}

void update_plunger(Pinball game) {
    PinballState& state = game.state;
    if (state.is_down[static_cast<std::size_t>(Button::plunger)])
        state.pull = std::min(1.0, state.pull + game.world.tick_length() / full_pull);
    if (state.launch_at == 0 || game.now() < state.launch_at) return;
    // Launches vary, so that games differ.
    const double pull = random_between(least_own_pull, most_own_pull, game.world.seed(),
                                       RandomStream::player, state.games, game.world.next_ball());
    const bool is_launched = launch(game, pull);
    // The ball may not have settled on the plunger yet; the table waits for a limited time only.
    if (!is_launched && game.now() < state.launch_at + game.ticks(settling_time)) return;
    state.launch_at = 0;
    if (!is_launched) return;
    if (state.to_serve == 0) state.serves_itself = false;
    note_launch(game, false);
}

}  // namespace

PinballState begin_pinball(const Scene& scene) {
    PinballState state;
    const std::size_t devices = scene.table.devices.size();
    state.is_lit.assign(devices, 0);
    state.events.assign(devices, 0);
    state.lit_until.assign(devices, 0);
    state.flash_until.assign(devices, 0);
    state.is_rising.assign(devices, 0);
    state.turning.assign(devices, 0.0);
    state.turned.assign(devices, 0.0);
    state.rules = begin_rules(scene.rules);
    begin_players(state);
    for (std::size_t i = 0; i < devices; ++i)
        if (scene.table.devices[i].kind == DeviceKind::kickback) state.is_lit[i] = 1;
    return state;
}

void update_pinball(const Scene& scene, World& world, PinballState& state,
                    std::span<const Contact> contacts) {
    const Pinball game{scene, world, state};
    wait_for_launch(game);
    run_rules(game);
    hit_devices(game, contacts);
    expire_lights(game);
    visit_zones(game);
    update_locks(game);
    cross_ramps(game);
    update_holes(game);
    update_spinners(game);
    award_replay(game);
    count_drained(game);
    go_on_after_count(game);
    raise_targets(game);
    update_openings(game);
    push_table(game);
    launch_tilted_ball(game);
    update_plunger(game);
    if (scene.table.is_game) {
        search_balls(game);
        serve(game);
    }
    move_flippers(game);
    note_goal(game);
    tell_extra_ball(game);
    if (!state.message.empty() && world.tick() >= state.message_until) state.message.clear();
}

bool has_button(const Scene& scene, Button button) {
    if (button == Button::plunger)
        return scene.table.is_game ||
               std::ranges::count(scene.table.devices, DeviceKind::plunger, &Device::kind) > 0;
    if (button == Button::add_player) return scene.table.is_game && scene.rules.players > 1;
    if (button == Button::left_flipper || button == Button::right_flipper)
        return std::ranges::count(scene.table.flipper_buttons, button) > 0;
    return !scene.table.is_empty();
}

void pull_plunger(const Scene& scene, World& world, PinballState& state, double share,
                  bool lets_go) {
    const Pinball game{scene, world, state};
    state.is_down[static_cast<std::size_t>(Button::plunger)] = false;
    state.pull = lets_go ? 0.0 : share;
    if (lets_go && launch(game, share)) note_launch(game, true);
}

void press(const Scene& scene, World& world, PinballState& state, Button button, bool is_down) {
    const Pinball game{scene, world, state};
    const bool was_down = std::exchange(state.is_down[static_cast<std::size_t>(button)], is_down);
    if (was_down == is_down) return;
    switch (button) {
        case Button::left_flipper:
        case Button::right_flipper:
            if (is_down && are_flippers_alive(state))
                change_lanes(game, button == Button::right_flipper);
            move_flippers(game);
            break;
        case Button::plunger:
            if (is_down && scene.table.is_game && state.phase == Phase::over) {
                begin_game_again(game);
            } else if (!is_down) {
                if (launch(game, state.pull)) note_launch(game, true);
                state.pull = 0.0;
            }
            break;
        case Button::nudge_left:
            if (is_down) begin_nudge(game, {-1.0, 0.0});
            break;
        case Button::nudge_right:
            if (is_down) begin_nudge(game, {1.0, 0.0});
            break;
        case Button::nudge_up:
            if (is_down) begin_nudge(game, {0.0, 1.0});
            break;
        case Button::add_player:
            if (is_down) join(game);
            break;
    }
}

}  // namespace carom

#include "game/ai/demo_player.h"

#include <algorithm>

#include "game/pinball/pinball.h"
#include "physics/world/random.h"

namespace carom {
namespace {

// All times in seconds.
constexpr double pause_between = 4.0;  // games

// Meeting a ball that comes down.
constexpr double decides_every = 0.10;
constexpr double press_error = 0.020;  // most, to either side
constexpr double misjudgement = 0.06;  // of a ball's speed, most, by components
constexpr int press_reach = 1;         // in steps
constexpr double longest_rest = 3.0;   // that balls may lie near the flippers without a press

// Shots from a cradle.
constexpr double settling_speed = 20.0;  // radii a second: of a ball that is trapped
constexpr double cradle_speed = 1.5;     // of one that lies still
constexpr double still_time = 0.25;      // that a ball lies before it is let go
constexpr double first_roll = 0.06;      // from letting go to the press
constexpr double last_roll = 0.65;
constexpr double roll_step = 0.012;
constexpr std::uint64_t ticks_for_a_shot = 6;  // that it takes to think of one
constexpr double flight = 1.6;                 // that it looks ahead
constexpr double shot_error = 0.045;           // most, to either side
constexpr int shot_reach = 3;                  // in steps
constexpr double shot_time = 2.0;              // in which a shot reaches its device

// The least gain for which it presses a button, and for which it nudges: a ball that would be lost.
constexpr double least_gain = 4.0;
constexpr double nudge_gain = 40.0;
constexpr double still_meter = 0.05;  // tilt meter, of 1: below it a nudge raises no warning

std::size_t index(Button button) {
    return static_cast<std::size_t>(button);
}

std::uint32_t events_of_group(const Scene& scene, const PinballState& state, std::uint32_t device) {
    std::uint32_t events = 0;
    for (const std::uint32_t d : scene.table.groups[scene.table.devices[device].group].devices)
        events += state.events[d];
    return events;
}

// A shot is for what it wins: that the ball comes back to the flippers slowly is worth nothing.
double shot_value(const Foreseen& shot) {
    return std::min(0.0, shot.safety) + shot.gain;
}

// How well a ball that comes down is met.
double meeting_value(const Foreseen& way) {
    return way.safety + way.gain;
}

}  // namespace

// In -most..most, small errors being more likely: the sum of two uniform random numbers.
double DemoPlayer::error(const World& world, double most) {
    const auto draw = [&] {
        return random_between(-0.5 * most, 0.5 * most, world.seed(), RandomStream::player, 2000,
                              errors_++);
    };
    const double first = draw();
    return first + draw();
}

// The game as the player sees it, with speeds judged by eye.
PinballTrial DemoPlayer::seen(const Game& game) {
    PinballTrial trial{game.world, game.state};
    for (std::size_t i = 0; i < trial.world.balls().size(); ++i) {
        const Vec2 velocity = trial.world.balls().velocity[i];
        const double most = misjudgement * length(velocity);
        const Vec2 wrong{error(game.world, most), error(game.world, most)};
        trial.world.edit_balls().velocity[i] = velocity + wrong;
    }
    return trial;
}

// Carries out the presses of an option from the next tick on.
void DemoPlayer::follow(const Game& game, const PinballOption& option) {
    for (const TimedPress& press : option.presses)
        due_.push_back({game.world.tick() + press.after, press.button, press.is_down});
    acted_at_ = game.world.tick();
}

// Plans a shot with a ball that lies in a cradle, one trial at a time, and shoots it. False: no
// ball lies in a cradle, or another one is coming.
bool DemoPlayer::aim(const Game& game, const std::vector<std::size_t>& near) {
    std::optional<std::size_t> flipper;
    for (const std::size_t ball : near) {
        const auto cradle = game.sight.cradle_of(game.world, ball, cradle_speed);
        if (!cradle) {
            cradle_.reset();
            return false;
        }
        if (!flipper || (cradle_ && cradle_->flipper == *cradle)) flipper = cradle;
    }
    if (cradle_ && cradle_->flipper != *flipper) cradle_.reset();
    if (!cradle_) {
        cradle_ =
            Cradle{.flipper = *flipper, .since = game.world.tick(), .rolling = {}, .shots = {}};
        return true;
    }
    const std::uint64_t rested = game.world.tick() - cradle_->since;
    if (rested < pinball_ticks(game.world, still_time)) return true;
    if (cradle_->rolls >= pinball_ticks(game.world, last_roll)) {
        shoot(game);
        cradle_.reset();
    } else if (rested % ticks_for_a_shot == 0) {
        try_next_shot(game);
    }
    return true;
}

void DemoPlayer::try_next_shot(const Game& game) {
    Solver solver(*settings_);
    const Button button = game.sight.button_of(cradle_->flipper);
    std::uint64_t rolls = pinball_ticks(game.world, roll_step);
    if (!cradle_->rolling) {
        cradle_->rolling = PinballTrial{game.world, game.state};
        press(game.scene, cradle_->rolling->world, cradle_->rolling->state, button, false);
        rolls = pinball_ticks(game.world, first_roll);
    }
    for (std::uint64_t i = 0; i < rolls; ++i)
        play_tick(game.scene, solver, *cradle_->rolling);
    cradle_->rolls += rolls;
    const std::uint64_t flips = pinball_ticks(game.world, pinball_flip_time);
    const Foreseen foreseen = play_ahead(game.sight, game.scene, solver, *cradle_->rolling,
                                         {{0, button, true}, {flips, button, false}},
                                         pinball_ticks(game.world, flight), false);
    cradle_->shots.push_back({{{0, button, false},
                               {cradle_->rolls, button, true},
                               {cradle_->rolls + flips, button, false}},
                              foreseen});
}

void DemoPlayer::shoot(const Game& game) {
    std::vector<double> values;
    for (const PinballOption& shot : cradle_->shots)
        values.push_back(shot_value(shot.foreseen));
    std::size_t best = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
        if (value_around(values, i, shot_reach) > value_around(values, best, shot_reach)) best = i;
    PinballOption chosen = cradle_->shots[best];
    const double late = error(game.world, shot_error) * game.world.rate();
    for (std::size_t i = 1; i < chosen.presses.size(); ++i)
        chosen.presses[i].after = static_cast<std::uint64_t>(
            std::max(0.0, static_cast<double>(chosen.presses[i].after) + late));
    follow(game, chosen);
    if (!chosen.foreseen.device) return;
    const std::uint64_t from = game.world.tick() + chosen.presses[1].after;
    shot_ = Shot{*chosen.foreseen.device, from, from + pinball_ticks(game.world, shot_time), {}};
}

void DemoPlayer::watch_shot(const Game& game) {
    if (!shot_ || game.world.tick() < shot_->from) return;
    const std::uint32_t events = events_of_group(game.scene, game.state, shot_->device);
    if (!shot_->events_before) {
        shot_->events_before = events;
        ++shots_.tried;
    }
    const bool is_made = events > *shot_->events_before;
    if (is_made) ++shots_.made;
    if (is_made || game.world.tick() >= shot_->until) shot_.reset();
}

// Makes all presses of an option early or late by one error, as a person does.
PinballOption DemoPlayer::delayed(const Game& game, PinballOption option) {
    const double late = error(game.world, press_error) * game.world.rate();
    for (TimedPress& press : option.presses)
        press.after =
            static_cast<std::uint64_t>(std::max(0.0, static_cast<double>(press.after) + late));
    return option;
}

void DemoPlayer::meet(const Game& game, std::size_t ball) {
    const PinballTrial trial = seen(game);
    const std::vector<PinballOption> options = ways_to_meet(
        game.sight, game.scene, *settings_, trial, game.sight.button_for(game.world, ball));
    // Options alternate between changes for good and for a moment; each is judged among its kind.
    std::array<std::vector<double>, 2> values;
    for (std::size_t i = 1; i < options.size(); ++i)
        values[(i - 1) % 2].push_back(meeting_value(options[i].foreseen));
    const double idle = meeting_value(options[0].foreseen);
    // Balls that lean on each other in one cradle would otherwise lie there for ever.
    const bool must_act = game.world.tick() > acted_at_ + pinball_ticks(game.world, longest_rest) &&
                          options.size() > 1;
    double most = must_act ? -1e9 : idle + least_gain;
    std::size_t best = 0;
    for (std::size_t i = 1; i < options.size(); ++i) {
        const double value = value_around(values[(i - 1) % 2], (i - 1) / 2, press_reach);
        if (value > most) {
            most = value;
            best = i;
        }
    }
    if (best == 0 || most < idle + nudge_gain) {
        const bool may_nudge = game.state.tilt_meter < still_meter && !game.state.is_tilted;
        const auto nudge =
            may_nudge ? best_nudge(game.sight, game.scene, *settings_, trial) : std::nullopt;
        if (nudge && nudge->foreseen.safety > most + nudge_gain)
            return follow(game, delayed(game, *nudge));
    }
    if (best == 0) return;
    // A press that is due later is decided later, when the ball is nearer.
    const PinballOption& chosen = options[best];
    if (chosen.presses.front().after > pinball_ticks(game.world, decides_every + pinball_reaction))
        return;
    follow(game, delayed(game, chosen));
}

void DemoPlayer::decide(const Game& game) {
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < game.world.balls().size(); ++i)
        if (game.sight.is_near(game.world, i) && !game.sight.is_lost(game.world, i))
            near.push_back(i);
    if (!due_.empty()) return;
    if (near.empty()) {
        wants_down_[index(Button::left_flipper)] = false;
        wants_down_[index(Button::right_flipper)] = false;
        cradle_.reset();
        acted_at_ = game.world.tick();
        return;
    }
    if (aim(game, near) || game.world.tick() < decides_at_) return;
    decides_at_ = game.world.tick() + pinball_ticks(game.world, decides_every);
    // A ball that is being trapped is left alone.
    const bool is_settling =
        game.world.tick() < acted_at_ + pinball_ticks(game.world, longest_rest);
    std::erase_if(near, [&](std::size_t i) {
        return is_settling && game.sight.cradle_of(game.world, i, settling_speed);
    });
    const auto lowest = std::ranges::min_element(
        near, {}, [&](std::size_t i) { return game.world.balls().position[i].y; });
    if (lowest != near.end()) meet(game, *lowest);
}

std::vector<command::Press> DemoPlayer::play(const Scene& scene, const World& world,
                                             const PinballState& state) {
    // After a step back, its plans belong to a future that no longer exists.
    if (world.tick() < seen_until_) *this = {};
    seen_until_ = world.tick();
    std::vector<command::Press> presses;
    const auto set = [&](Button button, bool is_down) {
        if (state.is_down[index(button)] != is_down && has_button(scene, button))
            presses.push_back({button, is_down});
    };
    if (state.phase == PinballState::Phase::over) {
        if (begins_at_ == 0) begins_at_ = world.tick() + pinball_ticks(world, pause_between);
        // Press and release: the next tick releases the button.
        set(Button::plunger, world.tick() >= begins_at_ && !state.is_down[index(Button::plunger)]);
        return presses;
    }
    begins_at_ = 0;
    if (!settings_) settings_ = pick_solver(scene.world).settings;
    const PinballSight sight(scene);
    if (sight.has_pair()) {
        const Game game{scene, world, state, sight};
        watch_shot(game);
        decide(game);
    }
    std::erase_if(due_, [&](const DuePress& press) {
        if (press.tick > world.tick()) return false;
        wants_down_[index(press.button)] = press.is_down;
        return true;
    });
    const bool may_launch = state.launch_at == 0 && is_on_plunger(scene, world);
    if (!may_launch) plunge_ = {};
    const auto pull =
        may_launch ? plunge_.think(sight, scene, world, state, *settings_) : std::nullopt;
    wants_down_[index(Button::plunger)] = pull && state.pull < *pull;
    for (int button = 0; button < button_count; ++button)
        set(static_cast<Button>(button), wants_down_[static_cast<std::size_t>(button)]);
    return presses;
}

}  // namespace carom

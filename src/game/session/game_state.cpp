#include "game/session/game_state.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "game/digest.h"
#include "game/pinball/pinball.h"
#include "game/rules/rules.h"
#include "physics/world/fingerprint.h"

namespace carom {
namespace {

// The state of the game, and of the player's hands.
void add_play(Digest& digest, const PinballState& s) {
    for (const std::uint64_t value : {static_cast<std::uint64_t>(s.phase),
                                      s.phase_until,
                                      static_cast<std::uint64_t>(s.score),
                                      std::uint64_t{s.ball},
                                      std::uint64_t{s.extra_balls},
                                      static_cast<std::uint64_t>(s.bonus),
                                      static_cast<std::uint64_t>(s.multiplier),
                                      s.games,
                                      std::uint64_t{s.is_launched},
                                      s.save_until,
                                      std::uint64_t{s.to_serve},
                                      std::uint64_t{s.serves_itself},
                                      s.launch_at,
                                      s.nudge_until,
                                      std::uint64_t{s.warnings},
                                      std::uint64_t{s.is_tilted},
                                      s.removals_seen,
                                      s.drained,
                                      s.searches,
                                      s.lost,
                                      s.message_until,
                                      std::uint64_t{s.message.size()}})
        digest.add(value);
    if (s.extra_ball_is_untold) digest.add(std::uint64_t{1});
    digest.add(s.pull);
    digest.add(s.nudge);
    digest.add(s.tilt_meter);
    // What a button for another player is doing matters only while it is down: older
    // recordings, which have none, keep their fingerprints.
    for (int button = 0; button < button_count; ++button) {
        const bool is_down = s.is_down[static_cast<std::size_t>(button)];
        if (is_down || static_cast<Button>(button) != Button::add_player)
            digest.add(std::uint64_t{is_down});
    }
}

// What the devices of the table do, and which balls they watch.
void add_devices(Digest& digest, const PinballState& s) {
    for (std::size_t i = 0; i < s.is_lit.size(); ++i) {
        digest.add(std::uint64_t{s.is_lit[i]} * 2 + s.is_rising[i]);
        digest.add(s.turning[i]);
        digest.add(s.turned[i]);
    }
    for (std::size_t i = 0; i < s.lit_until.size(); ++i)
        if (s.lit_until[i] > 0) {
            digest.add(std::uint64_t{i});
            digest.add(s.lit_until[i]);
        }
    for (const PinballState::Held& held : s.held) {
        digest.add(std::uint64_t{held.device} << 32 | number(held.ball));
        digest.add(held.until);
    }
    for (const PinballState::Lying& ball : s.lying) {
        digest.add(std::uint64_t{ball.device} << 32 | number(ball.ball));
        digest.add(ball.since);
        digest.add(ball.seen * 2 + (ball.is_counted ? 1 : 0));
    }
    for (const BallId ball : s.locked)
        digest.add(std::uint64_t{number(ball)});
    for (const PinballState::Visit& visit : s.visits)
        digest.add(std::uint64_t{visit.device} << 32 | number(visit.ball));
    for (const PinballState::Progress& watch : s.progress) {
        digest.add(std::uint64_t{number(watch.ball)});
        digest.add(watch.place);
        digest.add(watch.since);
        digest.add(std::uint64_t{watch.searches});
    }
}

std::uint64_t digest_of(const World& world, const PinballState& s, int version) {
    Digest digest(fingerprint(world, version));
    // Ramps change the kinds of balls, which fingerprint version 1 leaves out.
    if (version == 1 && kinds_of_a_layer(world) < world.kinds().size())
        for (const ClassIndex kind : world.balls().kind)
            digest.add(std::uint64_t{kind});
    add_play(digest, s);
    add_devices(digest, s);
    add_to(digest, s.rules);
    if (s.goal.done) add_to(digest, s.goal);
    if (s.has_replay) digest.add(std::uint64_t{1});
    for (const PinballState::Parked& parked : s.parked) {
        if (parked.has_replay) digest.add(std::uint64_t{1});
        digest.add(static_cast<std::uint64_t>(parked.score));
        digest.add(std::uint64_t{parked.extra_balls});
        for (const std::uint8_t lit : parked.is_lit)
            digest.add(std::uint64_t{lit});
    }
    return digest.value();
}

// The places that a command names.
std::vector<Vec2> places_of(const Command& command) {
    using namespace command;
    if (const auto* hold = std::get_if<HoldBall>(&command)) return {hold->target};
    if (const auto* hold = std::get_if<HoldCapsule>(&command))
        return {hold->start_target, hold->end_target};
    if (const auto* place = std::get_if<PlaceBall>(&command)) return {place->position};
    if (const auto* place = std::get_if<PlaceCapsule>(&command)) return {place->start, place->end};
    if (const auto* add = std::get_if<AddBall>(&command)) return {add->spec.position};
    if (const auto* add = std::get_if<AddCapsule>(&command))
        return {add->shape.start, add->shape.end};
    return {};
}

}  // namespace

GameState begin_game(const Scene& scene) {
    if (const auto pool = begin_pool(scene)) return *pool;
    if (auto shots = begin_shots(scene)) return *std::move(shots);
    if (auto goal = begin_goal(scene); goal && scene.table.is_empty()) return *std::move(goal);
    if (scene.table.is_empty()) return {};
    return begin_pinball(scene);
}

void update_game(const Scene& scene, World& world, GameState& game,
                 std::span<const Contact> contacts) {
    if (auto* pinball = std::get_if<PinballState>(&game))
        update_pinball(scene, world, *pinball, contacts);
    if (auto* pool = std::get_if<PoolPlay>(&game)) update_pool(scene, world, *pool, contacts);
    if (auto* shots = std::get_if<ShotsState>(&game)) update_shots(scene, world, *shots, contacts);
    if (auto* goal = std::get_if<GoalPlay>(&game)) update_goal(scene, world, *goal);
}

bool is_within_reach(const Scene& scene, const Command& command) {
    constexpr double furthest = 1000.0;  // view's sizes
    const Vec2 extent = size(scene.view);
    const double reach = furthest * std::max(extent.x, extent.y);
    if (!(reach > 0.0)) return true;  // a scene without a view
    return std::ranges::none_of(places_of(command), [&](Vec2 place) {
        const Vec2 away = place - scene.view.low;
        return std::abs(away.x) > reach || std::abs(away.y) > reach;
    });
}

std::optional<std::string> refusal(const Scene& scene, const World& world, const GameState& game,
                                   const Command& command) {
    if (!is_within_reach(scene, command)) return "the place is too far away";
    if (const auto* pool = std::get_if<PoolPlay>(&game))
        return refusal(scene, world, *pool, command);
    if (const auto* shots = std::get_if<ShotsState>(&game))
        return refusal(scene, world, *shots, command);
    const auto* press = std::get_if<command::Press>(&command);
    const auto* pull = std::get_if<command::Pull>(&command);
    const bool is_pinball = std::holds_alternative<PinballState>(game);
    if ((!press && !pull) || !is_pinball) {
        const bool changes = !std::holds_alternative<command::SetSolver>(command);
        if (is_pinball && scene.table.is_game && changes) return "Disabled under rules.";
        return refusal(world, command);
    }
    if (pull && !(pull->share >= 0.0 && pull->share <= 1.0))
        return "a plunger is pulled by 0 to 1 of its way";
    if (has_button(scene, press ? press->button : Button::plunger)) return std::nullopt;
    return "this table has nothing that the button moves";
}

void execute(const Scene& scene, World& world, GameState& game, const Command& command) {
    const auto* pressed = std::get_if<command::Press>(&command);
    const auto* pulled = std::get_if<command::Pull>(&command);
    auto* pinball = std::get_if<PinballState>(&game);
    if (pressed && pinball)
        press(scene, world, *pinball, pressed->button, pressed->is_down);
    else if (pulled && pinball)
        pull_plunger(scene, world, *pinball, pulled->share, pulled->lets_go);
    else if (auto* pool = std::get_if<PoolPlay>(&game))
        execute(scene, world, *pool, command);
    else if (auto* shots = std::get_if<ShotsState>(&game))
        execute(scene, world, *shots, command);
    else if (auto* goal = std::get_if<GoalPlay>(&game))
        execute(scene, world, *goal, command);
    else
        execute(world, command);
}

std::vector<Button> pressed_buttons(const GameState& game) {
    std::vector<Button> down;
    const auto* pinball = std::get_if<PinballState>(&game);
    for (int button = 0; pinball && button < button_count; ++button)
        if (pinball->is_down[static_cast<std::size_t>(button)])
            down.push_back(static_cast<Button>(button));
    return down;
}

bool is_plunger_pulled(const GameState& game) {
    const auto* pinball = std::get_if<PinballState>(&game);
    return pinball && pinball->pull > 0.0;
}

std::uint64_t fingerprint(const World& world, const GameState& game, int version) {
    if (const auto* pool = std::get_if<PoolPlay>(&game))
        return digest_of(fingerprint(world, version), *pool);
    if (const auto* shots = std::get_if<ShotsState>(&game))
        return digest_of(fingerprint(world, version), *shots);
    if (const auto* pinball = std::get_if<PinballState>(&game))
        return digest_of(world, *pinball, version);
    if (const auto* goal = std::get_if<GoalPlay>(&game))
        return digest_of(fingerprint(world, version), *goal);
    return fingerprint(world, version);
}

std::size_t bytes_of(const GameState& game) {
    if (const auto* pool = std::get_if<PoolPlay>(&game)) return bytes_of(*pool);
    if (const auto* shots = std::get_if<ShotsState>(&game)) return bytes_of(*shots);
    const auto* pinball = std::get_if<PinballState>(&game);
    if (!pinball) return 0;
    const auto bytes_in = [](const auto& values) {
        return values.capacity() * sizeof(values.front());
    };
    return bytes_in(pinball->is_lit) + bytes_in(pinball->is_rising) + bytes_in(pinball->turning) +
           bytes_in(pinball->turned) + bytes_in(pinball->visits) + bytes_in(pinball->progress) +
           bytes_in(pinball->lit_until) + bytes_in(pinball->flash_until) + bytes_in(pinball->held) +
           bytes_in(pinball->lying) + bytes_in(pinball->locked) + bytes_in(pinball->events) +
           bytes_in(pinball->parked) + bytes_of(pinball->rules) + pinball->message.capacity();
}

const GoalState* goal_state(const GameState& game) {
    if (const auto* shots = std::get_if<ShotsState>(&game)) return &shots->goal;
    if (const auto* pinball = std::get_if<PinballState>(&game)) return &pinball->goal;
    if (const auto* play = std::get_if<GoalPlay>(&game)) return &play->goal;
    return nullptr;
}

int stars_of(const GameState& game) {
    const GoalState* const goal = goal_state(game);
    return goal && goal->done ? goal->done->stars : 0;
}

const RuleState* rule_state(const GameState& game) {
    if (const auto* shots = std::get_if<ShotsState>(&game)) return &shots->rules;
    if (const auto* pinball = std::get_if<PinballState>(&game)) return &pinball->rules;
    return nullptr;
}

std::string task_text(const Scene& scene, const World& world, const GameState& game) {
    if (const auto* shots = std::get_if<ShotsState>(&game)) return task_text(scene, world, *shots);
    if (const auto* pinball = std::get_if<PinballState>(&game))
        return task_text(scene, world, *pinball);
    if (const auto* goal = std::get_if<GoalPlay>(&game)) return task_text(scene, *goal);
    return {};
}

}  // namespace carom

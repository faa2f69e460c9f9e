#include "lab/games/pool_games.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "game/ai/planner.h"
#include "game/session/game_state.h"

namespace carom {
namespace {

std::vector<Command> decision(const Scene& scene, const World& world, const PoolPlay& play,
                              const SolverSettings& solver, const ShotNoise& error) {
    if (play.rules.phase == PoolPhase::choosing)
        return {command::Decide{choice_of(scene, world, play, error)}};
    const std::uint64_t seed = decision_seed(world, play);
    ShotPlanner planner(scene, world, play, solver, error, seed);
    while (!planner.is_done())
        planner.work(ShotPlanner::most_tries);
    return commands_of(scene, play, planner.best().front(), error, seed);
}

}  // namespace

PoolFrame play_pool_frame(const Scene& scene, const SolverSettings& settings,
                          const std::array<int, 2>& skill, std::uint32_t number) {
    PoolFrame frame;
    World world = scene.world;
    world.edit_definition().seed = scene.world.seed() + number;
    GameState game = *begin_pool(scene, static_cast<int>(number % 2));
    if (number > 0) rack_frame(scene, world, std::get<PoolPlay>(game), number);
    const auto& play = std::get<PoolPlay>(game);
    frame.breaker = play.rules.breaker;
    std::array<std::uint32_t, 2> shots_of{};
    Solver solver(settings);
    for (std::uint32_t made = 0; made < most_decisions; ++made) {
        if (play.rules.phase == PoolPhase::over) break;
        const auto player = static_cast<std::size_t>(play.rules.player);
        const std::uint32_t shots = play.shots;
        for (const Command& command :
             decision(scene, world, play, settings, shot_noise(skill[player]))) {
            frame.refused = refusal(scene, world, game, command);
            if (frame.refused) return frame;
            execute(scene, world, game, command);
        }
        while (play.is_shooting) {
            solver.tick(world);
            update_game(scene, world, game, solver.contacts());
        }
        if (play.shots == shots) continue;
        ++shots_of[player];
        if (play.last_foul != PoolFoul::none) ++frame.fouls[player];
    }
    frame.winner = play.rules.winner;
    frame.is_break_and_run = frame.winner == std::optional(frame.breaker) &&
                             shots_of[static_cast<std::size_t>(1 - frame.breaker)] == 0;
    frame.shots = play.shots;
    frame.seconds = world.time();
    return frame;
}

std::uint32_t frames_won(const PoolMatch& match, int player) {
    return static_cast<std::uint32_t>(
        std::ranges::count(match.frames, std::optional(player), &PoolFrame::winner));
}

std::uint32_t frames_unfinished(const PoolMatch& match) {
    return static_cast<std::uint32_t>(
        std::ranges::count_if(match.frames, [](const PoolFrame& frame) { return !frame.winner; }));
}

std::uint32_t frames_of_breakers(const PoolMatch& match) {
    return static_cast<std::uint32_t>(std::ranges::count_if(
        match.frames,
        [](const PoolFrame& frame) { return frame.winner == std::optional(frame.breaker); }));
}

std::uint32_t breaks_and_runs(const PoolMatch& match, int player) {
    return static_cast<std::uint32_t>(
        std::ranges::count_if(match.frames, [player](const PoolFrame& frame) {
            return frame.is_break_and_run && frame.breaker == player;
        }));
}

ShareRange likely_share(std::uint32_t won, std::uint32_t frames) {
    if (frames == 0) return {};
    constexpr double z = 1.96;  // quantile of the normal distribution for 95 %, two-sided
    const double n = frames;
    const double share = won / n;
    const double middle = share + z * z / (2.0 * n);
    const double reach = z * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
    const double scale = 1.0 + z * z / n;
    return {std::max(0.0, (middle - reach) / scale), std::min(1.0, (middle + reach) / scale)};
}

std::string pool_match_head() {
    return "| game | skills | frames | won | the more skilled wins | shots a frame: mean, most | "
           "fouls a frame | the breaker wins | break and run | not ended |\n"
           "|---|---|---|---|---|---|---|---|---|---|\n";
}

std::string pool_match_row(std::string_view game, const PoolMatch& match) {
    const auto frames = static_cast<std::uint32_t>(match.frames.size());
    const std::uint32_t won = frames_won(match, 0);
    const std::uint32_t lost = frames_won(match, 1);
    const ShareRange range = likely_share(won, won + lost);
    double shots = 0.0;
    std::uint32_t most = 0;
    std::array<double, 2> fouls{};
    for (const PoolFrame& frame : match.frames) {
        shots += frame.shots;
        most = std::max(most, frame.shots);
        for (std::size_t i : {0u, 1u})
            fouls[i] += frame.fouls[i];
    }
    const double ended = std::max(1u, won + lost);
    const double count = std::max(1u, frames);
    return fmt::format(
        "| {} | {} against {} | {} | {}:{} | {:.0f} % ({:.0f} to {:.0f}) | {:.1f}, {} | "
        "{:.1f} and {:.1f} | {:.0f} % | {} and {} | {} |\n",
        game, match.skill[0], match.skill[1], frames, won, lost, 100.0 * won / ended,
        100.0 * range.low, 100.0 * range.high, shots / count, most, fouls[0] / count,
        fouls[1] / count, 100.0 * frames_of_breakers(match) / ended, breaks_and_runs(match, 0),
        breaks_and_runs(match, 1), frames_unfinished(match));
}

}  // namespace carom

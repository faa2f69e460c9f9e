#include <string>
#include <utility>
#include <vector>

#include "game/pinball/pinball.h"
#include "game/rules/rules.h"
#include "game/session/game_state.h"

// The figures of a game that reports and expectations name.
namespace carom {
namespace {

using Tallies = std::vector<std::pair<std::string, std::int64_t>>;

Tallies tallies_of(const PoolPlay& pool) {
    return {{"player", pool.rules.player + 1},
            {"shots", std::int64_t{pool.shots}},
            {"frames1", std::int64_t{pool.frames[0]}},
            {"frames2", std::int64_t{pool.frames[1]}}};
}

Tallies tallies_of(const ShotsState& shots) {
    Tallies all{{"player", std::int64_t{shots.rules.player} + 1},
                {"shots", std::int64_t{shots.shots}},
                {"over", shots.is_over ? 1 : 0},
                {"winner", shots.winner ? std::int64_t{*shots.winner} + 1 : 0}};
    for (std::size_t i = 0; i < shots.players.size(); ++i)
        all.emplace_back("score" + std::to_string(i + 1), shots.players[i].score);
    for (std::size_t i = 0; i < shots.players.size(); ++i)
        all.emplace_back("fouls" + std::to_string(i + 1), shots.players[i].fouls);
    return all;
}

Tallies tallies_of(const PinballState& pinball) {
    Tallies all{{"score", pinball.score},
                {"ball", std::int64_t{pinball.ball}},
                {"drained", static_cast<std::int64_t>(pinball.drained)},
                {"searches", static_cast<std::int64_t>(pinball.searches)},
                {"lost", static_cast<std::int64_t>(pinball.lost)}};
    const std::vector<std::int64_t> scores = scores_of(pinball);
    for (std::size_t i = 0; scores.size() > 1 && i < scores.size(); ++i)
        all.emplace_back("score" + std::to_string(i + 1), scores[i]);
    return all;
}

Tallies tallies_of(const GoalPlay& play) {
    return {{"shots", std::int64_t{play.goal.shots}}};
}

Tallies tallies_of(const std::monostate&) {
    return {};
}

}  // namespace

std::vector<std::pair<std::string, std::int64_t>> tallies(const GameState& game) {
    Tallies all = std::visit([](const auto& play) { return tallies_of(play); }, game);
    if (const GoalState* const goal = goal_state(game); goal && goal->done) {
        all.emplace_back("done", std::int64_t{goal->done->shots});
        all.emplace_back("stars", std::int64_t{goal->done->stars});
    }
    return all;
}

std::vector<std::pair<std::string, std::vector<std::int64_t>>> variables(const Scene& scene,
                                                                         const GameState& game) {
    std::vector<std::pair<std::string, std::vector<std::int64_t>>> all;
    const RuleState* const rules = rule_state(game);
    for (std::size_t i = 0; rules && i < scene.rules.variables.size(); ++i) {
        const auto values = values_of(scene.rules, *rules, i);
        all.emplace_back(scene.rules.variables[i].name, std::vector(values.begin(), values.end()));
    }
    return all;
}

}  // namespace carom

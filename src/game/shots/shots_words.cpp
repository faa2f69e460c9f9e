#include <fmt/format.h>

#include <algorithm>

#include "game/shots/shots.h"
#include "game/shots/shots_play.h"

// A game of shots in words.
namespace carom {

std::string turn_text(const Scene& scene, const ShotsState& state) {
    std::string text;
    const std::size_t players = state.players.size();
    for (std::size_t i = 0; i < players; ++i) {
        if (i > 0) text += ", ";
        text += players == 1 ? fmt::format("score {}", state.players[i].score)
                             : fmt::format("player {}: {}", i + 1, state.players[i].score);
    }
    if (state.is_over && state.winner && players > 1)
        return text + fmt::format("; player {} wins", *state.winner + 1);
    if (state.is_over) return text + (players > 1 ? "; a tie" : "; the game is over");
    if (players > 1) text += fmt::format("; player {}", state.rules.player + 1);
    if (scene.pool.cues.size() > 1) {
        const std::uint32_t cue = cue_of(scene, state);
        text += fmt::format(" ({})", scene.ball_names[cue]);
    }
    if (state.is_in_hand) text += ": ball in hand";
    return text;
}

std::string task_text(const Scene& scene, const World& world, const ShotsState& state) {
    const ShotsAnswers answers(scene, world, state);
    std::string task = task_text(scene.rules, state.rules, answers);
    if (!task.empty() || scene.rules.goals.empty()) return task;
    const LevelGoal& goal = scene.rules.goals.front();
    if (!state.done) return goal.text;
    const int stars = stars_of(scene, world, state);
    return fmt::format("{}: done in {} shots, {} of 3 stars", goal.text, state.done->shots, stars);
}

int stars_of(const Scene& scene, const World& world, const ShotsState& state) {
    constexpr int most_stars = 3;
    if (!state.done || scene.rules.goals.empty()) return 0;
    const LevelGoal& goal = scene.rules.goals.front();
    const double spent = goal.counts_seconds
                             ? static_cast<double>(state.done->tick - state.begun) / world.rate()
                             : static_cast<double>(state.done->shots);
    int stars = most_stars;
    for (const double limit : goal.limits) {
        if (spent <= limit) return stars;
        --stars;
    }
    return goal.limits.empty() ? most_stars : 0;
}

}  // namespace carom

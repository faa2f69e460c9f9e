#include <fmt/format.h>

#include <algorithm>

#include "game/shots/shots.h"
#include "game/shots/shots_play.h"

// A game of shots in words.
namespace carom {

namespace {

bool has_score(const RuleBook& book) {
    return std::ranges::any_of(book.rules, [](const Rule& rule) {
        return std::ranges::count(rule.actions, RuleAction::What::score, &RuleAction::what) > 0;
    });
}

}  // namespace

std::string cue_name(const Scene& scene, const Cue& cue) {
    const std::size_t ball = *index_of(scene.world, cue.ball);
    if (cue.balls.size() == 1) return scene.ball_names[ball];
    return scene.kind_names[scene.world.balls().kind[ball] % scene.kind_names.size()];
}

std::string turn_text(const Scene& scene, const ShotsState& state) {
    const std::size_t players = state.players.size();
    const bool shows_score = players > 1 || has_score(scene.rules);
    std::string text = players == 1 && shows_score ? "score " : "";
    for (std::size_t i = 0; shows_score && i < players; ++i)
        text += fmt::format("{}{}", i > 0 ? " : " : "", state.players[i].score);
    if (state.is_over && state.winner && players > 1)
        return text + fmt::format(", player {} wins", *state.winner + 1);
    if (state.is_over && players == 1)
        return text + (text.empty() ? "the game is over" : ", the game is over");
    if (state.is_over) return text + ", a tie";
    if (players > 1) text += fmt::format(", player {} shoots", state.rules.player + 1);
    if (scene.pool.cues.size() > 1)
        text += fmt::format(" ({})", cue_name(scene, cue_in_turn(scene, state)));
    if (state.is_in_hand) text += text.empty() ? "ball in hand" : ": ball in hand";
    return text;
}

std::optional<Box> box_to_look_at(const Scene& scene, const ShotsState& state) {
    if (state.look < 0) return std::nullopt;
    const RulePlace& place = scene.rules.places[static_cast<std::size_t>(state.look)];
    std::optional<Box> box;
    for (const std::uint32_t zone : place.zones) {
        const Box of_zone = bounds(scene.world.zones()[zone].shape);
        box = box ? join(*box, of_zone) : of_zone;
    }
    return box;
}

std::string task_text(const Scene& scene, const World& world, const ShotsState& state) {
    const ShotsAnswers answers(scene, world, state);
    if (!state.goal.done && !state.is_over)
        if (std::string task = task_text(scene.rules, state.rules, answers); !task.empty())
            return task;
    return goal_text(scene.rules, state.goal);
}

}  // namespace carom

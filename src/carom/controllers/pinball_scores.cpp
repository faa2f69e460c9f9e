#include "carom/controllers/pinball_scores.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "game/pinball/pinball.h"

namespace carom {

void PinballScores::follow(const PinballState& state, bool is_demonstrating, bool is_watched) {
    is_left_out_ = is_left_out_ || is_demonstrating;
    if (state.phase != PinballState::Phase::over) {
        if (state.games != last_game_ && state.score == 0) is_left_out_ = is_demonstrating;
        return;
    }
    if (state.games == last_game_ || is_watched) return;
    last_game_ = state.games;
    const std::vector<std::int64_t> scores = scores_of(state);
    if (!is_demonstrating) last_scores_ = scores;
    if (is_left_out_) return;
    asked_.clear();
    for (std::size_t i = 0; i < scores.size(); ++i)
        asked_.push_back({scores[i], scores.size() > 1 ? i + 1 : 0});
    std::ranges::stable_sort(asked_, std::ranges::greater{}, &Asked::score);
    ask_next();
}

void PinballScores::restart() {
    last_game_ = 0;
    is_left_out_ = false;
}

// Asks for the first of those whose score is still among the best.
void PinballScores::ask_next() {
    initials_.reset();
    idle_ = 0.0;
    std::erase_if(asked_, [&](const Asked& asked) { return !scores_.takes(asked.score); });
    if (!asked_.empty()) initials_ = "";
}

void PinballScores::type(const InputEvent& event) {
    idle_ = 0.0;
    if (!initials_ || event.action == InputEvent::Action::release) return;
    if (event.key == key::backspace) {
        if (!initials_->empty()) initials_->pop_back();
        return;
    }
    if (event.key == key::escape) {
        asked_.erase(asked_.begin());
        return ask_next();
    }
    const bool is_letter = (event.key >= U'a' && event.key <= U'z') ||
                           (event.key >= U'A' && event.key <= U'Z') ||
                           (event.key >= U'0' && event.key <= U'9');
    if (is_letter && initials_->size() < 3) {
        char letter = static_cast<char>(event.key);
        if (letter >= 'a') letter = static_cast<char>(letter - 'a' + 'A');
        initials_->push_back(letter);
    }
    if (event.key == key::enter && !initials_->empty()) enter();
}

bool PinballScores::pass(double seconds) {
    constexpr double patience = 60.0;  // s
    if (!initials_) return false;
    idle_ += seconds;
    if (idle_ < patience) return false;
    enter();
    return true;
}

// The initials are complete.
void PinballScores::enter() {
    initials_->resize(3, '-');
    written_ = newest_ = HighScore{*initials_, asked_.front().score};
    scores_.add(*newest_);
    asked_.erase(asked_.begin());
    ask_next();
}

std::optional<HighScore> PinballScores::take() {
    return std::exchange(written_, std::nullopt);
}

void PinballScores::continue_from(const PinballScores& before, std::size_t most) {
    newest_ = before.newest_;
    scores_ = before.scores_;
    scores_.most = most;
    scores_.lines.resize(std::min(scores_.lines.size(), most));
}

}  // namespace carom

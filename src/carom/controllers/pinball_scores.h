#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "carom/files/high_scores.h"
#include "game/pinball/pinball_state.h"
#include "terminal/input/input.h"

/// The high scores of a pinball table, and the initials that the player enters for one.
namespace carom {

class PinballScores {
  public:
    void set(HighScores scores) { scores_ = std::move(scores); }
    const HighScores& scores() const { return scores_; }
    /// The score that was entered last.
    const std::optional<HighScore>& newest() const { return newest_; }

    /// Asks for initials once a game is over with a score among the best. Not after a game in which
    /// the demonstration played a part, nor where the game is `watched`.
    void follow(const PinballState& state, bool is_demonstrating, bool is_watched);
    /// The initials so far; none: they are not asked for.
    const std::optional<std::string>& initials() const { return initials_; }
    /// A letter, a correction, or the end of it.
    void type(const InputEvent& event);
    /// The score that has been entered, once.
    std::optional<HighScore> take();

    /// The same table, changed on disk: the scores stay, of which it keeps `most` now.
    void continue_from(const PinballScores& before, std::size_t most);

  private:
    HighScores scores_;
    std::optional<std::string> initials_;
    std::int64_t asked_for_ = 0;  ///< the score
    std::optional<HighScore> written_;
    std::optional<HighScore> newest_;
    bool was_demonstrated_ = false;  ///< for a part of this game
    std::uint64_t last_game_ = 0;    ///< the game whose end has been seen
};

}  // namespace carom

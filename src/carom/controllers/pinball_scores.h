#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "carom/files/high_scores.h"
#include "game/pinball/pinball_state.h"
#include "terminal/input/input.h"

/// The high scores of a pinball table, and the entry of initials.
namespace carom {

class PinballScores {
  public:
    void set(HighScores scores) { scores_ = std::move(scores); }
    const HighScores& scores() const { return scores_; }
    /// The score entered last.
    const std::optional<HighScore>& newest() const { return newest_; }

    /// Asks for initials when a game ends with a score among the best. Not after a game that the
    /// demo took part in, nor in a recording (`watched`).
    void follow(const PinballState& state, bool is_demonstrating, bool is_watched);
    /// The initials typed so far; none: they are not being asked for.
    const std::optional<std::string>& initials() const { return initials_; }
    /// Takes a letter, a correction, or the confirmation.
    void type(const InputEvent& event);
    /// The score that has been entered; returned once.
    std::optional<HighScore> take();

    /// The level was changed on disk: keeps the scores, up to its new limit `most`.
    void continue_from(const PinballScores& before, std::size_t most);

  private:
    HighScores scores_;
    std::optional<std::string> initials_;
    std::int64_t asked_for_ = 0;  ///< the score that initials are asked for
    std::optional<HighScore> written_;
    std::optional<HighScore> newest_;
    bool was_demonstrated_ = false;  ///< at some point of this game
    std::uint64_t last_game_ = 0;    ///< the game whose end has been handled
};

}  // namespace carom

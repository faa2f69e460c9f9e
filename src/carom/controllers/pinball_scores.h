#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

    /// Asks each player for initials whose score is among the best when a game ends, the best
    /// first. Not after a game that the demo took part in or that was left out, nor in a recording
    /// (`watched`).
    void follow(const PinballState& state, bool is_demonstrating, bool is_watched);
    /// What the players of the last game of people scored; empty: there was none.
    const std::vector<std::int64_t>& last_game() const { return last_scores_; }
    /// Leaves this game out of the high scores: its player went back and changed it, or slowed it,
    /// in this session or before it was resumed.
    void leave_out() { is_left_out_ = true; }
    bool is_left_out() const { return is_left_out_; }
    /// The table stands as at the start, where its games are counted anew.
    void restart();
    /// The initials typed so far; none: they are not being asked for.
    const std::optional<std::string>& initials() const { return initials_; }
    /// Whose they are, from 1; 0: one person played. Pre: they are being asked for.
    std::size_t player() const { return asked_.front().player; }
    /// Takes a letter, a correction, or the confirmation.
    void type(const InputEvent& event);
    /// Passes time in which initials can be typed. After a minute without a key, what has been
    /// typed counts, as on real tables. Returns whether that has happened now.
    bool pass(double seconds);
    /// The score that has been entered; returned once.
    std::optional<HighScore> take();

    /// The level was changed on disk: keeps the scores, up to its new limit `most`.
    void continue_from(const PinballScores& before, std::size_t most);

  private:
    struct Asked {
        std::int64_t score = 0;
        std::size_t player = 0;
    };
    void ask_next();
    void enter();

    HighScores scores_;
    std::optional<std::string> initials_;
    std::vector<Asked> asked_;  ///< the scores that initials are asked for, the best first
    double idle_ = 0.0;         ///< s since the last key
    std::vector<std::int64_t> last_scores_;
    std::optional<HighScore> written_;
    std::optional<HighScore> newest_;
    bool is_left_out_ = false;     ///< this game
    std::uint64_t last_game_ = 0;  ///< the game whose end has been handled
};

}  // namespace carom

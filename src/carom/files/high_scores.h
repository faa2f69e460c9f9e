#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// High scores. They live in one small text file in the user's data folder: a first line that names
/// the format, then one line a score:
///
///     carom high scores 1
///     three-bumpers 123450 ABC
///
/// the name of the table, the points, the initials. A file in another format is never written over.
namespace carom {

struct HighScore {
    std::string initials;  ///< three of A to Z and digits
    std::int64_t score = 0;

    friend bool operator==(const HighScore&, const HighScore&) = default;
};

/// The high scores of one table, the best first.
struct HighScores {
    std::vector<HighScore> lines;
    std::size_t most = 5;

    /// Whether this score would be among them.
    bool takes(std::int64_t score) const;
    /// Of equal scores, the older stands first.
    void add(const HighScore& score);
};

struct HighScoresText {
    HighScores scores;
    std::optional<std::string> problem;  ///< a sentence: the file cannot be used
};
/// Of this table. `file` is for the message.
HighScoresText read_high_scores(std::string_view text, std::string_view table, std::size_t most,
                                std::string_view file);
/// The text with the table's lines in place of those that it had; all else stays. Pre: the text can
/// be read, or is empty.
std::string with_high_scores(std::string_view text, std::string_view table,
                             const HighScores& scores);

/// Reads the high scores from the user's file; a user without one has none yet.
HighScoresText load_high_scores(std::string_view table, std::size_t most);
/// Adds one to the user's file, which is read again for it, and returns the table's scores now. The
/// new text takes the place of the old at once or not at all.
HighScoresText keep_high_score(std::string_view table, std::size_t most, const HighScore& score);

/// By which a level is known there: its file's name without folder and ending.
std::string high_scores_name(std::string_view level_path);

}  // namespace carom

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// High scores, kept in one small text file in the user's data folder: a first line with the
/// format, then one line a score:
///
///     carom high scores 1
///     three-bumpers 123450 ABC
///
/// with the name of the table, the points, and the initials. The stars of a level's goal are lines
/// of a table of their own, without initials:
///
///     stars/clear-one 3 ---
///
/// A file in another format is never overwritten.
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

    /// Whether this score would be on the list.
    bool takes(std::int64_t score) const;
    /// Among equal scores, the older comes first.
    void add(const HighScore& score);
};

/// What a table shows: the best of `kept` and of the scores of the house, which a real table has
/// from the factory. Those reach from a tenth of `replay`, the score of the extra ball, to all of
/// it; 0: there are none. They are in no file.
HighScores with_house_scores(HighScores kept, std::int64_t replay);

struct HighScoresText {
    HighScores scores;
    std::optional<std::string> problem;  ///< set if the file cannot be used: a sentence
};
/// Parses the scores of `table`. `file` is for the error message.
HighScoresText read_high_scores(std::string_view text, std::string_view table, std::size_t most,
                                std::string_view file);
/// The text with the table's lines replaced; everything else stays. Pre: the text can be parsed, or
/// is empty.
std::string with_high_scores(std::string_view text, std::string_view table,
                             const HighScores& scores);

/// Reads the user's file; empty for a user without one.
HighScoresText load_high_scores(std::string_view table, std::size_t most);
/// Rereads the user's file, adds one score, and returns the table's scores. The file is replaced at
/// once or not at all, under a lock, so that two games that end together keep both scores.
HighScoresText keep_high_score(std::string_view table, std::size_t most, const HighScore& score);

/// The most stars that were kept for the goal of the level; 0: none.
int load_stars(const std::string& level_path);
/// Keeps the stars, unless the level has as many. Returns the problem, as a sentence.
std::optional<std::string> keep_stars(const std::string& level_path, int stars);

/// The name of a level in the file: its file name without folder and extension.
std::string high_scores_name(std::string_view level_path);

}  // namespace carom

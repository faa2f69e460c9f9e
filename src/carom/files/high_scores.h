#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// High scores. They live in one small text file in the user's data folder: a first line that says
/// what it is, then one line a score,
///
///     carom high scores 1
///     three-bumpers 123450 ABC
///
/// the name of the table, the points, the initials. A file that is not so is never written over.
namespace carom {

struct Honour {
    std::string initials;  ///< three of A to Z and digits
    std::int64_t score = 0;

    friend bool operator==(const Honour&, const Honour&) = default;
};

/// Those of one table, the best first.
struct Honours {
    std::vector<Honour> lines;
    std::size_t most = 5;

    /// Whether this score would be among them.
    bool takes(std::int64_t score) const;
    /// Those who came first stand before those who did as well later.
    void add(const Honour& honour);
};

struct HonoursText {
    Honours honours;
    std::optional<std::string> problem;  ///< a sentence: the file cannot be used
};
/// Of this table. `file` is for the message.
HonoursText read_honours(std::string_view text, std::string_view table, std::size_t most,
                         std::string_view file);
/// The text with the table's lines in place of those that it had; all else stays. Pre: the text can
/// be read, or is empty.
std::string with_honours(std::string_view text, std::string_view table, const Honours& honours);

/// As read_honours, from the user's file; a user without one has no scores yet.
HonoursText load_honours(std::string_view table, std::size_t most);
/// Adds one to the user's file, which is read anew for it, and gives what stands there now. The
/// new text takes the place of the old at once or not at all.
HonoursText keep_honour(std::string_view table, std::size_t most, const Honour& honour);

/// By which a level is known there: its file's name without folder and ending.
std::string honours_name(std::string_view level_path);

}  // namespace carom

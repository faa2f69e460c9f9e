#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "game/ai/opponents.h"
#include "game/replay/replay_commands.h"
#include "game/replay/replay_text.h"
#include "game/session/fingerprint_mark.h"
#include "level/text/text.h"
#include "physics/world/fingerprint.h"

namespace carom {
namespace {

constexpr std::uint64_t oldest_version = 2;
constexpr std::uint64_t version = 3;
constexpr std::string_view first_words = "carom replay ";

/// An error: a message and its remedy.
struct Fault {
    std::string message;
    std::string remedy;
};
using Wrong = std::optional<Fault>;

const std::string record_again = "make a new recording, with --record";
const std::string take_out = "take the line out, or take an unchanged copy of the recording";

Wrong wrong_version(std::string_view first_line) {
    if (first_line.ends_with('\r'))
        return Fault{"the line ends are CR LF, which would change the level in it",
                     "copy the file without converting its line ends"};
    if (!first_line.starts_with(first_words))
        return Fault{"this is not a recording of carom",
                     "a recording begins with the line 'carom replay 3'; a level is played with "
                     "carom play"};
    Words words(first_line.substr(first_words.size()));
    const auto found = words.integer<std::uint64_t>();
    if (!words.done())
        return Fault{"the version of this recording cannot be read",
                     "the line should say: carom replay 3"};
    if (found >= oldest_version && found <= version) return std::nullopt;
    return Fault{
        fmt::format("the recording is of version {}, and this carom reads versions {} and {}",
                    found, oldest_version, version),
        found < version ? "record the game again, or use the carom that recorded it"
                        : "use a newer carom"};
}

class ReplayReader {
  public:
    std::variant<Replay, ReplayError> read(std::string_view text) {
        if (text.empty()) return error(1, {"the file is empty", record_again});
        for (int line = 1; !text.empty(); ++line) {
            const std::size_t end = text.find('\n');
            const std::string_view content = text.substr(0, end);
            if (line == 1) {
                if (auto wrong = wrong_version(content)) return error(line, *wrong);
            }
            if (end == std::string_view::npos) return error(line, truncated());
            if (line > 1) {
                if (auto wrong = statement(content)) return error(line, *wrong);
            }
            text.remove_prefix(end + 1);
            last_line_ = line;
        }
        if (auto wrong = incomplete()) return error(last_line_, *wrong);
        if (!has_position_) replay_.position = replay_.end;
        return std::move(replay_);
    }

  private:
    static ReplayError error(int line, const Fault& fault) {
        return {line, fault.message, fault.remedy};
    }
    static Fault truncated() {
        return {"the recording is cut off here: its last line, 'end', is missing",
                "take a whole copy of it, or record the game again"};
    }

    Wrong statement(std::string_view text) {
        if (has_end_)
            return Fault{"there is more after 'end'", "delete this line and all after it"};
        if (text.starts_with('|')) return text_line(text.substr(1));
        is_in_text_ = false;
        Words words(text);
        const std::string_view keyword = words.next().value_or("");
        Wrong wrong;
        if (keyword == "program") {
            replay_.program = words.take_rest();
        } else if (keyword == "physics") {
            replay_.physics_version = words.integer<int>();
        } else if (keyword == "fingerprint") {
            wrong = fingerprint_of_marks(words.integer<int>());
        } else if (keyword == "level") {
            replay_.level = words.take_rest();
            if (replay_.level.empty()) return Fault{"the level has no name", record_again};
        } else if (keyword == "set") {
            replay_.overrides.emplace_back(words.take_rest());
        } else if (keyword == "file") {
            wrong = file(words.integer<std::size_t>());
        } else if (keyword == "include") {
            wrong = include(words);
        } else if (keyword == "hash") {
            replay_.level_hash = words.integer<std::uint64_t>(16);
            replay_.hash_line = last_line_ + 1;
            has_hash_ = true;
        } else if (keyword == "solver") {
            replay_.solver = read_solver(words);
            has_solver_ = true;
        } else if (keyword == "rate") {
            replay_.rate = words.real();
            has_rate_ = replay_.rate >= 1e-3 && replay_.rate <= 1e9;
        } else if (keyword == "seed") {
            replay_.seed = words.integer<std::uint64_t>();
            has_seed_ = true;
        } else if (keyword == "at") {
            wrong = timed_command(words);
        } else if (keyword == "mark") {
            wrong = mark(words);
        } else if (keyword == "opponent") {
            wrong = opponent(words.integer<int>());
        } else if (keyword == "stance") {
            replay_.setup = read_shot_setup(words);
        } else if (keyword == "time-left") {
            replay_.time_left = words.real();
        } else if (keyword == "unranked") {
            replay_.is_unranked = true;
        } else if (keyword == "stands") {
            replay_.position = words.integer<std::uint64_t>();
            has_position_ = true;
        } else if (keyword == "end") {
            replay_.end = words.integer<std::uint64_t>();
            has_end_ = true;
        } else {
            return Fault{fmt::format("there is no statement '{}'", legible(keyword)), take_out};
        }
        if (wrong) return wrong;
        if (words.done()) return std::nullopt;
        return Fault{fmt::format("'{}' is not complete or not right", keyword), take_out};
    }

    Wrong fingerprint_of_marks(int number) {
        if (number < 1) return Fault{"there is no such version of fingerprints", take_out};
        if (number > fingerprint_version)
            return Fault{fmt::format("the fingerprints are of version {}, and this carom knows {}",
                                     number, fingerprint_version),
                         "use a newer carom"};
        replay_.fingerprint_version = number;
        return std::nullopt;
    }

    Wrong file(std::size_t number) {
        if (number != replay_.texts.size())
            return Fault{fmt::format("file {} is missing", replay_.texts.size()), record_again};
        replay_.texts.emplace_back();
        is_in_text_ = true;
        is_first_of_text_ = true;
        return std::nullopt;
    }

    Wrong text_line(std::string_view line) {
        if (!is_in_text_) return Fault{"this line of a level belongs to no 'file'", take_out};
        if (!is_first_of_text_) replay_.texts.back() += '\n';
        is_first_of_text_ = false;
        replay_.texts.back() += line;
        return std::nullopt;
    }

    Wrong include(Words& words) {
        Include include;
        include.from = words.integer<std::size_t>();
        include.file = words.integer<std::size_t>();
        include.path = words.take_rest();
        const std::size_t files = replay_.texts.size();
        if (include.from >= files || include.file >= files)
            return Fault{"the file that this is about is missing", record_again};
        replay_.includes.push_back(std::move(include));
        return std::nullopt;
    }

    Wrong timed_command(Words& words) {
        const auto tick = words.integer<std::uint64_t>();
        if (!replay_.commands.empty() && tick < replay_.commands.back().tick)
            return Fault{"the ticks go back", "put the commands in the order of their ticks"};
        const auto command = read_command(words);
        if (!command) return Fault{"there is no such command", take_out};
        replay_.commands.push_back({tick, *command});
        return std::nullopt;
    }

    Wrong opponent(int number) {
        if (number < 1 || number > most_opponent)
            return Fault{"there is no such opponent", take_out};
        replay_.opponent = number;
        return std::nullopt;
    }

    Wrong mark(Words& words) {
        const auto tick = words.integer<std::uint64_t>();
        const auto fingerprint = words.integer<std::uint64_t>(16);
        if (!replay_.marks.empty() && tick <= replay_.marks.back().tick)
            return Fault{"the ticks go back", "put the marks in the order of their ticks"};
        replay_.marks.push_back({tick, fingerprint});
        return std::nullopt;
    }

    Wrong incomplete() const {
        if (!has_end_) return truncated();
        const auto missing = [](std::string_view what) {
            return Fault{fmt::format("'{}' is missing", what), record_again};
        };
        if (replay_.level.empty()) return missing("level");
        if (replay_.texts.empty()) return missing("file 0");
        if (!has_hash_) return missing("hash");
        if (!has_solver_) return missing("solver");
        if (!has_rate_) return Fault{"'rate' is missing, or not in 0.001..1e9", record_again};
        if (!has_seed_) return missing("seed");
        if (has_position_ && replay_.position > replay_.end)
            return Fault{"'stands' lies after 'end'", record_again};
        if (!replay_.commands.empty() && replay_.commands.back().tick > replay_.end)
            return Fault{"there are commands after 'end'", record_again};
        if (!replay_.marks.empty() && replay_.marks.back().tick > replay_.end)
            return Fault{"there are marks after 'end'", record_again};
        // So a wrong `end` costs no more time than the recording has.
        if (!replay_.marks.empty() &&
            replay_.end - replay_.marks.back().tick > mark_interval(replay_.rate))
            return Fault{"'end' lies more than a second after the last fingerprint", record_again};
        return std::nullopt;
    }

    Replay replay_;
    int last_line_ = 0;
    bool is_in_text_ = false;
    bool is_first_of_text_ = false;
    bool has_hash_ = false;
    bool has_solver_ = false;
    bool has_rate_ = false;
    bool has_seed_ = false;
    bool has_position_ = false;
    bool has_end_ = false;
};

}  // namespace

std::variant<Replay, ReplayError> read_replay(std::string_view text) {
    return ReplayReader{}.read(text);
}

}  // namespace carom

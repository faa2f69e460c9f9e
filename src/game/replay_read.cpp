#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "game/replay_text.h"
#include "game/replay_words.h"

namespace carom {
namespace {

using namespace command;

/// The words of one line, taken from the left. A word that is missing or wrong gives none, and so
/// does everything after it.
class Words {
  public:
    explicit Words(std::string_view line) : rest_(line) {}

    std::optional<std::string_view> next() {
        if (failed_ || rest_.empty()) return std::nullopt;
        const std::size_t end = std::min(rest_.find(' '), rest_.size());
        const std::string_view word = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        return word;
    }
    std::string_view rest() const { return rest_; }
    bool done() const { return !failed_ && rest_.empty(); }
    void fail() { failed_ = true; }

    template <typename T>
    T integer(int base = 10) {
        T value{};
        const auto word = next();
        if (!word) return failed<T>();
        const auto [end, error] =
            std::from_chars(word->data(), word->data() + word->size(), value, base);
        return error == std::errc{} && end == word->data() + word->size() ? value : failed<T>();
    }
    double real() {
        const auto word = next();
        return word ? real_of(*word) : failed<double>();
    }
    Vec2 point() {
        const auto word = next();
        const std::size_t comma = word ? word->find(',') : std::string_view::npos;
        if (comma == std::string_view::npos) return failed<Vec2>();
        return {real_of(word->substr(0, comma)), real_of(word->substr(comma + 1))};
    }
    /// The number of `key=number`, if that is what comes next.
    std::optional<double> optional_real(std::string_view key) {
        if (!rest_.starts_with(key)) return std::nullopt;
        return real_of(next()->substr(key.size()));
    }
    int setting(std::string_view key) {
        if (!rest_.starts_with(key)) return failed<int>();
        rest_.remove_prefix(key.size());
        return integer<int>();
    }

  private:
    template <typename T>
    T failed() {
        failed_ = true;
        return T{};
    }
    double real_of(std::string_view text) {
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
            return failed<double>();
        return value;
    }

    std::string_view rest_;
    bool failed_ = false;
};

SolverSettings solver_of(Words& words) {
    SolverSettings settings;
    const auto kind = solver_named(words.next().value_or(""));
    if (!kind) words.fail();
    settings.kind = kind.value_or(settings.kind);
    settings.updates = words.setting("updates=");
    settings.steps = words.setting("steps=");
    settings.substeps = words.setting("substeps=");
    return settings;
}

BallId ball_of(Words& words) {
    return BallId{words.integer<std::uint32_t>()};
}

CapsuleId capsule_of(Words& words) {
    return CapsuleId{words.integer<std::uint32_t>()};
}

Side side_of(Words& words) {
    const auto word = words.next();
    for (std::size_t side = 0; side < std::size(side_names); ++side)
        if (word == side_names[side]) return static_cast<Side>(side);
    words.fail();
    return Side::both;
}

Command add_ball_of(Words& words) {
    BallSpec spec;
    spec.kind = words.integer<ClassIndex>();
    spec.position = words.point();
    spec.velocity = words.point();
    spec.radius = words.optional_real("r=");
    spec.mass = words.optional_real("m=");
    spec.restitution = words.optional_real("e=");
    return AddBall{spec};
}

Command add_edge_of(Words& words) {
    AddCapsule add;
    add.material = words.integer<ClassIndex>();
    add.shape.start = words.point();
    add.shape.end = words.point();
    add.shape.radius = words.real();
    add.side = side_of(words);
    return add;
}

Command gravity_of(Words& words) {
    if (words.rest() != "off") return SetGravity{words.point()};
    words.next();
    return SetGravity{};
}

/// None: there is no such command. Wrong numbers make `words` fail.
std::optional<Command> command_of(Words& words) {
    const std::string_view what = words.next().value_or("");
    // Arguments in braces are evaluated from left to right.
    if (what == "strike") return Strike{ball_of(words), words.point()};
    if (what == "hold-ball") return HoldBall{ball_of(words), words.point()};
    if (what == "drop-ball") return DropBall{ball_of(words)};
    if (what == "hold-edge") return HoldCapsule{capsule_of(words), words.point(), words.point()};
    if (what == "drop-edge") return DropCapsule{capsule_of(words)};
    if (what == "place-ball") return PlaceBall{ball_of(words), words.point()};
    if (what == "place-edge") return PlaceCapsule{capsule_of(words), words.point(), words.point()};
    if (what == "add-ball") return add_ball_of(words);
    if (what == "remove-ball") return RemoveBall{ball_of(words)};
    if (what == "add-edge") return add_edge_of(words);
    if (what == "remove-edge") return RemoveCapsule{capsule_of(words)};
    if (what == "gravity") return gravity_of(words);
    if (what == "solver") return SetSolver{solver_of(words)};
    return std::nullopt;
}

class ReplayReader {
  public:
    std::variant<Replay, ReplayError> read(std::string_view text) {
        for (int line = 1; !text.empty(); ++line) {
            const std::size_t end = text.find('\n');
            if (end == std::string_view::npos) return ReplayError{line, "the line is cut off"};
            if (auto wrong = statement(line, text.substr(0, end))) return ReplayError{line, *wrong};
            text.remove_prefix(end + 1);
            last_line_ = line;
        }
        if (auto wrong = incomplete()) return ReplayError{last_line_, *wrong};
        return std::move(replay_);
    }

  private:
    using Wrong = std::optional<std::string>;

    Wrong statement(int line, std::string_view text) {
        if (line == 1)
            return text == "carom replay 1" ? Wrong{} : "this is not a carom replay of version 1";
        Words words(text);
        const std::string_view keyword = words.next().value_or("");
        if (keyword == "level") return level(words.rest());
        if (keyword == "set") {
            replay_.overrides.emplace_back(words.rest());
            return std::nullopt;
        }
        if (keyword == "hash") {
            replay_.level_hash = words.integer<std::uint64_t>(16);
            has_hash_ = true;
        } else if (keyword == "solver") {
            replay_.solver = solver_of(words);
            has_solver_ = true;
        } else if (keyword == "rate") {
            replay_.rate = words.real();
            has_rate_ = replay_.rate > 0.0;
        } else if (keyword == "seed") {
            replay_.seed = words.integer<std::uint64_t>();
            has_seed_ = true;
        } else if (keyword == "at") {
            if (auto wrong = timed_command(words)) return wrong;
        } else if (keyword == "mark") {
            const auto tick = words.integer<std::uint64_t>();
            replay_.marks.push_back({tick, words.integer<std::uint64_t>(16)});
        } else if (keyword == "end") {
            replay_.end = replay_.stands = words.integer<std::uint64_t>();
            has_end_ = true;
        } else if (keyword == "stands") {
            replay_.stands = words.integer<std::uint64_t>();
        } else {
            return fmt::format("there is no statement '{}'", keyword);
        }
        return words.done() ? Wrong{} : fmt::format("'{}' is not complete or not right", keyword);
    }

    Wrong level(std::string_view name) {
        if (name.empty()) return "the level has no name";
        replay_.level = name;
        return std::nullopt;
    }

    Wrong timed_command(Words& words) {
        const auto tick = words.integer<std::uint64_t>();
        if (!replay_.commands.empty() && tick < replay_.commands.back().tick)
            return "the ticks go back";
        const auto command = command_of(words);
        if (!command) return "there is no such command";
        replay_.commands.push_back({tick, *command});
        return std::nullopt;
    }

    Wrong incomplete() const {
        if (last_line_ == 0) return "the file is empty";
        if (replay_.level.empty()) return "'level' is missing";
        if (!has_hash_) return "'hash' is missing";
        if (!has_solver_) return "'solver' is missing";
        if (!has_rate_) return "'rate' is missing, or not positive";
        if (!has_seed_) return "'seed' is missing";
        if (!has_end_) return "'end' is missing: the file is cut off";
        if (replay_.stands > replay_.end) return "'stands' lies after 'end'";
        if (!replay_.commands.empty() && replay_.commands.back().tick > replay_.end)
            return "there are commands after 'end'";
        return std::nullopt;
    }

    Replay replay_;
    int last_line_ = 0;
    bool has_hash_ = false;
    bool has_solver_ = false;
    bool has_rate_ = false;
    bool has_seed_ = false;
    bool has_end_ = false;
};

}  // namespace

std::variant<Replay, ReplayError> read_replay(std::string_view text) {
    return ReplayReader{}.read(text);
}

}  // namespace carom

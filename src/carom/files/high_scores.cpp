#include "carom/files/high_scores.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "carom/files/files.h"
#include "carom/files/user_folders.h"

namespace carom {
namespace {

constexpr std::string_view first_line = "carom high scores 1";

struct Line {
    std::string_view table;
    HighScore score;
};

std::string_view next_word(std::string_view& text) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return word;
}

std::string_view next_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

bool are_initials(std::string_view text) {
    return text.size() == 3 && std::ranges::all_of(text, [](char c) {
               return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
           });
}

std::optional<Line> line_of(std::string_view text) {
    Line line;
    line.table = next_word(text);
    const std::string_view score = next_word(text);
    const std::string_view initials = next_word(text);
    const char* const end = score.data() + score.size();
    const auto [stop, fault] = std::from_chars(score.data(), end, line.score.score);
    const bool is_sound = fault == std::errc{} && stop == end && line.score.score >= 0;
    if (line.table.empty() || !is_sound || !are_initials(initials) || !text.empty())
        return std::nullopt;
    line.score.initials = std::string(initials);
    return line;
}

std::optional<std::string> high_scores_path() {
    const auto folder = data_folder();
    if (!folder) return std::nullopt;
    return *folder + "/high-scores";
}

}  // namespace

bool HighScores::takes(std::int64_t score) const {
    return score > 0 && most > 0 && (lines.size() < most || score > lines.back().score);
}

void HighScores::add(const HighScore& score) {
    const auto after = std::ranges::find_if(
        lines, [&](const HighScore& other) { return other.score < score.score; });
    lines.insert(after, score);
    if (lines.size() > most) lines.resize(most);
}

HighScores with_house_scores(HighScores kept, std::int64_t replay) {
    struct Share {
        const char* initials;
        std::int64_t percent;
    };
    // People of the ladder (game/ai/opponents.h), the least first: in a short list it can be
    // beaten.
    constexpr Share house[] = {{"IDA", 10}, {"REX", 20}, {"MAR", 40}, {"OTT", 60}, {"VIV", 100}};
    std::size_t free = kept.most;
    for (const Share& share : house) {
        const std::int64_t score = replay / 100 * share.percent;
        if (free == 0 || score <= 0) break;
        --free;
        kept.add({share.initials, score});
    }
    return kept;
}

HighScoresText read_high_scores(std::string_view text, std::string_view table, std::size_t most,
                                std::string_view file) {
    HighScoresText result;
    result.scores.most = most;
    if (text.empty()) return result;
    if (next_line(text) != first_line) {
        result.problem = fmt::format(
            "{} is no file of high scores: it is left as it is, and no score is kept", file);
        return result;
    }
    for (int number = 2; !text.empty(); ++number) {
        const auto line = line_of(next_line(text));
        if (!line) {
            result.problem = fmt::format(
                "{}:{}: this is no score: mend the line, or no score is kept", file, number);
            return result;
        }
        if (line->table == table) result.scores.add(line->score);
    }
    return result;
}

std::string with_high_scores(std::string_view text, std::string_view table,
                             const HighScores& scores) {
    std::string result(first_line);
    result += '\n';
    next_line(text);
    while (!text.empty()) {
        const std::string_view line = next_line(text);
        std::string_view rest = line;
        if (next_word(rest) != table) result += fmt::format("{}\n", line);
    }
    for (const HighScore& score : scores.lines)
        result += fmt::format("{} {} {}\n", table, score.score, score.initials);
    return result;
}

HighScoresText load_high_scores(std::string_view table, std::size_t most) {
    HighScoresText none;
    none.scores.most = most;
    const auto path = high_scores_path();
    std::error_code ignored;
    if (!path || !std::filesystem::exists(*path, ignored)) return none;
    const FileText file = read_file(*path);
    if (!file.text) {
        none.problem = file.error;
        return none;
    }
    return read_high_scores(*file.text, table, most, *path);
}

HighScoresText keep_high_score(std::string_view table, std::size_t most, const HighScore& score) {
    const auto path = high_scores_path();
    std::optional<std::string> problem =
        path ? make_folder(*data_folder())
             : fmt::format("there is no place for high scores: {}", no_folder_reason());
    std::optional<FileLock> lock;
    if (!problem) lock.emplace(*path + ".lock", FileLock::Wait::a_while);
    if (lock && !lock->is_held()) problem = lock->error();
    HighScoresText kept = load_high_scores(table, most);
    kept.scores.add(score);
    if (!kept.problem) kept.problem = problem;
    if (kept.problem) return kept;
    const FileText file = read_file(*path);
    kept.problem = write_file_atomically(
        *path, with_high_scores(file.text.value_or(""), table, kept.scores), Access::owner);
    return kept;
}

int load_stars(const std::string& level_path) {
    const HighScoresText kept = load_high_scores("stars/" + high_scores_name(level_path), 1);
    return kept.scores.lines.empty() ? 0 : static_cast<int>(kept.scores.lines.front().score);
}

std::optional<std::string> keep_stars(const std::string& level_path, int stars) {
    if (stars <= load_stars(level_path)) return std::nullopt;
    return keep_high_score("stars/" + high_scores_name(level_path), 1, {"---", stars}).problem;
}

std::string high_scores_name(std::string_view level_path) {
    std::string name = std::filesystem::path(level_path).stem().string();
    std::ranges::replace_if(
        name, [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
    return name.empty() ? "table" : name;
}

}  // namespace carom

#include "carom/files/pool_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <vector>

#include "carom/files/files.h"
#include "carom/files/user_folders.h"

namespace carom {
namespace {

constexpr std::string_view record_format = "carom pool record 1";

std::vector<std::string_view> split(std::string_view text, char at) {
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(at), text.size());
        parts.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

template <typename Number>
bool read_number(std::string_view text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() && number >= Number{};
}

struct Count {
    std::string_view word;
    std::uint64_t PoolRecord::*number;
};
constexpr std::array counts{Count{"shots", &PoolRecord::shots},
                            Count{"pots", &PoolRecord::pots},
                            Count{"attempts", &PoolRecord::attempts},
                            Count{"made", &PoolRecord::made},
                            Count{"safeties", &PoolRecord::safeties},
                            Count{"fouls", &PoolRecord::fouls},
                            Count{"turns", &PoolRecord::turns},
                            Count{"best-run", &PoolRecord::best_run},
                            Count{"breaks-and-runs", &PoolRecord::breaks_and_runs}};

// How the file calls an AI player: "2", or "nell" of the ladder.
std::string word_of(int opponent) {
    if (!is_of_ladder(opponent)) return fmt::format("{}", opponent);
    std::string word(ai_player(opponent).name);
    for (char& c : word)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return word;
}

bool read_results(const std::vector<std::string_view>& words, PoolRecord& record) {
    auto& results = words[0] == "opponent" ? record.frames : record.matches;
    for (int opponent = 1; opponent <= most_opponent; ++opponent) {
        if (word_of(opponent) != words[1]) continue;
        PoolRecord::Results& of_one = results[static_cast<std::size_t>(opponent - 1)];
        return read_number(words[2], of_one.won) && read_number(words[3], of_one.lost);
    }
    return false;
}

bool read_line(std::string_view line, PoolRecord& record) {
    const std::vector<std::string_view> words = split(line, ' ');
    if (words.size() == 4 && (words[0] == "opponent" || words[0] == "match"))
        return read_results(words, record);
    if (words.size() != 2) return false;
    const auto count = std::ranges::find(counts, words[0], &Count::word);
    if (count != counts.end()) return read_number(words[1], record.*count->number);
    return words[0] == "seconds" && read_number(words[1], record.seconds) && record.seconds < 1e12;
}

void add(std::array<PoolRecord::Results, most_opponent>& results,
         const std::array<PoolRecord::Results, most_opponent>& more) {
    for (std::size_t i = 0; i < results.size(); ++i) {
        results[i].won += more[i].won;
        results[i].lost += more[i].lost;
    }
}

std::optional<std::string> pool_record_path() {
    const auto folder = data_folder();
    if (!folder) return std::nullopt;
    return *folder + "/pool-record";
}

}  // namespace

void add(PoolRecord& record, const PoolRecord& more) {
    const std::uint64_t best = std::max(record.best_run, more.best_run);
    for (const Count& count : counts)
        record.*count.number += more.*count.number;
    record.best_run = best;
    record.seconds += more.seconds;
    add(record.frames, more.frames);
    add(record.matches, more.matches);
}

std::size_t rungs_climbed(const PoolRecord& record) {
    std::size_t climbed = 0;
    for (const LadderRung& rung : ladder()) {
        if (record.matches[static_cast<std::size_t>(rung.opponent - 1)].won == 0) break;
        ++climbed;
    }
    return climbed;
}

PoolRecordText read_pool_record(std::string_view text, std::string_view file) {
    PoolRecordText result;
    if (text.empty()) return result;
    const std::vector<std::string_view> lines = split(text, '\n');
    if (lines.front() != record_format) {
        result.problem =
            fmt::format("{} is no record of pool: it is left as it is, and nothing is kept", file);
        return result;
    }
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (read_line(lines[i], result.record)) continue;
        result.problem = fmt::format(
            "{}:{}: this is no figure of pool: mend the line, or nothing is kept", file, i + 1);
        return result;
    }
    return result;
}

std::string text_of(const PoolRecord& record) {
    std::string text = fmt::format("{}\n", record_format);
    for (const Count& count : counts)
        text += fmt::format("{} {}\n", count.word, record.*count.number);
    text += fmt::format("seconds {:.0f}\n", record.seconds);
    for (int opponent = 1; opponent <= most_opponent; ++opponent) {
        const auto i = static_cast<std::size_t>(opponent - 1);
        const auto add_line = [&](std::string_view word, const PoolRecord::Results& results) {
            if (results == PoolRecord::Results{}) return;
            text +=
                fmt::format("{} {} {} {}\n", word, word_of(opponent), results.won, results.lost);
        };
        add_line("opponent", record.frames[i]);
        add_line("match", record.matches[i]);
    }
    return text;
}

PoolRecordText load_pool_record() {
    const auto path = pool_record_path();
    std::error_code ignored;
    if (!path || !std::filesystem::exists(*path, ignored)) return {};
    const FileText file = read_file(*path);
    if (!file.text) return {{}, file.error};
    return read_pool_record(*file.text, *path);
}

PoolRecordText keep_pool_record(const PoolRecord& more) {
    const auto path = pool_record_path();
    if (!path)
        return {more,
                fmt::format("there is no place for a record of pool: {}", no_folder_reason())};
    if (auto problem = make_folder(*data_folder())) return {more, std::move(problem)};
    const FileLock lock(*path + ".lock", FileLock::Wait::a_while);
    if (!lock.is_held()) return {more, lock.error()};
    PoolRecordText kept = load_pool_record();
    add(kept.record, more);
    if (!kept.problem)
        kept.problem = write_file_atomically(*path, text_of(kept.record), Access::owner);
    return kept;
}

}  // namespace carom

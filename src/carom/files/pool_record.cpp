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

bool read_line(std::string_view line, PoolRecord& record) {
    const std::vector<std::string_view> words = split(line, ' ');
    if (words.size() == 4 && words[0] == "opponent") {
        std::size_t skill = 0;
        if (!read_number(words[1], skill) || skill < 1 || skill > record.opponents.size())
            return false;
        PoolRecord::Frames& frames = record.opponents[skill - 1];
        return read_number(words[2], frames.won) && read_number(words[3], frames.lost);
    }
    if (words.size() != 2) return false;
    if (words[0] == "shots") return read_number(words[1], record.shots);
    if (words[0] == "pots") return read_number(words[1], record.pots);
    if (words[0] == "safeties") return read_number(words[1], record.safeties);
    if (words[0] == "fouls") return read_number(words[1], record.fouls);
    if (words[0] == "best-run") return read_number(words[1], record.best_run);
    return words[0] == "seconds" && read_number(words[1], record.seconds) && record.seconds < 1e12;
}

std::optional<std::string> pool_record_path() {
    const auto folder = data_folder();
    if (!folder) return std::nullopt;
    return *folder + "/pool-record";
}

}  // namespace

void add(PoolRecord& record, const PoolRecord& more) {
    record.shots += more.shots;
    record.pots += more.pots;
    record.safeties += more.safeties;
    record.fouls += more.fouls;
    record.best_run = std::max(record.best_run, more.best_run);
    record.seconds += more.seconds;
    for (std::size_t i = 0; i < record.opponents.size(); ++i) {
        record.opponents[i].won += more.opponents[i].won;
        record.opponents[i].lost += more.opponents[i].lost;
    }
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
    std::string text =
        fmt::format("{}\nshots {}\npots {}\nsafeties {}\nfouls {}\nbest-run {}\nseconds {:.0f}\n",
                    record_format, record.shots, record.pots, record.safeties, record.fouls,
                    record.best_run, record.seconds);
    for (std::size_t i = 0; i < record.opponents.size(); ++i)
        text += fmt::format("opponent {} {} {}\n", i + 1, record.opponents[i].won,
                            record.opponents[i].lost);
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
    if (!path) return {more, "there is no place for a record of pool: HOME is not set"};
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

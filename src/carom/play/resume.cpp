#include "carom/play/resume.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "carom/files/files.h"
#include "carom/files/user_folders.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view ending = ".resume";
constexpr std::string_view left_ending = ".left";
constexpr std::size_t most_files = 20;
/// About a day of dragging; a longer file is not carom's.
constexpr std::size_t most_session_bytes = std::size_t{256} << 20;

std::uint64_t hash_of(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325ull;  // FNV-1a
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    return hash;
}

// With room for what `begin` and `put_aside` append, and for locks and temporary files.
std::string stem_of(std::string_view level) {
    constexpr std::size_t longest = 200;  // bytes
    return fmt::format("{}-{:016x}", fs::path(level).stem().string().substr(0, longest),
                       hash_of(level));
}

std::string lock_of(const std::string& path) {
    return path + ".lock";
}

/// Whether a process is playing the game of this file.
bool is_running(const std::string& path) {
    return FileLock(lock_of(path), FileLock::Wait::no).is_held_elsewhere();
}

std::int64_t saved_at(const std::string& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 ? status.st_mtim.tv_sec : 0;
}

/// Files of games that were left or that nobody plays any more, newest first, then by name.
/// `level`: only of this level; empty: of all.
std::vector<std::string> left_behind(const std::string& folder, std::string_view level = {}) {
    std::vector<std::pair<std::int64_t, std::string>> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string path = entry.path().string();
        const std::string name = entry.path().filename().string();
        if (!level.empty() && !name.starts_with(stem_of(level))) continue;
        if (path.ends_with(left_ending) || (path.ends_with(ending) && !is_running(path)))
            found.emplace_back(-saved_at(path), path);
    }
    std::ranges::sort(found);
    std::vector<std::string> paths;
    for (auto& [age, path] : found)
        paths.push_back(std::move(path));
    return paths;
}

}  // namespace

std::vector<InterruptedGame> interrupted_games(const std::string& folder, std::string_view level) {
    std::vector<InterruptedGame> games;
    for (const std::string& path : left_behind(folder, level)) {
        const FileText read = read_file(path, most_session_bytes);
        if (!read.text) continue;
        auto replay = read_replay(*read.text);
        auto* good = std::get_if<Replay>(&replay);
        if (good && (level.empty() || good->level == level))
            games.push_back({path, std::move(*good), saved_at(path), path.ends_with(left_ending)});
    }
    return games;
}

std::vector<std::string> unreadable_games(const std::string& folder, std::string_view level) {
    std::vector<std::string> games;
    for (const std::string& path : left_behind(folder, level)) {
        const FileText read = read_file(path, most_session_bytes);
        if (!read.text) {
            games.push_back(read.error);
            continue;
        }
        const auto replay = read_replay(*read.text);
        if (const auto* const bad = std::get_if<ReplayError>(&replay))
            games.push_back(fmt::format("{}, line {}: {}", path, bad->line, bad->message));
    }
    return games;
}

ResumeFile::ResumeFile(std::string folder, std::string_view level)
    : folder_(std::move(folder)), stem_(fmt::format("{}/{}", folder_, stem_of(level))) {}

std::optional<std::string> ResumeFile::save(const Replay& replay) {
    if (folder_.empty()) return std::nullopt;
    if (auto problem = begin()) return problem;
    auto problem = write_file_atomically(path_, replay_text(replay), Access::owner);
    is_written_ = is_written_ || !problem;
    return problem;
}

// Before the first save: finds a name that no other game has, and locks it.
std::optional<std::string> ResumeFile::begin() {
    if (lock_) return std::nullopt;
    if (auto problem = make_folder(folder_)) return problem;
    const std::vector<std::string> old = left_behind(folder_);
    for (std::size_t i = most_files - 1; i < old.size(); ++i)
        ::unlink(old[i].c_str());
    for (int number = 1;; ++number) {
        path_ = fmt::format("{}-{}{}", stem_, number, ending);
        FileLock lock(lock_of(path_), FileLock::Wait::no);
        if (!lock.is_held() && !lock.is_held_elsewhere()) return lock.error();
        std::error_code error;
        if (!lock.is_held() || fs::exists(path_, error)) continue;
        lock_ = std::move(lock);
        return std::nullopt;
    }
}

void ResumeFile::remove() {
    if (is_written_) ::unlink(path_.c_str());
    is_written_ = false;
    lock_.reset();
}

bool ResumeFile::put_aside() {
    if (!is_written_) return false;
    is_written_ = false;
    const std::string stem = path_.substr(0, path_.size() - ending.size());
    std::error_code error;
    for (int number = 0;; ++number) {
        const std::string name = fmt::format("{}-{}{}", stem, number, left_ending);
        if (!fs::exists(name, error)) return ::rename(path_.c_str(), name.c_str()) == 0;
    }
}

void forget(const InterruptedGame& game) {
    ::unlink(game.file.c_str());
}

std::optional<std::string> resume_folder() {
    const auto folder = state_folder();
    if (!folder) return std::nullopt;
    return *folder + "/cut-off";
}

}  // namespace carom

#include "carom/files/guest.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include "carom/files/confinement.h"
#include "carom/files/level_files.h"
#include "carom/files/user_folders.h"

namespace carom {
namespace {

constexpr rlim_t most_bytes_in_a_file = rlim_t{16} << 20;

// Variables that would lead to other folders.
constexpr const char* ignored[] = {"CAROM_LEVELS",  "TERMINFO",      "TERMINFO_DIRS",
                                   "TERMCAP",       "TERMPATH",      "XDG_CONFIG_HOME",
                                   "XDG_DATA_HOME", "XDG_STATE_HOME"};
// What terminals and locales need, as Debian has it.
constexpr const char* system_folders[] = {"/etc/terminfo", "/lib", "/usr/lib", "/usr/share"};

// The session's lock; none: the guest has all of them.
std::variant<FileLock, std::string> lock_session(const std::string& folder,
                                                 const GuestOptions& guest) {
    for (int number = 1; number <= guest.most_sessions; ++number) {
        FileLock lock(fmt::format("{}/session-{}.lock", folder, number), FileLock::Wait::no);
        if (lock.is_held()) return lock;
        if (!lock.is_held_elsewhere()) return lock.error();
    }
    return fmt::format("{} already plays in {} session{}: end one of them first", guest.name,
                       guest.most_sessions, guest.most_sessions == 1 ? "" : "s");
}

}  // namespace

bool is_guest_name(const std::string& name) {
    const auto is_allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    };
    return !name.empty() && name.size() <= 32 && name.front() != '-' &&
           std::ranges::all_of(name, is_allowed);
}

std::variant<FileLock, std::string> become_guest(const GuestOptions& guest) {
    for (const char* const variable : ignored)
        ::unsetenv(variable);
    const auto data = data_folder();
    if (!data) return fmt::format("there is no folder for guests: {}", no_folder_reason());
    const std::string folder = *data + "/guests/" + guest.name;
    const std::string levels = folder + "/levels";
    ::umask(0077);
    if (auto problem = make_folder(levels)) return *problem;
    auto session = lock_session(folder, guest);
    if (std::holds_alternative<std::string>(session)) return session;

    const rlimit size{.rlim_cur = most_bytes_in_a_file, .rlim_max = most_bytes_in_a_file};
    ::setrlimit(RLIMIT_FSIZE, &size);
    ::setenv("HOME", folder.c_str(), 1);
    for (const char* const variable : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME"})
        ::setenv(variable, folder.c_str(), 1);
    if (::chdir(levels.c_str()) != 0)
        return fmt::format("cannot enter '{}': {}", levels, std::strerror(errno));

    std::vector<std::string> readable(std::begin(system_folders), std::end(system_folders));
    if (const auto shipped = shipped_levels_folder()) readable.push_back(*shipped);
    // Without Landlock, what remains is that a guest can name no file.
    static_cast<void>(confine_files(readable, {folder}));
    return session;
}

std::optional<std::string> remove_oldest(const std::string& folder, std::string_view extension,
                                         std::size_t most) {
    namespace fs = std::filesystem;
    std::vector<std::pair<fs::file_time_type, std::string>> saved;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (entry.path().extension() == extension)
            saved.emplace_back(entry.last_write_time(error), entry.path().filename().string());
    std::ranges::sort(saved);
    std::optional<std::string> removed;
    for (std::size_t i = 0; i + most < saved.size(); ++i) {
        ::unlink((folder + "/" + saved[i].second).c_str());
        removed = saved[i].second;
    }
    return removed;
}

}  // namespace carom

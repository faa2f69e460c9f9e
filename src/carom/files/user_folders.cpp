#include "carom/files/user_folders.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace carom {
namespace {

std::optional<std::string> folder(const char* variable, const char* below_home) {
    const char* base = std::getenv(variable);
    if (base && base[0] == '/') return std::string(base) + "/carom";
    const char* home = std::getenv("HOME");
    if (home && home[0] == '/') return std::string(home) + below_home + "/carom";
    return std::nullopt;
}

}  // namespace

std::optional<std::string> configuration_folder() {
    return folder("XDG_CONFIG_HOME", "/.config");
}

std::optional<std::string> data_folder() {
    return folder("XDG_DATA_HOME", "/.local/share");
}

std::optional<std::string> state_folder() {
    return folder("XDG_STATE_HOME", "/.local/state");
}

std::string no_folder_reason() {
    const char* const home = std::getenv("HOME");
    if (!home || home[0] == '\0') return "HOME is not set";
    return fmt::format("HOME is '{}', which is no absolute path", home);
}

std::optional<std::string> make_folder(const std::string& path) {
    for (std::size_t slash = path.find('/', 1);; slash = path.find('/', slash + 1)) {
        const std::string part = path.substr(0, slash);
        if (::mkdir(part.c_str(), 0700) != 0 && errno != EEXIST)
            return fmt::format("cannot make '{}': {}", part, std::strerror(errno));
        if (slash == std::string::npos) return std::nullopt;
    }
}

}  // namespace carom

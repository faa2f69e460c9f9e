#include "carom/files/confinement.h"

#if __has_include(<linux/landlock.h>)

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace carom {
namespace {

constexpr std::uint64_t reading = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t writing = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_MAKE_REG |
                                  LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
                                  LANDLOCK_ACCESS_FS_REMOVE_DIR;
// What no folder is given.
constexpr std::uint64_t refused = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
                                  LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
                                  LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;

// False: the rule could not be added. A folder that does not exist needs none.
bool allow(int rules, const std::string& folder, std::uint64_t access) {
    landlock_path_beneath_attr rule{};
    rule.allowed_access = access;
    rule.parent_fd = ::open(folder.c_str(), O_PATH | O_CLOEXEC);
    if (rule.parent_fd < 0) return true;
    const bool is_added =
        ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0;
    ::close(rule.parent_fd);
    return is_added;
}

}  // namespace

bool confine_files(const std::vector<std::string>& readable,
                   const std::vector<std::string>& writable) {
    landlock_ruleset_attr handled{};
    handled.handled_access_fs = reading | writing | refused;
    const auto rules = static_cast<int>(
        ::syscall(SYS_landlock_create_ruleset, &handled, sizeof handled.handled_access_fs, 0));
    if (rules < 0) return false;
    bool is_confined = true;
    for (const std::string& folder : readable)
        is_confined = is_confined && allow(rules, folder, reading);
    for (const std::string& folder : writable)
        is_confined = is_confined && allow(rules, folder, reading | writing);
    is_confined = is_confined && ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                  ::syscall(SYS_landlock_restrict_self, rules, 0) == 0;
    ::close(rules);
    return is_confined;
}

}  // namespace carom

#else

namespace carom {

bool confine_files(const std::vector<std::string>&, const std::vector<std::string>&) {
    return false;
}

}  // namespace carom

#endif

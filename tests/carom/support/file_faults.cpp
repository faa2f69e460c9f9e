#include "carom/support/file_faults.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

namespace {

carom::test::FileFault fault = carom::test::FileFault::none;
int fault_at = 0;
int calls = 0;

bool is_to_fail() {
    using enum carom::test::FileFault;
    if (++calls != fault_at || fault == none) return false;
    if (fault == death) ::_exit(9);
    errno = ENOSPC;
    return true;
}

}  // namespace

namespace carom::test {

void set_file_fault(FileFault kind, int number) {
    fault = kind;
    fault_at = number;
    calls = 0;
}

int file_calls() {
    return calls;
}

}  // namespace carom::test

// These replace the C library's functions in this program.
extern "C" ssize_t write(int file, const void* bytes, size_t length) {
    if (fault != carom::test::FileFault::none && calls + 1 == fault_at && length > 1) {
        const long put = syscall(SYS_write, file, bytes, length / 2);
        static_cast<void>(put);
    }
    if (is_to_fail()) return -1;
    return syscall(SYS_write, file, bytes, length);
}

extern "C" int fchmod(int file, mode_t mode) noexcept {
    return is_to_fail() ? -1 : static_cast<int>(syscall(SYS_fchmod, file, mode));
}

extern "C" int fsync(int file) {
    return is_to_fail() ? -1 : static_cast<int>(syscall(SYS_fsync, file));
}

extern "C" int rename(const char* from, const char* to) noexcept {
    return is_to_fail() ? -1
                        : static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

extern "C" int mkostemps(char* name, int ending, int flags) {
    using Function = int (*)(char*, int, int);
    static const auto original = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "mkostemps"));
    return is_to_fail() ? -1 : original(name, ending, flags);
}

extern "C" int mkdir(const char* path, mode_t mode) noexcept {
    return is_to_fail() ? -1 : static_cast<int>(syscall(SYS_mkdirat, AT_FDCWD, path, mode));
}

extern "C" int flock(int file, int operation) noexcept {
    return is_to_fail() ? -1 : static_cast<int>(syscall(SYS_flock, file, operation));
}

extern "C" int unlink(const char* path) noexcept {
    return is_to_fail() ? -1 : static_cast<int>(syscall(SYS_unlinkat, AT_FDCWD, path, 0));
}

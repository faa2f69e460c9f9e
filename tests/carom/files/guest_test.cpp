#include "carom/files/guest.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "carom/files/confinement.h"
#include "carom/files/user_folders.h"
#include "carom/support/process.h"

using namespace carom;
using carom::test::TemporaryFolder;

namespace {

// The exit code of a process that does this and nothing else.
int in_a_process(const std::function<int()>& run) {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) ::_exit(run());
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

bool can_open(const std::string& path, int flags) {
    const int file = ::open(path.c_str(), flags | O_CLOEXEC, 0600);
    if (file >= 0) ::close(file);
    return file >= 0;
}

}  // namespace

TEST_CASE("a guest's name cannot lead to another folder") {
    for (const char* const good : {"anna", "a", "0", "anna-2", "_x"})
        CHECK(is_guest_name(good));
    for (const char* const bad :
         {"", ".", "..", "../x", "a/b", "-x", "Anna", "a b", "a\nb", "\xc3"})
        CHECK_FALSE(is_guest_name(bad));
    CHECK(is_guest_name(std::string(32, 'a')));
    CHECK_FALSE(is_guest_name(std::string(33, 'a')));
}

TEST_CASE("a guest's files are below its own folder, whatever the environment names") {
    const TemporaryFolder home;
    const std::string folder = home.path(".local/share/carom/guests/anna");
    const auto result = in_a_process([&] {
        ::setenv("HOME", home.path().c_str(), 1);
        ::setenv("XDG_DATA_HOME", "/tmp", 1);
        ::setenv("CAROM_LEVELS", "/", 1);
        const auto session = become_guest({.name = "anna"});
        if (!std::holds_alternative<FileLock>(session)) return 1;
        for (const auto& mine : {configuration_folder(), data_folder(), state_folder()})
            if (mine != folder + "/carom") return 2;
        if (std::filesystem::current_path() != folder + "/levels") return 3;
        return ::getenv("CAROM_LEVELS") == nullptr ? 0 : 4;
    });
    CHECK(result == 0);
    struct stat status {};
    REQUIRE(::stat(folder.c_str(), &status) == 0);
    CHECK((status.st_mode & 0777) == 0700);
}

TEST_CASE("a guest has a number of sessions, and one that is killed frees its place") {
    const TemporaryFolder home;
    const auto result = in_a_process([&] {
        ::setenv("HOME", home.path().c_str(), 1);
        const GuestOptions anna{.name = "anna", .most_sessions = 1};
        const std::string before = home.path();
        if (in_a_process([&] { return become_guest(anna).index() == 0 ? 0 : 1; }) != 0) return 1;
        // That one ended without removing its lock.
        const pid_t child = ::fork();
        if (child == 0) {
            const auto session = become_guest(anna);
            ::pause();
        }
        const std::string lock = before + "/.local/share/carom/guests/anna/session-1.lock";
        for (int i = 0; i < 500 && !FileLock(lock, FileLock::Wait::no).is_held_elsewhere(); ++i)
            ::usleep(10'000);
        const auto second = become_guest(anna);
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const auto* problem = std::get_if<std::string>(&second);
        if (!problem || *problem != "anna already plays in 1 session: end one of them first")
            return 2;
        return become_guest(anna).index() == 0 ? 0 : 3;
    });
    CHECK(result == 0);
}

TEST_CASE("the system lets a guest's process open nothing outside of its folders") {
    const TemporaryFolder folder;
    const std::string outside = folder.file("outside", "secret");
    for (const char* const name : {"read", "write"})
        std::filesystem::create_directory(folder.path(name));
    const std::string readable = folder.file("read/a", "a");
    REQUIRE(::symlink("../outside", folder.path("write/link").c_str()) == 0);
    const int result = in_a_process([&] {
        if (!confine_files({folder.path("read"), "/none"}, {folder.path("write")})) return 77;
        if (!can_open(readable, O_RDONLY) || can_open(readable, O_WRONLY)) return 1;
        if (can_open(folder.path("read/new"), O_WRONLY | O_CREAT)) return 2;
        if (!can_open(folder.path("write/new"), O_RDWR | O_CREAT)) return 3;
        if (::rename(folder.path("write/new").c_str(), folder.path("write/b").c_str())) return 4;
        if (can_open(outside, O_RDONLY) || can_open(folder.path("write/link"), O_RDONLY)) return 5;
        if (can_open(folder.path("new"), O_WRONLY | O_CREAT)) return 6;
        if (::symlink("/etc/passwd", folder.path("write/link2").c_str()) == 0) return 7;
        ::execl("/bin/true", "true", nullptr);
        return errno == EACCES ? 0 : 8;
    });
    if (result == 77) {
        MESSAGE("skipped: this system has no Landlock");
        return;
    }
    CHECK(result == 0);
}

TEST_CASE("the oldest of a guest's levels gives way to a new one") {
    const TemporaryFolder folder;
    int age = 5000;
    for (const char* const name : {"c.level", "a.level", "b.level", "other"}) {
        const std::string path = folder.file(name, "");
        const timespec then[2] = {{age, 0}, {age, 0}};
        ::utimensat(AT_FDCWD, path.c_str(), then, 0);
        age += 1000;
    }
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    CHECK(remove_oldest(".", ".level", 3) == std::nullopt);
    CHECK(remove_oldest(".", ".level", 2) == "c.level");
    CHECK(remove_oldest(".", ".level", 0) == "b.level");
    std::filesystem::current_path(before);
    CHECK(folder.names() == std::vector<std::string>{"other"});
}

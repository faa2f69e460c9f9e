#include "carom/files/files.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "carom/support/file_faults.h"
#include "carom/support/process.h"

using namespace carom;
using carom::test::content;
using carom::test::file_calls;
using carom::test::FileFault;
using carom::test::set_file_fault;
using carom::test::TemporaryFolder;

TEST_CASE("a file is read whole, up to a limit") {
    const TemporaryFolder folder;
    const std::string path = folder.file("a", std::string("zero\0byte", 9));
    CHECK(*read_file(path).text == std::string("zero\0byte", 9));
    CHECK(read_file(path, 4).text->size() == 5);
    CHECK(*read_file("/dev/null").text == "");
}

TEST_CASE("reading errors state the reason") {
    const TemporaryFolder folder;
    CHECK_FALSE(read_file(folder.path("none")).text.has_value());
    CHECK(read_file("none").error == "cannot read 'none': No such file or directory");
    CHECK(read_file(folder.path()).error == "cannot read '" + folder.path() + "': Is a directory");
}

TEST_CASE("a file appears only when it is complete") {
    const TemporaryFolder folder;
    const std::string path = folder.file("out", "old");
    {
        OutputFile file(path);
        file.write("half of what ");
        CHECK(content(path) == "old");
        file.write("was to come");
    }
    CHECK(content(path) == "old");
    {
        OutputFile file(path);
        file.write("new");
        file.commit();
        CHECK(file.error().empty());
    }
    CHECK(content(path) == "new");
    CHECK(folder.names() == std::vector<std::string>{"out"});
}

TEST_CASE("replacing a file keeps its mode and its symbolic link") {
    const TemporaryFolder folder;
    const std::string target = folder.file("target", "old");
    ::chmod(target.c_str(), 0600);
    REQUIRE(::symlink("target", folder.path("link").c_str()) == 0);
    CHECK_FALSE(write_file_atomically(folder.path("link"), "new").has_value());
    CHECK(std::filesystem::is_symlink(folder.path("link")));
    CHECK(content(target) == "new");
    struct stat status {};
    REQUIRE(::stat(target.c_str(), &status) == 0);
    CHECK((status.st_mode & 0777) == 0600);
}

TEST_CASE("writing errors state the reason, and leave no files") {
    const TemporaryFolder folder;
    CHECK(*write_file_atomically("/nowhere/x", "text") ==
          "cannot write '/nowhere/x': No such file or directory");
    CHECK(*write_file_atomically(folder.path(), "text") ==
          "cannot write '" + folder.path() + "': Is a directory");
    CHECK(*write_file_atomically("/dev/full", "text") ==
          "cannot write '/dev/full': No space left on device");
    CHECK(folder.names().empty());
}

TEST_CASE("a long text arrives in order") {
    const TemporaryFolder folder;
    std::string expected;
    OutputFile file(folder.path("long"));
    for (int i = 0; i < 50000; ++i) {
        const std::string line = std::to_string(i) + '\n';
        file.write(line);
        expected += line;
    }
    file.commit();
    CHECK(content(folder.path("long")) == expected);
}

TEST_CASE("a temporary file that a killed process left is removed, one in use is not") {
    const TemporaryFolder folder;
    const std::string path = folder.file("out", "old");
    const std::string abandoned = folder.file("out.aaaaaa.tmp", "half");
    const std::string used = folder.file("out.bbbbbb.tmp", "half");
    folder.file("out.cccccc.tmp", "new");
    folder.file("another.aaaaaa.tmp", "half");
    constexpr std::array<timespec, 2> long_ago{timespec{1000, 0}, timespec{1000, 0}};
    for (const std::string& file : {abandoned, used, folder.path("another.aaaaaa.tmp")})
        ::utimensat(AT_FDCWD, file.c_str(), long_ago.data(), 0);
    const int writer = ::open(used.c_str(), O_RDONLY);
    REQUIRE(::flock(writer, LOCK_EX) == 0);
    CHECK_FALSE(write_file_atomically(path, "new"));
    ::close(writer);
    CHECK(folder.names() == std::vector<std::string>{"another.aaaaaa.tmp", "out", "out.bbbbbb.tmp",
                                                     "out.cccccc.tmp"});
}

TEST_CASE("a file whose name is as long as a name may be is written, a longer one fails at once") {
    const TemporaryFolder folder;
    for (const std::size_t length : {243, 244, 245, 250, 255}) {
        CAPTURE(length);
        const std::string name(length, 'x');
        CHECK_FALSE(write_file_atomically(folder.path(name), "new"));
        CHECK(content(folder.path(name)) == "new");
    }
    CHECK(folder.names().size() == 5);
    const OutputFile longer(folder.path(std::string(256, 'x')));
    CHECK(longer.error().ends_with("File name too long"));
    CHECK(folder.names().size() == 5);
}

TEST_CASE("a file that is to be kept is not replaced, also if two are written at once") {
    const TemporaryFolder folder;
    const std::string path = folder.path("out");
    {
        OutputFile first(path, Access::everybody, Existing::kept);
        OutputFile second(path, Access::everybody, Existing::kept);
        first.write("first");
        second.write("second");
        first.commit();
        second.commit();
        CHECK(first.error().empty());
        CHECK(second.error() == "cannot write '" + path + "': File exists");
    }
    CHECK(write_file_atomically(path, "third", Access::everybody, Existing::kept));
    CHECK(content(path) == "first");
    CHECK(folder.names() == std::vector<std::string>{"out"});
}

TEST_CASE("only its owner may read a player's file, whatever the umask, and a temporary file") {
    const TemporaryFolder folder;
    const mode_t before = ::umask(0);
    const auto permissions = [&](const std::string& path) {
        struct stat status {};
        CHECK(::stat(path.c_str(), &status) == 0);
        return status.st_mode & 0777;
    };
    CHECK_FALSE(write_file_atomically(folder.path("scores"), "1", Access::owner));
    CHECK(permissions(folder.path("scores")) == 0600);
    CHECK_FALSE(write_file_atomically(folder.path("level"), "1"));
    CHECK(permissions(folder.path("level")) == 0666);
    const std::string open_to_all = folder.file("preferences", "old");
    ::chmod(open_to_all.c_str(), 0664);
    CHECK_FALSE(write_file_atomically(open_to_all, "1", Access::owner));
    CHECK(permissions(open_to_all) == 0600);
    ::umask(0027);
    {
        OutputFile file(folder.path("report"));
        for (const std::string& name : folder.names())
            if (name.ends_with(".tmp")) CHECK(permissions(folder.path(name)) == 0600);
        file.commit();
    }
    CHECK(permissions(folder.path("report")) == 0640);
    ::umask(before);
}

TEST_CASE("whatever fails while a file is replaced, the old or the new one is there, whole") {
    const std::string old_text(200'000, 'o');
    const std::string new_text(300'000, 'n');
    set_file_fault(FileFault::none, 0);
    {
        const TemporaryFolder folder;
        CHECK_FALSE(write_file_atomically(folder.path("out"), new_text));
    }
    const int calls = file_calls();
    REQUIRE(calls >= 5);
    for (int number = 1; number <= calls; ++number) {
        CAPTURE(number);
        const TemporaryFolder folder;
        const std::string path = folder.file("out", old_text);
        set_file_fault(FileFault::full_disk, number);
        const auto error = write_file_atomically(path, new_text);
        set_file_fault(FileFault::none, 0);
        // The second call locks the temporary file, which not every file system can. The last one
        // syncs the folder: the file is there already.
        CHECK(error.has_value() == (number != 2 && number < calls));
        CHECK(content(path) == (error ? old_text : new_text));
        CHECK(folder.names() == std::vector<std::string>{"out"});
    }
    for (int number = 1; number <= calls; ++number) {
        CAPTURE(number);
        const TemporaryFolder folder;
        const std::string path = folder.file("out", old_text);
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            set_file_fault(FileFault::death, number);
            static_cast<void>(write_file_atomically(path, new_text));
            ::_exit(0);
        }
        int status = 0;
        REQUIRE(::waitpid(child, &status, 0) == child);
        CHECK(WEXITSTATUS(status) == 9);
        const std::string found = content(path);
        CHECK((found == old_text || found == new_text));
    }
}

TEST_CASE("a lock has one holder, and ends with its process") {
    const TemporaryFolder folder;
    const std::string path = folder.path("lock");
    {
        const FileLock lock(path, FileLock::Wait::no);
        CHECK(lock.is_held());
        const FileLock second(path, FileLock::Wait::no);
        CHECK_FALSE(second.is_held());
        CHECK(second.is_held_elsewhere());
        CHECK(second.error() == "cannot lock '" + path + "': another process uses it");
    }
    CHECK(folder.names().empty());
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        const FileLock lock(path, FileLock::Wait::no);
        ::_exit(lock.is_held() ? 0 : 1);
    }
    siginfo_t info{};
    REQUIRE(::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT) == 0);
    CHECK(folder.names() == std::vector<std::string>{"lock"});
    CHECK(FileLock(path, FileLock::Wait::no).is_held());  // although the process is a zombie
    ::waitpid(child, nullptr, 0);
    const FileLock nowhere("/proc/lock", FileLock::Wait::a_while);
    CHECK_FALSE(nowhere.is_held());
    CHECK_FALSE(nowhere.is_held_elsewhere());
}

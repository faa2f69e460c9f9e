#include "carom/play/file_watcher.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

using namespace carom;
namespace fs = std::filesystem;

namespace {

/// A folder that is deleted at the end of the test.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("carom-watch-" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    std::string file(const char* name) const { return (path / name).string(); }
};

void write(const std::string& path, const std::string& text) {
    std::ofstream(path) << text;
}

}  // namespace

TEST_CASE("saving a file with other content is reported once") {
    const Folder folder;
    write(folder.file("a"), "one");
    write(folder.file("b"), "two");
    FileWatcher watch({folder.file("a"), folder.file("b")});
    CHECK_FALSE(watch.has_changed());
    write(folder.file("b"), "three");
    CHECK(watch.has_changed());
    CHECK_FALSE(watch.has_changed());
}

TEST_CASE("saving unchanged content is no change") {
    const Folder folder;
    write(folder.file("a"), "one");
    FileWatcher watch({folder.file("a")});
    fs::last_write_time(folder.file("a"), fs::file_time_type::clock::now() + std::chrono::hours(1));
    CHECK_FALSE(watch.has_changed());
}

TEST_CASE("an editor that renames a new file over the old one is noticed") {
    const Folder folder;
    write(folder.file("a"), "one");
    FileWatcher watch({folder.file("a")});
    write(folder.file("new"), "ONE");  // of equal size
    fs::rename(folder.file("new"), folder.file("a"));
    CHECK(watch.has_changed());
}

TEST_CASE("a file that vanishes for a moment is waited for") {
    const Folder folder;
    write(folder.file("a"), "one");
    FileWatcher watch({folder.file("a")});
    fs::remove(folder.file("a"));
    CHECK_FALSE(watch.has_changed());
    write(folder.file("a"), "one more");
    CHECK(watch.has_changed());
}

TEST_CASE("a file that did not exist is noticed when it appears") {
    const Folder folder;
    FileWatcher watch({folder.file("a")});
    CHECK_FALSE(watch.has_changed());
    write(folder.file("a"), "one");
    CHECK(watch.has_changed());
}

#include "carom/files/files.h"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "carom/support/process.h"

using namespace carom;
using carom::test::content;
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

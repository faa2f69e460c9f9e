#include "carom/files/output_clash.h"

#include <doctest/doctest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "carom/support/process.h"

using namespace carom;
using namespace carom::test;

TEST_CASE("two outputs that are one file clash, however their paths are spelt") {
    const TemporaryFolder folder;
    std::filesystem::create_directory_symlink(folder.path(), folder.path("again"));
    const std::string path = folder.path("out");
    const auto clash = [](const std::string& a, const std::string& b) {
        return clash_of_outputs(std::array{a, b}, {}).has_value();
    };
    // Before the file exists, and then.
    for (int i = 0; i < 2; ++i) {
        CHECK(clash(path, path));
        CHECK(clash(path, folder.path("./out")));
        CHECK(clash(path, folder.path("again/out")));
        CHECK_FALSE(clash(path, folder.path("out2")));
        CHECK_FALSE(clash("", ""));
        CHECK_FALSE(clash(path, "-"));
        folder.file("out", "text");
    }
    CHECK(clash("-", "-"));
    CHECK(clash("no-such-file", "./no-such-file"));
    std::filesystem::create_hard_link(path, folder.path("linked"));
    CHECK(clash(path, folder.path("linked")));
}

TEST_CASE("no output replaces what is read") {
    const TemporaryFolder folder;
    const std::string parts = folder.file("parts.level", "ball a at=0,0\n");
    const std::string level = folder.file("top.level",
                                          "carom 1 \"Top\"\n"
                                          "include \"parts.level\"\n");
    const std::string commands = folder.file("push.txt", "at 1 gravity 0,-1\n");
    const std::string recording = folder.path("game.replay");
    REQUIRE(run_carom({"run", level, "--ticks", "9", "--record", recording}).exit_code == 0);
    std::filesystem::create_symlink("top.level", folder.path("link.level"));
    const std::string link = folder.path("link.level");
    const std::string same = folder.path("./top.level");
    const std::vector<std::string> calls[] = {
        {"run", level, "--ticks", "9", "--record", level},
        {"run", level, "--ticks", "9", "--trace", same},
        {"run", link, "--ticks", "9", "--events", level},
        {"run", level, "--ticks", "9", "--report", link},
        {"run", level, "--ticks", "9", "--report", parts},
        {"run", level, "--ticks", "9", "--commands", commands, "--curves", commands},
        {"run", recording, "--trace", recording},
        {"measure", level, "--time", "0.1", "--csv", level},
        {"measure", recording, "--json", recording},
        {"compare", level, "--solvers", "swept,event", "--time", "0.1", "--json", same},
        {"picture", level, "--output", level},
        {"play", level, "--record", same},
        {"play", level, "--cast", link},
        {"replay", recording, "--cast", recording},
    };
    const auto texts = [&] {
        return content(level) + content(parts) + content(commands) + content(recording);
    };
    const std::string before = texts();
    for (const std::vector<std::string>& call : calls) {
        CAPTURE(call.front());
        CAPTURE(call.back());
        const Finished finished = run_carom(call);
        CAPTURE(finished.err);
        CHECK(finished.exit_code == 2);
        CHECK(finished.err.starts_with("carom: error: '"));
        CHECK(has(finished.err, "is read, and the output would replace it: name another file"));
        CHECK(texts() == before);
    }
    // A name of its own is free, though the level's name begins with it.
    CHECK(run_carom({"run", level, "--ticks", "9", "--trace", level + ".csv"}).exit_code == 0);
}

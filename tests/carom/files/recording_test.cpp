#include "carom/files/recording.h"

#include <doctest/doctest.h>
#include <fmt/core.h>
#include <signal.h>
#include <sys/wait.h>

#include <string>

#include "carom/support/at_home.h"
#include "carom/support/process.h"
#include "physics/version.h"
#include "support/terminal_program.h"

using namespace carom::test;

namespace {

const char* const level =
    "carom 1 \"Two balls\"\n"
    "include \"walls.txt\"\n"
    "ball a at=10,10 v=7,3\n"
    "ball b at=20,15 v=-5,4\n";

/// A folder with a level and its include.
struct Folder : TemporaryFolder {
    std::string level_file = file("two.level", level);
    std::string walls = file("walls.txt", "edge r=1  0,0  40,0  40,30  0,30  close\n");

    std::string record(const std::vector<std::string>& options) const {
        std::vector<std::string> arguments{"run",      level_file, "--record", path("a.replay"),
                                           "--solver", "swept"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        REQUIRE(run_carom(arguments).exit_code == 0);
        return content(path("a.replay"));
    }
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    REQUIRE(at != std::string::npos);
    return text.replace(at, what.size(), by);
}

}  // namespace

TEST_CASE("a recorded run verifies, without the level's files") {
    const Folder folder;
    folder.record({"--ticks", "300", "--seed", "9", "--rate", "100", "--set", "use gravity 0,-5"});
    ::unlink(folder.level_file.c_str());
    ::unlink(folder.walls.c_str());
    const Finished verified = run_carom({"verify", folder.path("a.replay")});
    CHECK(verified.exit_code == 0);
    CHECK(has(verified.out, "the same: 300 ticks (3 s), 0 commands, 4 fingerprints"));
    CHECK(verified.err.empty());
}

TEST_CASE("verify names the interval of ticks that contains the first difference") {
    const Folder folder;
    const std::string text = folder.record({"--ticks", "300"});
    const auto verify = [&](const std::string& changed) {
        return run_carom({"verify", folder.file("b.replay", changed)});
    };
    const std::size_t mark = text.find("\nmark 240 ") + 10;
    Finished verified = verify(text.substr(0, mark) + "0123456789abcdef" + text.substr(mark + 16));
    CHECK(verified.exit_code == 1);
    CHECK(has(verified.out, "the first tick that differs is one of 121 to 240"));
    CHECK(has(verified.out, "and was 0123456789abcdef"));

    verified = verify(replaced(text, "\nmark 120", "\nat 30 strike 0 1,1\nmark 120"));
    CHECK(verified.exit_code == 1);
    CHECK(has(verified.out, "the first tick that differs is one of 1 to 120"));

    verified = verify(replaced(text, "\nmark 120", "\nat 30 strike 7 1,1\nmark 120"));
    CHECK(verified.exit_code == 1);
    CHECK(has(verified.out, "it differs at tick 30: there is no ball 7"));

    verified = verify(replaced(replaced(text, "program ", "program 9"), "\nmark 120",
                               "\nat 30 strike 0 1,1\nmark 120"));
    CHECK(verified.exit_code == 1);
    CHECK(has(verified.out, "it was recorded by carom 9"));
}

TEST_CASE("verify distinguishes a change of the physics from a difference") {
    const Folder folder;
    const std::string text =
        replaced(folder.record({"--ticks", "300"}),
                 fmt::format("physics {}", carom::physics_version), "physics 99");
    // Equal bits are equal under any version.
    CHECK(run_carom({"verify", folder.file("b.replay", text)}).exit_code == 0);
    const std::string struck = replaced(text, "\nmark 120", "\nat 30 strike 0 1,1\nmark 120");
    const Finished verified = run_carom({"verify", folder.file("c.replay", struck)});
    CHECK(verified.exit_code == 2);
    CHECK(has(verified.err, fmt::format("was recorded under physics 99; this is physics {}",
                                        carom::physics_version)));
    CHECK(verified.out.empty());
}

TEST_CASE("games of an older carom verify with the fingerprint they were marked with") {
    const std::string samples = CAROM_SOURCE_DIR "/tests/carom/play/samples/";
    CHECK(content(samples + "balls.replay").starts_with("carom replay 2\n"));
    const Finished same = run_carom({"verify", samples + "balls.replay"});
    CHECK(same.exit_code == 0);
    CHECK(has(same.out, ": the same: "));
    // Since physics 3 a flipper recoils from its stop; since physics 5 balls under `swept` pay for
    // the height to which others carry them.
    for (const char* const unfinished : {"three-bumpers.resume", "galton.resume"}) {
        CHECK(content(samples + unfinished).starts_with("carom replay 2\n"));
        const Finished other = run_carom({"verify", samples + unfinished});
        CHECK(other.exit_code == 2);
        CHECK(has(other.err, fmt::format("was recorded under physics 1; this is physics {}",
                                         carom::physics_version)));
    }
}

TEST_CASE("an incomplete recording is reported with its line and a remedy") {
    const Folder folder;
    const std::string text = folder.record({"--ticks", "10"});
    struct Row {
        std::string text;
        std::string told;
    };
    const Row table[] = {
        {text.substr(0, text.size() - 4), ": error: the recording is cut off here"},
        {replaced(text, "replay 3", "replay 7"),
         "b.replay:1:1: error: the recording is of version 7, and this carom reads versions 2 and "
         "3"},
        {replaced(text, "v=7,3", "v=7,4"), "error: the level in it has been changed: its hash is"},
        {replaced(text, "|ball a", "|bell a"),
         "error: the level in it does not load: two.level:3:"},
        {replaced(text, "solver swept", "solver magic"), "'solver' is not complete or not right"},
        {level, "b.replay:1:1: error: this is not a recording of carom"},
        {std::string("\0\xff\n", 3), "b.replay:1:1: error: this is not a recording of carom"},
    };
    for (const Row& row : table) {
        CAPTURE(row.told);
        const std::string file = folder.file("b.replay", row.text);
        for (const char* command : {"verify", "replay"}) {
            const Finished finished = run_carom({command, file});
            CHECK(finished.exit_code == 2);
            CHECK(has(finished.err, row.told));
            CHECK(has(finished.err, "      = "));
            CHECK(finished.out.empty());
        }
    }
    const Finished missing = run_carom({"verify", folder.path("nowhere")});
    CHECK(missing.exit_code == 2);
    CHECK(has(missing.err, "cannot read"));
}

TEST_CASE("a game is recorded, even if it is terminated, and can be watched") {
    const Folder folder;
    const std::string file = folder.path("game.replay");
    int ending = 0;
    SUBCASE("quit") {
        ending = 0;
    }
    SUBCASE("terminated") {
        ending = SIGTERM;
    }
    SUBCASE("hung up") {
        ending = SIGHUP;
    }
    {
        TerminalProgram game(
            {CAROM_BINARY_DIR "/carom", "play", folder.level_file, "--paused", "--record", file},
            at_home(folder));
        REQUIRE(game.wait_for_text("tick 0"));
        game.send("g>");
        REQUIRE(game.wait_for_text("tick 120"));
        game.send("s.");
        REQUIRE(game.wait_for_text("tick 121"));
        CHECK(folder.names().size() < 6);  // no recording yet
        if (ending == 0)
            game.send("q");
        else
            game.signal(ending);
        REQUIRE(game.wait_for_end());
        CHECK(game.what_is_left_dirty().empty());
    }
    const Finished verified = run_carom({"verify", file});
    CHECK(verified.exit_code == 0);
    CHECK(has(verified.out, "121 ticks"));
    CHECK(has(verified.out, "2 commands"));
    const std::string text = content(file);
    CHECK(has(text, "\nlevel two.level\n"));
    CHECK_FALSE(has(text, folder.path()));  // no path of the player's folders

    TerminalProgram watcher({CAROM_BINARY_DIR "/carom", "replay", file, "--paused"},
                            at_home(folder));
    REQUIRE(watcher.wait_for_text("recording"));
    watcher.send(">");
    REQUIRE(watcher.wait_for_text("tick 120"));
    CHECK(has(watcher.screen().text(), "gravity"));
    watcher.send(">");
    CHECK(watcher.wait_for_text("recording ends here"));
    watcher.send("q");
    REQUIRE(watcher.wait_for_end());
}

TEST_CASE("a recording that disagrees with its replay is reported") {
    const Folder folder;
    const std::string text = folder.record({"--ticks", "300"});
    const std::string file =
        folder.file("b.replay", replaced(text, "\nmark 120", "\nat 30 strike 0 1,1\nmark 120"));
    TerminalProgram watcher({CAROM_BINARY_DIR "/carom", "replay", file, "--paused"},
                            at_home(folder));
    REQUIRE(watcher.wait_for_text("recording"));
    watcher.send(">> ");
    CHECK(watcher.wait_for_text("at tick 120 the fingerprint differs"));
    watcher.send("q");
    REQUIRE(watcher.wait_for_end());
}

TEST_CASE("a recording that cannot be written is reported before the game, and no file is lost") {
    const Folder folder;
    for (const std::string& place :
         {folder.path(), std::string("/proc/a.replay"), std::string("-")}) {
        const Finished finished = run_carom({"play", folder.level_file, "--record", place});
        CHECK(finished.exit_code == 2);
        CHECK(has(finished.err, "carom: error: "));
    }
    const std::string precious = folder.file("old.replay", "precious");
    CHECK(run_carom({"run", "nowhere", "--record", precious}).exit_code == 2);
    CHECK(content(precious) == "precious");
}

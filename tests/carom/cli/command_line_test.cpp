#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "carom/support/process.h"

using namespace carom::test;

namespace {

const char* const ramp =
    "carom 1 \"One ball, one ramp\"\n"
    "use gravity 0,-9.81\n"
    "material wood e=0.8\n"
    "edge wood r=1  0,0  100,0  100,80  0,80  close\n"
    "edge wood r=0.5  20,40  60,25\n"
    "ball a at=30,60 v=2,0 r=2 m=1\n";

std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

}  // namespace

TEST_CASE("wrong usage gets an error and a suggestion") {
    const TemporaryFolder folder;
    const std::string level = folder.file("ramp.level", ramp);
    struct Row {
        std::vector<std::string> arguments;
        std::string message;
    };
    const Row rows[] = {
        {{"runn", level}, "there is no command 'runn'; did you mean 'run'?"},
        {{"galton"}, "there is no command 'galton'; to play a level, write `carom play galton`"},
        {{"run"}, "LEVEL is required"},
        {{"check"}, "LEVEL is required"},
        {{"run", level, level}, "is one argument too many"},
        {{"run", level, "--slover", "swept"},
         "there is no option '--slover'; did you mean '--solver'?"},
        {{"run", level, "--solver", "swpt"}, "there is no solver 'swpt'; did you mean 'swept'?"},
        {{"run", level, "--solver", "xyz"}, "there is no solver 'xyz'; there are discrete, "},
        {{"run", level, "--solver"}, "--solver needs a value"},
        {{"run", level, "--time", "1", "--time", "2"}, "--time may be given only once"},
        {{"play", level, "--opponent", "9"},
         "--opponent must be a whole number from 1 to 4, but is '9'"},
        {{"run", level, "--time", "-1"}, "--time must be a number from 0"},
        {{"run", level, "--time", "soon"}, "but is 'soon'"},
        {{"run", level, "--time", "nan"}, "but is 'nan'"},
        {{"run", level, "--ticks", "1.5"}, "--ticks must be a whole number from 0 to"},
        {{"run", level, "--ticks", "99999999999999999999"}, "from 0 to 18446744073709551615"},
        {{"run", level, "--ticks", "1", "--time", "1"}, "--time and --ticks cannot stand together"},
        {{"run", level, "--rate", "0"}, "--rate must be a number from"},
        {{"run", level, "--seed", "-5"}, "--seed must be a whole number"},
        {{"run", level, "--report", "-", "--trace", "-"}, "two outputs cannot both go to standard"},
        {{"run", level, "--report", "x", "--trace", "x"}, "two outputs cannot both go to 'x'"},
        {{"run", level, "--report", "x", "--trace", "./x"}, "two outputs cannot both go to './x'"},
        {{"play", level, "--record", "x", "--cast", "./x"}, "two outputs cannot both go to './x'"},
        {{"play", level, "--renderer", "brialle"}, "did you mean 'braille'?"},
        {{"play", level, "--colors", "7"}, "--colors must be one of auto, mono, 8, 16, 256"},
        {{"list", "galton"}, "'galton' is one argument too many"},
        {{"run", folder.path("none.level")}, "there is no level"},
        {{"play", folder.path("none.level")}, "there is no level"},
        {{"picture", folder.path("none.level")}, "there is no level"},
        {{"run", "-"}, "a level on standard input is only for carom check"},
        {{"run", folder.path()}, "is a folder, not a level"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.message);
        const Finished finished = run_carom(row.arguments);
        CAPTURE(finished.err);
        CHECK(finished.exit_code == 2);
        CHECK(finished.out.empty());
        CHECK(finished.err.starts_with("carom: error: "));
        CHECK(has(finished.err, row.message));
    }
}

TEST_CASE("a level that cannot be found: a link to nothing, and no folder of levels") {
    const TemporaryFolder folder;
    for (const char* target : {"nothing.level", "circle.level"}) {
        const std::string link = folder.path("circle.level");
        std::filesystem::remove(link);
        std::filesystem::create_symlink(target, link);
        CHECK(has(run_carom({"run", link}).err, "circle.level' is a link that leads to no file"));
    }
    const Finished lost = run_carom({"run", "gas"}, folder.path("no-levels"));
    CHECK(lost.exit_code == 2);
    CHECK(has(lost.err, "there is no folder of levels that ship: set CAROM_LEVELS to it"));
}

TEST_CASE("help and version go to standard output") {
    CHECK(run_carom({"--version"}).out.starts_with("carom "));
    const Finished help = run_carom({"--help"});
    CHECK(help.exit_code == 0);
    CHECK(help.err.empty());
    for (const char* command : {"play", "run", "measure", "compare", "check", "list"}) {
        CAPTURE(command);
        CHECK(has(help.out, command));
        const Finished of_command = run_carom({command, "--help"});
        CHECK(of_command.exit_code == 0);
        CHECK(has(of_command.out, std::string("Usage: carom ") + command));
    }
}

TEST_CASE("a run without outputs prints a summary") {
    const TemporaryFolder folder;
    const Finished finished = run_carom({"run", folder.file("ramp.level", ramp)});
    CHECK(finished.exit_code == 0);
    CHECK(finished.err.empty());
    CHECK(has(finished.out, "10 s simulated in 1200 ticks"));
}

TEST_CASE("reports are written where they are sent and nowhere else") {
    const TemporaryFolder folder;
    const std::string level = folder.file("ramp.level", ramp);
    const Finished finished =
        run_carom({"run", level, "--ticks", "300", "--report", folder.path("report.json"),
                   "--events", folder.path("events"), "--trace", "-"});
    CHECK(finished.exit_code == 0);
    CHECK(finished.err.empty());
    CHECK(lines(finished.out) == 302);
    CHECK(has(content(folder.path("report.json")), "\"ticks\": 300,"));
    CHECK(content(folder.path("events")).starts_with("{\"t\": 2.15"));
    CHECK(folder.names() == std::vector<std::string>{"events", "ramp.level", "report.json"});
}

TEST_CASE("time is rounded to whole ticks") {
    const TemporaryFolder folder;
    const std::string level = folder.file("ramp.level", ramp);
    struct Row {
        std::vector<std::string> options;
        std::string ticks;
    };
    const Row rows[] = {
        {{"--time", "1"}, "120"},
        {{"--time", "0.999"}, "120"},
        {{"--time", "0"}, "0"},
        {{"--time", "0.004"}, "0"},
        {{"--ticks", "7"}, "7"},
        {{}, "1200"},
        {{"--time", "1", "--rate", "33.4"}, "33"},
    };
    for (const Row& row : rows) {
        std::vector<std::string> arguments{"run", level, "--report", "-"};
        arguments.insert(arguments.end(), row.options.begin(), row.options.end());
        CHECK(has(run_carom(arguments).out, "\"ticks\": " + row.ticks + ","));
    }
}

TEST_CASE("options override the level") {
    const TemporaryFolder folder;
    const std::string level = folder.file("ramp.level", ramp);
    const std::string report =
        run_carom({"run", level, "--ticks", "12", "--solver", "discrete", "--seed", "9", "--set",
                   "use gravity 0,-1.6", "--report", "-"})
            .out;
    CHECK(has(report, "\"solver\": \"discrete\""));
    CHECK(has(report, "\"seed\": 9"));
    CHECK(has(report, "\"gravity 0,-1.6\""));
}

TEST_CASE("the explanation is left out when standard output carries a report") {
    const TemporaryFolder folder;
    const std::string level = folder.file("ramp.level", ramp);
    const Finished alone = run_carom({"run", level, "--explain", "--ticks", "1"});
    CHECK(has(alone.out, "model   gravity 0,-9.81\n"));
    CHECK(has(alone.out, "solver  "));
    const Finished beside = run_carom({"run", level, "--explain", "--ticks", "1", "--report", "-"});
    CHECK(beside.out.starts_with("{"));
    CHECK(has(beside.err, "model   gravity 0,-9.81\n"));
}

TEST_CASE("a failed expectation is exit code 1") {
    const TemporaryFolder folder;
    const std::string level =
        folder.file("expect.level",
                    std::string(ramp) + "expect collisions 3 within 0\nexpect a.x 0 within 1\n");
    const Finished finished = run_carom({"run", level});
    CHECK(finished.exit_code == 1);
    CHECK(has(finished.out, "expect.level:7: holds: expect collisions 3 within 0"));
    CHECK(has(finished.err, "expect.level:8: error: expect a.x 0 within 1: it is "));
    const Finished changed = run_carom({"run", level, "--seed", "5"});
    CHECK(changed.exit_code == 0);
    CHECK(has(changed.out, "not judged"));
}

TEST_CASE("check reports all errors in every level") {
    const TemporaryFolder folder;
    const std::string good = folder.file("good.level", ramp);
    const std::string bad = folder.file(
        "bad.level", "carom 1 \"bad\"\nball a at=0,0 r=-1\nedgee r=1 0,0 1,0\nball b at=9,9\n");
    CHECK(run_carom({"check", good}).out == good + ": ok\n");
    const Finished finished = run_carom({"check", bad, good, folder.path("missing.level")});
    CHECK(finished.exit_code == 2);
    CHECK(finished.out == good + ": ok\n");
    CHECK(has(finished.err, bad + ":2:"));
    CHECK(has(finished.err, bad + ":3:1: error: "));
    CHECK(has(finished.err, "did you mean 'edge'?"));
    CHECK(has(finished.err, "there is no level"));
}

TEST_CASE("found 38: check tells editors in JSON what is wrong, and where") {
    const TemporaryFolder folder;
    const std::string good = folder.file("good.level", ramp);
    const std::string bad = folder.file("bad.level", "carom 1 \"bad\"\nedgee r=1 0,0 1,0\n");
    CHECK(run_carom({"check", good, "--format", "json"}).out == "[]\n");
    const Finished finished = run_carom({"check", bad, "missing", "--format=json"});
    CHECK(finished.exit_code == 2);
    CHECK(finished.err.empty());
    CHECK(has(finished.out,
              "bad.level\", \"line\": 2, \"column\": 1, \"length\": 5, "
              "\"severity\": \"error\", \"code\": \"unknown-statement\", "));
    CHECK(has(finished.out, "\"remedy\": \"did you mean 'edge'?\""));
    CHECK(has(finished.out, "{\"file\": \"missing\", \"severity\": \"error\", "));
    CHECK(has(run_carom({"check", bad, "--format", "xml"}).err,
              "--format must be one of text, json"));
}

TEST_CASE("a bad level does not run, and writes no output") {
    const TemporaryFolder folder;
    const std::string bad = folder.file("bad.level", "carom 1 \"bad\"\nball a at=0,0 r=-1\n");
    CHECK(run_carom({"run", bad, "--report", folder.path("report")}).exit_code == 2);
    CHECK(folder.names() == std::vector<std::string>{"bad.level"});
}

TEST_CASE("shipped levels are found by name, and listed with their titles") {
    const TemporaryFolder folder;
    folder.file("ramp.level", ramp);
    folder.file("another.level", "# no first line\n");
    folder.file("notes.txt", "not a level\n");
    CHECK(run_carom({"list"}, folder.path()).out == "another  \nramp     One ball, one ramp\n");
    CHECK(run_carom({"check", "ramp"}, folder.path()).exit_code == 0);
    CHECK(run_carom({"check", "ramp.level"}, folder.path()).exit_code == 0);
    CHECK(has(run_carom({"run", "rmap"}, folder.path()).err, "did you mean 'ramp'?"));
    CHECK(run_carom({"list"}, folder.path("nowhere")).exit_code == 2);
}

TEST_CASE("includes are found beside the level and among the shipped levels, and nowhere else") {
    const TemporaryFolder shipped;
    const TemporaryFolder folder;
    shipped.file("common.level", "carom 1 \"common\"\nball c at=9,9\n");
    folder.file("parts/deep.level", "carom 1 \"deep\"\nball d at=5,5\ninclude \"near.level\"\n");
    folder.file("parts/near.level", "carom 1 \"near\"\nball n at=-5,5\n");
    const std::string level = folder.file("main.level",
                                          "carom 1 \"main\"\ninclude \"parts/deep.level\"\n"
                                          "include \"common.level\"\n");
    const std::string report =
        run_carom({"run", level, "--ticks", "0", "--report", "-"}, shipped.path()).out;
    for (const char* name : {"\"c\"", "\"d\"", "\"n\""})
        CHECK(has(report, name));

    const std::string up =
        folder.file("parts/up.level", "carom 1 \"up\"\ninclude \"../x.level\"\n");
    CHECK(run_carom({"check", up}, shipped.path()).exit_code == 2);
}

TEST_CASE("outputs that cannot be written are exit code 2, and leave no files") {
    const TemporaryFolder folder;
    const std::string level = folder.file("ramp.level", ramp);
    for (const char* option : {"--report", "--events", "--trace"}) {
        CAPTURE(option);
        const Finished missing = run_carom({"run", level, option, folder.path("no/such/folder/x")});
        CHECK(missing.exit_code == 2);
        CHECK(has(missing.err, "cannot write"));
        const Finished full = run_carom({"run", level, "--time", "60", option, "/dev/full"});
        CHECK(full.exit_code == 2);
        CHECK(has(full.err, "No space left on device"));
    }
    CHECK(folder.names() == std::vector<std::string>{"ramp.level"});
}

TEST_CASE("names of files reach the terminal without their control characters") {
    const TemporaryFolder folder;
    const std::string level = folder.file("red\x1b[31m.level", ramp);
    const std::string broken = folder.file("broken\x1b[31m.level", "carom 1\n");
    const std::string recording = folder.path("red\x1b[31m.replay");
    CHECK(run_carom({"run", level, "--ticks", "9", "--record", recording}).exit_code == 0);
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"check", level},
             {"check", broken},
             {"run", folder.path("none\x1b[31m")},
             {"run", level, "--commands", folder.path("none\x1b[31m")},
             {"verify", recording},
             {"verify", level},
             {"new", folder.path("new\x1b[31m.level")},
             {"list", "\x1b[31m"}}) {
        CAPTURE(arguments.front());
        const Finished finished = run_carom(arguments);
        CHECK(has(finished.out + finished.err, "?[31m"));
        CHECK_FALSE(has(finished.out + finished.err, "\x1b"));
    }
}

TEST_CASE("a closed pipe ends the run silently") {
    const TemporaryFolder folder;
    const std::string level = folder.file("ramp.level", ramp);
    const Finished finished =
        run_carom_into_closed_pipe({"run", level, "--time", "1e6", "--trace", "-"}, 1000);
    CHECK(finished.exit_code == 0);
    CHECK(finished.err.empty());
}

TEST_CASE("an interrupted run exits cleanly") {
    const TemporaryFolder folder;
    const std::string level = folder.file("ramp.level", ramp);
    const Finished finished = run_carom(
        {"run", level, "--time", "1e6", "--trace", "-", "--report", folder.path("report.json")}, {},
        100000);
    CHECK(finished.exit_code == 128 + 2);
    CHECK(finished.out.ends_with("\n"));
    const std::string report = content(folder.path("report.json"));
    CHECK(report.ends_with("}\n"));
    CHECK(folder.names() == std::vector<std::string>{"ramp.level", "report.json"});
}

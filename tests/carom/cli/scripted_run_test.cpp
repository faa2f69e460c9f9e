#include <doctest/doctest.h>
#include <sys/stat.h>

#include <string>
#include <vector>

#include "carom/support/process.h"
#include "game/replay/command_script.h"
#include "physics/version.h"

using namespace carom;
using namespace carom::test;

namespace {

const char* const pushed =
    "carom 1 \"Pushed\"\n"
    "box 0,0 40,20\n"
    "edge r=0.5  30,0.5  30,19.5\n"
    "ball a at=5,10 r=1 v=1,0\n"
    "expect a.x 11.5 within 0.1 at=3s\n";

const char* const push =
    "at 0   hold-edge 4  20,0.5 20,19.5\n"
    "at 240 drop-edge 4  # lets go\n"
    "at 300 strike 0 8,0\n";

/// The report without what depends on the clock and on the file's name.
std::string essence(const std::string& report) {
    const std::size_t cost = report.find("  \"cost\"");
    const std::size_t solver = report.find("  \"solver\"");
    REQUIRE(cost != std::string::npos);
    return report.substr(solver, cost - solver) + report.substr(report.find('\n', cost));
}

struct Folder : TemporaryFolder {
    std::string level = file("pushed.level", pushed);
    std::string script = file("push.txt", push);
    std::string replay = path("a.replay");
};

}  // namespace

TEST_CASE("a script of commands runs, is recorded, and the recording runs to the same report") {
    const Folder folder;
    const Finished scripted =
        run_carom({"run", folder.level, "--time", "5", "--commands", folder.script, "--record",
                   folder.replay, "--report", "-"});
    CHECK(scripted.exit_code == 0);
    CHECK(scripted.err.empty());
    CHECK(has(scripted.out, "\"verdict\": \"fails\"") == false);
    CHECK(has(run_carom({"verify", folder.replay}).out, "the same: 600 ticks (5 s), 3 commands"));

    const Finished again = run_carom({"run", folder.replay, "--report", "-"});
    CHECK(again.exit_code == 0);
    CHECK(again.err.empty());
    CHECK(has(again.out, "\"verdict\": \"not judged\""));
    const auto until_expects = [](const std::string& text) {
        return text.substr(0, text.find("\"expects\""));
    };
    CHECK(until_expects(essence(again.out)) == until_expects(essence(scripted.out)));
    const auto fingerprint = [](const std::string& text) {
        return text.substr(text.find("\"fingerprint\""));
    };
    CHECK(fingerprint(again.out) == fingerprint(scripted.out));
    CHECK(fingerprint(again.out) !=
          fingerprint(run_carom({"run", folder.level, "--time", "5", "--report", "-"}).out));

    CHECK(has(run_carom({"run", folder.replay, "--events", "-"}).out, "\"kind\""));
    CHECK(has(run_carom({"run", folder.replay, "--time", "1", "--report", "-"}).out,
              "\"ticks\": 120,"));
    CHECK(has(run_carom({"run", folder.replay, "--solver", "event", "--report", "-"}).out,
              "\"solver\": \"event\""));
}

TEST_CASE("the report of a game has the variables of its rules") {
    const TemporaryFolder folder;
    const std::string level = folder.file("game.level",
                                          "carom 1 \"Game\"\n"
                                          "use cloth slide=0.2 roll=0.05 spin=10 g=10\n"
                                          "box 0,0 40,20\n"
                                          "ball white at=5,10\n"
                                          "cue ball=white power=0..20\n"
                                          "game shots players=2\n"
                                          "var rails of shot\n"
                                          "var made of player start=3\n"
                                          "on cue rail  rails +1\n"
                                          "on shot ends if rails=1  made +1, turn\n"
                                          "on shot judged if made=9  end\n");
    const std::string script = folder.file("shot.txt", "at 5 strike 0 0,4.5\n");
    const Finished run =
        run_carom({"run", level, "--time", "20", "--commands", script, "--report", "-"});
    CHECK(run.exit_code == 0);
    CHECK(has(run.out, "\"variables\": {\n    \"rails\": 1,\n    \"made\": [4, 3]\n  }"));
    CHECK_FALSE(
        has(run_carom({"run", "cradle", "--time", "1", "--report", "-"}).out, "\"variables\""));
}

TEST_CASE("a recording decides its level, rate, seed and commands") {
    const Folder folder;
    REQUIRE(
        run_carom({"run", folder.level, "--ticks", "240", "--record", folder.replay}).exit_code ==
        0);
    for (const std::vector<std::string>& option : {std::vector<std::string>{"--rate", "60"},
                                                   {"--seed", "1"},
                                                   {"--set", "use spin"},
                                                   {"--commands", folder.script}}) {
        std::vector<std::string> arguments{"run", folder.replay};
        arguments.insert(arguments.end(), option.begin(), option.end());
        const Finished finished = run_carom(arguments);
        CHECK(finished.exit_code == 2);
        CHECK(has(finished.err, "is a recording, which leaves no choice of " + option[0]));
    }
}

TEST_CASE("a run that departs from its recording says so") {
    const Folder folder;
    REQUIRE(
        run_carom({"run", folder.level, "--ticks", "240", "--record", folder.replay}).exit_code ==
        0);
    std::string text = content(folder.replay);
    const std::size_t mark = text.find("mark 120 ") + 9;
    text[mark] = text[mark] == '0' ? '1' : '0';
    const Finished changed = run_carom({"run", folder.file("b.replay", text)});
    CHECK(changed.exit_code == 0);
    CHECK(changed.err == "note: at tick 120 the run is no longer what was recorded\n");
    const std::string physics = "physics " + std::to_string(physics_version) + "\n";
    text.replace(text.find(physics), physics.size(), "physics 1\n");
    CHECK(has(run_carom({"run", folder.file("b.replay", text)}).err, ": it is of physics 1, and"));
}

TEST_CASE("a script that is wrong or refused is exit code 2, and leaves no files") {
    const Folder folder;
    struct Row {
        std::string script;
        std::string message;
    };
    const Row rows[] = {
        {"at 1 jump", ":1:1: error: there is no such command"},
        {"\nat 5 hold-edge 9 0,0 1,1\n", ":2:1: error: at tick 5: there is no edge 9"},
    };
    for (const Row& row : rows) {
        const Finished finished =
            run_carom({"run", folder.level, "--commands", folder.file("bad.txt", row.script),
                       "--report", folder.path("report.json")});
        CAPTURE(finished.err);
        CHECK(finished.exit_code == 2);
        CHECK(has(finished.err, "bad.txt" + row.message));
    }
    CHECK(folder.names() == std::vector<std::string>{"bad.txt", "push.txt", "pushed.level"});
    CHECK(has(run_carom({"run", folder.level, "--commands", folder.path("none")}).err,
              "cannot read"));
    CHECK(has(run_carom({"run", folder.level, "--ticks", "250", "--commands", folder.script}).err,
              "note: 1 of the commands were not due by the last tick, 250\n"));
}

TEST_CASE("a pipe that nobody writes to is refused at once") {
    const Folder folder;
    REQUIRE(::mkfifo(folder.path("pipe").c_str(), 0600) == 0);
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"run", folder.path("pipe")},
          {"check", folder.path("pipe")},
          {"run", folder.level, "--commands", folder.path("pipe")},
          {"verify", folder.path("pipe")}}) {
        const Finished finished = run_carom(arguments);
        CHECK(finished.exit_code == 2);
        CHECK(has(finished.err, "is a pipe; copy what comes out of it to a file first"));
    }
}

TEST_CASE("docs/command-line.md lists every command, as scripts take it") {
    const std::string manual = content(CAROM_SOURCE_DIR "/docs/command-line.md");
    const std::size_t begin = manual.find("\n| command | does |");
    REQUIRE(begin != std::string::npos);
    std::string script;
    for (std::size_t row = manual.find("\n| `", begin); row < manual.find("\n\n", begin);
         row = manual.find("\n| `", row + 1))
        script += "at 0 " + manual.substr(row + 4, manual.find('`', row + 4) - row - 4) + "\n";
    const auto read = read_script(script);
    REQUIRE(std::holds_alternative<CommandScript>(read));
    std::vector<bool> is_listed(std::variant_size_v<Command>);
    for (const TimedCommand& command : std::get<CommandScript>(read).commands)
        is_listed[command.command.index()] = true;
    CHECK(is_listed == std::vector<bool>(std::variant_size_v<Command>, true));
}

TEST_CASE("a run names the solvers that did its ticks, and checks what each promises") {
    const Folder folder;
    const auto run_with = [&](const std::string& commands, std::vector<std::string> more) {
        more.insert(more.begin(), {"run", folder.level, "--ticks", "20", "--solver", "event",
                                   "--commands", folder.file("solvers.txt", commands)});
        return run_carom(more).out;
    };
    // A command of tick 0 comes before anything that the first solver could do.
    CHECK(has(run_with("at 0 solver swept\n", {}), "ticks by swept substeps=1, in"));
    CHECK(has(run_with("at 0 solver swept\nat 5 solver contact\nat 9 solver swept\n", {}),
              "ticks by swept substeps=1, then contact substeps=4, in"));
    CHECK(has(run_with("at 5 solver event\n", {}), "ticks by event, in"));

    const std::string changed = run_with("at 5 solver contact\n", {"--check", "--report", "-"});
    CHECK(has(changed, "\"solver\": \"event\""));
    CHECK(has(changed, "{\"tick\": 5, \"solver\": \"contact\", \"settings\": {\"substeps\": 4}}"));
    CHECK_FALSE(
        has(run_with("at 0 solver contact\n", {"--check", "--report", "-"}), "solver_changes"));
}

#include "game/replay/command_script.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <tuple>
#include <variant>

#include "game/support/scenes.h"
#include "level/load.h"

using namespace carom;
using carom::test::busy_box;

TEST_CASE("a script of commands is read, with its comments, blanks and line ends") {
    const auto read = read_script(
        "\xef\xbb\xbf# push\r\n\n"
        "  at 0   hold-edge  2\t39.5,0 39.5,20   # to the left\r\n"
        "at 120 drop-edge 2\n"
        "at 120 solver substep updates=8");
    REQUIRE(std::holds_alternative<CommandScript>(read));
    const auto& script = std::get<CommandScript>(read);
    CHECK(script.lines == std::vector<int>{3, 4, 5});
    REQUIRE(script.commands.size() == 3);
    CHECK(script.commands[1].tick == 120);
    CHECK(std::get<command::HoldCapsule>(script.commands[0].command).end_target ==
          Vec2{39.5, 20.0});
    CHECK(std::get<command::SetSolver>(script.commands[2].command).settings ==
          SolverSettings{.kind = SolverKind::substep, .updates = 8});
    CHECK(std::get<CommandScript>(read_script("")).commands.empty());
}

TEST_CASE("a command that is wrong gets an example of it as advice") {
    std::vector<bool> has_example(std::variant_size_v<Command>);
    for (const std::string_view example : command_examples()) {
        CAPTURE(example);
        const auto read = read_script("at 3 " + std::string(example) + "\n");
        REQUIRE(std::holds_alternative<CommandScript>(read));
        has_example[std::get<CommandScript>(read).commands.front().command.index()] = true;
    }
    CHECK(has_example == std::vector<bool>(std::variant_size_v<Command>, true));
    const auto wrong = read_script("at 10 strike 3 0\n");
    REQUIRE(std::holds_alternative<ReplayError>(wrong));
    CHECK(std::get<ReplayError>(wrong).remedy == "write for example: at 120 strike 0 1.5,-2");
}

TEST_CASE("errors in a script are reported with their line") {
    struct Bad {
        std::string text;
        int line;
        std::string message;
    };
    const Bad rows[] = {
        {"drop-ball 1", 1, "a command begins with 'at' and its tick"},
        {"carom replay 3\n", 1, "a command begins with 'at' and its tick"},
        {"\n\nat noon drop-ball 1", 3, "the tick is not a whole number from 0 to 2^64 - 1"},
        {"at -1 drop-ball 1", 1, "the tick is not a whole number from 0 to 2^64 - 1"},
        {"at", 1, "the tick is not a whole number from 0 to 2^64 - 1"},
        {"at 3", 1, "there is no such command"},
        {"at 3 jump 1", 1, "there is no such command"},
        {"at 3 drop-ball", 1, "'drop-ball' is not complete or not right"},
        {"at 3 drop-ball 1 2", 1, "'drop-ball' is not complete or not right"},
        {"at 3 hold-ball 1 nan,0", 1, "'hold-ball' is not complete or not right"},
        // A word that is wrong comes before one with a key.
        {"at 3 strike 132-3,4 1,2 side=1", 1, "'strike' is not complete or not right"},
        {"at 3 strike 1 2 side=1", 1, "'strike' is not complete or not right"},
        {"at 3 solver swept updates=0", 1, "'solver' is not complete or not right"},
        {"at 3 drop-ball 1\nat 2 drop-ball 1", 2, "the ticks go back"},
    };
    for (const Bad& row : rows) {
        CAPTURE(row.text);
        const auto read = read_script(row.text);
        REQUIRE(std::holds_alternative<ReplayError>(read));
        CHECK(std::get<ReplayError>(read).line == row.line);
        CHECK(std::get<ReplayError>(read).message == row.message);
        CHECK_FALSE(std::get<ReplayError>(read).remedy.empty());
    }
}

TEST_CASE("commands are executed at their ticks, until one is refused") {
    const Scene scene = busy_box();
    World world = scene.world;
    GameState game = begin_game(scene);
    Solver solver({.kind = SolverKind::swept});
    ScriptRunner runner(std::get<CommandScript>(read_script("at 0 gravity 0,-1\n"
                                                            "at 2 gravity 0,-2\n"
                                                            "at 2 solver discrete\n"
                                                            "at 3 drop-ball 999999\n"
                                                            "at 3 gravity 0,-3\n"))
                            .commands);
    CHECK_FALSE(runner.execute_due(scene, world, game, solver));
    CHECK(world.model().gravity == Vec2{0.0, -1.0});
    solver.tick(world);
    CHECK_FALSE(runner.execute_due(scene, world, game, solver));
    CHECK(runner.remaining() == 4);
    solver.tick(world);
    CHECK_FALSE(runner.execute_due(scene, world, game, solver));
    CHECK(world.model().gravity == Vec2{0.0, -2.0});
    CHECK(solver.settings().kind == SolverKind::discrete);
    solver.tick(world);
    const auto refused = runner.execute_due(scene, world, game, solver);
    REQUIRE(refused);
    CHECK(refused->index == 3);
    CHECK(world.model().gravity == Vec2{0.0, -2.0});
}

TEST_CASE("commands wait for rest, and strike the cue ball whatever its number is by then") {
    const Scene scene = *load_level(
                             "carom 1 \"Two players\"\n"
                             "units mm\n"
                             "use cloth slide=0.2 roll=0.02 spin=10rad/s2\n"
                             "box 0,0 1400,700 r=10\n"
                             "pocket hole at=1300,350 r=60\n"
                             "ball white at=300,350 r=30 m=210g\n"
                             "cue ball=white power=0..6m/s\n"
                             "game shots players=2\n"
                             "on cue pocketed  score 1\n"
                             "on shot ends  turn\n"
                             "on shot judged if shots=3  end\n",
                             "two.level", {})
                             .scene;
    const auto play = [&](std::string_view text, std::uint64_t ticks) {
        World world = scene.world;
        GameState game = begin_game(scene);
        Solver solver({.kind = SolverKind::event});
        ScriptRunner runner(std::get<CommandScript>(read_script(text)).commands);
        std::optional<ScriptRunner::Refused> refused;
        while (!(refused = runner.execute_due(scene, world, game, solver)) &&
               world.tick() < ticks) {
            solver.tick(world);
            update_game(scene, world, game, solver.contacts());
        }
        return std::tuple(std::get<ShotsState>(game), runner.executed(), refused);
    };
    const auto [state, executed, refused] = play(
        "at rest strike cue 2,0\n"
        "at rest strike cue 0,0.2\n"
        "at rest strike cue 2,0 follow=0.1\n",
        6000);
    CHECK_FALSE(refused);
    CHECK(state.shots == 3);
    REQUIRE(executed.size() == 3);
    CHECK(executed[0].tick < executed[1].tick);
    CHECK(executed[1].tick < executed[2].tick);
    CHECK(std::get<command::Strike>(executed[0].command).ball == BallId{0});
    CHECK(std::get<command::Strike>(executed[1].command).ball == BallId{1});

    const auto late =
        std::get<2>(play("at rest strike cue 2,0\n"
                         "at rest strike cue 0,0.2\nat 3 gravity off\n",
                         6000));
    REQUIRE(late);
    CHECK(late->index == 2);
    const auto wrong = std::get<2>(play("at rest strike cue 2,0\nat 2000 strike 0 0,1\n", 6000));
    REQUIRE(wrong);
    CHECK(wrong->reason == "player 2 strikes white, ball 1");
}

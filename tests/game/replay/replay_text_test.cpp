#include "game/replay/replay_text.h"

#include <doctest/doctest.h>

#include <string>

using namespace carom;

namespace {

Replay everything() {
    Replay replay;
    replay.physics_version = 7;
    replay.fingerprint_version = 2;
    replay.level = "levels/my gas.level";
    replay.program = "0.1.0";
    replay.texts = {"carom 1 \"A\"\r\n\n|#\x01\ninclude \"b c\"", "", "\n"};
    replay.includes = {{0, 1, "b c"}, {1, 2, "d"}};
    replay.level_hash = 0x0123456789abcdefull;
    replay.solver = {.kind = SolverKind::substep, .updates = 7, .steps = 3, .substeps = 2};
    replay.rate = 1.0 / 3.0;
    replay.seed = 18446744073709551615ull;
    replay.overrides = {"use gravity 0,-1.6", "seed 4"};
    const double third = 1.0 / 3.0;
    replay.commands = {
        {0, command::Strike{BallId{3}, {third, -2e-300}}},
        {0, command::Strike{BallId{3}, {third, 1.0}, third, -0.125}},
        {12, command::HoldBall{BallId{3}, {1e22, 0.1}}},
        {40, command::DropBall{BallId{3}}},
        {50, command::HoldCapsule{CapsuleId{2}, {0.0, 0.3}, {10.0, 5.0}}},
        {50, command::DropCapsule{CapsuleId{2}}},
        {60, command::PlaceBall{BallId{1}, {0.7, 4.0}}},
        {60, command::PlaceCapsule{CapsuleId{1}, {0.7, 4.0}, {0.1, 0.2}}},
        {61, command::AddBall{{.kind = 1,
                               .position = {5.0, third},
                               .velocity = {-0.0, 1.0},
                               .radius = 0.1,
                               .mass = std::nullopt,
                               .restitution = 0.5}}},
        {62, command::RemoveBall{BallId{4}}},
        {63, command::AddCapsule{{{0.0, 1.0}, {2.0, third}, 0.5}, 2, Side::left}},
        {64, command::RemoveCapsule{CapsuleId{5}}},
        {65, command::SetGravity{Vec2{0.0, -9.81}}},
        {66, command::SetGravity{}},
        {67, command::SetSolver{{.kind = SolverKind::swept, .updates = 1}}},
        {68, command::CallShot{{PoolCall::Kind::pot, 3, 2}}},
        {68, command::CallShot{{PoolCall::Kind::push_out}}},
        {69, command::Decide{PoolChoice::return_push}},
        {70, command::RackAgain{}},
        {70, command::TimeOut{}},
        {70, command::Concede{}},
    };
    replay.marks = {{600, 0xfedcba9876543210ull}, {1200, 1}};
    replay.end = 1200;
    replay.position = 1100;
    replay.opponent = 3;
    replay.setup = {third, 2.5, -0.1, third, Aids::cloud, ShotSetup::Intent::push_out, 4};
    return replay;
}

const std::string head =
    "carom replay 2\nlevel a\nfile 0\n|x\nhash 1f\n"
    "solver swept updates=4 steps=15 substeps=1\nrate 120\nseed 7\n";

struct Bad {
    std::string text;
    int line;
    std::string message;
};

}  // namespace

TEST_CASE("a replay reads back as written, to the last bit") {
    const std::string text = replay_text(everything());
    const auto read = read_replay(text);
    REQUIRE(std::holds_alternative<Replay>(read));
    const Replay& replay = std::get<Replay>(read);
    CHECK(replay_text(replay) == text);
    CHECK(replay.program == "0.1.0");
    CHECK(replay.level == "levels/my gas.level");
    CHECK(replay.texts == everything().texts);
    CHECK(replay.includes == everything().includes);
    CHECK(replay.rate == 1.0 / 3.0);
    CHECK(replay.seed == 18446744073709551615ull);
    CHECK(replay.overrides == everything().overrides);
    CHECK(replay.marks == everything().marks);
    CHECK(replay.solver == everything().solver);
    CHECK(replay.opponent == 3);
    CHECK(replay.setup == everything().setup);
    REQUIRE(replay.commands.size() == everything().commands.size());
    CHECK(std::get<command::Strike>(replay.commands[0].command).velocity ==
          Vec2{1.0 / 3.0, -2e-300});
    CHECK(std::get<command::Strike>(replay.commands[1].command).side == 1.0 / 3.0);
    CHECK(std::get<command::Strike>(replay.commands[1].command).follow == -0.125);
    const auto& add = std::get<command::AddBall>(replay.commands[8].command).spec;
    CHECK(add.radius == 0.1);
    CHECK_FALSE(add.mass);
    CHECK(add.restitution == 0.5);
    CHECK(std::get<command::AddCapsule>(replay.commands[10].command).side == Side::left);
}

TEST_CASE("a text without commands is valid") {
    const auto read = read_replay(head + "end 0\n");
    REQUIRE(std::holds_alternative<Replay>(read));
    CHECK(std::get<Replay>(read).position == 0);
    CHECK(std::get<Replay>(read).opponent == 0);
    CHECK_FALSE(std::get<Replay>(read).setup);
}

TEST_CASE("a recording without versions is of physics 1, marked with fingerprint 1") {
    const auto read = read_replay(head + "end 1\n");
    REQUIRE(std::holds_alternative<Replay>(read));
    CHECK(std::get<Replay>(read).physics_version == 1);
    CHECK(std::get<Replay>(read).fingerprint_version == 1);
}

TEST_CASE("errors in a replay are reported with their line") {
    const std::string cut_off = "the recording is cut off here: its last line, 'end', is missing";
    const std::string no_replay = "this is not a recording of carom";
    const std::string not_right = "'at' is not complete or not right";
    const Bad table[] = {
        {"", 1, "the file is empty"},
        {"carom replay 1\n", 1,
         "the recording is of version 1, and this carom reads versions 2 and 3"},
        {"carom replay 4\nwhatever\n", 1,
         "the recording is of version 4, and this carom reads versions 2 and 3"},
        {"carom replay 2\r\n", 1, "the line ends are CR LF, which would change the level in it"},
        {"carom replay two\n", 1, "the version of this recording cannot be read"},
        {"\x7f"
         "ELF\n",
         1, no_replay},
        {"carom 1 \"A level\"\n", 1, no_replay},
        {"garbage without a line end", 1, no_replay},
        {head + "end 12", 9, cut_off},
        {head, 8, cut_off},
        {head + "at 5 strike 1 2,3\n", 9, cut_off},
        {head + "end 1\nend 2\n", 10, "there is more after 'end'"},
        {head + "end 1\n\n", 10, "there is more after 'end'"},
        {head + "|text\nend 1\n", 9, "this line of a level belongs to no 'file'"},
        {head + "file 2\nend 1\n", 9, "file 1 is missing"},
        {head + "include 0 1 b\nend 1\n", 9, "the file that this is about is missing"},
        {head + "frobnicate\nend 1\n", 9, "there is no statement 'frobnicate'"},
        {head + "at 1 jump 3\nend 1\n", 9, "there is no such command"},
        {head + "fingerprint 0\nend 1\n", 9, "there is no such version of fingerprints"},
        {head + "fingerprint 99\nend 1\n", 9,
         "the fingerprints are of version 99, and this carom knows 2"},
        {head + "physics one\nend 1\n", 9, "'physics' is not complete or not right"},
        {head + "opponent 12\nend 1\n", 9, "there is no such opponent"},
        {head + "stance 1 2 3 4 full guess 0\nend 1\n", 9, "'stance' is not complete or not right"},
        {head + "stance 1 2 3 4 full pocket\nend 1\n", 9, "'stance' is not complete or not right"},
        {head + "at 1 strike 3 4\nend 1\n", 9, not_right},
        {head + "at 1 strike 3 4,nan\nend 1\n", 9, not_right},
        {head + "at 1 strike 3 4,inf\nend 1\n", 9, not_right},
        {head + "at 1 strike 3 4,5 6\nend 1\n", 9, not_right},
        {head + "at 1 strike 99999999999 4,5\nend 1\n", 9, not_right},
        {head + "at 1 add-edge 0 0,0 1,1 1 top\nend 1\n", 9, not_right},
        {head + "at 1 solver magic updates=1 steps=1 substeps=1\nend 1\n", 9, not_right},
        {head + "at 1 solver swept updates=0 steps=1 substeps=1\nend 1\n", 9, not_right},
        {head + "at 5 drop-ball 1\nat 4 drop-ball 1\nend 9\n", 10, "the ticks go back"},
        {head + "mark 5 1\nmark 5 1\nend 9\n", 10, "the ticks go back"},
        {head + "mark 5 xyz\nend 9\n", 9, "'mark' is not complete or not right"},
        {head + "at 5 drop-ball 1\nend 4\n", 10, "there are commands after 'end'"},
        {head + "mark 5 1\nend 4\n", 10, "there are marks after 'end'"},
        {head + "mark 5 1\nend 126\n", 10,
         "'end' lies more than a second after the last fingerprint"},
        {head + "mark 5 1\nend 18446744073709551615\n", 10,
         "'end' lies more than a second after the last fingerprint"},
        {head + "rate 1e300\nmark 5 1\nend 9\n", 11, "'rate' is missing, or not in 0.001..1e9"},
        {head + "stands 5\nend 4\n", 10, "'stands' lies after 'end'"},
        {"carom replay 2\nlevel a\nfile 0\n|\nend 1\n", 5, "'hash' is missing"},
        {"carom replay 2\nlevel a\nhash 1\nend 1\n", 4, "'file 0' is missing"},
        {"carom replay 2\nlevel \nend 1\n", 2, "the level has no name"},
    };
    for (const Bad& row : table) {
        CAPTURE(row.text);
        const auto read = read_replay(row.text);
        REQUIRE(std::holds_alternative<ReplayError>(read));
        CHECK(std::get<ReplayError>(read).line == row.line);
        CHECK(std::get<ReplayError>(read).message == row.message);
        CHECK_FALSE(std::get<ReplayError>(read).remedy.empty());
    }
}

TEST_CASE("a recording that is truncated anywhere, or lacks a line, is rejected") {
    const std::string text = replay_text(everything());
    for (std::size_t bytes = 0; bytes < text.size(); ++bytes) {
        CAPTURE(bytes);
        CHECK(std::holds_alternative<ReplayError>(read_replay(text.substr(0, bytes))));
    }
}

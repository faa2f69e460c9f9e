#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "game/ai/pinball_trial.h"
#include "game/pinball/pinball.h"
#include "game/pinball/pinball_table.h"
#include "game/support/shipped.h"
#include "game/support/small_table.h"

// What the rules of a table can set as goals: lit shots, players, the replay award.
using namespace carom;
using test::SmallTable;

namespace {

std::vector<std::string> shots_of(const SmallTable& game) {
    std::vector<std::string> names;
    for (const std::uint32_t group : shots_to_make(game.scene, game.world, game.state()))
        names.push_back(game.scene.table.groups[group].name);
    return names;
}

// Loses the ball in play, and waits for the next one.
void lose_ball(SmallTable& game) {
    game.send({200, 20}, {});
    game.run(3.5);
}

}  // namespace

TEST_CASE("a rule can name one device of a group, whose rules come first") {
    SmallTable game(R"(game pinball save=0s
var first of turn
on lanes.2 enter if first=0  score 100
on lanes enter  first 1, score 1
on stand hit  reset drops.1
on pops hit  light lanes.1
)");
    game.send({100, 330}, {0.0, -0.8});
    CHECK(game.state().score == 1);
    game.send({300, 330}, {0.0, -0.8});
    CHECK(game.state().score == 2);

    SmallTable other(
        "game pinball save=0s\nvar first\non lanes enter first 1\n"
        "on lanes.2 enter if first=0 score 100\non stand hit reset drops.1\n");
    other.send({300, 330}, {0.0, -0.8});
    CHECK(other.state().score == 100);
    other.send({50, 120}, {-1.0, 0.0});
    other.send({50, 180}, {-1.0, 0.0});
    other.send({360, 120}, {1.0, 0.0}, 0.1);
    const auto side = [&](std::size_t which) {
        return other.world.capsules().side[number(other.scene.table.devices[which].capsules[0])];
    };
    CHECK(side(0) == Side::both);
    CHECK(side(1) == Side::none);
}

TEST_CASE("the shots to make are those of the first task that holds") {
    SmallTable game(R"(game pinball save=0s
var mode
on stand hit  mode 1
on pops hit  mode 2
task "POPS" for pops lanes.2 arrow if mode=1
task "REST" if mode=2
task "BANK" for drops
)");
    game.run(0.01);
    CHECK(shots_of(game) == std::vector<std::string>{"drops"});
    game.send({360, 120}, {1.0, 0.0});
    CHECK(shots_of(game) == std::vector<std::string>{"pops", "lanes.2", "arrow"});
    game.send({200, 460}, {0.0, 1.0});
    CHECK(shots_of(game).empty());
}

TEST_CASE("a shot that the task asks for is foreseen as worth more") {
    const auto foresee = [](const std::string& task) {
        SmallTable game(
            "flipper other at=300,60 length=50 r=5 key=right rest=210 up=150\n"
            "game pinball save=0s\non pops hit score 100\n" +
            task);
        game.send({200, 420}, {0.0, 1.0}, 0.001);
        const PinballSight sight(game.scene);
        return play_ahead(sight, game.scene, game.solver, {game.world, game.state()}, {}, 100,
                          false);
    };
    const Foreseen plain = foresee("");
    const Foreseen lit = foresee("task \"POPS\" for pops\n");
    const Foreseen elsewhere = foresee("task \"BANK\" for drops\n");
    CHECK(lit.gain >= plain.gain + 10.0);
    CHECK(elsewhere.gain == plain.gain);
    CHECK(lit.device == plain.device);
}

TEST_CASE("players join during the first ball, and each has a state of its own") {
    SmallTable game(R"(game pinball balls=2 save=0s players=3
var mine of player
on pops hit  score 100, mine +1
on stand hit if mine=1  score 5
on lanes enter  score 1
)");
    CHECK(may_join(game.scene, game.state()));
    game.press(Button::add_player, true);
    game.press(Button::add_player, false);
    CHECK(scores_of(game.state()).size() == 2);
    game.send({200, 460}, {0.0, 1.0});
    game.send({100, 330}, {0.0, -0.8});
    CHECK(game.state().is_lit[game.scene.table.groups[0].devices[0]] == 0);
    lose_ball(game);
    // The second player's first ball.
    CHECK(game.state().rules.player == 1);
    CHECK(game.state().ball == 1);
    CHECK(game.state().score == 0);
    game.send({360, 120}, {1.0, 0.0});
    CHECK(game.state().score == 0);
    lose_ball(game);
    CHECK(game.state().rules.player == 0);
    CHECK(game.state().ball == 2);
    CHECK(game.state().score == 101);
    CHECK_FALSE(may_join(game.scene, game.state()));
    game.press(Button::add_player, true);
    game.press(Button::add_player, false);
    CHECK(scores_of(game.state()).size() == 2);
    game.send({360, 120}, {1.0, 0.0});
    CHECK(game.state().score == 106);
    lose_ball(game);
    lose_ball(game);
    CHECK(game.state().phase == PinballState::Phase::over);
    CHECK(game.state().message.starts_with("GAME OVER  PLAYER 1 WINS"));
    // Another game begins with one player.
    game.press(Button::plunger, true);
    CHECK(scores_of(game.state()) == std::vector<std::int64_t>{0});
}

TEST_CASE("the rules of a table leave a player its buttons alone") {
    const auto answer = [](const SmallTable& game, const Command& command) {
        return refusal(game.scene, game.world, game.game, command);
    };
    const SmallTable game("game pinball\n");
    const SmallTable parts("");
    const Command changes[] = {command::SetGravity{}, command::Strike{BallId{0}, {1.0, 0.0}},
                               command::HoldBall{BallId{0}, {0.2, 0.3}},
                               command::PlaceBall{BallId{0}, {0.2, 0.2}}};
    for (const Command& change : changes) {
        CHECK(answer(game, change) == "Disabled under rules.");
        CHECK(answer(parts, change) == std::nullopt);
    }
    CHECK(answer(game, command::Press{Button::left_flipper, true}) == std::nullopt);
    CHECK(answer(game, command::Pull{0.5, false}) == std::nullopt);
}

TEST_CASE("a table without players= has no button for another player") {
    const SmallTable game("game pinball\n");
    CHECK_FALSE(has_button(game.scene, Button::add_player));
    CHECK_FALSE(may_join(game.scene, game.state()));
}

TEST_CASE("the replay award is an extra ball, once a game") {
    SmallTable game("game pinball balls=1 save=0s replay=150\non pops hit score 100\n");
    game.send({200, 460}, {0.0, 1.0});
    CHECK(game.state().extra_balls == 0);
    game.send({200, 460}, {0.0, 1.0});
    CHECK(game.state().extra_balls == 1);
    game.send({200, 460}, {0.0, 1.0});
    CHECK(game.state().extra_balls == 1);
    lose_ball(game);
    CHECK(game.state().phase == PinballState::Phase::playing);
    lose_ball(game);
    CHECK(game.state().phase == PinballState::Phase::over);
}

TEST_CASE("the message of an extra ball comes after the other message of the same shot") {
    SmallTable game("game pinball save=0s\non pops hit message \"MULTIBALL\", extraball\n");
    game.send({200, 460}, {0.0, 1.0});
    CHECK(game.state().extra_balls == 1);
    CHECK(game.state().message == "MULTIBALL");
    game.send({200, 300}, {}, 1.6);
    CHECK(game.state().message == "EXTRA BALL");
    SmallTable alone("game pinball save=0s\non pops hit extraball\n");
    alone.send({200, 460}, {0.0, 1.0});
    CHECK(alone.state().message == "EXTRA BALL");
}

TEST_CASE("a mode that fails is taken up with its count") {
    const Scene scene = test::shipped_level("three-bumpers");
    World world = scene.world;
    GameState game = begin_game(scene);
    auto& state = std::get<PinballState>(game);
    const Pinball table{scene, world, state};
    const auto hit_all = [&](std::string_view name, int times) {
        for (const DeviceGroup& group : scene.table.groups)
            for (int i = 0; group.name == name && i < times; ++i)
                apply_rules(table, group.devices[static_cast<std::size_t>(i)], RuleEvent::hit);
    };
    run_rules(table);
    hit_all("bumps", 1);  // the skill shot is over
    hit_all("west", 3);
    CHECK(task_text(scene, world, state) == "HIT THE BUMPERS: 12 MORE  0:30");
    hit_all("bumps", 3);
    world.edit_tick() += static_cast<std::uint64_t>(31.0 * world.rate());
    run_rules(table);
    CHECK(state.message == "TIME IS UP: 9 MORE NEXT TIME");
    hit_all("east", 3);
    CHECK(task_text(scene, world, state) == "HIT THE BUMPERS: 9 MORE  0:30");
}

TEST_CASE("a table asks for no shot before the rules have begun the turn") {
    SmallTable game(
        "game pinball save=0s\nvar skill\non turn begins skill 1\n"
        "task \"THE SKILL SHOT\" for lanes if skill\ntask \"HIT THE STAND\" for stand\n");
    CHECK(task_text(game.scene, game.world, game.state()).empty());
    CHECK(shots_of(game).empty());
    game.run(0.01);
    CHECK(task_text(game.scene, game.world, game.state()) == "THE SKILL SHOT");
}

TEST_CASE("a tilted table asks for no shot") {
    SmallTable game("game pinball save=0s tilt=0\ntask \"HIT THE STAND\" for stand\n");
    game.run(0.01);
    REQUIRE(shots_of(game).size() == 1);
    CHECK(task_text(game.scene, game.world, game.state()) == "HIT THE STAND");
    for (int i = 0; i < 4; ++i) {
        game.press(Button::nudge_up, true);
        game.run(0.12);
        game.press(Button::nudge_up, false);
    }
    REQUIRE(game.state().is_tilted);
    CHECK(shots_of(game).empty());
    CHECK(task_text(game.scene, game.world, game.state()) == "TILT");
}

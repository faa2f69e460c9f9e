#include "game/pinball/pinball.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "game/replay/replayer.h"
#include "game/session/session.h"
#include "game/support/small_table.h"

using namespace carom;

using Game = test::SmallTable;
using test::scene_of;
using test::small_table;

TEST_CASE("rules react to hits, entries and completed banks") {
    Game game(R"(game pinball balls=3 save=0s bonus=500
on pops hit score 100
on stand hit score 7, bonus +2
on lanes enter score 1
on lanes all multiplier +1, reset lanes
on drops hit score 10
on drops all score 1000, reset drops, light arrow
on pops hit while arrow score 5000, unlight arrow
)");
    game.send({200, 460}, {0.0, 1.0});
    CHECK(game.state().score == 100);
    game.send({360, 120}, {1.0, 0.0});
    CHECK(game.state().score == 107);
    CHECK(game.state().bonus == 2);
    game.send({100, 330}, {0.0, -0.8});
    CHECK(game.state().score == 108);
    CHECK(game.state().multiplier == 1);
    game.send({300, 330}, {0.0, -0.8});
    CHECK(game.state().score == 109);
    CHECK(game.state().multiplier == 2);
    game.send({50, 120}, {-1.0, 0.0});
    CHECK(game.state().score == 119);
    // The target is down now: the next ball passes and hits the wall.
    game.send({50, 120}, {-1.0, 0.0}, 0.03);
    CHECK(game.world.balls().position[0].x < 0.025);
    CHECK(game.state().score == 119);
    game.send({50, 180}, {-1.0, 0.0}, 0.1);
    CHECK(game.state().score == 1129);
    game.send({50, 120}, {-1.0, 0.0});
    CHECK(game.state().score == 1139);
    game.send({200, 460}, {0.0, 1.0});
    CHECK(game.state().score == 6239);
    game.send({200, 460}, {0.0, 1.0});
    CHECK(game.state().score == 6339);
}

TEST_CASE("a bank due to rise waits until no ball is in the way") {
    Game game("game pinball save=0s\non lanes enter reset drops\n");
    add_ball(game.world, {.kind = 0, .position = {0.2, 0.4}, .radius = 0.01});
    game.send({50, 120}, {-1.0, 0.0});
    game.send({50, 180}, {-1.0, 0.0});
    game.world.edit_balls().position[1] = {0.1, 0.32};
    game.world.edit_balls().velocity[1] = {0.0, -0.5};
    game.send({20, 180}, {});
    const auto side = [&](std::size_t which) {
        return game.world.capsules().side[number(game.scene.table.devices[which].capsules[0])];
    };
    CHECK(side(0) == Side::both);
    CHECK(side(1) == Side::none);
    game.send({200, 300}, {});
    CHECK(side(1) == Side::both);
}

TEST_CASE("a ball that drains early is saved, a late one ends with its bonus") {
    Game game("game pinball balls=2 save=2s bonus=500\non stand hit bonus +3, multiplier 2\n");
    // Rests on the plunger and is launched.
    game.send({390, 30.1}, {});
    CHECK(is_on_plunger(game.scene, game.world));
    game.press(Button::plunger, true);
    game.run(0.5);
    game.press(Button::plunger, false);
    game.run(0.01);
    CHECK(game.world.balls().velocity[0].y == doctest::Approx(1.5).epsilon(0.01));
    game.send({200, 30}, {0.0, -1.0}, 0.1);
    CHECK(game.state().drained == 1);
    CHECK(game.state().message == "BALL SAVED");
    REQUIRE(game.world.balls().size() == 1);
    CHECK(game.state().ball == 1);
    game.run(2.0);
    game.send({360, 120}, {1.0, 0.0});
    CHECK(game.state().bonus == 3);
    game.send({200, 30}, {0.0, -1.0}, 0.1);
    CHECK(game.world.balls().size() == 0);
    CHECK(game.state().score == 3000);
    CHECK(game.state().message == "BONUS 3,000");
    game.run(3.0);
    CHECK(game.state().ball == 2);
    REQUIRE(game.world.balls().size() == 1);
    game.run(3.0);
    game.send({200, 30}, {0.0, -1.0}, 0.1);
    CHECK(game.state().message == "NO BONUS");
    game.run(3.0);
    CHECK(game.state().phase == PinballState::Phase::over);
    CHECK(game.state().message.starts_with("GAME OVER"));
    // And another.
    game.press(Button::plunger, true);
    game.press(Button::plunger, false);
    game.run(0.1);
    CHECK(game.state().phase == PinballState::Phase::playing);
    CHECK(game.state().score == 0);
    CHECK(game.world.balls().size() == 1);
}

TEST_CASE("while the only ball lies on the plunger again, ball saver, timers and lights stand") {
    Game game(
        "game pinball save=2s\ntimer hurry 1s\non ball launch start hurry, light arrow 1s\n"
        "on hurry ends score 1\n");
    const auto plunge = [&] {
        game.press(Button::plunger, true);
        game.press(Button::plunger, false);
        game.run(0.1);
    };
    game.send({390, 30.1}, {});
    plunge();
    game.run(0.5);
    // Too weak: it is back.
    game.send({390, 30.1}, {}, 5.0);
    CHECK(game.state().score == 0);
    CHECK(game.state().save_until > game.world.tick());
    CHECK(std::ranges::count(game.state().is_lit, 1) >= 2);  // the kickback too
    const std::uint64_t stood = game.state().save_until - game.world.tick();
    CHECK(stood < 2000);
    plunge();
    CHECK(game.state().save_until - game.world.tick() > stood);
    game.send({200, 300}, {}, 1.2);
    CHECK(game.state().score == 1);
    game.send({200, 30}, {0.0, -1.0}, 0.1);
    CHECK(game.state().message == "BALL SAVED");
}

TEST_CASE("an extra ball is played before the next one, and multiball has its own ball saver") {
    Game game("game pinball balls=1 save=1s\non pops hit extraball\non stand hit multiball 3\n");
    game.send({200, 460}, {0.0, 1.0});
    CHECK(game.state().extra_balls == 1);
    game.send({360, 120}, {1.0, 0.0}, 3.0);
    CHECK(game.state().to_serve + game.world.balls().size() == 3);
    CHECK(game.state().save_until > 0);
}

TEST_CASE("nudging pushes balls, warns, and finally tilts") {
    Game game("game pinball save=0s tilt=1\non pops hit score 100\non stand hit bonus +1\n");
    game.send({360, 120}, {1.0, 0.0});
    CHECK(game.state().bonus == 1);
    game.send({200, 300}, {});
    game.press(Button::nudge_right, true);
    game.run(0.2);
    CHECK(game.world.balls().velocity[0].x == doctest::Approx(0.2).epsilon(0.05));
    CHECK(game.state().warnings == 0);
    game.press(Button::nudge_right, false);
    for (int i = 0; i < 4; ++i) {
        game.press(Button::nudge_up, true);
        game.run(0.12);
        game.press(Button::nudge_up, false);
    }
    CHECK(game.state().warnings >= 1);
    CHECK(game.state().is_tilted);
    CHECK(game.state().bonus == 0);
    game.press(Button::left_flipper, true);
    game.run(0.1);
    CHECK(game.world.flippers()[0].progress == 0.0);
    game.send({200, 460}, {0.0, 1.0});
    CHECK(game.state().score == 0);
}

TEST_CASE("a table that is tilted while the ball lies on the plunger launches it, for good") {
    Game game("game pinball balls=2 save=10s tilt=0\n");
    game.send({390, 30.1}, {});
    for (int i = 0; i < 4; ++i) {
        game.press(Button::nudge_up, true);
        game.run(0.12);
        game.press(Button::nudge_up, false);
    }
    REQUIRE(game.state().is_tilted);
    game.send({390, 30.1}, {}, 0.65);
    CHECK(game.world.balls().velocity[0].y > 0.5);
    game.send({200, 30}, {0.0, -1.0}, 0.1);
    CHECK(game.world.balls().size() == 0);
    CHECK(game.state().phase == PinballState::Phase::counting);
    CHECK(game.state().to_serve == 0);
}

TEST_CASE("a kickback returns a ball once") {
    Game game("game pinball save=0s\non pops hit light rescue\n");
    game.send({60, 80}, {0.0, -1.0});
    CHECK(game.world.balls().velocity[0].y > 1.0);
    game.send({60, 80}, {0.0, -1.0}, 0.02);
    CHECK(game.world.balls().velocity[0].y < 0.0);
}

TEST_CASE("each press of a flipper rotates the lights of rollovers") {
    Game game("game pinball save=0s\non lanes all score 1\n");
    game.send({100, 330}, {0.0, -0.8});
    const auto& lanes = game.scene.table.groups[3];
    REQUIRE(lanes.name == "lanes");
    CHECK(game.state().is_lit[lanes.devices[0]] == 1);
    game.press(Button::left_flipper, true);
    CHECK(game.state().is_lit[lanes.devices[0]] == 0);
    CHECK(game.state().is_lit[lanes.devices[1]] == 1);
}

TEST_CASE("the ball search frees a stuck ball") {
    Game game("game pinball save=0s\n");
    game.send({200, 300}, {}, 6.0);
    CHECK(game.state().searches == 1);
    CHECK(length(game.world.balls().velocity[0]) > 0.1);
}

TEST_CASE("without a game the mechanisms of a table still work") {
    Game game("");
    game.send({50, 120}, {-1.0, 0.0});
    CHECK(game.world.capsules().side[number(game.scene.table.devices[0].capsules[0])] ==
          Side::none);
    game.press(Button::left_flipper, true);
    game.run(0.1);
    CHECK(game.world.flippers()[0].progress == 1.0);
    CHECK(game.state().score == 0);
}

TEST_CASE("a plunger pulled by hand launches the ball as far as it is pulled") {
    const auto launched = [](double share, bool by_hand) {
        Game game("game pinball save=0s\n");
        game.send({390, 31}, {0.0, 0.0}, 0.01);
        game.press(Button::plunger, true);
        game.run(0.1);
        if (!by_hand) {
            game.run(0.9);
            game.press(Button::plunger, false);
            return game.world.balls().velocity[0].y;
        }
        const auto pull = [&](double to, bool lets_go) {
            const Command command = command::Pull{to, lets_go};
            REQUIRE_FALSE(refusal(game.scene, game.world, game.game, command).has_value());
            execute(game.scene, game.world, game.game, command);
        };
        pull(0.9, false);
        pull(share, false);
        game.run(0.5);  // it stays where it is held
        CHECK(game.state().pull == share);
        CHECK_FALSE(game.state().is_down[static_cast<std::size_t>(Button::plunger)]);
        pull(share, true);
        CHECK(game.state().pull == 0.0);
        CHECK(game.state().is_launched);
        return game.world.balls().velocity[0].y;
    };
    CHECK(launched(0.0, true) == doctest::Approx(0.5));
    CHECK(launched(0.25, true) == doctest::Approx(1.0));
    CHECK(launched(1.0, true) == launched(1.0, false));
}

TEST_CASE("a plunger held only in a forgotten future is released") {
    const Scene scene = scene_of(small_table + "game pinball save=0s\n");
    Session session(scene, {});
    session.step_forward();
    CHECK_FALSE(session.apply(command::Pull{0.5, false}).has_value());
    for (int i = 0; i < 5; ++i)
        session.step_forward();
    REQUIRE(session.go_to(3));
    CHECK(std::get<PinballState>(session.game()).pull == 0.5);
    CHECK_FALSE(session.apply(command::Press{Button::left_flipper, true}).has_value());
    CHECK(std::get<PinballState>(session.game()).pull == 0.0);
    CHECK(session.apply(command::Pull{1.5, false}).has_value());
    const std::string text = replay_text(record(session, "table.level", {}));
    CHECK(text.find("at 1 pull 0.5\n") != std::string::npos);
    CHECK(text.find("at 3 pull 0\n") != std::string::npos);
    const auto read = read_replay(text);
    REQUIRE(std::holds_alternative<Replay>(read));
    CHECK(replay_text(std::get<Replay>(read)) == text);
}

TEST_CASE("buttons without a device are refused") {
    Scene plain = scene_of("carom 1 \"Plain\"\nball a at=0,0\n");
    Session session(plain, {});
    CHECK(session.apply(command::Press{Button::left_flipper, true}).has_value());
    CHECK(session.apply(command::Pull{0.5, true}).has_value());
    Scene table = scene_of(small_table);
    Session pinball(table, {});
    CHECK_FALSE(pinball.apply(command::Press{Button::left_flipper, true}).has_value());
    CHECK(pinball.apply(command::Press{Button::right_flipper, true}).has_value());
    const CapsuleId flipper = table.world.flippers()[0].capsule;
    CHECK(pinball.apply(command::HoldCapsule{flipper, {}, {}}).has_value());
}

TEST_CASE("rewinding, undoing and replaying a game of pinball give the same bits") {
    const std::string rules =
        "game pinball save=2s\non pops hit score 100\non lanes enter score 3\n";
    Scene scene = scene_of(small_table + "use gravity 0,-0.793m/s2\n" + rules);
    Session session(scene, pick_solver(scene.world).settings);
    std::vector<std::uint64_t> marks;
    const auto now = [&] { return fingerprint(session.world(), session.game()); };
    for (int tick = 0; tick < 3000; ++tick) {
        if (tick % 150 == 20) session.apply(command::Press{Button::left_flipper, true});
        if (tick % 150 == 90) session.apply(command::Press{Button::left_flipper, false});
        if (tick == 700) session.apply(command::Press{Button::nudge_right, true});
        marks.push_back(now());
        session.step_forward();
    }
    const std::uint64_t end = now();
    for (const std::uint64_t tick : {2500u, 701u, 1u, 2999u}) {
        REQUIRE(session.go_to(tick));
        CHECK(now() == marks[tick]);
    }
    REQUIRE(session.go_to(3000));
    CHECK(now() == end);
    const std::string text = replay_text(record(session, "table.level", {}));
    const auto read = read_replay(text);
    REQUIRE(std::holds_alternative<Replay>(read));
    CHECK(replay_text(std::get<Replay>(read)) == text);
    auto again = scene_of(std::get<Replay>(read));
    REQUIRE(std::holds_alternative<Scene>(again));
    Replayer replayer(std::get<Replay>(read), std::get<Scene>(again));
    while (replayer.advance(1000)) {
    }
    CHECK_FALSE(replayer.failure().has_value());
    CHECK(fingerprint(replayer.session().world(), replayer.session().game()) == end);
}

TEST_CASE("a hole holds a ball, then ejects it") {
    Game game(
        "hole cellar at=300,200 toward=200,400 speed=1m/s hold=0.5s r=8\n"
        "game pinball save=0s\non cellar enter score 5\n");
    game.send({320, 200}, {-1.0, 0.0}, 0.4);
    CHECK(game.state().score == 5);
    CHECK(game.world.balls().position[0] == Vec2{0.3, 0.2});
    game.run(0.2);
    CHECK(game.world.balls().velocity[0].y > 0.8);
    CHECK(game.state().score == 5);
    CHECK(game.state().held.empty());
}

TEST_CASE("a ball in a hole is in play: meanwhile no drain ends the turn") {
    Game game(
        "hole cellar at=300,200 toward=200,400 speed=1m/s hold=0.5s r=8\n"
        "lamp locks at=320,300 at=340,300\n"
        "game pinball balls=3 save=0s bonus=10\n"
        "on cellar enter advance locks, bonus +1\non locks all multiball 3\n");
    add_ball(game.world, {.kind = game.world.balls().kind[0],
                          .position = {0.2, 0.05},
                          .radius = game.world.balls().radius[0]});
    game.send({320, 200}, {-1.0, 0.0}, 0.1);
    REQUIRE(game.state().held.size() == 1);
    game.world.edit_balls().velocity[1] = {0.0, -1.0};
    game.run(0.1);
    REQUIRE(game.state().drained == 1);
    CHECK(game.state().phase == PinballState::Phase::playing);
    CHECK(game.state().ball == 1);
    game.run(0.5);
    CHECK(game.world.balls().velocity[0].y > 0.8);
    CHECK(game.state().phase == PinballState::Phase::playing);
    // A locked ball stays locked during the next ball.
    game.send({200, 40}, {0.0, -1.0}, 0.1);
    CHECK(game.state().phase == PinballState::Phase::counting);
    game.run(3.0);
    CHECK(game.state().ball == 2);
    REQUIRE(game.world.balls().size() == 1);
    game.send({320, 200}, {-1.0, 0.0}, 0.1);
    CHECK(game.state().to_serve + game.world.balls().size() == 3);
}

TEST_CASE("a ramp moves balls to another layer, and back if they roll back") {
    Game game(
        "material rail e=0.4 layer=1\nedge rail 100,450 300,450\n"
        "ramp up 150,400 250,400 pass=up layer=1\nramp down 150,350 250,350 pass=down layer=0\n"
        "game pinball save=0s\non up enter score 1\non down enter score 10\n");
    const auto layer = [&] { return game.world.kinds()[game.world.balls().kind[0]].layer; };
    // Below the rail, on the layer where it does not exist.
    game.send({120, 430}, {0.0, 1.0});
    CHECK(game.world.balls().position[0].y > 0.46);
    game.send({200, 380}, {0.0, 1.0}, 0.035);
    CHECK(layer() == 1);
    CHECK(game.state().score == 1);
    // Bounces off the rail, and the other ramp takes it down.
    game.run(0.5);
    CHECK(game.world.balls().position[0].y < 0.4);
    CHECK(layer() == 0);
    // A ball from the wrong side is not lifted.
    game.send({200, 340}, {0.0, 1.0}, 0.02);
    CHECK(layer() == 0);
}

TEST_CASE("lamps count, shine for a time, and gate rules") {
    Game game(
        "lamp locks at=10,300 at=20,300\ngame pinball save=0s\n"
        "on pops hit unless arrow advance locks, light arrow 0.2s\n"
        "on pops hit while arrow score 7\non locks all score 100, unlight locks\n");
    game.send({200, 460}, {0.0, 1.0});
    game.send({200, 460}, {0.0, 1.0});
    CHECK(game.state().score == 7);
    game.send({200, 300}, {}, 0.2);
    game.send({200, 460}, {0.0, 1.0});
    CHECK(game.state().score == 107);
}

TEST_CASE("a bumper that is hit flashes, which is in no fingerprint") {
    Game game("game pinball save=0s\n");
    game.send({200, 460}, {0.0, 1.0}, 0.05);
    auto& state = std::get<PinballState>(game.game);
    CHECK(std::ranges::count(state.flash_until, 0u) + 1 ==
          static_cast<std::ptrdiff_t>(state.flash_until.size()));
    const std::uint64_t before = fingerprint(game.world, game.game);
    std::ranges::fill(state.flash_until, 0u);
    CHECK(fingerprint(game.world, game.game) == before);
}

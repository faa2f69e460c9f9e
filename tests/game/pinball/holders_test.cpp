#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "game/pinball/pinball.h"
#include "game/session/session.h"
#include "game/support/small_table.h"

// Parts of tables that hold balls, or that rules open: locks, posts, gates, magnets, captive balls,
// and ramps that need speed.
using namespace carom;
using test::SmallTable;

namespace {

std::uint32_t device_named(const Scene& scene, const std::string& name, std::size_t which = 0) {
    for (const DeviceGroup& group : scene.table.groups)
        if (group.name == name) return group.devices[which];
    FAIL("no such device");
    return 0;
}

bool is_lit(const SmallTable& game, const std::string& name, std::size_t which = 0) {
    return game.state().is_lit[device_named(game.scene, name, which)] != 0;
}

Side side_of(const SmallTable& game, const std::string& name) {
    const Device& device = game.scene.table.devices[device_named(game.scene, name)];
    return game.world.capsules().side[number(device.capsules[0])];
}

Vec2 at(const SmallTable& game, std::size_t ball = 0) {
    return game.world.balls().position[ball] * 1000.0;
}

// A slope, with a well at (200, 400) in which two balls lie on a post.
const std::string well =
    "use gravity 0,-1m/s2\n"
    "edge 180,284 220,284\n"  // on which a ball that is served rests
    "edge 188,380 188,470\nedge 212,380 212,470\n"
    "post stop 188,384 212,384\n"
    "lock bay at=200,395 at=200,416 r=9\n";

// A slope with a captive ball, shut in between two lips and two walls.
const std::string cell =
    "use gravity 0,-1m/s2\nkind steel r=10 m=80g e=0.9\n"
    "edge 180,284 220,284\n"  // on which the other ball rests
    "captive jail at=300,400 kind=steel\n"
    "material metal e=0.4\nedge metal 286,396 286,450 314,450 314,396\n"
    "peg metal at=291,388 r=2\npeg metal at=309,388 r=2\n";

}  // namespace

TEST_CASE("a hole that keeps its ball holds it until a rule releases it, and the table serves") {
    SmallTable game(
        "hole saucer at=100,400 toward=100,0 speed=1m/s keeps r=12\n"
        "game pinball save=0s\non saucer enter score 100\non stand hit release saucer\n"
        "on saucer all  score 1000\n");
    game.send({100, 400}, {0.0, 0.0}, 0.01);
    CHECK(game.state().score == 1100);
    CHECK(is_lit(game, "saucer"));
    CHECK_FALSE(is_in_play(game.scene, game.state(), game.world.balls().id[0]));
    // Another ball comes to the plunger, and it is still the same turn.
    game.run(1.0);
    REQUIRE(game.world.balls().size() == 2);
    CHECK(game.state().phase == PinballState::Phase::playing);
    CHECK(game.state().ball == 1);
    CHECK(at(game) == Vec2{100, 400});
    game.run(20.0);
    CHECK(at(game) == Vec2{100, 400});
    // A second ball rolls past.
    game.world.edit_balls().position[1] = Vec2{100, 425} * 0.001;
    game.world.edit_balls().velocity[1] = {0.0, -0.5};
    game.run(0.1);
    CHECK(game.state().score == 1100);
    game.world.edit_balls().position[1] = Vec2{360, 120} * 0.001;
    game.world.edit_balls().velocity[1] = {1.0, 0.0};
    game.run(0.05);
    CHECK_FALSE(is_lit(game, "saucer"));
    CHECK(is_in_play(game.scene, game.state(), game.world.balls().id[0]));
    CHECK(length(game.world.balls().velocity[0]) == doctest::Approx(1.0));
    CHECK(game.world.balls().velocity[0].y < -0.9);
}

TEST_CASE("a ball that drains while another is locked ends the turn, and the lock keeps its ball") {
    SmallTable game(
        "hole saucer at=100,400 toward=100,0 speed=1m/s keeps r=12\n"
        "game pinball save=0s balls=2\non stand hit release saucer\n");
    game.send({100, 400}, {}, 1.0);
    REQUIRE(game.world.balls().size() == 2);
    game.world.edit_balls().position[1] = Vec2{200, 20} * 0.001;
    game.run(4.0);
    CHECK(game.state().ball == 2);
    CHECK(game.world.balls().size() == 2);
    CHECK(is_lit(game, "saucer"));
    // The last ball: the game is over, and the next one begins with an empty lock.
    game.world.edit_balls().position[1] = Vec2{200, 20} * 0.001;
    game.run(4.0);
    CHECK(game.state().phase == PinballState::Phase::over);
    game.press(Button::plunger, true);
    game.run(0.5);
    CHECK(game.state().ball == 1);
    CHECK(game.world.balls().size() == 1);
    CHECK_FALSE(is_lit(game, "saucer"));
}

TEST_CASE("the turn continues if a rule releases a locked ball as the last ball drains") {
    SmallTable game(
        "hole saucer at=100,400 toward=100,0 speed=1m/s keeps r=12\n"
        "game pinball save=0s balls=2\non ball drain release saucer\n");
    game.send({100, 400}, {}, 1.0);
    REQUIRE(game.world.balls().size() == 2);
    game.world.edit_balls().position[1] = Vec2{200, 20} * 0.001;
    for (int i = 0; i < 400 && game.world.balls().size() == 2; ++i)
        game.run(0.01);
    REQUIRE(game.world.balls().size() == 1);
    CHECK(game.state().phase == PinballState::Phase::playing);
    CHECK(game.state().ball == 1);
    CHECK(is_in_play(game.scene, game.state(), game.world.balls().id[0]));
}

TEST_CASE("a hole that lifts balls ejects them on its layer") {
    SmallTable game(
        "material rail layer=1\nedge rail 0,0 400,0\n"
        "hole lift at=100,400 toward=200,400 speed=1m/s hold=0.1s layer=1 r=12\ngame pinball\n");
    game.send({100, 400}, {}, 0.3);
    const World& world = game.world;
    CHECK(world.kinds()[world.balls().kind[0]].layer == 1);
    CHECK(at(game).x > 150.0);
}

TEST_CASE("balls that come to rest on a post are locked, one after another, and it lets them go") {
    SmallTable game(well +
                    "game pinball save=0s\non bay enter score 100*lit(bay)+10\n"
                    "on bay all  score 5000, open stop 1s\n");
    CHECK(side_of(game, "stop") == Side::both);
    game.send({200, 430}, {}, 0.3);
    CHECK_FALSE(is_lit(game, "bay"));
    for (int i = 0; i < 100 && game.world.balls().size() < 2; ++i)
        game.run(0.02);
    REQUIRE(game.world.balls().size() == 2);
    CHECK(is_lit(game, "bay"));
    CHECK_FALSE(is_lit(game, "bay", 1));
    CHECK(game.state().score == 10);
    // A nudge lifts it, and it counts once.
    game.world.edit_balls().velocity[0] = {0.0, 0.25};
    game.run(1.5);
    CHECK(is_lit(game, "bay"));
    CHECK(game.state().score == 10);
    const Vec2 first = at(game, 0);
    CHECK(std::abs(first.y - 394.0) < 1.0);
    game.world.edit_balls().position[1] = Vec2{200, 450} * 0.001;
    game.world.edit_balls().velocity[1] = {};
    game.run(2.0);
    // Both were locked, and the post has opened.
    CHECK(game.state().score == 10 + 110 + 5000);
    CHECK(at(game, 0).y < 384.0);
    game.run(1.0);
    CHECK(side_of(game, "stop") == Side::both);
    CHECK(is_in_play(game.scene, game.state(), game.world.balls().id[0]));
}

TEST_CASE("a post that is shut waits until no ball is in the way") {
    SmallTable game(
        "post stop 150,400 250,400\ngame pinball\ntimer soon 0.2s\n"
        "on stand hit  open stop, start soon\non soon ends  shut stop\n"
        "on lanes enter  open stop 0.2s\n");
    game.send({360, 120}, {1.0, 0.0});
    CHECK(side_of(game, "stop") == Side::none);
    CHECK(is_lit(game, "stop"));
    // The ball lies across the post when it is shut.
    game.send({200, 402}, {}, 0.3);
    CHECK_FALSE(is_lit(game, "stop"));
    CHECK(side_of(game, "stop") == Side::none);
    game.send({200, 450}, {}, 0.1);
    CHECK(side_of(game, "stop") == Side::both);
    game.send({100, 330}, {0.0, -0.8}, 0.1);
    CHECK(side_of(game, "stop") == Side::none);
    game.run(0.3);
    CHECK(side_of(game, "stop") == Side::both);
}

TEST_CASE("a gate that a rule opens lets balls pass both ways, until it is shut") {
    SmallTable game(
        "gate door 150,400 250,400 pass=up\ngame pinball\non stand hit open door\n"
        "on pops hit  shut door\n");
    const auto comes_down = [&] {
        game.send({200, 430}, {0.0, -1.0}, 0.05);
        return at(game).y < 400.0;
    };
    CHECK_FALSE(comes_down());
    game.send({360, 120}, {1.0, 0.0});
    CHECK(comes_down());
    game.send({200, 440}, {0.0, 1.0}, 0.1);
    CHECK_FALSE(comes_down());
    game.send({200, 370}, {0.0, 1.0}, 0.06);
    CHECK(at(game).y > 411.0);
}

TEST_CASE("a magnet catches a ball while it is lit, pulls it to its centre, and lets it fall") {
    SmallTable game(
        "use gravity 0,-1m/s2\nmagnet pull at=200,300 hold=1s r=15\ngame pinball\n"
        "on pull enter score 7\non stand hit light pull\n");
    game.send({200, 330}, {0.0, -1.0}, 0.2);
    CHECK(at(game).y < 200.0);
    CHECK(game.state().score == 7);
    game.send({360, 120}, {1.0, 0.0});
    game.send({205, 330}, {0.0, -1.0}, 0.3);
    CHECK(distance(at(game), Vec2{200, 300}) < 0.1);
    game.run(0.6);
    CHECK(distance(at(game), Vec2{200, 300}) < 0.1);
    game.run(0.3);
    CHECK(at(game).y < 299.0);
    CHECK(at(game).x == doctest::Approx(200.0).epsilon(0.001));
    game.run(0.3);
    CHECK(at(game).y < 250.0);
}

TEST_CASE("a ball that a magnet holds gives way to another ball, and comes back") {
    SmallTable game(
        "ball other at=50,500 r=10 m=80g e=0.9\nmagnet pull at=200,300 hold=3s r=15\ngame pinball\n"
        "on stand hit light pull\n");
    game.send({360, 120}, {1.0, 0.0});
    game.send({200, 330}, {0.0, -1.0}, 0.3);
    game.world.edit_balls().position[1] = Vec2{260, 300} * 0.001;
    game.world.edit_balls().velocity[1] = {-2.0, 0.0};
    double nearest = 1e9;
    for (int i = 0; i < 100; ++i) {
        game.run(0.001);
        nearest = std::min(nearest, distance(at(game, 0), at(game, 1)));
    }
    CHECK(nearest > 19.9);
    CHECK(distance(at(game), Vec2{200, 300}) < 5.0);
}

TEST_CASE("a captive ball is hit, comes back, and never counts as a ball in play") {
    SmallTable game(cell + "game pinball save=0s balls=1\non jail hit score 100\n");
    REQUIRE(game.world.balls().size() == 2);
    const BallId captive = game.scene.table.captives[0].ball;
    const auto captive_at = [&] { return at(game, *index_of(game.world, captive)); };
    // No search kicks it, though it lies still for longer than 5 s.
    game.send({200, 295}, {}, 3.5);
    game.send({185, 295}, {}, 3.5);
    CHECK(game.state().searches == 0);
    CHECK(distance(captive_at(), Vec2{300, 395.94}) < 0.01);
    game.send({300, 350}, {0.0, 2.0}, 0.05);
    CHECK(game.state().score >= 100);
    CHECK(captive_at().y > 400.0);
    game.send({200, 295}, {}, 3.0);
    CHECK(distance(captive_at(), Vec2{300, 395.94}) < 0.1);
    game.send({200, 20}, {}, 0.1);
    CHECK(game.state().phase == PinballState::Phase::counting);
    CHECK(game.world.balls().size() == 1);
}

TEST_CASE("a ramp that needs speed takes its energy, gives it back, and turns slow balls away") {
    const std::string ramp =
        "material rail layer=1\nedge rail 100,300 100,500\n"
        "ramp climb 150,400 250,400 pass=up layer=1 speed=1m/s r=20\ngame pinball\n"
        "on climb enter score 1\n";
    const auto layer = [](const SmallTable& game) {
        return int{game.world.kinds()[game.world.balls().kind[0]].layer};
    };
    SmallTable slow(ramp);
    slow.send({200, 395}, {0.3, 0.9}, 0.02);
    CHECK(layer(slow) == 0);
    CHECK(slow.state().score == 0);
    CHECK(slow.world.balls().velocity[0].y == doctest::Approx(-0.9));
    CHECK(slow.world.balls().velocity[0].x == doctest::Approx(0.3));

    SmallTable fast(ramp);
    fast.send({200, 395}, {0.3, 1.25}, 0.02);
    CHECK(layer(fast) == 1);
    CHECK(fast.state().score == 1);
    CHECK(fast.world.balls().velocity[0].y == doctest::Approx(0.75));
    // Back down.
    fast.send({200, 403}, {0.3, -0.75}, 0.02);
    CHECK(layer(fast) == 0);
    CHECK(fast.world.balls().velocity[0].y == doctest::Approx(-1.25));
    CHECK(fast.world.balls().velocity[0].x == doctest::Approx(0.3));
}

TEST_CASE("a rollover on a ramp detects the balls of its layer alone") {
    SmallTable game(
        "material rail layer=1\nedge rail 0,0 400,0\n"
        "ramp up 150,400 250,400 pass=up layer=1 r=20\nramp down 150,450 250,450 pass=up layer=0\n"
        "rollover high at=200,425 layer=1 r=10\ngame pinball\non high enter score 1\n");
    game.send({300, 430}, {0.0, -1.0}, 0.05);
    game.send({230, 425}, {-1.0, 0.0}, 0.05);
    CHECK(game.state().score == 0);
    game.send({200, 390}, {0.0, 1.0}, 0.05);
    CHECK(game.state().score == 1);
}

TEST_CASE("one drop target of a bank is reset alone") {
    SmallTable game("game pinball\non stand hit reset drops.2\n");
    game.send({50, 120}, {-1.0, 0.0});
    game.send({50, 180}, {-1.0, 0.0});
    CHECK(is_lit(game, "drops", 0));
    CHECK(is_lit(game, "drops", 1));
    game.send({360, 120}, {1.0, 0.0});
    game.run(0.1);
    const auto stands = [&](std::size_t which) {
        const Device& drop = game.scene.table.devices[device_named(game.scene, "drops", which)];
        return game.world.capsules().side[number(drop.capsules[0])] == Side::both;
    };
    CHECK_FALSE(stands(0));
    CHECK(stands(1));
    CHECK(is_lit(game, "drops", 0));
    CHECK_FALSE(is_lit(game, "drops", 1));
}

TEST_CASE("a spinner pays while it turns, and turns more slowly") {
    SmallTable game("spinner vane at=200,300 r=15\ngame pinball\non vane hit score 1\n");
    game.send({200, 330}, {0.0, -2.0}, 0.1);
    game.send({50, 450}, {}, 0.9);
    const std::int64_t first = game.state().score;
    game.run(1.0);
    const std::int64_t second = game.state().score - first;
    game.run(10.0);
    const std::int64_t all = game.state().score;
    CHECK(first > second);
    CHECK(second > 3);
    CHECK(all > first + second);
    game.run(2.0);
    CHECK(game.state().score == all);
}

TEST_CASE("what locks, posts and magnets do is undone and comes again with the same bits") {
    std::string table = test::small_table;
    table.replace(table.find("200,300"), 7, "200,430");
    const std::string text =
        table + well +
        "magnet pull at=200,300 hold=0.3s r=15\ngame pinball save=0s\n"
        "on bay.1 enter  open stop 1s, light pull\non pull enter  unlight pull, score 5\n";
    const Scene scene = test::scene_of(text);
    Session session(scene, pick_solver(scene.world).settings);
    std::vector<std::uint64_t> marks;
    for (int i = 0; i < 4000; ++i) {
        session.step_forward();
        marks.push_back(fingerprint(session.world(), session.game()));
    }
    CHECK(std::get<PinballState>(session.game()).score >= 5);
    REQUIRE(session.go_to(500));
    for (std::size_t i = 500; i < marks.size(); ++i) {
        session.step_forward();
        REQUIRE(fingerprint(session.world(), session.game()) == marks[i]);
    }
}

#include "game/session/amend_level.h"

#include <doctest/doctest.h>

#include <string>

#include "game/session/save_level.h"
#include "game/session/session.h"
#include "level/load.h"

using namespace carom;

namespace {

Scene loaded(const std::string& text) {
    LoadResult result = load_level(text, "test.level");
    std::string problems;
    for (const Diagnostic& diagnostic : result.diagnostics)
        if (diagnostic.severity == Severity::error) problems += render(diagnostic);
    REQUIRE(problems == "");
    REQUIRE(result.scene);
    return std::move(*result.scene);
}

// What save_level must keep as it is: repeat, mirror, let, units, comments, no line end.
const std::string own_words = R"(carom 1 "Own words"   # a comment
units mm
let W=400
use gravity 0,-9.81m/s2
kind bead r=5
material wood e=0.5 mu=0.2
use spin
repeat 3 step=40,0
  ball b kind=bead at=-40,60
  edge wood lid r=2 -60,0 -40,-10
end
mirror x=0
  peg wood post at=W/4,W/4 r=7
end
edge wood r=2 -W/2,-W/4 W/2,-W/4)";

Session played(const Scene& scene, int ticks) {
    Session session(scene, pick_solver(scene.world).settings);
    for (int tick = 0; tick < ticks; ++tick)
        session.step_forward();
    return session;
}

void check_kept(const Scene& scene, const World& world) {
    const AmendedLevel amended = amended_level(scene, world);
    REQUIRE(amended.text);
    CAPTURE(*amended.text);
    CHECK(amended.text->starts_with(scene.texts.front()));
    CHECK(has_same_bodies(loaded(*amended.text).world, world));
}

}  // namespace

TEST_CASE("a level that has not changed is its author's text") {
    const Scene scene = loaded(own_words);
    CHECK(amended_level(scene, scene.world).text == own_words);
}

TEST_CASE("found 34: a played level keeps its author's text, and reads back bit by bit") {
    const Scene scene = loaded(own_words);
    Session session = played(scene, 77);
    check_kept(scene, session.world());
    // Bodies are moved, removed and added.
    REQUIRE_FALSE(session.apply(command::RemoveBall{BallId{1}}));
    REQUIRE_FALSE(session.apply(command::RemoveCapsule{CapsuleId{1}}));
    REQUIRE_FALSE(session.apply(command::PlaceCapsule{CapsuleId{4}, {0.0, 0.3}, {0.0, 0.3}}));
    REQUIRE_FALSE(session.apply(command::AddCapsule{{{0.1, 0.2}, {0.15, 0.25}, 0.001}, 0}));
    BallSpec spec;
    spec.position = {0.0, 0.2};
    spec.velocity = {0.1, 0.7};
    REQUIRE_FALSE(session.apply(command::AddBall{spec}));
    check_kept(scene, session.world());
    // What is saved from the saved level appends to it.
    const Scene again = loaded(*amended_level(scene, session.world()).text);
    Session later = played(again, 33);
    REQUIRE_FALSE(later.apply(command::RemoveBall{BallId{2}}));
    check_kept(again, later.world());
}

TEST_CASE("bodies are named as the author named them, else by number") {
    const Scene scene = loaded(
        "carom 1 \"N\"\nball a at=0,0\nball at=9,9\nrepeat 2 step=0,5\n  edge lid r=1 20,0 "
        "30,0\nend\n"
        "edge r=1 20,20 30,20\npeg name=p at=50,50 r=1\n");
    Session session = played(scene, 0);
    for (const std::uint32_t i : {0u, 1u})
        REQUIRE_FALSE(session.apply(command::PlaceBall{BallId{i}, {-10.0, 5.0 * i}}));
    REQUIRE_FALSE(session.apply(command::RemoveCapsule{CapsuleId{0}}));
    REQUIRE_FALSE(session.apply(command::PlaceCapsule{CapsuleId{1}, {20.0, 7.0}, {30.0, 7.5}}));
    REQUIRE_FALSE(session.apply(command::RemoveCapsule{CapsuleId{2}}));
    REQUIRE_FALSE(session.apply(command::PlaceCapsule{CapsuleId{3}, {51.0, 50.0}, {51.0, 50.0}}));
    const std::string text = *amended_level(scene, session.world()).text;
    CHECK(text.substr(scene.texts.front().size()) ==
          "\n# Changed in play, at 0.000 s.\n"
          "move a at=-10,0\n"
          "move ball=1 at=-10,5\n"
          "remove lid.1\n"
          "move lid.2 20,7 30,7.5\n"
          "remove edge=2\n"
          "move p 51,50 51,50\n");
    check_kept(scene, session.world());
}

TEST_CASE("gravity that is new is appended; what cannot be said is not") {
    const Scene scene = loaded("carom 1 \"G\"\nball a at=0,0\n");
    Session session = played(scene, 0);
    REQUIRE_FALSE(session.apply(command::SetGravity{Vec2{0.0, -3.0}}));
    check_kept(scene, session.world());
    const Scene heavy = loaded("carom 1 \"G\"\nuse gravity 0,-1\nball a at=0,0\n");
    Session changed = played(heavy, 0);
    REQUIRE_FALSE(changed.apply(command::SetGravity{Vec2{0.0, -3.0}}));
    CHECK(amended_level(heavy, changed.world()).obstacle == "its gravity has changed");
    const Scene rain =
        loaded("carom 1 \"S\"\nkind k r=1\nspawn k at=0,0 every=0.1 count=9 v=9,0\n");
    CHECK(amended_level(rain, played(rain, 60).world()).obstacle == "it has spawned balls");
}

TEST_CASE("the edited start has the balls of the start and the edges of now") {
    const Scene scene = loaded(
        "carom 1 \"E\"\nball a at=0,0 v=5,0\nball b at=0,9\n"
        "edge lid r=1 20,0 30,0\n");
    Session session = played(scene, 30);
    REQUIRE_FALSE(session.apply(command::PlaceCapsule{CapsuleId{0}, {40.0, 0.0}, {40.0, 9.0}}));
    REQUIRE_FALSE(session.apply(command::RemoveBall{BallId{1}}));
    BallSpec spec;
    spec.position = {0.0, 20.0};
    REQUIRE_FALSE(session.apply(command::AddBall{spec}));
    const World start = edited_start(scene, session.world(), session.commands());
    REQUIRE(start.balls().size() == 2);
    CHECK(start.balls().position[0] == Vec2{0.0, 0.0});
    CHECK(start.balls().position[1] == Vec2{0.0, 20.0});
    CHECK(start.capsules().shape[0].start == Vec2{40.0, 0.0});
    check_kept(scene, start);
}

TEST_CASE("a level with motions keeps them, and its edges go on with the same bits") {
    const Scene scene = loaded(R"(carom 1 "Mill"
units mm
use gravity 0,-9.81m/s2
kind bead r=5
material wood e=0.5
box wood room -200,-200 200,200 r=2
edge wood blades r=2 0,0 60,0
edge wood blades r=2 0,0 -60,0
edge wood lift r=2 -190,-150 -100,-150
ball a kind=bead at=-40,100 v=0.1m/s,0
motion turn blades about=0,0 every=1.7s clockwise time=0.3s
motion slide lift by=0,100 every=2s stops=2
)");
    for (const int ticks : {0, 100, 300}) {
        CAPTURE(ticks);
        Session session = played(scene, ticks);
        const AmendedLevel amended = amended_level(scene, session.world());
        REQUIRE(amended.text);
        CAPTURE(*amended.text);
        const std::string whole = level_text(scene, session.world());
        CAPTURE(whole);
        CHECK((ticks == 0) == (*amended.text == scene.texts.front()));
        World world = session.world();
        const SolverSettings settings = session.solver();
        for (int tick = 0; tick < 200; ++tick)
            Solver(settings).tick(world);
        for (const std::string& text : {*amended.text, whole}) {
            const Scene again = loaded(text);
            CHECK(has_same_bodies(again.world, session.world()));
            World copy = again.world;
            for (int tick = 0; tick < 200; ++tick)
                Solver(settings).tick(copy);
            // A ball's times of impact are those of another clock, so its last bits may differ.
            for (std::size_t i = 0; i < 2; ++i) {
                CHECK(copy.movers()[i].clock == world.movers()[i].clock);
                CHECK(copy.movers()[i].runs == world.movers()[i].runs);
            }
            CHECK(copy.capsules().shape == world.capsules().shape);
            CHECK(length(copy.balls().position[0] - world.balls().position[0]) < 1e-6);
        }
    }
}

TEST_CASE("a level with a seesaw keeps it, with its tilt and its rate") {
    const Scene scene = loaded(R"(carom 1 "Seesaw"
units mm
use gravity 0,-9.81m/s2
kind bead r=5 m=3g
material wood e=0.5
box wood room -200,-200 200,200 r=2
edge wood r=2 -190,-150 -150,-150
edge wood plank r=2 -80,0 80,0
ball a kind=bead at=-40,60 v=0.1m/s,0
seesaw plank about=7,3 m=40g from=-17deg to=23deg e=0.3 tilt=5deg turning=11deg/s
)");
    for (const int ticks : {0, 20, 100}) {
        CAPTURE(ticks);
        Session session = played(scene, ticks);
        const AmendedLevel amended = amended_level(scene, session.world());
        REQUIRE(amended.text);
        CAPTURE(*amended.text);
        const std::string whole = level_text(scene, session.world());
        CAPTURE(whole);
        CHECK((ticks == 0) == (*amended.text == scene.texts.front()));
        for (const std::string& text : {*amended.text, whole}) {
            const Scene again = loaded(text);
            CHECK(has_same_bodies(again.world, session.world()));
            Seesaw seesaw = again.world.seesaws().at(0);
            seesaw.capsule = session.world().seesaws().at(0).capsule;
            CHECK(seesaw == session.world().seesaws().at(0));
        }
    }
    const World start = edited_start(scene, played(scene, 50).world(), {});
    CHECK(has_same_bodies(start, scene.world));
}

TEST_CASE("an edited start has motions at their start") {
    const Scene scene = loaded(
        "carom 1 \"Lift\"\nball a at=0,9\nedge name=lift 0,0 5,0\n"
        "motion slide lift by=0,4 every=3\n");
    const Session session = played(scene, 50);
    const World start = edited_start(scene, session.world(), {});
    CHECK(has_same_bodies(start, scene.world));
    CHECK_FALSE(has_same_bodies(session.world(), scene.world));
}

#include "game/session/save_level.h"

#include <doctest/doctest.h>

#include <bit>
#include <string>

#include "game/session/session.h"
#include "level/load.h"

using namespace carom;

namespace {

/// Fails the test with the errors of the text, if it has any.
Scene loaded(const std::string& text) {
    LoadResult result = load_level(text, "test.level");
    std::string problems;
    for (const Diagnostic& diagnostic : result.diagnostics)
        if (diagnostic.severity == Severity::error) problems += render(diagnostic);
    REQUIRE(problems == "");
    REQUIRE(result.scene);
    return std::move(*result.scene);
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(Vec2 a, Vec2 b) {
    return same_bits(a.x, b.x) && same_bits(a.y, b.y);
}

// The edges in which each edge goes on smoothly, by index.
std::vector<std::optional<std::size_t>> joints_of(const World& world) {
    std::vector<std::optional<std::size_t>> found;
    for (const Joints& joints : world.capsules().joints)
        for (const CapsuleId id : joints)
            found.push_back(index_of(world, id));
    return found;
}

void check_same(const World& a, const World& b) {
    REQUIRE(a.balls().size() == b.balls().size());
    for (std::size_t i = 0; i < a.balls().size(); ++i) {
        CAPTURE(i);
        CHECK(same_bits(a.balls().position[i], b.balls().position[i]));
        CHECK(same_bits(a.balls().velocity[i], b.balls().velocity[i]));
        CHECK(same_bits(a.balls().radius[i], b.balls().radius[i]));
        CHECK(same_bits(a.balls().inverse_mass[i], b.balls().inverse_mass[i]));
        CHECK(a.balls().kind[i] == b.balls().kind[i]);
    }
    CHECK(a.balls().restitution == b.balls().restitution);
    CHECK(a.balls().spin == b.balls().spin);
    CHECK(a.capsules().shape == b.capsules().shape);
    CHECK(a.capsules().material == b.capsules().material);
    CHECK(a.capsules().side == b.capsules().side);
    CHECK(joints_of(a) == joints_of(b));
    CHECK(a.model() == b.model());
    CHECK(a.definition().meets == b.definition().meets);
    CHECK(a.seed() == b.seed());
    CHECK(a.rate() == b.rate());
    REQUIRE(a.kinds().size() == b.kinds().size());
    for (std::size_t i = 0; i < a.kinds().size(); ++i) {
        CHECK(same_bits(a.kinds()[i].radius, b.kinds()[i].radius));
        CHECK(same_bits(a.kinds()[i].mass, b.kinds()[i].mass));
        CHECK(same_bits(a.kinds()[i].restitution, b.kinds()[i].restitution));
    }
    REQUIRE(a.materials().size() == b.materials().size());
    for (std::size_t i = 0; i < a.materials().size(); ++i) {
        CHECK(same_bits(a.materials()[i].restitution, b.materials()[i].restitution));
        CHECK(same_bits(a.materials()[i].soften, b.materials()[i].soften));
        CHECK(same_bits(a.materials()[i].friction, b.materials()[i].friction));
    }
    REQUIRE(a.zones().size() == b.zones().size());
    for (std::size_t i = 0; i < a.zones().size(); ++i) {
        CHECK(a.zones()[i].shape == b.zones()[i].shape);
        CHECK(a.zones()[i].effect == b.zones()[i].effect);
        CHECK(a.zones()[i].counter == b.zones()[i].counter);
    }
}

const std::string natural = R"(carom 1 "A busy place"
# What it shows.
#
# Try: everything.
seed 42
rate 250
solver substep updates=3 steps=7
use gravity 0,-9.81
use drag 0.1
use stop 0.001
use limit 300
use scatter 40.471194469094584
kind heavy r=1.5 m=7.7 e=0.9
kind light r=0.5 density=0.1
material wood e=0.8 soften=0.25
material ice e=0.99
collide heavy light
collide heavy edge
collide light wood
collide light ice
edge wood r=1  0,0  100,0  100,80  0,80  close
edge wood ramp r=0.5  20,40  60,25  80,25  90,35
edge ice r=0  10,10  12,30  side=left
peg ice at=50,50 r=2
arc wood r=0.3 at=70,60 radius=9 from=200 to=330
ball first kind=heavy at=30,60 v=2,0
ball kind=light at=33,68 v=-1e-3,1/3 m=0.3
ball kind=light at=40,68 r=0.7
spawn light at=50,70 every=0.5 count=100 v=1,-2 jitter=0.5,0 vjitter=0.1,0.2
bins tally at=50,20 count=4 width=5 depth=10 sink
show histogram of=tally against=uniform
show energy
show msd
observe pairs pressure from=2s
)";

const std::string metric = R"(carom 1 "In millimetres"
units mm
use gravity 0.1m/s2,-9.81m/s2
use wrap
use spin inertia=2/5
world -1270,-635 1270,635
kind pool r=28.575 m=170g e=0.95 mu=0.05
material rubber e=0.85 soften=0.4 mu=1/7
edge rubber r=8  -1000/3,100  200,100/7  350,200
ball cue kind=pool at=-1270/2,0 v=1.7m/s,-3cm/s
ball kind=pool at=0,-300 w=100rad/s/7
ball kind=pool at=100,-300 w=-777deg/s
ball at=300,300 r=50 m=1kg/3
)";

const std::string lasting = R"(carom 1 "Contacts that last"
units in
use modulus 5.84GPa poisson=0.34
ball a at=1,2 r=1 m=100g v=1m/s,0
ball b at=3.1,2 r=1 m=100g
)";

/// Simulates a while, so that no number is round.
World after(const Scene& scene, int ticks) {
    Session session(scene, scene.solver.value_or(pick_solver(scene.world).settings));
    for (int tick = 0; tick < ticks; ++tick)
        session.step_forward();
    return session.world();
}

}  // namespace

TEST_CASE("a world at its start reads back bit by bit") {
    for (const std::string& text : {natural, metric, lasting}) {
        const Scene scene = loaded(text);
        const std::string saved = level_text(scene, scene.world);
        CAPTURE(saved);
        check_same(scene.world, loaded(saved).world);
    }
}

TEST_CASE("a world after play reads back bit by bit, and so does the level saved from it") {
    for (const std::string& text : {natural, metric}) {
        const Scene scene = loaded(text);
        const World world = after(scene, 777);
        const std::string saved = level_text(scene, world);
        CAPTURE(saved);
        const Scene again = loaded(saved);
        check_same(world, again.world);
        CHECK(level_text(again, again.world) == saved);
    }
}

TEST_CASE("data besides the world are kept too") {
    const Scene scene = loaded(natural);
    const Scene again = loaded(level_text(scene, scene.world));
    CHECK(again.title == scene.title);
    CHECK(again.comment == scene.comment);
    CHECK(again.view == scene.view);
    CHECK(again.solver == scene.solver);
    CHECK(again.ball_names == scene.ball_names);
    CHECK(again.outlines == scene.outlines);
    REQUIRE(again.shows.size() == 3);
    CHECK(again.shows[2].observable == Observable::msd);
    CHECK(again.observation.what.has(Observable::pressure));
    CHECK(again.observation.what.has(Observable::pairs));
    CHECK_FALSE(again.observation.what.has(Observable::vacf));
    CHECK(again.observation.from == 2.0);
    CHECK(again.shows[0].counters == scene.shows[0].counters);
    CHECK(again.shows[0].expected == scene.shows[0].expected);
    REQUIRE(again.world.emitters().size() == 1);
    CHECK(again.world.emitters()[0].every == scene.world.emitters()[0].every);
    CHECK(again.world.emitters()[0].velocity_jitter == scene.world.emitters()[0].velocity_jitter);
}

TEST_CASE("an emitter keeps its remaining balls, and an empty one is dropped") {
    const Scene scene = loaded(natural);
    const World world = after(scene, 250 * 5);
    const std::uint32_t given = world.emitters()[0].emitted;
    REQUIRE(given > 5);
    CHECK(loaded(level_text(scene, world)).world.emitters()[0].count == 100 - given);
    World empty = world;
    empty.edit_emitters()[0].emitted = 100;
    CHECK(loaded(level_text(scene, empty)).world.emitters().empty());
}

TEST_CASE("curves and their corners are saved") {
    const std::string start = "carom 1 \"curves\"\nmaterial m e=0.4\nball at=0,0\n";
    for (const std::string edges :
         {"arc m at=0,0 radius=11 from=180 to=0\n", "arc m at=0,0 radius=11\n",
          "box m -20,-20 20,20 fillet=3\n", "edge m -9,-20 -9,0 0,-6 fillet=2\nedge m 0,-6 9,-8\n",
          "edge m smooth 0,-9 5,-8.5 9,-7 12,-5\nedge m 12,-5 14,-3\n",
          "edge m -11,-20 -11,0\narc m at=0,0 radius=11 from=180 to=0\nedge m 11,0 11,-20\n",
          "edge m -9,-9 0,-8 9,-9\nedge m smooth 9,-9 12,-8.5 14,-7.8\n"}) {
        CAPTURE(edges);
        const Scene scene = loaded(start + edges);
        CHECK(scene.world.model().curved);
        check_same(scene.world, loaded(level_text(scene, scene.world)).world);
    }
}

TEST_CASE("a player's changes are saved") {
    const Scene scene = loaded(natural);
    Session session(scene, {});
    const auto apply = [&](const Command& c) { REQUIRE(session.apply(c) == std::nullopt); };
    BallSpec spec;
    spec.position = {20.1, 70.3};
    apply(command::AddBall{spec});
    apply(command::RemoveBall{BallId{1}});
    apply(command::AddCapsule{{{5.1, 60.0}, {9.0, 70.7}, 0.25}, 1, Side::both});
    apply(command::RemoveCapsule{CapsuleId{0}});
    apply(command::SetGravity{Vec2{9.81, 0.0}});
    check_same(session.world(), loaded(level_text(scene, session.world())).world);
}

TEST_CASE("names of copies become separate names") {
    const Scene scene = loaded(R"(carom 1 "Copies"
repeat 3 step=5,0
  ball b at=0,0
end
cradle c at=0,20 count=3 v=1
)");
    const std::string saved = level_text(scene, scene.world);
    CAPTURE(saved);
    check_same(scene.world, loaded(saved).world);
}

TEST_CASE("an edge with very many points reads back") {
    std::string text = "carom 1 \"Long\"\nedge r=0.1";
    for (int i = 0; i < 500; ++i)
        text += " \\\n " + std::to_string(i * 1.1) + "," + std::to_string(i % 7 / 3.0);
    const Scene scene = loaded(text + "\n");
    REQUIRE(scene.world.capsules().size() == 499);
    check_same(scene.world, loaded(level_text(scene, scene.world)).world);
}

TEST_CASE("save_level keeps colours, paint, labels and the theme") {
    const Scene scene = loaded(
        "carom 1 \"t\"\ntheme board=navy\nkind k color=red\nmaterial m color=gold\n"
        "edge m 0,0 9,0 color=teal\nedge m 9,0 9,9\npeg m at=20,20 r=1 color=pink\n"
        "ball a at=3,3 kind=k\nball blue at=6,6 kind=k\nrepeat 2 step=0,20\nball lime "
        "at=30,3\nend\n"
        "zone z 40,0 41,0 r=1 color=red\npaint rect 0,0 9,9 color=olive\n"
        "paint circle at=3,3 r=2 color=tan\nlabel \"hello there\" at=1,2 align=right color=sky\n");
    const Scene again = loaded(level_text(scene, scene.world));
    const Dress& a = scene.dress;
    const Dress& b = again.dress;
    CHECK(a.kinds[0] == b.kinds[0]);
    CHECK(a.materials == b.materials);
    CHECK(a.balls == b.balls);
    CHECK(a.edges == b.edges);
    CHECK(a.zones == b.zones);
    CHECK(a.theme.board == b.theme.board);
    REQUIRE(b.areas.size() == 2);
    CHECK(a.areas[0].corners == b.areas[0].corners);
    CHECK(a.areas[1].disc == b.areas[1].disc);
    CHECK(a.areas[1].color == b.areas[1].color);
    REQUIRE(b.labels.size() == 1);
    CHECK(a.labels[0].text == b.labels[0].text);
    CHECK(a.labels[0].at == b.labels[0].at);
    CHECK(a.labels[0].align == b.labels[0].align);
    CHECK(a.labels[0].color == b.labels[0].color);
}

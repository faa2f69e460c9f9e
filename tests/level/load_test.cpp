#include "level/load.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "geometry/elementary.h"
#include "level/support/files.h"

using namespace carom;
using namespace carom::test;

namespace {

const Capsule& edge(const Scene& scene, std::size_t i) {
    return scene.world.capsules().shape[i];
}

}  // namespace

TEST_CASE("a level of one line loads, with defaults") {
    const Scene scene = load_clean(
        "use gravity 0,-9.81\n"
        "material wood e=0.8\n"
        "edge wood r=1  0,0  100,0  100,80  0,80  close\n"
        "edge wood r=0.5  20,40  60,25\n"
        "ball a at=30,60 v=2,0 r=2 m=1\n");
    CHECK(scene.title == "Test");
    const World& world = scene.world;
    REQUIRE(world.balls().size() == 1);
    CHECK(world.balls().position[0] == Vec2{30, 60});
    CHECK(world.balls().velocity[0] == Vec2{2, 0});
    CHECK(world.balls().radius[0] == 2.0);
    CHECK(world.balls().inverse_mass[0] == 1.0);
    REQUIRE(world.capsules().size() == 5);
    CHECK(edge(scene, 3) == Capsule{{0, 80}, {0, 0}, 1});
    CHECK(edge(scene, 4) == Capsule{{20, 40}, {60, 25}, 0.5});
    CHECK(world.materials()[world.capsules().material[0]].restitution == 0.8);
    CHECK(world.model().gravity == Vec2{0, -9.81});
    CHECK(world.model().inelastic);
    CHECK_FALSE(world.model().filtered);
    CHECK(world.model().ball_ball);
    CHECK(world.rate() == 120.0);
    CHECK(scene.ball_names == std::vector<std::string>{"a"});
    REQUIRE(scene.outlines.size() == 1);
    CHECK(scene.outlines[0].size() == 4);
    CHECK(scene.view == Box{{-1, -1}, {101, 81}});
}

TEST_CASE("a Galton board loads with its emitter, bins and experiment") {
    const Scene scene = load_clean(
        "units mm\n"
        "seed 1873\n"
        "use gravity 0,-9.81m/s2\n"
        "use scatter 20deg\n"
        "collide bead edge\n"
        "let p=20\n"
        "kind bead      r=0.38*p m=1g\n"
        "material peg   e=0.50\n"
        "pegs triangle material=peg rows=12 pitch=p row=0.866*p r=0.10*p at=0,0\n"
        "bins count=13 width=p at=0,-12*0.866*p depth=30 sink\n"
        "spawn bead at=0,0.78*p jitter=0.1*p,0 every=50ms count=3000\n"
        "show histogram of=bins against=binomial(12,0.5)\n");
    const World& world = scene.world;
    CHECK(world.seed() == 1873);
    CHECK(world.capsules().size() == 78 + 14);
    REQUIRE(world.zones().size() == 13);
    CHECK(world.zones()[0].effect == Zone::Effect::sink);
    CHECK(world.zones()[0].counter == 0);
    CHECK(world.zones()[0].shape.start.x < world.zones()[12].shape.start.x);
    CHECK(world.zones()[6].shape.start.x == 0.0);
    CHECK(world.ledger().counters.size() == 13);
    REQUIRE(world.emitters().size() == 1);
    CHECK(world.emitters()[0].every == 0.05);
    CHECK(world.emitters()[0].count == 3000);
    CHECK(world.emitters()[0].jitter.x == doctest::Approx(0.002));
    CHECK_FALSE(world.model().ball_ball);
    CHECK(world.model().ball_edge);
    CHECK(world.model().filtered);
    CHECK(*world.model().scatter == doctest::Approx(pi / 9));
    REQUIRE(scene.shows.size() == 1);
    CHECK(scene.shows[0].counters.size() == 13);
    CHECK(scene.shows[0].expected[6] == doctest::Approx(924.0 / 4096.0));
    CHECK(scene.unit == LengthUnit::millimetre);
}

TEST_CASE("a level without use has elastic balls and no terms") {
    const Scene scene = load_clean("ball a at=0,0\nedge 0,9 9,9\n");
    CHECK(scene.world.model() == Model{});
    CHECK(scene.world.balls().radius[0] == 1.0);
    CHECK(scene.world.balls().inverse_mass[0] == doctest::Approx(1.0 / pi));
    CHECK(scene.kind_names == std::vector<std::string>{"ball"});
    CHECK(scene.material_names == std::vector<std::string>{"edge"});
}

TEST_CASE("each use statement sets its term of the model") {
    const Scene scene = load_clean(
        "world -10,-10 10,10\nuse gravity 1,-2\nuse drag 0.5\nuse stop 0.1\nuse limit 30\n"
        "use scatter 90\nuse wrap\nball a at=0,0\n");
    const Model& model = scene.world.model();
    CHECK(model.gravity == Vec2{1, -2});
    CHECK(model.drag == 0.5);
    CHECK(model.stop_speed == 0.1);
    CHECK(model.speed_limit == 30.0);
    CHECK(*model.scatter == doctest::Approx(pi / 2));
    CHECK(model.wrap == Box{{-10, -10}, {10, 10}});
    CHECK(scene.view == Box{{-10, -10}, {10, 10}});
}

TEST_CASE("a level says what it needs of the solver") {
    const Need need = load_clean("tolerance 0.01r within 10s\nbudget 2ms\nball a at=0,0\n")
                          .world.definition()
                          .need;
    CHECK(need.tolerance == 0.01);
    CHECK(need.within == 10.0);
    CHECK(need.budget == 0.002);
    const Scene plain = load_clean("tolerance 1e-6r\nball a at=0,0\n");
    CHECK(plain.world.definition().need.tolerance == 1e-6);
    CHECK(plain.world.definition().need.within == 10.0);
    CHECK_FALSE(plain.world.definition().need.budget);
}

TEST_CASE("a term of 0 is off") {
    const Scene scene =
        load_clean("use gravity 0,0\nuse drag 0\nuse stop 0\nuse scatter 0\nball a at=0,0\n");
    CHECK(scene.world.model() == Model{});
}

TEST_CASE("a mass comes from the ball, else its kind, else its area") {
    const Scene scene = load_clean(
        "kind heavy r=2 m=5\nkind dense r=2 density=3\nkind plain r=2\n"
        "ball a kind=heavy at=0,0\nball b kind=heavy r=3 at=10,0\nball c kind=heavy m=7 at=20,0\n"
        "ball d kind=dense at=30,0\nball f kind=dense r=1 at=40,0\nball g kind=plain at=50,0\n");
    const auto mass = [&](std::size_t i) { return 1.0 / scene.world.balls().inverse_mass[i]; };
    CHECK(mass(0) == doctest::Approx(5));
    CHECK(mass(1) == doctest::Approx(5));
    CHECK(mass(2) == doctest::Approx(7));
    CHECK(mass(3) == doctest::Approx(12 * pi));
    CHECK(mass(4) == doctest::Approx(3 * pi));
    CHECK(mass(5) == doctest::Approx(4 * pi));
}

TEST_CASE("a ball keeps its own restitution in an inelastic level") {
    const Scene scene =
        load_clean("kind dull e=0.5\nball a kind=dull e=1 at=0,0\nball b kind=dull at=9,0\n");
    CHECK(scene.world.balls().restitution == std::vector<double>{1.0, 0.5});
}

TEST_CASE("values with units are converted to SI") {
    const Scene scene = load_clean(
        "units mm\nkind pool r=28.575 m=170g\nball a kind=pool at=1cm,-2in v=0.5m/s,20mm/s\n"
        "use gravity 0,-981cm/s2\nuse drag 30/min\nrate 1kHz\nlet W=5\npeg at=W,W+1cm r=W/2\n"
        "use scatter 0.1rad\nmaterial soft soften=0.4\nedge soft 0,1m 0,2m\n");
    const World& world = scene.world;
    CHECK(world.balls().position[0].x == 0.01);
    CHECK(world.balls().position[0].y == doctest::Approx(-0.0508));
    CHECK(world.balls().velocity[0].x == 0.5);
    CHECK(world.balls().velocity[0].y == doctest::Approx(0.02));
    CHECK(1.0 / world.balls().inverse_mass[0] == doctest::Approx(0.17));
    CHECK(world.model().gravity->y == doctest::Approx(-9.81));
    CHECK(*world.model().drag == doctest::Approx(0.5));
    CHECK(*world.model().scatter == doctest::Approx(0.1));
    CHECK(world.rate() == 1000.0);
    CHECK(edge(scene, 0).start.y == doctest::Approx(0.015));
    CHECK(edge(scene, 0).radius == doctest::Approx(0.0025));
    CHECK(world.materials()[0].soften == 0.4);
}

TEST_CASE("mirror makes images, but no duplicates on its line") {
    const Scene scene = load_clean(
        "mirror x=0 y=0\n"
        "  peg at=3,4 r=1\n"
        "  peg at=0,10 r=1\n"
        "  peg at=0,0 r=0.5\n"
        "  edge -5,20 5,20\n"
        "  edge name=one 20,0 30,0 side=left\n"
        "  ball b at=50,3 v=1,2\n"
        "end\n");
    const World& world = scene.world;
    // 4 images of the first peg, 2 of the second, the third alone, 2 edges, 2 one-way edges twice.
    CHECK(world.capsules().size() == 4 + 2 + 1 + 2 + 2);
    REQUIRE(world.balls().size() == 4);
    CHECK(world.balls().position[3] == Vec2{-50, -3});
    CHECK(world.balls().velocity[1] == Vec2{-1, 2});
    CHECK(scene.ball_names == std::vector<std::string>{"b", "b.2", "b.3", "b.4"});
    REQUIRE(scene.groups.size() == 2);
    CHECK(scene.groups[0].balls.size() == 4);
}

TEST_CASE("a mirror exchanges the sides of one-way edges") {
    const Scene scene = load_clean("mirror x=0\n edge 5,0 5,10 side=left\nend\n");
    REQUIRE(scene.world.model().one_way);
    CHECK(scene.world.capsules().side == std::vector<Side>{Side::left, Side::right});
}

TEST_CASE("repeat shifts, counts and nests") {
    const Scene scene =
        load_clean("repeat 3 i step=10,0\n  repeat 2 step=0,5\n    peg at=i,0 r=1\n  end\nend\n");
    REQUIRE(scene.world.capsules().size() == 6);
    CHECK(edge(scene, 5).start == Vec2{22, 5});
}

TEST_CASE("parts are translated, rotated and flipped, exactly for right angles") {
    const Scene scene = load_clean(
        "let gap=1\n"
        "part wing size=3 lift=\n"
        "  edge 0,0 size,lift+gap\n"
        "end\n"
        "place wing at=10,20 lift=2\n"
        "place wing at=10,20 lift=2 turn=90\n"
        "place wing at=10,20 lift=2 flip\n"
        "place wing at=10,20 lift=2 size=4 turn=-90 flip\n");
    CHECK(edge(scene, 0).end == Vec2{13, 23});
    CHECK(edge(scene, 1).end == Vec2{7, 23});
    CHECK(edge(scene, 2).end == Vec2{7, 23});
    CHECK(edge(scene, 3).end == Vec2{13, 24});
}

TEST_CASE("a part sees the names of the level, not those at its place statement") {
    const LoadResult result =
        load_lines("part a\n peg at=i,0 r=1\nend\nrepeat 2 i step=5,0\n place a at=0,0\nend\n");
    REQUIRE(result.diagnostics.size() == 1);
    CHECK(result.diagnostics[0].line == 3);
    CHECK(result.diagnostics[0].column == 9);
}

TEST_CASE("arcs pass through their ends, within 1/1000 of the radius") {
    const Scene scene = load_clean("arc at=5,7 radius=100 from=180 to=0 r=2\n");
    const auto& shapes = scene.world.capsules().shape;
    CHECK(shapes.front().start == Vec2{-95, 7});
    CHECK(shapes.back().end == Vec2{105, 7});
    double highest = 0.0;
    for (const Capsule& piece : shapes) {
        const Vec2 middle = (piece.start + piece.end) * 0.5;
        CHECK(distance(piece.start, {5, 7}) == doctest::Approx(100));
        CHECK(distance(middle, {5, 7}) > 99.9);
        highest = std::max(highest, middle.y);
    }
    CHECK(highest > 106.0);  // an arc from 180 to 0 passes 90, not 270
    CHECK(load_clean("arc at=0,0 radius=1\n").outlines.size() == 1);
}

TEST_CASE("fillets are tangent to both edges") {
    const Scene scene = load_clean("edge 0,0 10,0 10,10 fillet=4\n");
    const auto& shapes = scene.world.capsules().shape;
    CHECK(shapes.size() > 8);
    CHECK(distance(shapes.front().end, {6, 0}) < 1e-12);
    CHECK(distance(shapes.back().start, {10, 4}) < 1e-12);
    for (std::size_t i = 1; i < shapes.size(); ++i) {
        CHECK(shapes[i].start == shapes[i - 1].end);
        CHECK(distance(shapes[i].start, {6, 4}) == doctest::Approx(4));
    }
    const Scene rounded = load_clean("box 0,0 10,10 fillet=5\n");
    for (const Capsule& piece : rounded.world.capsules().shape)
        CHECK(distance(piece.start, {5, 5}) == doctest::Approx(5));
}

TEST_CASE("pegs form triangles and grids") {
    const Scene triangle = load_clean("pegs triangle at=0,0 rows=3 pitch=2 row=1 r=0.1\n");
    REQUIRE(triangle.world.capsules().size() == 6);
    CHECK(edge(triangle, 0).start == Vec2{0, 0});
    CHECK(edge(triangle, 3).start == Vec2{-2, -2});
    CHECK(edge(triangle, 5).start == Vec2{2, -2});
    const Scene grid = load_clean("pegs grid at=0,0 rows=3 columns=4 pitch=2 r=0.1\n");
    CHECK(grid.world.capsules().size() == 12);
    CHECK(edge(grid, 4).start == Vec2{-3, -2});
    const Scene stagger =
        load_clean("pegs grid at=0,0 rows=3 columns=4 pitch=2 r=0.1 row=1 stagger\n");
    CHECK(stagger.world.capsules().size() == 11);
    CHECK(edge(stagger, 4).start == Vec2{-2, -1});
}

TEST_CASE("bins have walls, a floor, and a zone each") {
    const Scene scene = load_clean("bins tray at=10,0 count=4 width=5 depth=20 wall=1\n");
    const World& world = scene.world;
    CHECK(world.capsules().size() == 6);
    CHECK(edge(scene, 0) == Capsule{{0, -20}, {0, -0.5}, 0.5});
    CHECK(edge(scene, 5) == Capsule{{0, -20}, {20, -20}, 0.5});
    REQUIRE(world.zones().size() == 4);
    CHECK(world.zones()[1].effect == Zone::Effect::census);
    CHECK(is_inside(world.zones()[1].shape, {5.6, -19.9}));
    CHECK(is_inside(world.zones()[1].shape, {9.4, -19.9}));
    CHECK_FALSE(is_inside(world.zones()[1].shape, {7.5, 0.1}));
    CHECK(scene.counter_names[3] == "tray.4");
}

TEST_CASE("open bins have zones but no walls") {
    const Scene scene = load_clean("bins slices at=0,10 count=2 width=4 depth=10 open\n");
    CHECK(scene.world.capsules().size() == 0);
    REQUIRE(scene.world.zones().size() == 2);
    CHECK(scene.world.zones()[0].effect == Zone::Effect::census);
    CHECK(is_inside(scene.world.zones()[0].shape, {-3.9, 9.9}));
    CHECK(is_inside(scene.world.zones()[0].shape, {-0.1, 0.1}));
    CHECK_FALSE(is_inside(scene.world.zones()[0].shape, {0.1, 5}));
}

TEST_CASE("a cradle is a row of balls, some of them swung out") {
    const Scene scene = load_clean("cradle row at=0,0 count=5 in=2 v=3 r=1 gap=0.5 swing=4\n");
    const World& world = scene.world;
    REQUIRE(world.balls().size() == 5);
    CHECK(world.balls().position[2] == Vec2{0, 0});
    CHECK(world.balls().position[1] == Vec2{-6.5, 0});
    CHECK(world.balls().position[4] == Vec2{5, 0});
    CHECK(world.balls().velocity[1] == Vec2{3, 0});
    CHECK(world.balls().velocity[2] == Vec2{0, 0});
    CHECK(world.capsules().size() == 2);
    CHECK(edge(scene, 1).start.x == 5 + 1 + 8);
    CHECK(scene.ball_names[4] == "row.5");
}

TEST_CASE("a map becomes edges, balls and pegs") {
    const Scene scene = load_clean(
        "kind red r=0.2\n"
        "legend ball x kind=red v=1,0\n"
        "map cell=2 at=-10,0\n"
        "|  ox   |\n"
        "|  *   |\n"
        "|\\ ## / |\n"
        "--------\n"
        "end\n");
    const World& world = scene.world;
    REQUIRE(world.balls().size() == 2);
    CHECK(world.balls().position[0] == Vec2{-3, 7});
    CHECK(world.balls().radius[0] == 1.0);
    CHECK(world.balls().velocity[1] == Vec2{1, 0});
    CHECK(world.balls().radius[1] == 0.2);
    const auto has = [&](const Capsule& wanted) {
        return std::ranges::count(world.capsules().shape, wanted) == 1;
    };
    CHECK(has({{-9, 8}, {-9, 1}, 0}));    // three | joined
    CHECK(has({{-10, 1}, {6, 1}, 0}));    // eight - joined
    CHECK(has({{-3, 5}, {-3, 5}, 0.5}));  // *
    CHECK(has({{-9, 5}, {-5, 1}, 0}));    // a backslash, from the | to the -
    CHECK(has({{5, 5}, {1, 1}, 0}));      // / between the same
    CHECK(has({{-4, 4}, {0, 4}, 0}));     // the roof of ##
    CHECK(has({{-4, 4}, {-4, 2}, 0}));    // its left wall
    CHECK(has({{0, 4}, {0, 2}, 0}));      // its right wall
    CHECK(has({{-4, 2}, {0, 2}, 0}));     // its floor
}

TEST_CASE("lines of a map join in the cells that they run into") {
    const Scene scene = load_clean(
        "map cell=2\n"
        "+--\n"
        "| /\n"
        "---\n"
        "end\n");
    const auto& shapes = scene.world.capsules().shape;
    const auto has = [&](const Capsule& wanted) { return std::ranges::count(shapes, wanted) == 1; };
    CHECK(shapes.size() == 4);
    CHECK(has({{1, 5}, {6, 5}, 0}));  // - from the middle of +
    CHECK(has({{1, 5}, {1, 1}, 0}));  // | from the middle of + to the - below
    CHECK(has({{0, 1}, {6, 1}, 0}));
    CHECK(has({{6, 4}, {3, 1}, 0}));  // / to the middle of the - below it on the left
}

TEST_CASE("collide sets the collision matrix") {
    const Scene scene = load_clean(
        "kind red\nkind blue\nmaterial wood e=0.5\n"
        "collide red blue\ncollide red edge\ncollide wood red\n"
        "ball a kind=red at=0,0\nball b kind=blue at=9,0\nedge wood 0,9 9,9\nedge 0,20 9,20\n");
    const World& world = scene.world;
    REQUIRE(world.model().filtered);
    CHECK(kinds_meet(world, 0, 1));
    CHECK_FALSE(kinds_meet(world, 0, 0));
    CHECK_FALSE(kinds_meet(world, 1, 1));
    CHECK(kind_meets_material(world, 0, 0));
    CHECK(kind_meets_material(world, 0, 1));
    CHECK_FALSE(kind_meets_material(world, 1, 0));
    CHECK_FALSE(kind_meets_material(world, 1, 1));
    CHECK(world.model().ball_ball);
}

TEST_CASE("balls that do not collide may start at one position") {
    CHECK(rendered(load_lines("collide ball edge\nball a at=0,0\nball b at=0,0\n")) == "");
    CHECK(rendered(load_lines("use overlap\nball a at=0,0\nball b at=0,0\nedge 0,0 9,0\n")) == "");
}

TEST_CASE("contact within rounding is no overlap") {
    CHECK(rendered(load_lines("ball a at=0.1*3,0 r=0.1\nball b at=0.5,0 r=0.1\n"
                              "edge 0,-0.1 9,-0.1\n")) == "");
}

TEST_CASE("a one-way edge is solid on one side") {
    CHECK(rendered(load_lines("edge 0,0 10,0 side=left\nball a at=5,-0.5\n")) == "");
    CHECK(load_lines("edge 0,0 10,0 side=left\nball a at=5,0.5\n").diagnostics.size() == 1);
}

TEST_CASE("expect resolves its quantity") {
    const Scene scene = load_clean(
        "ball a at=5,9\nbins at=0,0 count=3 width=5 depth=5\n"
        "expect collisions 10 within 0\nexpect a.vx 1.5 within 1e-9 at=2\n"
        "expect variance_ratio(bins) 1 within 0.05\n");
    REQUIRE(scene.expects.size() == 3);
    CHECK(scene.expects[0].what.kind == quantity_named("collisions"));
    CHECK(scene.expects[0].value == 10.0);
    CHECK_FALSE(scene.expects[0].at);
    CHECK(scene.expects[1].what.kind == quantity_named("vx"));
    CHECK(scene.expects[1].what.ball == scene.world.balls().id[0]);
    CHECK(*scene.expects[1].at == 2.0);
    CHECK(scene.expects[2].what.counters == std::vector<std::uint32_t>{0, 1, 2});
    CHECK(scene.expects[2].what.expected == std::vector<double>{0.25, 0.5, 0.25});
    CHECK_FALSE(scene.overridden);
}

TEST_CASE("solver, rate, seed and game reach the scene") {
    const Scene scene = load_clean(
        "solver substep updates=8 steps=5\nrate 240\nseed 18446744073709551615\n"
        "game galton\nphysics 1\n");
    REQUIRE(scene.solver);
    CHECK(*scene.solver == SolverSettings{SolverKind::substep, 8, 5, 1});
    CHECK(scene.world.rate() == 240.0);
    CHECK(scene.world.seed() == 18446744073709551615u);
    CHECK(scene.game == "galton");
}

TEST_CASE("substeps= sets the substeps of the named solver") {
    CHECK(load_lines("solver contact\n").scene->solver->contact_substeps == 4);
    CHECK(load_lines("solver contact substeps=9\n").scene->solver->contact_substeps == 9);
    CHECK(load_lines("solver swept substeps=9\n").scene->solver->substeps == 9);
    CHECK(load_lines("solver event substeps=9\n").diagnostics.size() == 1);
}

TEST_CASE("the opening comment keeps its relative indentation") {
    const auto comment = [](std::string_view text) {
        return load_level(text, "a.level").scene.value().comment;
    };
    const std::vector<std::string> two{"Shows this.", "Try that."};
    CHECK(comment("# Shows this.\n#Try that.\ncarom 1 \"A\"\n# not this\n") == two);
    CHECK(
        comment("carom 1 \"A\"  # beside\n\n#   Shows this. \r\n#\t Try that.\n#\nball at=0,0\n") ==
        std::vector<std::string>{"Shows this.", "Try that."});
    // Indentation relative to the margin stays, as in the second line of a list.
    const std::vector<std::string> list{"Try: one", "     two", "", "End"};
    CHECK(comment("carom 1 \"A\"\n# Try: one\n#      two\n#\n# End\n#\n") == list);
    CHECK(comment("carom 1 \"A\"\nball at=0,0\n# late\n").empty());
}

// Menus show the title and the comment, so a level must not send control characters to a terminal.
TEST_CASE("control characters of the title and the comment are replaced") {
    const Scene scene =
        load_level("carom 1 \"A\x1b[31mB\"\n# \x1b]0;x\x07\nball at=0,0\n", "a.level")
            .scene.value();
    CHECK(scene.title == "A?[31mB");
    CHECK(scene.comment == std::vector<std::string>{"?]0;x?"});
}

TEST_CASE("CR LF, a byte order mark and continued lines are read") {
    const LoadResult result = load_level(
        "\xef\xbb\xbf"
        "carom 1 \"A\"\r\nball a \\\r\n  at=1,2 \\  # on and on\r\n  r=3\r\n",
        "a.level");
    CHECK(rendered(result) == "");
    REQUIRE(result.scene);
    CHECK(result.scene->world.balls().radius[0] == 3.0);
}

TEST_CASE("includes share names and settings, and are read once") {
    LoadOptions options;
    int reads = 0;
    options.resolve_include = [&](std::string_view from, std::string_view path) {
        ++reads;
        CHECK(from == "test.level");
        return std::optional(
            IncludedFile{"lib/" + std::string(path),
                         "let W=10 unused=3\nkind bead r=2\npart post\n peg at=0,0 r=1\nend\n"});
    };
    const Scene scene = load_clean(
        "include \"lib.level\"\nball a kind=bead at=W,0\nplace post at=W+9,0\n", options);
    CHECK(scene.world.balls().position[0].x == 10.0);
    CHECK(reads == 1);
    CHECK(scene.files == std::vector<std::string>{"test.level", "lib/lib.level"});
    REQUIRE(scene.texts.size() == 2);
    CHECK(scene.texts[0].ends_with("place post at=W+9,0\n"));
    CHECK(scene.texts[1].starts_with("let W=10"));
    CHECK(scene.includes == std::vector<Include>{{0, 1, "lib.level"}});
}

TEST_CASE("a file that is included twice is read once, and both paths are known") {
    LoadOptions options;
    options.resolve_include = [&](std::string_view, std::string_view path) {
        return std::optional(IncludedFile{
            std::string(path), path == "a" ? "include \"b\"\nball at=0,0\n" : "# nothing\n"});
    };
    const Scene scene = load_clean("include \"b\"\ninclude \"a\"\nball at=5,0\n", options);
    CHECK(scene.files == std::vector<std::string>{"test.level", "b", "a"});
    CHECK(scene.includes == std::vector<Include>{{0, 1, "b"}, {0, 2, "a"}, {2, 1, "b"}});
}

TEST_CASE("the hash changes with every text and override") {
    const auto hash = [](std::string_view lines, std::vector<std::string> overrides) {
        LoadOptions options;
        options.overrides = std::move(overrides);
        return load_lines(lines, options).scene.value().text_hash;
    };
    CHECK(hash("ball at=0,0\n", {}) == hash("ball at=0,0\n", {}));
    CHECK(hash("ball at=0,0\n", {}) != hash("ball at=0,0 \n", {}));
    CHECK(hash("ball at=0,0\n", {}) != hash("ball at=0,0\n", {"seed 4"}));
}

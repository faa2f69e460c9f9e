#include "terminal/draw/board.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "level/load.h"
#include "terminal/canvas/oklab.h"
#include "terminal/draw/draw.h"

using namespace carom;

namespace {

Scene scene_of(const std::string& text) {
    LoadResult result = load_level("carom 1 \"t\"\n" + text, "test.level");
    REQUIRE(result.scene);
    return std::move(*result.scene);
}

// A pool table of 200 x 100.
std::string pool_table(const std::string& more) {
    return "use cloth slide=0.2 roll=0.01 spin=10 g=10\nuse spin\nball cue at=40,50 r=3\n"
           "cue ball=cue power=0..10\n" +
           more;
}

int cells_of(const Canvas& canvas, Color color) {
    int count = 0;
    for (int row = 0; row < canvas.rows(); ++row)
        for (int column = 0; column < canvas.columns(); ++column)
            count += canvas.at(column, row).background == color ||
                     canvas.at(column, row).foreground == color;
    return count;
}

}  // namespace

TEST_CASE("board: the cloth of a table of any shape and with any number of pockets is whole") {
    std::string pegs;
    for (int i = 0; i < 10; ++i)
        pegs += "peg at=" + std::to_string(60 + 10 * i) + ",30 r=2\n";
    for (const std::string& table :
         {std::string("box 0,0 200,100\n"), std::string("box 0,0 200,100\npocket p at=0,0 r=6\n"),
          "box 0,0 200,100\npocket p at=0,50 r=6\npocket q at=200,50 r=6\n" + pegs,
          std::string("edge 0,0 200,0 200,100 20,100 close\n")}) {
        CAPTURE(table);
        const Board board(scene_of(pool_table(table)));
        REQUIRE_FALSE(board.is_empty());
        for (const Vec2 place : {Vec2{40, 50}, {190, 20}, {100, 90}, {150, 60}})
            CHECK(board.at(place) == Ground::board);
        for (const Vec2 place : {Vec2{-500, 50}, {100, 300}})
            CHECK(board.at(place) == Ground::none);
        CHECK(board.at({100, -3}) == Ground::cushion);
        CHECK(board.frame().high.x > 200.0);
    }
}

TEST_CASE("board: with few colours, cloth is a pattern of the colour with its hue") {
    const Scene scene = scene_of(pool_table("box 0,0 200,100\n"));
    constexpr char32_t light_shade = U'\u2591';
    const auto picture = [&](const Look& look, const Renderer& renderer) {
        Canvas canvas(80, 24);
        const Camera camera = fit_camera({{-20, -20}, {220, 120}}, {0, 0, 80, 24}, 2.0);
        ViewOptions options;
        options.look = look;
        options.renderer = &renderer;
        ViewMemory memory;
        draw_world(canvas, camera, scene, scene.world, {}, {}, options, memory);
        return canvas;
    };
    constexpr Color green = 2;
    for (const int colors : {8, 16})
        for (const bool is_light : {false, true}) {
            CAPTURE(colors);
            CAPTURE(is_light);
            const Canvas canvas = picture({colors, true, is_light}, half_block_renderer());
            CHECK(canvas.at(60, 12).glyph == light_shade);
            CHECK(canvas.at(60, 12).foreground == green);
            CHECK(canvas.at(0, 0).glyph == U' ');
        }
    CHECK(picture({0, true, false}, half_block_renderer()).at(60, 12).glyph == U' ');
    CHECK(picture({16, true, false}, ascii_renderer()).at(60, 12).glyph == U' ');
    CHECK(picture({16, false, false}, half_block_renderer()).at(60, 12).glyph == U' ');
    CHECK(picture({256, true, false}, half_block_renderer()).at(60, 12).glyph != light_shade);
}

TEST_CASE("board: of 256 colours, an area that lies on another one has a colour of its own") {
    const Scene scene = scene_of(
        "world 0,0 40,20\nball b at=35,10 r=1\npaint rect 0,0 40,20 color=#2e7d43\n"
        "paint circle at=20,10 r=6 color=#348a4b\n");
    Canvas canvas(40, 10);
    ViewOptions options;
    options.renderer = &half_block_renderer();
    options.look.colors = 256;
    ViewMemory memory;
    draw_world(canvas, fit_camera(scene.view, {0, 0, 40, 10}, 2.0), scene, scene.world, {}, {},
               options, memory);
    CHECK(canvas.at(20, 5).foreground != canvas.at(5, 5).foreground);
}

TEST_CASE("board: gaps as wide as a ball do not let the outside in, and a lost wall does") {
    const Board gap(scene_of(pool_table("edge 0,0 98,0\nedge 104,0 200,0 200,100 0,100 0,0\n")));
    REQUIRE_FALSE(gap.is_empty());
    CHECK(gap.at({100, 50}) == Ground::board);
    CHECK(gap.at({101, -40}) == Ground::none);
    CHECK(Board(scene_of(pool_table("edge 0,0 200,0\n"))).is_empty());
}

TEST_CASE("board: a pool table's rails have square corners, and hold the jaws of its pockets") {
    const Scene scene = scene_of(
        pool_table("edge 6,0 194,0\nedge 6,100 194,100\nedge 0,6 0,94\nedge 200,6 200,94\n"
                   "edge 6,0 2,-12\nedge 0,6 -12,2\n"
                   "pocket c at=-4,-4 r=6\npocket c at=204,-4 r=6\npocket c at=-4,104 r=6\n"
                   "pocket c at=204,104 r=6\n"));
    const Board board(scene);
    REQUIRE_FALSE(board.is_empty());
    const Box& frame = board.frame();
    const double inside = 0.02 * size(frame).x;
    CHECK(board.at(frame.low + Vec2{inside, inside}) == Ground::rail);
    CHECK(board.at(frame.high - Vec2{inside, inside}) == Ground::rail);
    CHECK(frame.low.y < -12.0);
    CHECK(frame.low.x < -12.0);
}

TEST_CASE("board: a table without pockets has square corners too") {
    const Scene scene = scene_of(pool_table("box 0,0 200,100\n"));
    const Board board(scene);
    REQUIRE_FALSE(board.is_empty());
    const Box& frame = board.frame();
    const double inside = 0.003 * size(frame).x;
    for (const double x : {frame.low.x + inside, frame.high.x - inside})
        for (const double y : {frame.low.y + inside, frame.high.y - inside})
            CHECK(board.at({x, y}) == Ground::rail);
}

TEST_CASE("board: the rail covers the ends of jaws, but no wall of a narrow lane with a hole") {
    const Board table(scene_of(
        pool_table("edge 6,0 94,0 94,-16\nedge 106,-16 106,0 194,0\nedge 6,100 194,100\n"
                   "edge 0,6 0,94\nedge 200,6 200,94\npocket m at=100,-5 r=6\n"
                   "pocket c at=-4,-4 r=6\npocket c at=204,-4 r=6\npocket c at=-4,104 r=6\n"
                   "pocket c at=204,104 r=6\n")));
    for (const double x : {94.0, 106.0}) {
        CHECK(table.at({x, 3}) == Ground::board);
        CHECK(table.at({x, -14}) == Ground::rail);
    }
    const Board lane(
        scene_of(pool_table("edge 0,0 100,0 100,40 200,40 200,60 100,60 100,100 0,100 0,0\n"
                            "pocket hole at=180,50 r=6\n")));
    for (const Vec2 place : {Vec2{150, 50}, Vec2{150, 41}, Vec2{150, 59}, Vec2{199, 50}})
        CHECK(lane.at(place) == Ground::board);
}

TEST_CASE("board: what is closed off from the balls of a pinball table is a plastic") {
    const Board board(scene_of(
        "ball b at=10,50 r=2\nbox 0,0 100,100\nslingshot s 60,20 70,50 kick=1\n"
        "edge 70,50 70,20 60,20\nmaterial rail layer=1\nedge rail 0,80 100,80\nramp up 0,80 100,80 "
        "pass=up layer=1 r=1\n"));
    CHECK(board.at({67, 30}) == Ground::plastic);
    CHECK(board.at({30, 30}) == Ground::board);
    CHECK(board.at({30, 90}) == Ground::board);
}

TEST_CASE("board: other levels have one where their theme says so") {
    const std::string level = "ball a at=5,5\nbox 0,0 10,10\n";
    CHECK(Board(scene_of(level)).is_empty());
    const Scene scene = scene_of("theme board=navy\n" + level);
    CHECK(Board(scene).at({5, 5}) == Ground::board);
    CHECK(shown_box(scene, Board(scene)).high.x >= 10.0);
}

TEST_CASE("draw: a label moves aside from an edge, and is dark or light enough to be read") {
    // The label would begin on the edge; two columns to the right the ground is free.
    const Scene scene = scene_of(
        "world 0,0 40,20\npaint rect 0,0 40,20 color=#203040\nedge 10,0 10,20 r=0.5\n"
        "ball b at=35,10 r=1\nlabel \"CLEAR\" at=9,10 align=left color=#302030\n");
    Canvas canvas(40, 10);
    ViewOptions options;
    options.renderer = &half_block_renderer();
    options.look.colors = direct_colors;
    ViewMemory memory;
    draw_world(canvas, fit_camera(scene.view, {0, 0, 40, 10}, 2.0), scene, scene.world, {}, {},
               options, memory);
    int letters = 0;
    for (int row = 0; row < 10; ++row)
        for (int column = 0; column < 40; ++column) {
            const Cell& cell = canvas.at(column, row);
            if (cell.glyph < U'A' || cell.glyph > U'Z') continue;
            ++letters;
            CHECK(column > 10);
            const double text = lab_of(rgb_of(cell.foreground)).lightness;
            const double ground = lab_of(rgb_of(cell.background)).lightness;
            CHECK(std::abs(text - ground) > 0.2);
        }
    CHECK(letters == 5);
}

TEST_CASE("draw: a label beside another one moves aside, so that the two are two words") {
    const Scene scene = scene_of(
        "world 0,0 40,20\npaint rect 0,0 40,20 color=#203040\nball b at=35,10 r=1\n"
        "label \"CRANE\" at=10,10 align=left\nlabel \"ANVIL\" at=15,10 align=left\n"
        "label \"MOULD\" at=5,10 align=left\n");
    Canvas canvas(40, 10);
    ViewOptions options;
    options.renderer = &half_block_renderer();
    options.look.colors = direct_colors;
    ViewMemory memory;
    draw_world(canvas, fit_camera(scene.view, {0, 0, 40, 10}, 2.0), scene, scene.world, {}, {},
               options, memory);
    CHECK(canvas.text().find("MOULD██CRANE██ANVIL") != std::string::npos);
}

TEST_CASE("draw: a label that is half on a part, or half under a ball at rest, is left out") {
    const auto shown = [](const std::string& more) {
        const Scene scene = scene_of(
            "world 0,0 40,20\npaint rect 0,0 40,20 color=#203040\n"
            "label \"MILL\" at=20,10\n" +
            more);
        Canvas canvas(40, 10);
        ViewOptions options;
        options.renderer = &half_block_renderer();
        options.look.colors = direct_colors;
        ViewMemory memory;
        draw_world(canvas, fit_camera(scene.view, {0, 0, 40, 10}, 2.0), scene, scene.world, {}, {},
                   options, memory);
        return canvas.text().find('M') != std::string::npos;
    };
    CHECK(shown("ball b at=35,10 r=1\n"));
    // A wall in every place within three columns.
    CHECK_FALSE(
        shown("ball b at=35,10 r=1\nedge 17,9 17,11 r=1\nedge 20,9 20,11 r=0.5\n"
              "edge 23,9 23,11 r=1\n"));
    CHECK_FALSE(shown("ball b at=20,10 r=1\nball c at=16,10 r=1\nball d at=24,10 r=1\n"));
}

TEST_CASE("draw: a label that reaches out of the view moves into it, or is left out") {
    const Scene scene = scene_of(
        "world 0,0 80,40\ntheme board=#203040\nball a at=5,5 r=1\n"
        "label \"NEAR EDGE\" at=42,30 align=left\nlabel \"BEYOND\" at=37,10 align=left\n");
    Canvas canvas(60, 20);
    const CellArea area{10, 0, 40, 20};
    const Camera camera = fit_camera({{10.0, 0.0}, {50.0, 40.0}}, area, 2.0);
    ViewOptions options;
    options.renderer = &ascii_renderer();
    ViewMemory memory;
    draw_world(canvas, camera, scene, scene.world, {}, {}, options, memory);
    CHECK(canvas.text().find("NEAR EDGE") != std::string::npos);
    CHECK(canvas.text().find("BEYOND") != std::string::npos);
    canvas.fill({});
    const Camera aside = fit_camera({{6.0, 0.0}, {46.0, 40.0}}, area, 2.0);
    draw_world(canvas, aside, scene, scene.world, {}, {}, options, memory);
    CHECK(canvas.text().find("NE") == std::string::npos);
    CHECK(canvas.text().find("BEYOND") != std::string::npos);
}

TEST_CASE("draw: a ball named red is red, paint lies under it, and a label on free ground") {
    const Scene scene = scene_of(
        "world 0,0 40,20\npaint rect 0,0 40,20 color=#203040\nball red at=10,10 v=5,0 r=4\n"
        "ball b at=30,10 color=#30c040 r=4\nlabel \"ON FREE GROUND\" at=10,10 align=left\n");
    for (const Renderer* renderer : {&half_block_renderer(), &ascii_renderer()}) {
        Canvas canvas(40, 10);
        ViewOptions options;
        options.renderer = renderer;
        options.look.colors = direct_colors;
        ViewMemory memory;
        draw_world(canvas, fit_camera(scene.view, {0, 0, 40, 10}, 2.0), scene, scene.world, {}, {},
                   options, memory);
        CHECK(cells_of(canvas, direct_color({0xd9, 0x2b, 0x2b})) > 5);
        CHECK(cells_of(canvas, direct_color({0x30, 0xc0, 0x40})) > 5);
        CHECK(cells_of(canvas, direct_color({0x20, 0x30, 0x40})) > 200);
        // The label begins under the red ball, which is on its way, and shows only beside it.
        CHECK(canvas.text().find("ON FREE") == std::string::npos);
        CHECK(canvas.text().find("GROUND") != std::string::npos);
    }
}

namespace {

// A lane of wood with a gutter along its middle.
Scene lane_with_gutter() {
    return scene_of(
        pool_table("box 0,0 200,100\ntheme board=#b98a52 rail=#5b3a1e\n"
                   "zone gutter 20,20 180,20 r=12 sink color=#2a1b12\n"));
}

}  // namespace

TEST_CASE("board: a sink with a colour is one of the ground, as brown in 256 colours as the wood") {
    const Scene scene = lane_with_gutter();
    for (const Renderer* const renderer :
         {&ascii_renderer(), &half_block_renderer(), &octant_renderer(), &braille_renderer()}) {
        for (const int colors : {256, direct_colors}) {
            CAPTURE(renderer->name);
            CAPTURE(colors);
            Canvas canvas(100, 25);
            const Camera camera = fit_camera(scene.view, {0, 0, 100, 25}, 2.0);
            ViewOptions options;
            options.look.colors = colors;
            options.renderer = renderer;
            ViewMemory memory;
            draw_world(canvas, camera, scene, scene.world, {}, {}, options, memory);
            const auto color_at = [&](Vec2 place) {
                const CellPoint at = to_cells(camera, place);
                const Cell& cell = canvas.at(static_cast<int>(at.column), static_cast<int>(at.row));
                CHECK((cell.glyph == U' ' || cell.foreground == cell.background));
                REQUIRE(cell.background >= 0);
                return rgb_of(cell.background);
            };
            const Rgb gutter = color_at({150, 20});
            const Rgb lane = color_at({150, 70});
            CHECK(luminance(gutter) < 0.8 * luminance(lane));
            CHECK(gutter.red > gutter.green);
            CHECK(gutter.green > gutter.blue + 20);
        }
    }
}

#include "terminal/draw/draw.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "level/load.h"
#include "terminal/canvas/mosaic.h"
#include "terminal/draw/ground.h"

using namespace carom;

namespace {

Scene table(const Box& view) {
    Scene scene;
    scene.view = view;
    scene.world.edit_definition().kinds.resize(3);
    scene.world.edit_definition().materials.resize(2);
    return scene;
}

BallId put_ball(Scene& scene, Vec2 position, double radius, Vec2 velocity = {},
                ClassIndex kind = 0) {
    BallSpec spec;
    spec.kind = kind;
    spec.position = position;
    spec.velocity = velocity;
    spec.radius = radius;
    return add_ball(scene.world, spec);
}

struct Drawing {
    Canvas canvas;
    ViewMemory memory;

    Drawing(int columns, int rows) : canvas(columns, rows) {}
    Drawing& draw(const Scene& scene, const ViewOptions& options = {},
                  const Annotations& annotations = {}, std::span<const Contact> contacts = {}) {
        const Camera camera = fit_camera(scene.view, {0, 0, canvas.columns(), canvas.rows()}, 2.0);
        draw_world(canvas, camera, scene, scene.world, contacts, annotations, options, memory);
        return *this;
    }
    std::string text() const { return "\n" + canvas.text(); }
};

void turn_on(ViewOptions& options, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names)
        options.overlays[overlay_named(name)] = true;
}

ViewOptions in(const Renderer& renderer) {
    ViewOptions options;
    options.renderer = &renderer;
    return options;
}

int cells_that_are(const Canvas& canvas, char32_t glyph) {
    int count = 0;
    for (int row = 0; row < canvas.rows(); ++row) {
        for (int column = 0; column < canvas.columns(); ++column) {
            count += canvas.at(column, row).glyph == glyph;
        }
    }
    return count;
}

}  // namespace

TEST_CASE("auto picks a renderer that the terminal can show") {
    ViewOptions options;
    CHECK(&renderer_in_force(options) == &half_block_renderer());
    options.look.colors = 0;
    CHECK(&renderer_in_force(options) == &braille_renderer());
    options.look.utf8 = false;
    CHECK(&renderer_in_force(options) == &ascii_renderer());
    options.renderer = &braille_renderer();
    CHECK(&renderer_in_force(options) == &ascii_renderer());
    options.look.utf8 = true;
    CHECK(&renderer_in_force(options) == &braille_renderer());
}

TEST_CASE("a ball between two walls, in ASCII") {
    Scene scene = table({{0, 0}, {20, 10}});
    add_capsule(scene.world, {{0, 0.5}, {20, 0.5}, 0.5}, 0);
    add_capsule(scene.world, {{2, 2}, {2, 10}, 0.0}, 1);
    put_ball(scene, {12, 5}, 3.5);
    CHECK(Drawing(41, 11).draw(scene, in(ascii_renderer())).text() == R"(
    |
    |
    |               .;~^""^~;.
    |              ;^::::::::^;
    |             ]'::::::::::'[
    |             [::::::::::::]
    |             ].::::::::::.[
    |              ^;::::::::;^
    |               '^~;..;~^'
#########################################
#########################################
)");
}

TEST_CASE("a ball between two walls, in braille") {
    Scene scene = table({{0, 0}, {20, 10}});
    add_capsule(scene.world, {{0, 0.5}, {20, 0.5}, 0.5}, 0);
    add_capsule(scene.world, {{2, 2}, {2, 10}, 0.0}, 1);
    put_ball(scene, {12, 5}, 3.5);
    CHECK(Drawing(41, 11).draw(scene, in(braille_renderer())).text() == R"(
    ⢠
    ⢸
    ⢸               ⣠⢴⢖⢟⢝⢝⢖⢦⣄
    ⢸             ⢠⢞⢕⢕⢕⢕⢕⢕⢕⢕⢝⢷⡄
    ⢸            ⢀⣟⢕⢕⢕⢕⢕⢕⢕⢕⢕⢕⢕⢽⡀
    ⢸            ⢸⢕⢕⢕⢕⢕⢕⢕⢕⢕⢕⢕⢕⢕⡇
    ⢸            ⠈⣗⢕⢕⢕⢕⢕⢕⢕⢕⢕⢕⢕⣽⠁
    ⢸             ⠘⢷⣕⢕⢕⢕⢕⢕⢕⢕⢕⡵⠃
    ⠸               ⠙⠳⠵⣕⣕⣵⠵⠗⠋
⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤⣤
⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛⠛
)");
}

TEST_CASE("a ball between two walls, in half blocks") {
    Scene scene = table({{0, 0}, {20, 10}});
    add_capsule(scene.world, {{0, 0.5}, {20, 0.5}, 0.5}, 0);
    put_ball(scene, {12, 5}, 3.5);
    CHECK(Drawing(21, 6).draw(scene, in(half_block_renderer())).text() == R"(

         ▄▄▀▀▀▄▄
         ▀▀▀███▀
         ▀████▀▀
         ▀▀▀▀▀▀▀
▀▀▀▀▀▀▀▀▀▀▀▀▀▀▀▀▀▀▀▀▀
)");
}

TEST_CASE("an outlined ball has a radius in its direction of motion") {
    Scene scene = table({{0, 0}, {10, 10}});
    put_ball(scene, {5, 5}, 4.0, {3, 3});
    ViewOptions options = in(ascii_renderer());
    options.ball_style = BallStyle::outline;
    CHECK(Drawing(22, 11).draw(scene, options).text() == R"(

       .;~~~~;.
    ./^'      '^..
   :^         .' ^:
   [        .'    ]
  ][       '      ][
   [              ]
   ';            ;`
    '*;.      .;*'
       "^~~~~^"

)");
    // At rest it has none.
    scene.world.edit_balls().velocity[0] = {};
    CHECK(Drawing(22, 11).draw(scene, options).text() == R"(

       .;~~~~;.
    ./^'      '^\.
   :^            ^:
   [              ]
  ][              ][
   [              ]
   ';            ;`
    '*;.      .;*'
       "^~~~~^"

)");
}

TEST_CASE("only the camera's area is drawn on") {
    Scene scene = table({{0, 0}, {10, 10}});
    put_ball(scene, {5, 5}, 40.0);
    add_capsule(scene.world, {{-100, 5}, {100, 5}, 1.0}, 0);
    for (const Renderer& renderer : renderers()) {
        Canvas canvas(30, 12);
        canvas.fill({U'x'});
        ViewMemory memory;
        ViewOptions options = in(renderer);
        options.labels = Labels::all;
        options.trails = true;
        turn_on(options, {"grid", "velocities", "contacts"});
        Annotations annotations;
        annotations.cursor = Vec2{-1, 5};
        annotations.cue = CueLine{{5, 5}, {-20, 5}, "12 m/s"};
        annotations.selected_ball = BallId{0};
        const Camera camera = zoomed(fit_camera(scene.view, {5, 2, 10, 6}, 2.0), {7, 4}, 1.7);
        draw_world(canvas, camera, scene, scene.world, {}, annotations, options, memory);
        CHECK(cells_that_are(canvas, U'x') == 30 * 12 - 10 * 6);
    }
}

TEST_CASE("the previous picture leaves no traces") {
    Scene scene = table({{0, 0}, {10, 10}});
    put_ball(scene, {2, 5}, 1.0);
    for (const Renderer& renderer : renderers()) {
        Drawing moved(20, 10);
        moved.draw(scene, in(renderer));
        Scene later = scene;
        later.world.edit_balls().position[0] = {8, 5};
        moved.draw(later, in(renderer));
        CHECK(moved.text() == Drawing(20, 10).draw(later, in(renderer)).text());
    }
}

TEST_CASE("on a torus, a ball across a side shows on both") {
    Scene scene = table({{0, 0}, {20, 10}});
    scene.world.edit_definition().model.wrap = Box{{0, 0}, {20, 10}};
    put_ball(scene, {19.5, 9.5}, 2.0);
    CHECK(Drawing(41, 11).draw(scene, in(ascii_renderer())).text() == R"(
   \                                /
   /                                \
--'                                  '---






--.                                  .---
   \                                /
)");
}

TEST_CASE("found 3: beyond the border of a torus its copies are drawn, not a void") {
    Scene scene = table({{0, 0}, {20, 10}});
    scene.world.edit_definition().model.wrap = Box{{0, 0}, {20, 10}};
    put_ball(scene, {10, 5}, 2.0);
    const std::string text = Drawing(81, 11).draw(scene, in(ascii_renderer())).text();
    // The whole ball, and half of one on either side.
    CAPTURE(text);
    CHECK(std::ranges::count(text, '/') == 4);
    CHECK(std::ranges::count(text, '\\') == 4);
}

TEST_CASE("copies beyond the border of a torus are darker than what is within") {
    Scene scene = table({{0, 0}, {20, 10}});
    scene.world.edit_definition().model.wrap = Box{{0, 0}, {20, 10}};
    put_ball(scene, {10, 5}, 2.0);
    for (const int colors : {0, 16, 256}) {
        CAPTURE(colors);
        ViewOptions options = in(half_block_renderer());
        options.look.colors = colors;
        Drawing drawing(121, 11);
        drawing.draw(scene, options);
        // 40 columns are a torus.
        double within = 0.0;
        double beyond = 0.0;
        int dim_within = 0;
        int dim_beyond = 0;
        for (int column = 0; column < drawing.canvas.columns(); ++column) {
            const Cell& cell = drawing.canvas.at(column, 5);
            const bool is_within = std::abs(column - 60) < 15;
            if (cell.foreground >= 0) {
                double& most = is_within ? within : beyond;
                most = std::max(most, luminance(rgb_of(cell.foreground)));
            }
            (is_within ? dim_within : dim_beyond) += (cell.attributes & dim) != 0;
        }
        CHECK(dim_within == 0);
        if (colors == 256)
            CHECK(beyond < 0.7 * within);
        else
            CHECK(dim_beyond > 0);
    }
}

TEST_CASE("a ball smaller than a cell is visible in every renderer, at any zoom") {
    for (const Renderer& renderer : renderers()) {
        for (const double radius : {1e-9, 0.01, 0.3, 0.7, 1.0, 1.6}) {
            for (int place = 0; place < 30; ++place) {
                Scene scene = table({{0, 0}, {20, 20}});
                put_ball(scene, {10 + place * 0.071, 10 + place * 0.093}, radius);
                Drawing drawing(20, 10);
                drawing.draw(scene, in(renderer));
                CAPTURE(radius);
                CAPTURE(place);
                REQUIRE(cells_that_are(drawing.canvas, U' ') < 200);
            }
        }
    }
}

TEST_CASE("in ASCII, balls of few columns are characters that do not change while they move") {
    for (const auto& [radius, stamp] : {std::pair{0.5, "o"}, {1.0, "()"}, {1.6, "(o)"}}) {
        for (int step = 0; step < 20; ++step) {
            Scene scene = table({{0, 0}, {20, 20}});
            put_ball(scene, {5 + step * 0.31, 8 + step * 0.17}, radius);
            Drawing drawing(21, 11);
            drawing.draw(scene, in(ascii_renderer()));
            CHECK(drawing.text().find(stamp) != std::string::npos);
            CHECK(cells_that_are(drawing.canvas, U' ') ==
                  21 * 11 - static_cast<int>(std::string_view(stamp).size()));
        }
    }
    // Without colour, another kind has other characters.
    Scene scene = table({{0, 0}, {20, 20}});
    put_ball(scene, {10, 10}, 0.5, {}, 1);
    ViewOptions options = in(ascii_renderer());
    options.look.colors = 0;
    CHECK(Drawing(21, 11).draw(scene, options).text().find('@') != std::string::npos);
}

TEST_CASE("in ASCII, a peg of about a column is one character") {
    Scene scene = table({{0, 0}, {20, 20}});
    add_capsule(scene.world, {{5, 5}, {5, 5}, 0.5}, 0);
    add_capsule(scene.world, {{15, 5}, {15, 5}, 3.0}, 0);
    const std::string text = Drawing(21, 11).draw(scene, in(ascii_renderer())).text();
    CHECK(std::count(text.begin(), text.end(), '+') == 1);
    CHECK(std::count(text.begin(), text.end(), '#') > 1);
}

TEST_CASE("without colour, balls are told from edges, and kinds from each other") {
    for (const Renderer& renderer : renderers()) {
        std::vector<std::string> looks;
        for (int what = 0; what < 3; ++what) {
            Scene scene = table({{0, 0}, {12, 12}});
            // Pixels have no patterns: there, labels tell kinds apart.
            if (what == 1 && renderer.has_pixels()) scene.ball_names = {"b"};
            if (what < 2) put_ball(scene, {6, 6}, 5.0, {}, static_cast<ClassIndex>(what));
            if (what == 2) add_capsule(scene.world, {{6, 6}, {6, 6}, 5.0}, 0);
            ViewOptions options = in(renderer);
            options.look.colors = 0;
            if (!renderer.has_pixels()) options.labels = Labels::none;
            looks.push_back(Drawing(24, 12).draw(scene, options).text());
        }
        CHECK(looks[0] != looks[1]);
        CHECK(looks[0] != looks[2]);
        CHECK(looks[1] != looks[2]);
    }
}

TEST_CASE("without colour, balls that are large enough show their names") {
    Scene scene = table({{0, 0}, {24, 12}});
    put_ball(scene, {6, 6}, 4.0);
    put_ball(scene, {16, 6}, 4.0);
    put_ball(scene, {22, 6}, 0.4);
    scene.ball_names = {"cue", "a name too long", ""};
    ViewOptions options = in(ascii_renderer());
    options.look.colors = 0;
    const std::string mono = Drawing(49, 13).draw(scene, options).text();
    CHECK(mono.find("cue") != std::string::npos);
    // Found 26: no ids unasked.
    CHECK(mono.find("1") == std::string::npos);
    CHECK(mono.find("2") == std::string::npos);
    options.look.colors = 256;
    CHECK(Drawing(49, 13).draw(scene, options).text().find("cue") == std::string::npos);
    options.labels = Labels::all;
    const std::string all = Drawing(49, 13).draw(scene, options).text();
    for (const char* id : {"0", "1", "2"})
        CHECK(all.find(id) != std::string::npos);
}

TEST_CASE("a label on half blocks has the ball's colour as its background") {
    Scene scene = table({{0, 0}, {12, 12}});
    put_ball(scene, {6, 6}, 5.0);
    ViewOptions options = in(half_block_renderer());
    options.labels = Labels::all;
    Drawing drawing(24, 12);
    drawing.draw(scene, options);
    bool is_found = false;
    for (int column = 0; column < 24; ++column) {
        const Cell& cell = drawing.canvas.at(column, 6);
        if (cell.glyph == U'0') {
            is_found = true;
            CHECK(cell.background == ink_of_class(0, options.look).color);
        }
    }
    CHECK(is_found);
}

TEST_CASE("a sink is an outline, and with a colour of its own it is filled") {
    Scene scene = table({{0, 0}, {40, 20}});
    Zone pond;
    pond.shape = {{15, 10}, {25, 10}, 8.0};
    pond.effect = Zone::Effect::sink;
    scene.world.edit_definition().zones.push_back(pond);
    scene.world.edit_ledger().counters.push_back(0);
    const auto middle = [&] {
        Drawing drawing(80, 20);
        drawing.draw(scene, in(ascii_renderer()));
        return std::pair(drawing.canvas.at(40, 8).glyph, cells_that_are(drawing.canvas, U' '));
    };
    const auto outline = middle();
    scene.dress.zones.assign(1, Rgb24{0x2878c8});
    const auto filled = middle();
    CHECK(outline.first == U' ');
    CHECK(filled.first != U' ');
    CHECK(filled.second < outline.second);
}

TEST_CASE("a counter is drawn over each bin, staggered if there is no room side by side") {
    Scene scene = table({{0, 0}, {16, 10}});
    for (int i = 0; i < 4; ++i) {
        const double x = 2.0 + 4.0 * i;
        Zone zone;
        zone.shape = {{x, 0}, {x, 4}, 1.0};
        zone.counter = static_cast<std::uint32_t>(i);
        scene.world.edit_definition().zones.push_back(zone);
        scene.world.edit_ledger().counters.push_back(static_cast<std::uint64_t>(1234 + i));
    }
    const std::string wide = Drawing(40, 12).draw(scene, in(ascii_renderer())).text();
    for (const char* count : {"1234", "1235", "1236", "1237"}) {
        CHECK(wide.find(count) != std::string::npos);
    }
    const std::string narrow = Drawing(16, 10).draw(scene, in(ascii_renderer())).text();
    for (const char* count : {"1234", "1235", "1236", "1237"}) {
        CAPTURE(narrow);
        CHECK(narrow.find(count) != std::string::npos);
    }
}

TEST_CASE("a contact is a line between the two bodies") {
    Scene scene = table({{0, 0}, {20, 10}});
    put_ball(scene, {2, 5}, 0.5);
    put_ball(scene, {18, 5}, 0.5);
    Contact contact;
    contact.a = 0;
    contact.b = 1;
    ViewOptions options = in(ascii_renderer());
    turn_on(options, {"contacts"});
    Drawing drawing(40, 11);
    drawing.draw(scene, options, {}, {&contact, 1});
    const Ink ink = ink_of(Role::contact, options.look);
    int lit = 0;
    for (int column = 0; column < 40; ++column) {
        lit += drawing.canvas.at(column, 5).foreground == ink.color;
    }
    CHECK(lit > 25);
    // One of them is gone: no line.
    remove_ball(scene.world, BallId{1});
    CHECK(drawing.draw(scene, options, {}, {&contact, 1}).text() ==
          Drawing(40, 11).draw(scene, options).text());
}

TEST_CASE("a velocity is an arrow from the rim of its ball, longer for a higher speed") {
    Scene scene = table({{0, 0}, {40, 10}});
    put_ball(scene, {4, 3}, 2.0, {6, 0});
    put_ball(scene, {4, 8}, 1.0, {-3, 0});
    put_ball(scene, {30, 5}, 1.0);
    ViewOptions options = in(ascii_renderer());
    turn_on(options, {"velocities"});
    CHECK(Drawing(41, 6).draw(scene, options).text() == R"(

 ---()

   /""\   ._                  ()
   \__----''

)");
}

TEST_CASE("grid lines are at round coordinates, and the broad phase at its cells") {
    Scene scene = table({{0, 0}, {30, 10}});
    ViewOptions options = in(ascii_renderer());
    turn_on(options, {"grid"});
    // Found 6: they say which coordinates.
    CHECK(Drawing(31, 6).draw(scene, options).text() == R"(
10--------+---------+---------+
|         |         |         |
|         |         |         |
|         |         |         |
|         |         |         |
+0--------+10-------+20-------+
)");
    // A number that would be cut is left out.
    CHECK(Drawing(32, 6).draw(scene, options).text().find("|3") == std::string::npos);
    options.overlays = {};
    turn_on(options, {"broad-phase"});
    Annotations annotations;
    annotations.broad_phase = CellGrid{{2, 1}, 6.0};
    CHECK(Drawing(31, 6).draw(scene, options, annotations).text() == R"(
  |     |     |     |     |
  |     |     |     |     |
--+-----+-----+-----+-----+----
  |     |     |     |     |
  |     |     |     |     |
--+-----+-----+-----+-----+----
)");
    // Cells too small to be told apart are not drawn.
    annotations.broad_phase = CellGrid{{2, 1}, 1.0};
    CHECK(Drawing(31, 6).draw(scene, options, annotations).text() == "\n\n\n\n\n\n\n");
}

TEST_CASE("trails are behind balls and edges, and vanish when switched off") {
    Scene scene = table({{0, 0}, {20, 10}});
    put_ball(scene, {2, 5}, 1.0);
    ViewOptions options = in(ascii_renderer());
    options.trails = true;
    Drawing drawing(41, 6);
    for (int step = 0; step < 8; ++step) {
        scene.world.edit_balls().position[0].x += 1.5;
        ++scene.world.edit_tick();
        drawing.draw(scene, options);
    }
    CHECK(drawing.text() == R"(



             ...........()


)");
    options.trails = false;
    drawing.draw(scene, options);
    options.trails = true;
    CHECK(drawing.draw(scene, options).text() == Drawing(41, 6).draw(scene, options).text());
}

TEST_CASE("annotations show the player's actions, not by colour alone") {
    Scene scene = table({{0, 0}, {20, 10}});
    put_ball(scene, {10, 5}, 1.5);
    const CapsuleId edge = add_capsule(scene.world, {{2, 2}, {8, 2}, 0.0}, 0);
    const ViewOptions options = in(ascii_renderer());
    const std::string bare = Drawing(41, 11).draw(scene, options).text();

    Annotations selected;
    selected.selected_ball = BallId{0};
    const std::string ball = Drawing(41, 11).draw(scene, options, selected).text();
    CHECK(ball.find('[') != std::string::npos);
    CHECK(ball.find(']') != std::string::npos);

    Annotations ends;
    ends.selected_capsule = edge;
    const std::string handles = Drawing(41, 11).draw(scene, options, ends).text();
    CHECK(std::count(handles.begin(), handles.end(), 'O') ==
          std::count(bare.begin(), bare.end(), 'O') + 2);

    Annotations cue;
    cue.cue = CueLine{{10, 5}, {4, 8}, "3.20 m/s"};
    CHECK(Drawing(41, 11).draw(scene, options, cue).text().find("3.20 m/s") != std::string::npos);

    Annotations cursor;
    cursor.cursor = Vec2{15, 3};
    Drawing pointed(41, 11);
    pointed.draw(scene, options, cursor);
    CHECK((pointed.canvas.at(30, 7).attributes & reverse) != 0);
}

TEST_CASE("annotations of missing bodies are not drawn") {
    Scene scene = table({{0, 0}, {20, 10}});
    Annotations annotations;
    annotations.selected_ball = BallId{7};
    annotations.selected_capsule = CapsuleId{7};
    CHECK(Drawing(41, 11).draw(scene, {}, annotations).text() ==
          Drawing(41, 11).draw(scene).text());
}

TEST_CASE("worlds that are not finite, and windows without cells, do no harm") {
    Scene scene = table({{0, 0}, {20, 10}});
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double x : {0.0, 1e300, -1e300, infinity, std::nan("")}) {
        put_ball(scene, {5, 5}, 1.0, {1, 2});
        scene.world.edit_balls().position.back() = {x, x};
        put_ball(scene, {5, 5}, 1.0);
        scene.world.edit_balls().velocity.back() = {x, -x};
        add_capsule(scene.world, {{x, 0}, {3, x}, 0.0}, 0);
    }
    for (const Renderer& renderer : renderers()) {
        for (const ColorBy color_by :
             {ColorBy::kind, ColorBy::speed, ColorBy::mass, ColorBy::ball}) {
            ViewOptions options = in(renderer);
            options.color_by = color_by;
            options.trails = true;
            turn_on(options, {"velocities", "grid", "broad-phase"});
            options.labels = Labels::all;
            Annotations annotations;
            annotations.cursor = Vec2{infinity, std::nan("")};
            annotations.cue = CueLine{{0, 0}, {infinity, 1e300}, "fast"};
            annotations.broad_phase = CellGrid{{0, 0}, 1e-300};
            for (const auto& [columns, rows] : {std::pair{0, 0}, {1, 1}, {20, 8}, {300, 2}}) {
                Drawing drawing(columns, rows);
                for (int frame = 0; frame < 3; ++frame) {
                    ++scene.world.edit_tick();
                    drawing.draw(scene, options, annotations);
                }
                CHECK(drawing.canvas.columns() == columns);
            }
        }
    }
}

TEST_CASE("speed colours go from slow to fast, and decay slowly") {
    Scene scene = table({{0, 0}, {20, 10}});
    put_ball(scene, {5, 5}, 2.0, {0.1, 0});
    put_ball(scene, {15, 5}, 2.0, {10, 0});
    ViewOptions options = in(half_block_renderer());
    options.color_by = ColorBy::speed;
    Drawing drawing(42, 11);
    drawing.draw(scene, options);
    CHECK(drawing.canvas.at(11, 5).foreground == ink_of_scale(0.0, options.look).color);
    CHECK(drawing.canvas.at(31, 5).foreground == ink_of_scale(1.0, options.look).color);
    // A moment later the fast ball has slowed down, but the scale still remembers its speed.
    scene.world.edit_balls().velocity[1] = {5, 0};
    ++scene.world.edit_tick();
    drawing.draw(scene, options);
    CHECK(drawing.canvas.at(31, 5).foreground == ink_of_scale(0.5, options.look).color);
}

TEST_CASE("balls of a single kind each have their own colour, else each kind has one") {
    Scene scene = table({{0, 0}, {20, 10}});
    put_ball(scene, {5, 5}, 2.0);
    put_ball(scene, {15, 5}, 2.0);
    const auto colors = [&] {
        const Drawing drawing = Drawing(41, 11).draw(scene, in(ascii_renderer()));
        return std::pair{drawing.canvas.at(10, 4).foreground, drawing.canvas.at(30, 4).foreground};
    };
    CHECK(colors().first != colors().second);
    put_ball(scene, {10, 9}, 0.5, {}, 1);
    CHECK(colors().first == colors().second);
}

TEST_CASE("small pegs of one size have one shape in half blocks, without dim borders") {
    for (const double x : {5.0, 5.2, 5.5, 5.85}) {
        CAPTURE(x);
        Scene scene = table({{0, 0}, {20, 10}});
        const Vec2 at{x, 5.3 - 0.5 * (x - 5.0)};
        add_capsule(scene.world, {at, at, 0.8}, 0);
        ViewOptions options = in(half_block_renderer());
        const Canvas canvas = Drawing(20, 5).draw(scene, options).canvas;
        const Color ink = ink_of_material(0, options.look).color;
        int pixels = 0;
        for (int row = 0; row < canvas.rows(); ++row)
            for (int column = 0; column < canvas.columns(); ++column) {
                const Cell& cell = canvas.at(column, row);
                if (cell.glyph == U' ') continue;
                CHECK(cell.foreground == ink);
                pixels += cell.glyph == U'\u2588' || cell.background == ink ? 2 : 1;
            }
        CHECK(pixels == 4);
    }
}

TEST_CASE("a peg is a + in characters however small, and one pixel in half blocks") {
    Scene scene = table({{0, 0}, {40, 20}});
    add_capsule(scene.world, {{20.3, 10.2}, {20.3, 10.2}, 0.05}, 0);
    CHECK(cells_that_are(Drawing(41, 11).draw(scene, in(ascii_renderer())).canvas, U'+') == 1);
    const Canvas canvas = Drawing(41, 11).draw(scene, in(half_block_renderer())).canvas;
    CHECK(cells_that_are(canvas, U'▀') + cells_that_are(canvas, U'▄') == 1);
    CHECK(cells_that_are(canvas, U' ') == 41 * 11 - 1);
}

TEST_CASE("coinciding copies are a solid ball, and scattered ones a cloud") {
    Scene scene = table({{0.0, 0.0}, {40.0, 20.0}});
    put_ball(scene, {20.0, 10.0}, 4.0);
    std::vector<World> copies(100, scene.world);
    Annotations annotations;
    annotations.copies = copies;
    Drawing together(40, 10);
    together.draw(scene, in(ascii_renderer()), annotations);
    CHECK(together.canvas.at(20, 5).glyph == U'@');
    CHECK(together.canvas.at(5, 5).glyph == U' ');

    for (std::size_t i = 0; i < copies.size(); ++i)
        copies[i].edit_balls().position[0].x = 8.0 + 24.0 * static_cast<double>(i) / 99.0;
    annotations.copies = copies;
    Drawing apart(40, 10);
    apart.draw(scene, in(ascii_renderer()), annotations);
    // A third of the copies cover the centre, few its ends.
    CHECK(apart.canvas.at(20, 5).glyph == U'*');
    CHECK(std::string_view(".:-").find(static_cast<char>(apart.canvas.at(6, 5).glyph)) !=
          std::string_view::npos);
    CHECK(apart.canvas.at(1, 5).glyph == U' ');

    Drawing pixels(40, 10);
    ViewOptions options = in(half_block_renderer());
    pixels.draw(scene, options, annotations);
    CHECK(pixels.canvas.at(20, 5).foreground != pixels.canvas.at(6, 5).foreground);
    CHECK(pixels.canvas.at(6, 5).glyph != U' ');
}

TEST_CASE("a ball in one copy of two hundred is visible, and one that is not finite is not") {
    Scene scene = table({{0.0, 0.0}, {40.0, 20.0}});
    put_ball(scene, {20.0, 10.0}, 2.0);
    std::vector<World> copies(200, scene.world);
    copies[7].edit_balls().position[0] = {5.0, 10.0};
    copies[8].edit_balls().position[0] = {std::numeric_limits<double>::quiet_NaN(), 10.0};
    copies[9].edit_balls().position[0] = {1e300, -1e300};
    Annotations annotations;
    annotations.copies = copies;
    for (const Renderer* renderer : {&ascii_renderer(), &half_block_renderer()}) {
        Drawing drawing(40, 10);
        drawing.draw(scene, in(*renderer), annotations);
        CHECK(drawing.canvas.at(5, 5).glyph != U' ');
    }
}

TEST_CASE("the position of a divergence is marked") {
    Scene scene = table({{0.0, 0.0}, {40.0, 20.0}});
    Annotations annotations;
    annotations.marks = {{20.5, 9.0}};
    ViewOptions options = in(ascii_renderer());
    options.look = {0, false, false};
    Drawing drawing(40, 10);
    drawing.draw(scene, options, annotations);
    CHECK(drawing.text().find(">X<") != std::string::npos);
    CHECK(drawing.canvas.at(20, 5).glyph == U'X');
    CHECK((drawing.canvas.at(20, 5).attributes & reverse) != 0);
}

TEST_CASE("a cradle hangs from a bar by strings, which go with their balls") {
    Scene scene = table({{0.0, 0.0}, {30.0, 20.0}});
    const BallId left = put_ball(scene, {12.0, 6.0}, 1.5);
    const BallId right = put_ball(scene, {21.5, 6.0}, 1.5);
    scene.dress.strings = {{number(left), {12.0, 15.0}, true}, {number(right), {19.0, 15.0}}};
    Drawing drawing(30, 10);
    drawing.draw(scene, in(ascii_renderer()));
    // Of its bar: the columns from 7 to 24, twice the swing beyond the pivots, around y = 15.
    for (int column = 7; column < 24; ++column)
        CHECK(drawing.canvas.at(column, 2).glyph != U' ');
    CHECK(drawing.canvas.at(5, 2).glyph == U' ');
    CHECK(drawing.canvas.at(25, 2).glyph == U' ');
    // Each straight down, also to the ball that has moved.
    CHECK(drawing.canvas.at(12, 4).glyph != U' ');
    CHECK(drawing.canvas.at(17, 4).glyph == U' ');
    CHECK(drawing.canvas.at(19, 4).glyph == U' ');
    CHECK(drawing.canvas.at(21, 4).glyph != U' ');
}

namespace {

// The pixels of that colour in a cell of octants or sextants.
int pixels_of(const Cell& cell, Color color, const Renderer& renderer) {
    const int pixels = renderer.across * renderer.down;
    for (unsigned pattern = 0; pattern < 1u << pixels; ++pattern) {
        const char32_t glyph = pixels == 8 ? octant(pattern) : sextant(pattern);
        if (glyph != cell.glyph) continue;
        const int lit = std::popcount(pattern);
        return (cell.foreground == color ? lit : 0) + (cell.background == color ? pixels - lit : 0);
    }
    return 0;
}

}  // namespace

TEST_CASE("the string of a cradle takes no pixel of its ball or bar in a mosaic") {
    for (const Renderer* const renderer : {&octant_renderer(), &sextant_renderer()}) {
        for (int offset = 0; offset < 8; ++offset) {
            CAPTURE(renderer->name);
            CAPTURE(offset);
            Scene scene = table({{0.0, 0.0}, {30.0, 20.0}});
            const double down = 0.25 * offset;
            const BallId ball = put_ball(scene, {12.5, 7.0 - down}, 1.2);
            ViewOptions options = in(*renderer);
            options.look.colors = direct_colors;
            const auto colored = [&](Color color) {
                Drawing drawing(30, 10);
                drawing.draw(scene, options);
                int count = 0;
                for (int row = 0; row < 10; ++row)
                    for (int column = 0; column < 30; ++column)
                        count += pixels_of(drawing.canvas.at(column, row), color, *renderer);
                return count;
            };
            const Color of_ball = ink_of_class(0, options.look).color;
            const Color of_bar = dress_ink(0x7a4a24, options.look).color;
            const int alone = colored(of_ball);
            REQUIRE(alone > 4);
            scene.dress.strings = {{number(ball), {12.5, 15.0 - down}, true}};
            CHECK(colored(of_ball) >= alone);
            CHECK(colored(of_bar) > 0);
        }
    }
}

TEST_CASE("a large ball is shaded as a sphere among many small ones") {
    std::string level = "carom 1 \"t\"\nworld 0,0 100,60\nball big at=50,30 r=15\n";
    for (int i = 0; i < 300; ++i)
        level += fmt::format("ball at={},{} r=0.2\n", 1 + i % 90, 1 + i / 90 * 2);
    const LoadResult loaded = load_level(level, "test.level");
    REQUIRE(loaded.scene);
    Canvas canvas(100, 30);
    ViewOptions options;
    options.look.colors = direct_colors;
    options.renderer = &half_block_renderer();
    ViewMemory memory;
    const Camera camera = fit_camera(loaded.scene->view, {0, 0, 100, 30}, 2.0);
    draw_world(canvas, camera, *loaded.scene, loaded.scene->world, {}, {}, options, memory);
    std::set<Color> colors;
    for (int column = 40; column < 60; ++column)
        for (int row = 11; row < 19; ++row)
            colors.insert(canvas.at(column, row).foreground);
    CHECK(colors.size() >= 3);
}

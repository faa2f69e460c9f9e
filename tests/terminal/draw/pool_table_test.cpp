#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "level/load.h"
#include "terminal/canvas/color.h"
#include "terminal/draw/draw.h"

using namespace carom;

namespace {

// A pool table of 200 x 100 with jaws, and two pockets in corners.
Scene table_with_jaws(const std::string& balls) {
    LoadResult result = load_level(
        "carom 1 \"t\"\n"
        "use cloth slide=0.2 roll=0.01 spin=10 g=10\nuse spin\nball cue at=40,50 r=2\n"
        "cue ball=cue power=0..10\n"
        "edge 6,0 194,0\nedge 6,100 194,100\nedge 0,6 0,94\nedge 200,6 200,94\n"
        "edge 6,0 2,-6\nedge 0,6 -6,2\nedge 194,100 198,106\nedge 200,94 206,98\n"
        "pocket c at=-3,-3 r=5\npocket d at=203,103 r=5\n" +
            balls,
        "test.level");
    REQUIRE(result.scene);
    return std::move(*result.scene);
}

Look look_with(int colors) {
    Look look;
    look.colors = colors;
    look.utf8 = true;
    return look;
}

struct PixelPicture {
    Canvas canvas;
    Camera camera;

    /// The colours of the two pixels of each cell, from the left and from the top.
    Color pixel(int column, int row) const {
        const Cell& cell = canvas.at(column, row / 2);
        if (cell.glyph == U'\u2588') return cell.foreground;
        const bool is_upper = row % 2 == 0;
        if (cell.glyph == U'\u2580') return is_upper ? cell.foreground : cell.background;
        if (cell.glyph == U'\u2584') return is_upper ? cell.background : cell.foreground;
        return cell.background;
    }
};

PixelPicture pixels_of(const Scene& scene, const Look& look, const Annotations& annotations = {},
                       int columns = 80, int rows = 24) {
    PixelPicture picture{Canvas(columns, rows),
                         fit_camera({{-15, -15}, {215, 115}}, {0, 0, columns, rows}, 2.0)};
    ViewOptions options;
    options.look = look;
    options.renderer = &half_block_renderer();
    ViewMemory memory;
    draw_world(picture.canvas, picture.camera, scene, scene.world, {}, annotations, options,
               memory);
    return picture;
}

// The pixels around a place.
std::vector<Color> around(const PixelPicture& picture, Vec2 place, int reach) {
    const CellPoint at = to_cells(picture.camera, place);
    std::vector<Color> colors;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x)
            colors.push_back(
                picture.pixel(static_cast<int>(at.column) + x, static_cast<int>(2.0 * at.row) + y));
    return colors;
}

Annotations numbered_balls(const Scene& scene) {
    Annotations annotations;
    annotations.pool.emplace();
    const Balls& balls = scene.world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i)
        annotations.pool->numbers.push_back({balls.id[i], static_cast<int>(i)});
    return annotations;
}

}  // namespace

TEST_CASE("pool table: a small pocket is a whole hole over its cushions, the same at each corner") {
    const Look look = look_with(direct_colors);
    const PixelPicture picture = pixels_of(table_with_jaws(""), look);
    std::vector<std::ptrdiff_t> dark;
    for (const Vec2 pocket : {Vec2{-3, -3}, Vec2{203, 103}}) {
        const std::vector<Color> colors = around(picture, pocket, 3);
        dark.push_back(std::ranges::count_if(colors, [&](Color color) {
            const Rgb rgb = rgb_of(color);
            return color != default_color && rgb.red + rgb.green + rgb.blue < 60;
        }));
    }
    CHECK(dark[0] == 9);
    CHECK(dark[1] == dark[0]);
}

TEST_CASE("pool table: the wood of the rail hides the ends of the jaws") {
    const LoadResult loaded = load_level(
        "carom 1 \"t\"\nuse cloth slide=0.2 roll=0.01 spin=10 g=10\nuse spin\n"
        "ball cue at=40,50 r=2\ncue ball=cue power=0..10\n"
        "edge 6,0 94,0 94,-16\nedge 106,-16 106,0 194,0\nedge 6,100 194,100\n"
        "edge 0,6 0,94\nedge 200,6 200,94\npocket m at=100,-5 r=6\n"
        "pocket c at=-4,-4 r=6\npocket c at=204,-4 r=6\npocket c at=-4,104 r=6\n"
        "pocket c at=204,104 r=6\n",
        "test.level");
    REQUIRE(loaded.scene);
    const Scene& scene = *loaded.scene;
    const PixelPicture picture = pixels_of(scene, look_with(direct_colors), {}, 230, 65);
    const auto color_at = [&](Vec2 place) { return around(picture, place, 0).front(); };
    const Color wood = color_at({150, -12});
    CHECK(color_at({94, -14}) == wood);
    CHECK(color_at({94, 0}) != wood);
}

TEST_CASE("pool table: without shades a small pocket is a gap in the cushions and in the cloth") {
    for (const int colors : {8, 16}) {
        CAPTURE(colors);
        const PixelPicture picture =
            pixels_of(table_with_jaws("pocket e at=100,50 r=3\n"), look_with(colors));
        for (const Vec2 pocket : {Vec2{-3, -3}, Vec2{203, 103}, Vec2{100, 50}})
            for (const Color color : around(picture, pocket, 0))
                CHECK(color == default_color);
        const CellPoint hole = to_cells(picture.camera, {100, 50});
        CHECK(picture.canvas.at(static_cast<int>(hole.column), static_cast<int>(hole.row)).glyph ==
              U' ');
    }
    // Without colours there is no cloth, and a hole shows by its rim.
    const PixelPicture plain = pixels_of(table_with_jaws("pocket e at=100,50 r=3\n"), look_with(0));
    const CellPoint hole = to_cells(plain.camera, {100, 50});
    CHECK(plain.canvas.at(static_cast<int>(hole.column), static_cast<int>(hole.row)).glyph != U' ');
}

TEST_CASE("pool table: each ball of a rack of small balls keeps its share of the pixels") {
    // Fifteen balls that touch, each with a colour of its own, 1.5 pixels wide.
    int few = 0;
    int balls = 0;
    for (int shift = 0; shift < 16; ++shift) {
        std::string rack;
        for (int row = 0; row < 5; ++row)
            for (int i = 0; i <= row; ++i)
                rack += fmt::format("ball b{}{} at={},{} r=2 color=#{:02x}{:02x}80\n", row, i,
                                    140.0 + 0.7 * (shift % 4) + 4.01 * 0.8661 * row,
                                    50.0 + 0.7 * (shift / 4) + 4.01 * (i - 0.5 * row), 50 * row,
                                    50 * i);
        const Scene scene = table_with_jaws(rack);
        Annotations annotations;
        annotations.pool.emplace();
        const PixelPicture picture =
            pixels_of(scene, look_with(direct_colors), annotations, 88, 28);
        const std::vector<Color> colors = around(picture, {147, 50}, 8);
        for (int row = 0; row < 5; ++row)
            for (int i = 0; i <= row; ++i) {
                const auto count = std::ranges::count_if(colors, [&](Color color) {
                    return color != default_color && rgb_of(color) == Rgb{50 * row, 50 * i, 128};
                });
                few += count < 2;
                ++balls;
            }
    }
    CAPTURE(few);
    // A ball has two pixels on average: few have only one.
    CHECK(10 * few <= balls);
}

TEST_CASE("pool table: a ball about as large as a pixel takes two, so the cue ball is no dot") {
    const Scene scene = table_with_jaws("");
    const Look look = look_with(direct_colors);
    const auto lit_pixels = [&](int columns, int rows) {
        const PixelPicture picture = pixels_of(scene, look, numbered_balls(scene), columns, rows);
        const Vec2 cue = scene.world.balls().position[0];
        const Color own = around(picture, cue, 0).front();
        const std::vector<Color> colors = around(picture, cue, 3);
        return std::ranges::count(colors, own);
    };
    CHECK(lit_pixels(62, 20) == 4);
    CHECK(lit_pixels(30, 10) == 1);
}

TEST_CASE("pool table: one without pockets has diamonds too, if it is as long as two squares") {
    const auto diamonds = [](const std::string& box, int columns = 160, int rows = 50) {
        LoadResult loaded = load_level(
            "carom 1 \"t\"\nuse cloth slide=0.2 roll=0.01 spin=10 g=10\nuse spin\n"
            "ball cue at=40,30 r=3\ncue ball=cue power=0..10\nbox 0,0 " +
                box + "\n",
            "test.level");
        REQUIRE(loaded.scene);
        const PixelPicture picture =
            pixels_of(*loaded.scene, look_with(direct_colors), {}, columns, rows);
        const Color ivory = direct_color({0xe9, 0xdf, 0xc4});
        int count = 0;
        for (int row = 0; row < 2 * rows; ++row)
            for (int column = 0; column < columns; ++column)
                count += picture.pixel(column, row) == ivory;
        return count;
    };
    CHECK(diamonds("200,100") == 20);
    CHECK(diamonds("200,60") == 0);
    // All of one size, whatever pixels they lie on.
    for (const int columns : {200, 260, 330, 400, 490}) {
        CAPTURE(columns);
        const int pixels = diamonds("200,100", columns, columns / 3);
        CHECK(pixels >= 20);
        CHECK(pixels % 20 == 0);
    }
}

TEST_CASE("pool table: the head string shows with any number of colours") {
    const LoadResult loaded = load_level(
        "carom 1 \"t\"\nuse cloth slide=0.2 roll=0.01 spin=10 g=10\nuse spin\n"
        "ball cue at=80,30 r=2\ncue ball=cue power=0..10\nbox 0,0 200,100\n"
        "rack eight at=150,50 toward=east gap=0.05\n",
        "test.level");
    REQUIRE(loaded.scene);
    for (const int colors : {0, 8, 16, 256, direct_colors}) {
        CAPTURE(colors);
        const PixelPicture picture = pixels_of(*loaded.scene, look_with(colors));
        const CellPoint head = to_cells(picture.camera, {50, 80});
        int marked = 0;
        for (int row = 0; row < 10; ++row) {
            const auto at = [&](int aside) {
                return picture.pixel(static_cast<int>(head.column) + aside,
                                     static_cast<int>(2.0 * head.row) + row);
            };
            const Cell& cell = picture.canvas.at(static_cast<int>(head.column),
                                                 static_cast<int>(head.row) + row / 2);
            marked += colors > 0 ? at(0) != at(4) : cell.glyph != U' ';
        }
        CHECK(marked >= 5);
    }
}

TEST_CASE("pool table: with few colours no number is bold black, which terminals show as grey") {
    const Scene scene = table_with_jaws("ball a at=100,50 r=2\nball b at=150,30 r=2\n");
    Annotations annotations = numbered_balls(scene);
    annotations.pool->numbers[1].number = 1;
    annotations.pool->numbers[2].number = 9;
    for (const int colors : {8, 16}) {
        CAPTURE(colors);
        const PixelPicture picture = pixels_of(scene, look_with(colors), annotations, 110, 36);
        int numbers = 0;
        for (int row = 0; row < 36; ++row)
            for (int column = 0; column < 110; ++column) {
                const Cell& cell = picture.canvas.at(column, row);
                if (cell.glyph != U'1' && cell.glyph != U'9') continue;
                ++numbers;
                CHECK_FALSE((cell.foreground == 0 && (cell.attributes & bold) != 0));
            }
        CHECK(numbers == 2);
    }
}

TEST_CASE("pool table: a small ball is as wide with one digit on it as with two") {
    const Scene scene = table_with_jaws("ball a at=100,50 r=2.8\nball b at=150,30 r=2.8\n");
    Annotations annotations = numbered_balls(scene);
    annotations.pool->numbers[1].number = 7;
    annotations.pool->numbers[2].number = 10;
    const Look look = look_with(direct_colors);
    const PixelPicture picture = pixels_of(scene, look, annotations);
    for (std::size_t ball : {1, 2}) {
        CAPTURE(ball);
        const int number = annotations.pool->numbers[ball].number;
        const Color own = ball == 1 ? ink_of_pool_ball(number, look).color
                                    : ink_of(Role::stripe_white, look).color;
        int cells = 0;
        for (int row = 0; row < 24; ++row)
            for (int column = 0; column < 80; ++column)
                cells += picture.canvas.at(column, row).background == own;
        CHECK(cells == 2);
    }
}

TEST_CASE("pool table: a small hole is dark in characters and dots too, on a painted green") {
    const LoadResult loaded = load_level(
        "carom 1 \"t\"\nuse cloth slide=0.2 roll=0.01 spin=10 g=10\nuse spin\n"
        "ball cue at=40,50 r=1\ncue ball=cue power=0..10\nbox 0,0 200,100\n"
        "pocket p at=100,50 r=1.2\npaint rect 20,20 180,80 color=#3d8b52\n",
        "test.level");
    REQUIRE(loaded.scene);
    const Scene& scene = *loaded.scene;
    for (const Renderer* renderer : {&ascii_renderer(), &braille_renderer()}) {
        CAPTURE(renderer->name);
        for (int columns = 60; columns <= 80; ++columns) {
            CAPTURE(columns);
            Canvas canvas(columns, 24);
            const Camera camera = fit_camera({{-15, -15}, {215, 115}}, {0, 0, columns, 24}, 2.0);
            ViewOptions options;
            options.look = look_with(direct_colors);
            options.renderer = renderer;
            ViewMemory memory;
            draw_world(canvas, camera, scene, scene.world, {}, {}, options, memory);
            const CellPoint hole = to_cells(camera, {100, 50});
            const Cell& cell = canvas.at(static_cast<int>(hole.column), static_cast<int>(hole.row));
            REQUIRE(cell.background >= 0);
            CHECK(luminance(rgb_of(cell.background)) < 0.1);
        }
    }
}

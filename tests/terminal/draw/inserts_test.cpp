#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "level/load.h"
#include "terminal/draw/draw.h"

using namespace carom;

namespace {

const Color gold = direct_color({0xe3, 0xb3, 0x41});

TableLight light_at(Vec2 place, InsertShape shape, bool is_lit) {
    TableLight light;
    light.shape = {place, place, 3.0};
    light.is_lit = is_lit;
    light.insert = shape;
    light.color = 0xe3b341;
    light.text = "JACKPOT";
    return light;
}

struct Picture {
    Canvas canvas{60, 30};

    Picture(const TableAnnotations& table, const Renderer& renderer, const std::string& more = "",
            bool is_light = false, int colors = direct_colors) {
        const LoadResult loaded =
            load_level("carom 1 \"t\"\nworld 0,0 60,60\nball a at=5,5 r=1\n" + more, "t.level");
        REQUIRE(loaded.scene);
        const Scene& scene = *loaded.scene;
        Annotations annotations;
        annotations.table = table;
        ViewOptions options;
        options.renderer = &renderer;
        options.look.colors = colors;
        options.look.light_background = is_light;
        ViewMemory memory;
        draw_world(canvas, fit_camera(scene.view, {0, 0, 60, 30}, 2.0), scene, scene.world, {},
                   annotations, options, memory);
    }
    // The first cell with this letter; an empty one: there is none.
    Cell first(char32_t letter) const {
        for (int row = 0; row < canvas.rows(); ++row)
            for (int column = 0; column < canvas.columns(); ++column)
                if (canvas.at(column, row).glyph == letter) return canvas.at(column, row);
        return {};
    }
    // 2: no cell has it.
    double brightness_of(char32_t letter) const {
        const Cell cell = first(letter);
        return cell.glyph == letter ? luminance(rgb_of(cell.foreground)) : 2.0;
    }
    int count(Color color) const {
        int found = 0;
        for (int row = 0; row < canvas.rows(); ++row)
            for (int column = 0; column < canvas.columns(); ++column)
                found += canvas.at(column, row).foreground == color ||
                         canvas.at(column, row).background == color;
        return found;
    }
};

// The relative luminance that WCAG 2 computes its contrast ratio from; a ratio of 3 is meant for
// large text.
double light_of(Color color) {
    const Rgb rgb = rgb_of(color);
    const auto linear = [](int channel) { return std::pow(channel / 255.0, 2.2); };
    return 0.2126 * linear(rgb.red) + 0.7152 * linear(rgb.green) + 0.0722 * linear(rgb.blue);
}

}  // namespace

TEST_CASE("an insert has its shape and name, dim until it is lit") {
    for (const InsertShape shape :
         {InsertShape::circle, InsertShape::arrow, InsertShape::triangle, InsertShape::square,
          InsertShape::diamond, InsertShape::star, InsertShape::bar}) {
        TableAnnotations table;
        table.lights = {light_at({30, 30}, shape, false)};
        const Picture unlit(table, half_block_renderer());
        table.lights.front().is_lit = true;
        const Picture lit(table, half_block_renderer());
        CHECK(lit.canvas.text().find("JACKPOT") != std::string::npos);
        CHECK(unlit.count(gold) == 0);
        CHECK(lit.count(gold) > 0);  // at least its name
    }
}

TEST_CASE("the name of an unlit insert is dark on a dark board, whatever the screen's ground") {
    const std::string board = "theme board=navy\nbox 0,0 60,60\n";
    for (const bool is_light : {false, true})
        for (const Renderer* renderer : {&half_block_renderer(), &ascii_renderer()}) {
            CAPTURE(is_light);
            CAPTURE(renderer->name);
            TableAnnotations table;
            table.lights = {light_at({30, 30}, InsertShape::circle, false)};
            const double unlit = Picture(table, *renderer, board, is_light).brightness_of(U'J');
            table.lights.front().is_lit = true;
            const double lit = Picture(table, *renderer, board, is_light).brightness_of(U'J');
            CHECK(unlit < lit - 0.1);
        }
}

TEST_CASE("the name of an unlit insert can be read on a dark board") {
    for (const std::string board : {"navy", "#241a1c", "#1d3329", "#1c1a2e"})
        for (const Rgb24 color : {0xd62f2f, 0x8a4ad0, 0xe3b341, 0x3f7fd0}) {
            CAPTURE(board);
            CAPTURE(color);
            TableAnnotations table;
            table.lights = {light_at({30, 30}, InsertShape::circle, false)};
            table.lights.front().color = color;
            const Picture picture(table, ascii_renderer(),
                                  "theme board=" + board + "\nbox 0,0 60,60\n");
            const Cell name = picture.first(U'J');
            REQUIRE(name.glyph == U'J');
            const double ratio =
                (light_of(name.foreground) + 0.05) / (light_of(name.background) + 0.05);
            CHECK(ratio > 3.0);
        }
}

TEST_CASE("the ball of a table can be seen on its board, dark or light, in any theme") {
    for (const std::string board :
         {"theme board=navy\nbox 0,0 60,60\n", "theme board=#f0e8d8\nbox 0,0 60,60\n", ""})
        for (const bool is_light : {false, true})
            for (const int colors : {256, direct_colors}) {
                CAPTURE(board);
                CAPTURE(is_light);
                const Picture picture(TableAnnotations{}, octant_renderer(),
                                      board + "ball b at=30,30 r=6\n", is_light, colors);
                const Cell& ball = picture.canvas.at(30, 15);
                const bool is_on_dark = board.empty() ? !is_light : board.find("navy") < 99;
                CHECK((luminance(rgb_of(ball.foreground)) > 0.7) == is_on_dark);
            }
}

TEST_CASE("small inserts are squares, the same wherever they lie, and dim until they are lit") {
    for (const Renderer* renderer :
         {&half_block_renderer(), &sextant_renderer(), &octant_renderer()}) {
        CAPTURE(renderer->name);
        for (const InsertShape shape : {InsertShape::circle, InsertShape::arrow, InsertShape::star})
            for (const double shift : {0.0, 0.3, 0.55, 0.9}) {
                CAPTURE(shift);
                TableAnnotations table;
                table.lights = {light_at({30 + shift, 30 - shift}, shape, false)};
                table.lights.front().shape.radius = 0.7;
                table.lights.front().text = "";
                const Picture unlit(table, *renderer, "theme board=navy\nbox 0,0 60,60\n");
                CHECK(unlit.count(gold) == 0);
                table.lights.front().is_lit = true;
                const Picture lit(table, *renderer, "theme board=navy\nbox 0,0 60,60\n");
                CHECK(lit.canvas.text() == unlit.canvas.text());
                int changed = 0;
                for (int row = 0; row < lit.canvas.rows(); ++row)
                    for (int column = 0; column < lit.canvas.columns(); ++column)
                        changed += !(lit.canvas.at(column, row) == unlit.canvas.at(column, row));
                CHECK(changed >= 1);
                CHECK(changed <= 4);
            }
    }
}

TEST_CASE("without colours a lit light differs from an unlit one by more than bold or dim") {
    const std::string edges = "edge 20,20 20,26\npeg at=30,20 r=2\n";
    std::vector<TableLight> lights;
    for (const InsertShape shape :
         {InsertShape::circle, InsertShape::arrow, InsertShape::triangle, InsertShape::square,
          InsertShape::diamond, InsertShape::star, InsertShape::bar})
        lights.push_back(light_at({30, 40}, shape, false));
    for (const Capsule& edge :
         {Capsule{{20, 20}, {20, 26}, 0.0}, Capsule{{30, 20}, {30, 20}, 2.0}}) {
        lights.push_back(light_at({}, InsertShape::circle, false));
        lights.back().is_edge = true;
        lights.back().shape = edge;
    }
    lights.back().is_bumper = true;
    for (const Renderer& renderer : renderers())
        for (TableLight light : lights) {
            CAPTURE(renderer.name);
            CAPTURE(static_cast<int>(light.insert));
            CAPTURE(light.is_edge);
            light.text = "";
            if (!light.is_edge) light.shape.radius = 0.5;
            const Picture unlit({.lights = {light}}, renderer, edges, false, 0);
            light.is_lit = true;
            const Picture lit({.lights = {light}}, renderer, edges, false, 0);
            int changed = 0;
            for (int row = 0; row < lit.canvas.rows(); ++row)
                for (int column = 0; column < lit.canvas.columns(); ++column) {
                    const Cell& was = unlit.canvas.at(column, row);
                    const Cell& is = lit.canvas.at(column, row);
                    changed +=
                        was.glyph != is.glyph || ((was.attributes ^ is.attributes) & reverse) != 0;
                }
            CHECK(changed > 0);
        }
}

TEST_CASE("without colours a table of pinball is drawn with characters, other levels with dots") {
    ViewOptions options;
    options.look.colors = 0;
    options.look.utf8 = true;
    CHECK(&renderer_in_force(options) == &braille_renderer());
    options.is_table = true;
    CHECK(&renderer_in_force(options) == &ascii_renderer());
    options.look.colors = 8;
    CHECK(&renderer_in_force(options) == &half_block_renderer());
    options.look.colors = 0;
    options.renderer = &braille_renderer();
    CHECK(&renderer_in_force(options) == &braille_renderer());
}

TEST_CASE("an arrow points in ASCII too, and names do not cover other lights") {
    TableAnnotations table;
    table.lights = {light_at({30, 30}, InsertShape::arrow, true)};
    CHECK(Picture(table, ascii_renderer()).canvas.text().find('^') != std::string::npos);
    table.lights.front().direction = {1.0, 0.0};
    CHECK(Picture(table, ascii_renderer()).canvas.text().find('>') != std::string::npos);
    table.lights.push_back(light_at({31, 23}, InsertShape::circle, true));
    table.lights.back().text = "";
    CHECK(Picture(table, ascii_renderer()).canvas.text().find("JACKPOT") == std::string::npos);
}

TEST_CASE("names of lights and labels in a row stand two columns apart where there is room") {
    const auto names = [](double distance, const std::string& label = "") {
        TableAnnotations table;
        table.lights = {light_at({26, 30}, InsertShape::circle, true),
                        light_at({26 + distance, 30}, InsertShape::circle, true)};
        table.lights.back().text = "SUPER";
        return Picture(table, ascii_renderer(), label).canvas.text();
    };
    const auto shows = [](const std::string& picture, const char* text) {
        return picture.find(text) != std::string::npos;
    };
    CHECK(shows(names(8), "JACKPOT  SUPER"));
    CHECK(shows(names(7), "JACKPOT  SUPER"));
    CHECK(shows(names(6), "JACKPOT  SUPER"));
    CHECK(shows(names(4), "JACKPOT SUPER"));
    CHECK(shows(names(2), "JACKPOT"));
    CHECK_FALSE(shows(names(2), "SUPER"));  // no room within three columns
    // The level's labels come first.
    CHECK(shows(names(9, "label \"SAFE\" at=31,23\n"), "JACKPOT  SAFE  SUPER"));
}

TEST_CASE("an area above the board is see-through, and covers balls on the board only") {
    const std::string ramp =
        "material rail layer=1\nedge rail 40,10 50,10\n"
        "paint rect 0,0 10,10 color=red layer=1\npaint rect 0,0 60,60 color=navy\n";
    const Picture picture({}, half_block_renderer(), ramp);
    CHECK(picture.count(direct_color({0x1d, 0x2f, 0x6f})) > 1000);
    CHECK(picture.count(direct_color({0xd9, 0x2b, 0x2b})) == 0);  // mixed with what is under it
    const Color over = picture.canvas.at(1, 29).foreground;
    CHECK(over != direct_color({0x1d, 0x2f, 0x6f}));
}

#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "terminal/canvas/raster.h"
#include "terminal/draw/draw.h"

using namespace carom;

namespace {

Scene table_with_ball(double radius) {
    Scene scene;
    scene.view = {{0, 0}, {40, 20}};
    scene.world.edit_definition().kinds.resize(1);
    BallSpec spec;
    spec.position = {20, 10};
    spec.radius = radius;
    spec.velocity = {10, 0};
    add_ball(scene.world, spec);
    return scene;
}

Canvas drawn(const Scene& scene, const ViewOptions& options, ViewMemory& memory,
             const Annotations& annotations = {}, std::span<const Contact> contacts = {}) {
    Canvas canvas(40, 10);
    draw_world(canvas, fit_camera(scene.view, {0, 0, 40, 10}, 2.0), scene, scene.world, contacts,
               annotations, options, memory);
    return canvas;
}

Canvas drawn(const Scene& scene, const ViewOptions& options, const Annotations& annotations = {},
             std::span<const Contact> contacts = {}) {
    ViewMemory memory;
    return drawn(scene, options, memory, annotations, contacts);
}

ViewOptions with(const Renderer& renderer) {
    ViewOptions options;
    options.renderer = &renderer;
    return options;
}

Annotations numbered(int number) {
    Annotations annotations;
    annotations.pool.emplace();
    annotations.pool->numbers.push_back({BallId{0}, number});
    return annotations;
}

bool are_equal(const Canvas& a, const Canvas& b) {
    for (int row = 0; row < a.rows(); ++row)
        for (int column = 0; column < a.columns(); ++column)
            if (!(a.at(column, row) == b.at(column, row))) return false;
    return true;
}

}  // namespace

TEST_CASE("effects: the number of a pool ball is in its middle wherever the ball lies") {
    for (const int number : {3, 12}) {
        const std::string text = std::to_string(number);
        for (const double radius : {0.75, 1.1, 1.4}) {  // without a shadow
            for (int step = 0; step < 12; ++step) {
                Scene scene = table_with_ball(radius);
                scene.world.edit_balls().position[0] = {20.0 + step / 12.0, 10.0 + step / 7.0};
                const Canvas canvas = drawn(scene, with(half_block_renderer()), numbered(number));
                for (int row = 0; row < canvas.rows(); ++row) {
                    for (int column = 0; column + 1 < canvas.columns(); ++column) {
                        if (canvas.at(column, row).glyph != static_cast<char32_t>(text[0]))
                            continue;
                        // As much of the ball to the left as to the right: one digit on a ball of
                        // two columns is in the right one.
                        const auto shows_ball = [&](int at) {
                            return canvas.at(at, row).glyph != U' ' ||
                                   canvas.at(at, row).background != default_color;
                        };
                        int left = column;
                        while (shows_ball(left - 1))
                            --left;
                        int right = column + static_cast<int>(text.size()) - 1;
                        while (shows_ball(right + 1))
                            ++right;
                        CAPTURE(radius);
                        CAPTURE(step);
                        const int digits = static_cast<int>(text.size());
                        CHECK((column - left) - (right - (column + digits - 1)) ==
                              (right - left + 1 - digits) % 2);
                    }
                }
            }
        }
    }
}

TEST_CASE("effects: a ball too small to be round around its number is the cells of the number") {
    for (const Renderer& renderer : renderers()) {
        if (!renderer.has_pixels()) continue;
        CAPTURE(renderer.name);
        for (const double radius : {0.8, 1.0, 1.25}) {
            CAPTURE(radius);
            for (const auto& [number, text] : {std::pair{3, " 3"}, std::pair{12, "12"}}) {
                const Canvas canvas =
                    drawn(table_with_ball(radius), with(renderer), numbered(number));
                CHECK(canvas.text().find(text) != std::string::npos);
                const Color own = number == 12 ? ink_of(Role::stripe_white, {}).color
                                               : ink_of_pool_ball(number, {}).color;
                int written = 0;
                for (int row = 0; row < canvas.rows(); ++row)
                    for (int column = 0; column < canvas.columns(); ++column)
                        written += canvas.at(column, row).background == own;
                CHECK(written == 2);
            }
        }
    }
}

TEST_CASE("effects: numbers do not cover other balls, as in a rack of small balls") {
    const auto shows_twelve = [](double apart) {
        Scene scene = table_with_ball(0.7);
        BallSpec other;
        other.position = {20.0 + apart, 10.0};
        other.radius = 0.7;
        add_ball(scene.world, other);
        return drawn(scene, with(half_block_renderer()), numbered(12)).text().find("12") !=
               std::string::npos;
    };
    CHECK_FALSE(shows_twelve(1.4));
    CHECK(shows_twelve(4.0));
}

TEST_CASE("effects: balls that touch at an angle keep their numbers where these are almost clear") {
    // The corner of a number's cells is over the rim of the other ball.
    const auto shows_seven = [](double radius) {
        Scene scene = table_with_ball(radius);
        BallSpec other;
        other.position = Vec2{20.0, 10.0} + Vec2{1.0, 1.0} * (2.0 * radius * 0.70710678);
        other.radius = radius;
        add_ball(scene.world, other);
        return drawn(scene, with(octant_renderer()), numbered(7)).text().find('7') !=
               std::string::npos;
    };
    CHECK(shows_seven(1.3));
    CHECK_FALSE(shows_seven(0.95));
}

TEST_CASE("effects: a pool ball has a shadow to its lower right, a ball of few pixels none") {
    const auto shadow_of = [](int pixels) {
        Raster raster(half_block_renderer(), 20, 10, 2.0);
        raster.ball_shadow({10.0, 10.0}, 0.5 * pixels, {}, direct_color({0, 0, 0}));
        int lit = 0;
        int right_of_ball = 0;
        for (int down = 0; down < raster.samples_down(); ++down)
            for (int across = 0; across < raster.samples_across(); ++across) {
                if (raster.level_at(across, down) == 0) continue;
                ++lit;
                right_of_ball += across >= 10 + pixels / 2;
                CHECK(across > 10 - pixels / 2);
                CHECK(down > 10 - pixels / 2);
            }
        CHECK((lit > 0) == (right_of_ball > 0));
        return lit;
    };
    CHECK(shadow_of(2) == 0);
    CHECK(shadow_of(4) > 0);
    CHECK(shadow_of(8) > 0);
}

TEST_CASE("effects: a hard impact flashes for a moment, a soft one does not") {
    Scene scene = table_with_ball(2.0);
    Contact contact;
    contact.point = {22, 10};
    contact.approach = 10.0;
    const ViewOptions options = with(half_block_renderer());
    scene.world.edit_tick() = 5;
    const Canvas quiet = drawn(scene, options);
    ViewMemory memory;
    CHECK_FALSE(are_equal(drawn(scene, options, memory, {}, {&contact, 1}), quiet));
    // It still shows while the world stands, and is over a second later.
    CHECK_FALSE(are_equal(drawn(scene, options, memory), quiet));
    scene.world.edit_tick() += static_cast<std::uint64_t>(scene.world.rate());
    CHECK(are_equal(drawn(scene, options, memory), quiet));
    CHECK(memory.flashes.empty());
    contact.approach = 1.0;
    CHECK(are_equal(drawn(scene, options, {}, {&contact, 1}), quiet));
    // Characters have no light.
    contact.approach = 10.0;
    const ViewOptions ascii = with(ascii_renderer());
    CHECK(are_equal(drawn(scene, ascii, {}, {&contact, 1}), drawn(scene, ascii)));
}

// The last frame was a black spot beside the rail, which looked like a hole.
TEST_CASE("effects: a flash that has gone out clears nothing") {
    Scene scene = table_with_ball(2.0);
    scene.world.edit_definition().rate = 1000;
    scene.world.edit_tick() = 5;
    Contact contact;
    contact.point = {20, 10};  // on the ball
    contact.approach = 10.0;
    const ViewOptions options = with(half_block_renderer());
    ViewMemory memory;
    drawn(scene, options, memory, {}, {&contact, 1});
    int frames = 0;
    for (; !memory.flashes.empty(); ++scene.world.edit_tick(), ++frames) {
        const Cell cell = drawn(scene, options, memory).at(20, 5);
        CHECK((cell.foreground != default_color || cell.background != default_color));
    }
    CHECK(frames > 100);
}

TEST_CASE("effects: colours by speed or mass have a scale, where there are colours") {
    const Scene scene = table_with_ball(2.0);
    ViewOptions options = with(half_block_renderer());
    options.color_by = ColorBy::speed;
    CHECK(drawn(scene, options).text().find(" 0 ██████████ 10/s") != std::string::npos);
    options.color_by = ColorBy::mass;
    Canvas wide(60, 10);
    ViewMemory memory;
    draw_world(wide, fit_camera(scene.view, {0, 0, 60, 10}, 2.0), scene, scene.world, {}, {},
               options, memory);
    CHECK(wide.text().find("light ██████████ heavy") != std::string::npos);
    options.color_by = ColorBy::kind;
    CHECK(drawn(scene, options).text().find("heavy") == std::string::npos);
    options.color_by = ColorBy::speed;
    options.look = {0, false, false};
    CHECK(drawn(scene, options).text().find("10/s") == std::string::npos);
}

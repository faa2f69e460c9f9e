#include "lab/run/escape.h"

#include <doctest/doctest.h>

#include <array>
#include <vector>

using namespace carom;

namespace {

// Two boxes, one inside the other, and a third beside them.
struct Rooms {
    Scene scene;

    Rooms() {
        scene.world.edit_definition().kinds = {{}};
        scene.world.edit_definition().materials = {{}};
        add_box({0, 0}, {10, 10});
        add_box({4, 4}, {6, 6});
        add_box({20, 0}, {30, 10});
    }
    void add_box(Vec2 low, Vec2 high) {
        const std::array<Vec2, 4> corners{low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}};
        std::vector<CapsuleId> outline;
        for (std::size_t i = 0; i < 4; ++i) {
            outline.push_back(add_capsule(scene.world, {corners[i], corners[(i + 1) % 4], 0.5}, 0));
        }
        scene.outlines.push_back(outline);
    }
    BallId add(Vec2 position) {
        return add_ball(scene.world, {.kind = 0, .position = position, .radius = 0.1});
    }
    void move(BallId id, Vec2 position) {
        scene.world.edit_balls().position[*index_of(scene.world, id)] = position;
    }
};

}  // namespace

TEST_CASE("a ball has escaped when it is outside an outline in which it started") {
    struct Row {
        Vec2 start;
        Vec2 end;
        std::size_t escaped;
    };
    const Row rows[] = {
        {{2, 2}, {8, 8}, 0},    // stays
        {{2, 2}, {12, 2}, 1},   // through the wall
        {{2, 2}, {25, 5}, 1},   // into another outline
        {{2, 2}, {0.1, 2}, 0},  // pressed into the wall, its centre still inside the spine
        {{2, 2}, {5, 5}, 0},    // into the inner box: still inside the outer one
        {{5, 5}, {2, 2}, 1},    // out of the inner box
        {{15, 5}, {5, 5}, 0},   // started outside all: it cannot escape
    };
    for (const Row& row : rows) {
        CAPTURE(row.end.x);
        Rooms rooms;
        const BallId ball = rooms.add(row.start);
        const EscapeWatch watch(rooms.scene);
        CHECK(watch.escaped(rooms.scene.world) == 0);
        rooms.move(ball, row.end);
        CHECK(watch.escaped(rooms.scene.world) == row.escaped);
    }
}

// Regression: a ball that crossed the border of the torus inside such an outline had escaped.
TEST_CASE("on a torus a ball stays inside an outline that reaches across the border") {
    for (const Vec2 shift : {Vec2{0, 0}, Vec2{-5, 0}, Vec2{0, -5}, Vec2{-5, -5}}) {
        CAPTURE(shift.x);
        CAPTURE(shift.y);
        Rooms rooms;
        rooms.scene.world.edit_definition().model.wrap = Box{{0, 0}, {40, 40}};
        rooms.scene.outlines.clear();
        rooms.add_box(shift, shift + Vec2{10, 10});
        const BallId ball = rooms.add({2, 2});
        const EscapeWatch watch(rooms.scene);
        CHECK(watch.escaped(rooms.scene.world) == 0);
        const Vec2 inside = shift + Vec2{2, 2};
        rooms.move(ball, {inside.x < 0 ? inside.x + 40 : inside.x,
                          inside.y < 0 ? inside.y + 40 : inside.y});
        CHECK(watch.escaped(rooms.scene.world) == 0);
        rooms.move(ball, {20, 20});
        CHECK(watch.escaped(rooms.scene.world) == 1);
    }
}

TEST_CASE("a ball whose position is NaN has escaped") {
    Rooms rooms;
    const BallId ball = rooms.add({2, 2});
    const EscapeWatch watch(rooms.scene);
    rooms.move(ball, Vec2{0.0, 0.0} / 0.0);
    CHECK(watch.escaped(rooms.scene.world) == 1);
}

TEST_CASE("emitted balls are watched from then on, removed ones no more") {
    Rooms rooms;
    const BallId first = rooms.add({2, 2});
    EscapeWatch watch(rooms.scene);
    const BallId second = rooms.add({25, 5});
    const BallId third = rooms.add({26, 5});
    watch.note_births(rooms.scene.world);
    rooms.move(first, {15, 5});
    rooms.move(second, {15, 6});
    CHECK(watch.escaped(rooms.scene.world) == 2);
    remove_ball(rooms.scene.world, first);
    CHECK(watch.escaped(rooms.scene.world) == 1);
    rooms.move(third, {5, 5});
    CHECK(watch.escaped(rooms.scene.world) == 2);
}

#include "scene_list.h"

#include <doctest/doctest.h>

using namespace carom::bench;

TEST_CASE("a scene list reads back bit by bit") {
    SceneList list{.rate = 60.0,
                   .gravity_x = 0.1,
                   .gravity_y = -10.0,
                   .restitution = 1.0 / 3.0,
                   .friction = 0.2,
                   .plan = {.ticks = 600, .measured_from = 20, .sample_every = 6, .landed = -14.0}};
    list.capsules.push_back({.start_x = 1e-17, .end_x = 2.0, .end_y = 3.0, .radius = 0.5});
    list.balls.push_back({.tick = 4, .x = 0.1, .y = 0.2, .vx = 0.3, .vy = -0.4, .mass = 0.7});

    const std::string text = scene_list_text(list);
    const auto read = parse_scene_list(text);
    REQUIRE(read);
    CHECK(scene_list_text(*read) == text);
    CHECK(read->capsules.front().start_x == 1e-17);
    CHECK(read->balls.front().tick == 4);
    CHECK(read->plan.landed == -14.0);
    CHECK(read->restitution == 1.0 / 3.0);
}

TEST_CASE("a text that is not a scene list is refused") {
    CHECK_FALSE(parse_scene_list("rate 60\nwind 3\n"));
    CHECK_FALSE(parse_scene_list("gravity 0\n"));
    CHECK_FALSE(parse_scene_list("ball 0 1 2 x 4 5 6\n"));
}

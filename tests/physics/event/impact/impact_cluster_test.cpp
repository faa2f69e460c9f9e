#include "physics/event/impact/impact_cluster.h"

#include <doctest/doctest.h>

#include "physics/event/motion/tolerances.h"
#include "physics/support/event_parts.h"
#include "physics/support/scenes.h"

using namespace carom;

namespace {

BallEvent<double> impact_with(std::uint32_t other) {
    return {0.0, EventKind::ball_ball, 0, 0, other, 0};
}

World row(double gap) {
    World world = scenes::empty();
    for (int i = 0; i < 4; ++i)
        add_ball(world, {.position = {(1.0 + gap) * i, 0.0}, .radius = 0.5});
    return world;
}

}  // namespace

TEST_CASE(
    "impact cluster: it holds the bodies that touch the balls of the event, and grows on demand") {
    EventParts parts(row(0.0));
    parts.cluster.begin(1, impact_with(0));
    // Ball 0 first, though the event is ball 1's; then ball 2, which touches one of them.
    REQUIRE(parts.cluster.bodies().size() == 3);
    CHECK(parts.cluster.bodies()[0].ball == 0);
    CHECK(parts.cluster.bodies()[1].ball == 1);
    CHECK(parts.cluster.bodies()[2].ball == 2);
    REQUIRE(parts.cluster.contacts().size() == 2);
    CHECK(Vec2(parts.cluster.contacts()[0].contact.normal) == Vec2{-1.0, 0.0});
    parts.cluster.scan(2);
    CHECK(parts.cluster.bodies().size() == 4);
    CHECK(parts.cluster.contacts().size() == 3);
    CHECK(parts.cluster.body_of(3) == 3);
    parts.cluster.end();
    CHECK(parts.cluster.body_of(3) == BallRecord<double>::none);
}

TEST_CASE("impact cluster: bodies touch within the slop, and not beyond") {
    EventParts near(row(0.25 * contact_slop));
    near.cluster.begin(0, impact_with(1));
    CHECK(near.cluster.contacts().size() == 2);
    EventParts far(row(4.0 * contact_slop));
    far.cluster.begin(0, impact_with(1));
    CHECK(far.cluster.contacts().size() == 1);
}

TEST_CASE("impact cluster: its neighbours are valid until a body is moved") {
    EventParts parts(row(0.0));
    parts.cluster.begin(0, impact_with(1));
    const ClusterBody<double>& body = parts.cluster.bodies()[0];
    REQUIRE(parts.cluster.has_neighbours(body));
    CHECK(parts.cluster.neighbours_of(body).size() >= 1);
    CHECK(!parts.cluster.has_neighbours(parts.cluster.bodies()[2]));
    parts.cluster.note_correction();
    CHECK(!parts.cluster.has_neighbours(body));
}

#include "physics/event/motion/edge_impact.h"

#include <cmath>

#include <doctest/doctest.h>

using namespace carom;

namespace {

const Edge<double> floor_edge(Capsule{{-2.0, 0.0}, {2.0, 0.0}, 0.1}, {});

Trajectory<double> thrown(Vec2 position, Vec2 velocity, Vec2 acceleration = {}) {
    Trajectory<double> trajectory;
    trajectory.position = Vector<double>(position);
    trajectory.velocity = Vector<double>(velocity);
    trajectory.acceleration = Vector<double>(acceleration);
    return trajectory;
}

std::optional<double> impact_with(const Edge<double>& edge, const Trajectory<double>& trajectory,
                                  double end = 100.0) {
    ToiSearch<double> search;
    return edge_time_of_impact<double>(trajectory, edge, 0.4, Field<double>{}, end, search);
}

}  // namespace

TEST_CASE("edge impact: contact with the side, the ends, and a peg") {
    const auto above = contact_with<double>(floor_edge, {1.0, 2.0}, 0.4);
    CHECK(above.gap == 1.5);
    CHECK(above.normal == Vector<double>{0.0, 1.0});
    CHECK(above.place == 0.75);
    CHECK(contact_with<double>(floor_edge, {1.0, -2.0}, 0.4).normal == Vector<double>{0.0, -1.0});
    const auto beyond = contact_with<double>(floor_edge, {5.0, 4.0}, 0.4);
    CHECK(beyond.place == 1.0);
    CHECK(beyond.gap == 4.5);
    CHECK(beyond.normal == Vector<double>{0.6, 0.8});
    CHECK(contact_with<double>(floor_edge, {2.0, 0.0}, 0.4).normal == Vector<double>{0.0, 1.0});
    const Edge<double> peg(Capsule{{1.0, 1.0}, {1.0, 1.0}, 0.5}, {2.0, 0.0});
    CHECK(peg.is_point());
    CHECK(contact_with<double>(peg, {3.0, 4.0}, 0.5).gap == 2.0);
}

TEST_CASE("edge impact: sides and ends, from both sides") {
    CHECK(impact_with(floor_edge, thrown({0.0, 2.5}, {0.0, -1.0})) == doctest::Approx(2.0));
    CHECK(impact_with(floor_edge, thrown({0.0, -2.5}, {0.0, 1.0})) == doctest::Approx(2.0));
    CHECK(impact_with(floor_edge, thrown({5.0, 0.0}, {-1.0, 0.0})) == doctest::Approx(2.5));
    CHECK(impact_with(floor_edge, thrown({5.0, 0.3}, {-1.0, 0.0})) == doctest::Approx(2.6));
    CHECK(impact_with(floor_edge, thrown({0.0, 2.5}, {0.0, 1.0})) == std::nullopt);
    CHECK(impact_with(floor_edge, thrown({5.0, 2.5}, {0.0, -1.0})) == std::nullopt);
    CHECK(impact_with(floor_edge, thrown({0.0, 2.5}, {0.0, -1.0}), 1.9) == std::nullopt);
}

TEST_CASE("edge impact: a parabola comes back to the side") {
    const auto trajectory = thrown({0.0, 0.5}, {0.0, 5.0}, {0.0, -10.0});
    CHECK(impact_with(floor_edge, trajectory) == doctest::Approx(1.0));
}

TEST_CASE("edge impact: under drag a ball that rises past an end comes down on the side") {
    Field<double> field;
    field.gravity = {0.0, -10.0};
    field.has_drag = true;
    for (const double drag : {0.01, 0.1, 0.3}) {
        CAPTURE(drag);
        field.drag = drag;
        // It starts behind the line through the edge, beside which it is later.
        const auto trajectory = thrown({-4.0, -1.0}, {3.3, 6.2}, {0.0, -10.0});
        ToiSearch<double> search;
        const auto time =
            edge_time_of_impact<double>(trajectory, floor_edge, 0.4, field, 100.0, search);
        REQUIRE(time);
        const BallState<double> state = state_at(trajectory, field, *time);
        CHECK(state.position.y == doctest::Approx(0.5).epsilon(1e-12));
        CHECK(state.velocity.y < 0.0);
        CHECK(std::fabs(state.position.x) < 2.0);
    }
}

TEST_CASE("edge impact: a resting ball meets no edge") {
    auto trajectory = thrown({0.0, 0.5}, {});
    trajectory.motion = Motion::resting;
    CHECK(impact_with(floor_edge, trajectory) == std::nullopt);
}

TEST_CASE("edge impact: a kinematic edge goes on until it stops") {
    MovingEdge<double> edge;
    edge.edge = floor_edge;
    edge.start_velocity = edge.end_velocity = {0.0, 1.0};
    edge.time = 2.0;
    edge.stop = 3.0;
    CHECK(edge.at(2.5).start == Vector<double>{-2.0, 0.5});
    CHECK(edge.at(4.0).end == Vector<double>{2.0, 1.0});

    ToiSearch<double> search;
    const Field<double> field;
    const auto low = thrown({0.0, 1.25}, {});
    const auto time = moving_edge_time_of_impact<double>(low, edge, 0.4, field, 2.0, 9.0, search);
    REQUIRE(time);
    CHECK(*time == doctest::Approx(2.75));
    const auto high = thrown({0.0, 1.6}, {});
    CHECK(!moving_edge_time_of_impact<double>(high, edge, 0.4, field, 2.0, 9.0, search));
}

TEST_CASE("edge impact: a turning edge meets even a much larger ball in time") {
    // The edge turns about its middle, and the ball lies above that: the distance first shrinks
    // with the square of the time.
    for (const double radius : {0.05, 1.0, 10.0, 1000.0}) {
        CAPTURE(radius);
        constexpr double whole = 0.1;
        constexpr double gap = 0.004;
        MovingEdge<double> edge;
        edge.edge = Edge<double>({{-whole / 2, 0.0}, {whole / 2, 0.0}, 0.0}, {});
        edge.start_velocity = {0.0, -1.0};
        edge.end_velocity = {0.0, 1.0};
        edge.stop = 1.0;
        const auto trajectory = thrown({0.0, radius + gap}, {});
        const auto gap_at = [&](double time) {
            return contact_with(edge.at(time), trajectory.position, radius).gap;
        };
        double before = 0.0;
        while (before < 1.0 && gap_at(before) > 0.0)
            before += 1e-6;
        ToiSearch<double> search;
        const auto time = moving_edge_time_of_impact<double>(trajectory, edge, radius,
                                                             Field<double>{}, 0.0, 1.0, search);
        REQUIRE(time.has_value() == (before < 1.0));
        if (!time) continue;
        CHECK(*time <= before);
        CHECK(*time > before - 2e-6);
        CHECK(gap_at(*time) > -1e-9);
    }
}

// Regression: a tick of three balls that turned under strong drag took ten seconds, since the
// budget counted their iterations like all others.
TEST_CASE("edge impact: iterations about a ball that turns count as more work") {
    Field<double> field;
    field.gravity = {0.0, -1.0};
    const Edge<double> wall(Capsule{{2.0, -3.0}, {2.0, 3.0}, 0.1}, {});
    Trajectory<double> trajectory;
    trajectory.motion = Motion::turning;
    trajectory.center = {0.0, 0.0};
    trajectory.position = {0.6, 0.8};
    trajectory.velocity = {0.4, -0.3};
    ToiSearch<double> search;
    CHECK(!edge_time_of_impact<double>(trajectory, wall, 0.4, field, 100.0, search));
    CHECK(search.iterations > 0);
    CHECK(search.iterations % turning_iteration == 0);
}

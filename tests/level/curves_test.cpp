#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "geometry/elementary.h"
#include "level/load.h"
#include "physics/solver.h"
#include "physics/tick/totals.h"
#include "support/sanitizers.h"

using namespace carom;
using carom::test::has_sanitizers;

// Balls that roll along curves: edges with smooth joints (physics/laws/curve.h).
namespace {

constexpr double gravity = 10.0;

World world_of(const std::string& text) {
    LoadResult result = load_level("carom 1 \"curve\"\nuse overlap\n" + text, "curve.level");
    for (const Diagnostic& diagnostic : result.diagnostics)
        if (diagnostic.severity == Severity::error) FAIL(render(diagnostic));
    REQUIRE(result.scene);
    return std::move(result.scene->world);
}

// The statement of an edge through these points.
std::string edge_through(const std::vector<Vec2>& points, std::string_view flags) {
    std::string text = fmt::format("edge m {}", flags);
    for (std::size_t i = 0; i < points.size(); ++i)
        text += fmt::format("{} {},{}", i % 20 == 0 ? " \\\n  " : "", points[i].x, points[i].y);
    return text + "\n";
}

Vec2 on_circle(double radius, double degrees) {
    const SinCos at = sin_cos_degrees(degrees);
    return Vec2{at.cos, at.sin} * radius;
}

double energy(const World& world) {
    const Totals sums = totals(world);
    return sums.kinetic_energy + sums.potential_energy;
}

// The solvers that follow curves, and the share of the energy that they may lose.
struct Bound {
    SolverKind kind;
    double loss;
};
constexpr Bound bounds[] = {
    {SolverKind::event, 1e-9}, {SolverKind::swept, 1e-4}, {SolverKind::contact, 1e-3}};

void for_each_solver(const std::function<void(const Bound&)>& body) {
    for (const Bound& bound : bounds) {
        CAPTURE(name(bound.kind));
        body(bound);
    }
}

// A half circle of this many pieces, open above, in which the centre of a ball of radius 1 has a
// circle of radius 10 about the origin, with its lowest point 10 below. The ball starts in the
// middle of the third piece, in contact.
World groove(int pieces, double restitution) {
    std::vector<Vec2> points;
    for (int i = 0; i <= pieces; ++i)
        points.push_back(on_circle(11.0, 180.0 + 180.0 * i / pieces));
    const Vec2 middle = (points[2] + points[3]) * 0.5;
    const Vec2 start = middle * ((length(middle) - 1.0 - 1e-9) / length(middle));
    return world_of(fmt::format("use gravity 0,-{}\nmaterial m e={}\n{}ball at={},{} e={}\n",
                                gravity, restitution, edge_through(points, "smooth"), start.x,
                                start.y, restitution));
}

// The share of its energy above the lowest point that the first ball has lost when it first turns
// round on the other side.
double lost_in_one_swing(World world, SolverKind kind) {
    const auto height = [&] {
        return energy(world) + 10.0 * gravity / world.balls().inverse_mass[0];
    };
    const double before = height();
    Solver solver({.kind = kind});
    for (int i = 0; i < 6 * 60; ++i) {
        solver.tick(world);
        if (world.balls().position[0].x > 0.0 && world.balls().velocity[0].x <= 0.0) break;
    }
    REQUIRE(world.balls().position[0].x > 9.0);
    return (before - height()) / before;
}

// Walls that go on in a half circle above, in which the ball's centre has a circle of radius 10.
World arch(const std::string& settings, bool has_fillet) {
    const std::string curve = has_fillet ? "edge m -11,-20 -11,11 11,11 11,-20 fillet=11\n"
                                         : "edge m -11,-20 -11,0\n"
                                           "arc m at=0,0 radius=11 from=180 to=0\n"
                                           "edge m 11,0 11,-20\n";
    return world_of(settings + "material m e=0.4\n" + curve + "ball at=-10,-9 v=0,30 e=0.4\n");
}

}  // namespace

TEST_CASE("a ball that slides through a groove regains its height, however fine the pieces") {
    for (const int pieces : {72, 720})
        for (const double restitution : {0.0, 0.5, 1.0}) {
            CAPTURE(pieces);
            CAPTURE(restitution);
            for_each_solver([&](const Bound& bound) {
                const double lost = lost_in_one_swing(groove(pieces, restitution), bound.kind);
                CHECK(std::abs(lost) < bound.loss);
            });
        }
}

TEST_CASE("a ball keeps its speed in an arch, pressed on it by nothing but its curvature") {
    for (const bool has_fillet : {false, true})
        for (const std::string settings : {"", "use gravity 0,-10\n"}) {
            CAPTURE(has_fillet);
            CAPTURE(settings);
            for_each_solver([&](const Bound& bound) {
                World world = arch(settings, has_fillet);
                const double before = energy(world);
                Solver solver({.kind = bound.kind});
                for (int i = 0; i < 360 && world.balls().position[0].y > -9.5; ++i)
                    solver.tick(world);
                CHECK(world.balls().position[0].x > 9.9);
                CHECK(world.balls().velocity[0].y < -20.0);
                CHECK(std::abs(energy(world) - before) <
                      bound.loss * 0.5 * 30.0 * 30.0 / world.balls().inverse_mass[0]);
            });
        }
}

TEST_CASE("the periods of a ball on a cycloid are those of its height, which are all the same") {
    constexpr double size = 4.0;  // of the circle that rolls
    constexpr double radius = 0.5;
    constexpr int pieces = 2400;
    // The centre and the downward normal at a parameter in degrees.
    const auto centre_at = [](double degrees) {
        const SinCos at = sin_cos_degrees(degrees);
        return Vec2{degrees * pi / 180.0 + at.sin, 1.0 - at.cos} * size;
    };
    const auto down_at = [](double degrees) {
        const SinCos at = sin_cos_degrees(degrees / 2.0);
        return Vec2{at.sin, -at.cos};
    };
    std::vector<Vec2> points;
    for (int i = 0; i <= pieces; ++i) {
        const double degrees = -150.0 + 300.0 * i / pieces;
        points.push_back(centre_at(degrees) + down_at(degrees) * radius);
    }
    const double exact = 4.0 * pi * std::sqrt(size / gravity);
    const auto period = [&](double degrees, SolverKind kind) {
        const Vec2 start = centre_at(degrees) - down_at(degrees) * 1e-5;
        World world = world_of(
            fmt::format("use gravity 0,-{}\nmaterial m e=0\n{}ball at={},{} r={} e=0\n", gravity,
                        edge_through(points, "smooth"), start.x, start.y, radius));
        Solver solver({.kind = kind});
        std::vector<double> crossings;  // of the lowest point, to the right
        while (crossings.size() < 2) {
            const double before = world.balls().position[0].x;
            solver.tick(world);
            const double after = world.balls().position[0].x;
            if (before < 0.0 && after >= 0.0)
                crossings.push_back(world.time() - world.tick_length() * after / (after - before));
        }
        return crossings.back() - crossings.front();
    };
    for (const double degrees : {-30.0, -60.0, -90.0, -115.0}) {
        if (has_sanitizers && degrees != -60.0) continue;
        CAPTURE(degrees);
        CHECK(period(degrees, SolverKind::event) == doctest::Approx(exact).epsilon(5e-5));
        CHECK(period(degrees, SolverKind::swept) == doctest::Approx(exact).epsilon(1e-4));
        CHECK(period(degrees, SolverKind::contact) == doctest::Approx(exact).epsilon(5e-4));
    }
}

TEST_CASE("a corner that an author draws stays a corner") {
    // Two slopes of 5 degrees that meet without restitution: the approach at the corner is lost.
    for (const bool is_smooth : {false, true}) {
        const std::string level = fmt::format("material m e=0\nedge m {} -20,0 0,0 20,{}\n",
                                              is_smooth ? "smooth" : "", 20.0 * 0.0875);
        for_each_solver([&](const Bound& bound) {
            World world = world_of("use gravity 0,-10\n" + level + "ball at=-10,1 v=8,0 e=0\n");
            const double before = energy(world);
            Solver solver({.kind = bound.kind});
            while (world.balls().position[0].x < 1.0)
                solver.tick(world);
            const double lost =
                2.0 * (before - energy(world)) * world.balls().inverse_mass[0] / 64.0;
            if (is_smooth)
                CHECK(std::abs(lost) < std::max(bound.loss, 1e-8));
            else
                CHECK(lost > 0.7 * 0.0875 * 0.0875);
        });
    }
    // A turn of more than 20 degrees is one even where the edge is smooth, and so is an arc that
    // meets an edge at an angle.
    CHECK(!world_of("edge m smooth 0,0 10,0 10,10\nmaterial m e=0\nball at=0,5\n").model().curved);
    const World world = world_of(
        "material m e=0\narc m at=0,0 radius=10 from=180 to=90\nedge m 0,10 10,12\nball at=5,0\n");
    CHECK(world.capsules().joints.back() == Joints{no_joint, no_joint});
}

TEST_CASE("a real impact on an arc bounces off the arc, not off its pieces") {
    // Straight down onto the inside of a half circle, at places all along a piece.
    for (int i = 0; i < 9; ++i) {
        const Vec2 aim = on_circle(10.0, 300.0 + 0.7 * i);
        for_each_solver([&](const Bound& bound) {
            World world =
                world_of(fmt::format("material m e=0.5\narc m at=0,0 radius=11 from=180 "
                                     "to=360\nball at={},0 v=0,-20 e=0.5\n",
                                     aim.x));
            Solver solver({.kind = bound.kind});
            while (world.ledger().ball_edge_collisions == 0)
                solver.tick(world);
            const Vec2 normal = -aim / length(aim);
            const Vec2 along = perpendicular(normal);
            const Vec2 after = world.balls().velocity[0];
            CHECK(dot(after, normal) == doctest::Approx(-0.5 * -20.0 * normal.y).epsilon(0.002));
            CHECK(dot(after, along) == doctest::Approx(-20.0 * along.y).epsilon(0.002));
        });
    }
}

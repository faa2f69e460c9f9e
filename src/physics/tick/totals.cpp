#include "physics/tick/totals.h"

#include <algorithm>

#include "geometry/closest.h"
#include "physics/broad_phase/capsule_cells.h"
#include "physics/broad_phase/disc_grid.h"
#include "physics/broad_phase/nearest_image.h"

namespace carom {
namespace {

// Compensated summation. Source: Neumaier, ZAMM 54 (1974) 39.
class Sum {
  public:
    void add(double value) {
        const double sum = sum_ + value;
        if (std::fabs(sum_) >= std::fabs(value))
            dropped_ += (sum_ - sum) + value;
        else
            dropped_ += (value - sum) + sum_;
        sum_ = sum;
    }
    double value() const { return sum_ + dropped_; }

  private:
    double sum_ = 0.0;
    double dropped_ = 0.0;
};

}  // namespace

Totals totals(const World& world) {
    Sum kinetic;
    Sum potential;
    Sum momentum_x;
    Sum momentum_y;
    Sum angular;
    const Vec2 gravity = world.model().gravity.value_or(Vec2{});
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const double mass = 1.0 / world.balls().inverse_mass[i];
        const Vec2 position = world.balls().position[i];
        const Vec2 velocity = world.balls().velocity[i];
        kinetic.add(0.5 * mass * length_squared(velocity));
        potential.add(-mass * dot(gravity, position));
        momentum_x.add(mass * velocity.x);
        momentum_y.add(mass * velocity.y);
        angular.add(mass * cross(position, velocity));
        if (!world.model().spin) continue;
        const double radius = world.balls().radius[i];
        const double inertia = *world.model().spin * mass * radius * radius;
        kinetic.add(0.5 * inertia * world.balls().spin[i] * world.balls().spin[i]);
        angular.add(inertia * world.balls().spin[i]);
        if (!world.model().cloth) continue;
        kinetic.add(0.5 * *world.model().spin * mass * length_squared(world.balls().roll[i]));
    }
    for (const Seesaw& seesaw : world.seesaws()) {
        kinetic.add(0.5 * seesaw.inertia * seesaw.rate * seesaw.rate);
        angular.add(seesaw.inertia * seesaw.rate);
    }
    // + 0.0 turns a negative zero into a positive one, for print.
    return {kinetic.value() + 0.0,
            potential.value() + 0.0,
            {momentum_x.value() + 0.0, momentum_y.value() + 0.0},
            angular.value() + 0.0};
}

double typical_travel_in_radii(const World& world) {
    double ways = 0.0;
    for (const Vec2 velocity : world.balls().velocity)
        ways += length_squared(velocity);
    double radii = 0.0;
    for (const double radius : world.balls().radius)
        radii += radius * radius;
    return std::sqrt(ways / radii) * world.tick_length();
}

namespace {

double deepest_overlap_of_balls(const World& world) {
    const Balls& balls = world.balls();
    DiscGrid grid;
    grid.build(balls.position, balls.radius, 0.0, world.model().wrap);
    double deepest = 0.0;
    grid.for_each_pair([&](std::uint32_t a, std::uint32_t b) {
        if (!kinds_meet(world, balls.kind[a], balls.kind[b])) return;
        const Vec2 offset =
            nearest_image(world, balls.position[std::min(a, b)] - balls.position[std::max(a, b)]);
        deepest = std::max(deepest, balls.radius[a] + balls.radius[b] - length(offset));
    });
    return deepest;
}

double deepest_overlap_with_edges(const World& world) {
    const Balls& balls = world.balls();
    const double largest = largest_radius(balls);
    const CellFrame frame = frame_around(world, 2.0 * largest);
    CapsuleCells edges;
    edges.update(world, frame, largest);
    const Vec2 torus = world.model().wrap ? size(*world.model().wrap) : Vec2{};
    double deepest = 0.0;
    const auto against_edge = [&](std::size_t i, std::size_t capsule, Vec2 shift) {
        if (!kind_meets_material(world, balls.kind[i], world.capsules().material[capsule])) return;
        if (world.model().one_way && world.capsules().side[capsule] != Side::both) return;
        Capsule shape = world.capsules().shape[capsule];
        shape.start += shift;
        shape.end += shift;
        deepest = std::max(deepest, -separation(Disc{balls.position[i], balls.radius[i]}, shape));
    };
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Vec2 position = balls.position[i];
        const std::uint32_t cell = frame.index(frame.column(position.x), frame.row(position.y));
        for (const CapsuleEntry entry : edges.in_cell(cell))
            against_edge(i, entry.index, {entry.across * torus.x, entry.along * torus.y});
        for (const HeldCapsule& held : world.held_capsules())
            if (const auto index = index_of(world, held.id)) against_edge(i, *index, {});
    }
    return deepest;
}

}  // namespace

double deepest_overlap(const World& world) {
    double deepest = 0.0;
    if (world.model().ball_ball) deepest = deepest_overlap_of_balls(world);
    if (world.model().ball_edge) deepest = std::max(deepest, deepest_overlap_with_edges(world));
    return deepest;
}

}  // namespace carom

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/contact/solver.h"
#include "physics/tick/totals.h"

// The homes of the balls in the solver `contact`: regions around them that they stay in for some
// ticks. For as long, the pairs that were found in the regions are all that could meet.
namespace carom {
namespace {

// What the sizes of regions depend on.
struct Times {
    double tick = 0.0;     // s
    double substep = 0.0;  // s
    double fall = 0.0;     // length/s^2
    double radii = 0.0;    // that a region may be larger than the ball, for a way of a whole tick
};

// How far each ball may go in a tick before the pairs must be found again: what it needs at its
// speed, but at least `hit`, for what pushes it; of a very fast one, what it needs in a substep.
double margin_for(double speed, double radius, const Times& times, double hit) {
    const double whole = speed * times.tick + times.fall * times.tick * times.tick;
    const double most = std::max(
        times.radii * radius, speed * times.substep + times.fall * times.substep * times.substep);
    return std::max(1.25 * std::min(whole, most), hit) + 0.03 * radius;
}

// A few fast balls get large regions, so that not all pairs are found anew for their sake. Where
// balls typically go further than their radius in a tick, such regions would hold a crowd each, and
// all that meets looks at all of it: there they last for a substep.
double most_radii(const World& world) {
    return typical_way(world) > 1.0 ? 0.5 : 4.0;
}

}  // namespace

// Whether it does not show in the result when the pairs are found: nothing is ever pressed, so they
// are in no order, and neither the torus nor spin is rounded anew when bodies are loaded.
bool ContactSolver::is_order_free(const World& world) {
    const Model& model = world.model;
    return !model.gravity && !model.lossy && !model.wrap && !model.spin &&
           world.held_balls.empty() && world.held_capsules.empty();
}

// Regions for all balls, around where they are now.
void ContactSolver::find_homes(World& world) const {
    const Balls& balls = world.balls;
    const Times times{.tick = world.tick_length(),
                      .substep = duration_,
                      .fall = length(gravity_),
                      .radii = most_radii(world)};
    double fastest = 0.0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        fastest = std::max(fastest, length_squared(balls.velocity[i]));
        smallest = std::min(smallest, balls.radius[i]);
    }
    fastest = std::sqrt(fastest);
    // Where it does not show when the pairs are found, more for what is hit: so that they last for
    // the tick, mostly.
    const double roomy =
        is_order_free(world) ? std::min(1.15 * fastest * times.tick, 0.4 * smallest) : 0.0;
    Homes& homes = world.homes;
    homes.ball = balls.id;
    homes.place = balls.position;
    homes.margin.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double radius = balls.radius[i];
        const double hit = std::max(std::min(1.1 * fastest * duration_, 0.25 * radius), roomy);
        homes.margin[i] = margin_for(length(balls.velocity[i]), radius, times, hit);
    }
    for (const HeldBall& held : world.held_balls) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        Vec2 way = held.target - balls.position[*index];
        if (wraps_) way = nearest_image(way, torus_);
        homes.margin[*index] += length(way);
    }
}

// Whether a ball so far from home cannot leave its region in the next substep with this velocity:
// (away + way)^2 <= 2 (away^2 + way^2).
inline bool ContactSolver::stays_home(Vec2 away, Vec2 velocity, double margin) const {
    const double way = length(velocity) * duration_ + fall_;
    return 2.0 * (length_squared(away) + way * way) <= margin * margin;
}

// Whether the regions of an earlier tick will do, at least for the next substep. What a hand meets
// is asked anew in each tick, and on a torus balls leave their homes behind at its seams.
bool ContactSolver::has_homes(const World& world) const {
    const Homes& homes = world.homes;
    if (wraps_ || !world.held_balls.empty() || !world.held_capsules.empty()) return false;
    if (homes.ball != world.balls.id) return false;
    const Balls& balls = world.balls;
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (!stays_home(balls.position[i] - homes.place[i], balls.velocity[i], homes.margin[i]))
            return false;
    return true;
}

// Whether nobody can leave the region in which it was compared in the next substep.
bool ContactSolver::is_at_home() const {
    for (std::uint32_t i = 0; i < still_; ++i)
        if (!stays_home(position_[i] - home_[i], mover_[i].velocity, margin_[i])) return false;
    return true;
}

}  // namespace carom

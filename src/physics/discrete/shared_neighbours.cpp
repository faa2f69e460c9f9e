#include "physics/discrete/shared_neighbours.h"

#include <algorithm>
#include <limits>

#include "physics/broad_phase/nearest_image.h"

namespace carom {

// Once a tick every ball is checked; after that the longest displacements since add up.
void SharedNeighbours::update(const World& world, double displacement,
                              double kinematic_displacement) {
    const bool holds = has_checked_all_
                           ? list_.is_valid_after(displacement + kinematic_displacement)
                           : list_.is_valid(world);
    has_checked_all_ = true;
    if (!holds) build(world, displacement * step_.updates);
    has_escaped_ = false;
}

// The margin lets the steps of a tick share the list: it is at least what the fastest ball goes in
// the tick (`displacement`), unless that is a large part of the mean radius. It takes one of a few
// values, so that the cells seldom change.
void SharedNeighbours::build(const World& world, double displacement) {
    margin_ = 0.0;
    widest_ = std::numeric_limits<double>::infinity();
    are_alike_ = false;
    if (are_shared() && world.balls().size() > 0) {
        double sum = 0.0;
        double smallest = world.balls().radius[0];
        double largest = smallest;
        for (const double radius : world.balls().radius) {
            sum += radius;
            smallest = std::min(smallest, radius);
            largest = std::max(largest, radius);
        }
        widest_ = 2.0 * largest;
        are_alike_ = smallest == largest;
        margin_ = 0.5 * sum / static_cast<double>(world.balls().size());
        for (int halvings = 0; halvings < 6 && displacement <= margin_ / 2.0; ++halvings)
            margin_ /= 2.0;
    }
    list_.build(world, margin_);
}

void SharedNeighbours::update_after_notes(const World& world) {
    if (has_escaped_) list_.build(world, margin_);
    has_escaped_ = false;
}

bool SharedNeighbours::has_edges_of(const World& world, const PushedBall& pushed) const {
    const Vec2 position = world.balls().position[pushed.ball];
    if (margin_ > 0.0) return list_.is_valid_for(pushed.ball, position);
    const Vec2 displacement = nearest_image(world, position - pushed.origin);
    const double margin = 0.999 * list_.edge_margin(world.balls().radius[pushed.ball]);
    return length_squared(displacement) <= margin * margin;
}

}  // namespace carom

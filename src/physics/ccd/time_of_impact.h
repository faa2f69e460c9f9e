#pragma once

#include <optional>

#include "geometry/impact.h"
#include "physics/tick/kinematic.h"

/// When a ball on its chord (chord.h) first meets something in the rest of a substep: for the
/// solvers `swept` and `contact`. Units, approach and degenerate cases are those of
/// geometry/impact.h; `horizon` is the time left in the substep, s.
///
/// What differs between the two solvers stays with them: which approaches are rounding (`swept`
/// knows the speed that supports take away), and how far a pair may overlap first (`contact` leaves
/// pressed pairs to its constraints).
namespace carom {

/// First impact of two balls. `offset` points from the centre of the other ball to that of the
/// first one, on a torus to the nearest image; `relative` is the difference of their chords'
/// velocities. `allowed_overlap()` is how far the pair may overlap before it meets, length, at most
/// the sum of the radii; it is asked only where a quick test does not tell that the balls stay
/// apart.
template <typename Overlap>
std::optional<Impact> impact_of_balls(Vec2 offset, Vec2 relative, double radius,
                                      double other_radius, double horizon,
                                      Overlap&& allowed_overlap) {
    if (stays_apart(offset, relative, radius + other_radius, horizon)) return std::nullopt;
    const double reach = radius - allowed_overlap() + other_radius;
    return first_impact(Disc{offset, reach}, relative, Disc{{}, 0.0}, horizon);
}

/// First impact of a ball with a kinematic edge, which is at `shape` now. An edge that has stopped
/// is searched by iteration, as one that moves at speed 0. `swept` does not use this for stopped
/// edges: it treats them as fixed, in closed form. The results differ by rounding, 1e-12 of the
/// sizes, so `contact`, whose edges stop often, keeps the iteration, and with it its bits.
inline std::optional<Impact> impact_with_moving_edge(const Disc& ball, Vec2 velocity,
                                                     const Capsule& shape, const HeldEdge& edge,
                                                     double horizon) {
    if (edge.is_seesaw)
        return first_impact(
            ball, velocity, shape,
            HingeTurn{edge.seesaw.pivot, edge.is_stopped() ? 0.0 : edge.seesaw.rate}, horizon);
    const double share = edge.is_stopped() ? 0.0 : edge.share;
    return first_impact(ball, velocity, shape, edge.start_velocity * share,
                        edge.end_velocity * share, horizon);
}

}  // namespace carom

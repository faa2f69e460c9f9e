#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/vec2.h"
#include "geometry/vector.h"
#include "physics/world/world.h"

/// How a ball bounces off a piece of a curve: an edge that continues in another without a corner.
///
/// A curve is drawn in straight pieces, and a ball that rolls along one would hit the next, though
/// the curve itself has nothing to hit. At a smooth joint the impacts are those of the curve:
///
/// - A ball that goes along the curve, or nearly so, *rolls on*: its velocity is turned along the
///   piece, and keeps its size. That is the limit of ever finer pieces, in which the impulses are
///   those of a continuous curvature and do no work. Nearly: it approaches the piece at an angle
///   whose sine is at most `flat_turns` times that of the turn at a joint near by. Where the edge
///   is elastic, such a ball bounces off the curve, which loses nothing either, unless it comes
///   straight along the other edge of the joint.
/// - Any other impact has the normal of the curve at that place, between those at its two joints,
///   unless that would lead the ball into the piece.
///
/// A joint counts while the two edges end in the same point, and up to `joint_reach` lengths of the
/// other edge away from it. So edges that a player moves apart have corners again, and a long
/// straight edge is no curve far from its joint.
namespace carom {

/// 1 would do for exact paths: a ball from one piece meets the next at the angle of their turn, and
/// so does one that has hopped over a joint. Solvers with substeps are less exact. The higher, the
/// more flat impacts on a curve lose nothing that should.
inline constexpr double flat_turns = 1.5;
/// The lower, the sooner a ball that leaves a piece and falls back to the curve loses energy.
inline constexpr double joint_reach = 2.0;

/// A ball at the instant at which it meets a piece.
struct CurveImpact {
    Vec2 position;             ///< of its centre, in any image on a torus
    Vec2 velocity;             ///< relative to the piece
    Vec2 normal;               ///< unit, from the piece to the ball
    double reach = 0.0;        ///< sum of the radii of the ball and the piece
    double restitution = 0.0;  ///< the usual one, at this speed
};

/// What the ball does.
struct CurveBounce {
    enum class Way : std::uint8_t {
        as_usual,  ///< no piece of a curve, or no approach
        bounces,   ///< with the usual restitution, along `normal`
        rolls_on   ///< with restitution 1, along `rolling_normal`
    };
    Way way = Way::as_usual;
    Vec2 normal;           ///< unit; with `bounces`
    bool is_flat = false;  ///< the ball goes nearly along the curve; always with `rolls_on`
};

/// Cost: a dozen divisions and roots. Pre: Model::curved.
CurveBounce curve_bounce(const World& world, std::size_t capsule, const CurveImpact& impact);

/// The unit normal of the elastic bounce that turns `velocity` along a piece with this normal, and
/// keeps its direction along the piece. Pre: dot(velocity, normal) < 0.
template <typename V>
V rolling_normal(const V& velocity, const V& normal) {
    using Real = decltype(V::x);
    V along = perpendicular(normal);
    if (dot(along, velocity) < Real{}) along = -along;
    // Half of the angle from the piece to the velocity: tan(a / 2) = sin a / (1 + cos a).
    const Real half = -dot(velocity, normal) / (length(velocity) + dot(velocity, along));
    const V turned = normal + along * half;
    return turned / length(turned);
}

/// Whether the two edges, which have an end in common, can have a smooth joint there: their radii
/// are the same, and they turn by no more than 20 degrees.
bool can_join(const Capsule& one, const Capsule& other, Vec2 point);

}  // namespace carom

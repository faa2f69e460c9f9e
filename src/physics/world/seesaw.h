#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "geometry/shapes.h"
#include "physics/world/ids.h"

/// Seesaws: edges that turn about a pivot as bodies with a moment of inertia.
namespace carom {

class World;
struct HeldCapsule;

/// An edge on a hinge. Its centre of mass is the pivot, so gravity does not turn it, and nothing
/// brakes it: between impacts it turns at a constant rate, and where it is follows in closed form.
/// Impacts with balls change its rate, and so do its *stops*: at the least and the most angle it
/// bounces back. Balls and seesaw exchange impulses both ways (laws/hinge.h).
///
/// Angles are counter-clockwise, from where the level has drawn the edge.
struct Seesaw {
    CapsuleId capsule{};
    Capsule home;          ///< the edge at angle 0
    Vec2 pivot;            ///< on the edge or anywhere else
    double inertia = 1.0;  ///< moment of inertia about the pivot, mass length^2, > 0
    double least = -std::numeric_limits<double>::infinity();  ///< rad, <= angle
    double most = std::numeric_limits<double>::infinity();    ///< rad, >= angle, > least
    double stop_restitution = 0.0;                            ///< of the rate at a stop, 0..1

    double angle = 0.0;  ///< rad
    double rate = 0.0;   ///< rad/s
    /// Within a tick: how often it has bounced at its stops. Between ticks 0.
    std::uint32_t bounces = 0;

    friend bool operator==(const Seesaw&, const Seesaw&) = default;
};

/// The moment of inertia, for a mass of 1, of a thin uniform bar along the spine of this edge about
/// the pivot, length^2.
double bar_inertia(const Capsule& edge, Vec2 pivot);

/// The place of the edge when its seesaw is at this angle.
Capsule seesaw_shape(const Seesaw& seesaw, double angle);

/// Makes the edge of `seesaw` turn on a hinge, sets Model::hinged, and puts the edge where its
/// angle says. A stop that takes energy sets Model::inelastic. Pre: no flipper, mover or other
/// seesaw has the edge; it is solid on both sides, does not kick, and is no piece of a curve; the
/// world is no torus.
void add_seesaw(World& world, const Seesaw& seesaw);

/// Index into World::seesaws of the seesaw with this edge; none where there is none.
std::optional<std::uint32_t> seesaw_of(const World& world, CapsuleId id);

/// Begins a tick: the edges of all seesaws become kinematic bodies (World::held_capsules), which
/// the solver turns. Time stands still for those that turn too fast.
void release_seesaws(World& world);

/// Ends a tick: the edges of seesaws are no kinematic bodies any more, and time goes on for all.
void keep_seesaws(World& world);

/// A seesaw bounces at its stops at most so often in a tick; beyond it, time stands still for it
/// until the tick ends: it stays at its angle and keeps its rate. x10: a fast one takes ten times
/// as long, since each bounce is an event for all balls; /10: time stands still for seesaws that
/// flutter under a ball.
inline constexpr std::uint32_t most_bounces_at_stops = 256;
/// Time stands still for a seesaw that turns by more than this in a tick, rad. x10: searches for
/// impacts with it take ten times as long, and its angle loses a digit to rounding; /10: time
/// stands still where a millisecond would do.
inline constexpr double most_turning_in_a_tick = 1e5;
inline bool is_standing(const Seesaw& seesaw) {
    return seesaw.bounces > most_bounces_at_stops;
}
/// For how many seesaws time stands still. Pre: within a tick.
std::size_t count_standing_seesaws(const World& world);

/// Whether the seesaw stands at a stop that keeps it from turning in this direction.
inline bool is_stopped_at(const Seesaw& seesaw, double direction) {
    return (direction > 0.0 && seesaw.angle >= seesaw.most) ||
           (direction < 0.0 && seesaw.angle <= seesaw.least);
}

/// The speed of its fastest point, length/s.
double fastest_point(const Seesaw& seesaw);

/// In how many seconds a seesaw that turns at its rate reaches a stop; infinite if it does not, or
/// if time stands still for it.
double time_to_stop(const Seesaw& seesaw);

/// The seesaw `duration` s later, if nothing hits it before. Pre: duration <= time_to_stop.
void turn_on(Seesaw& seesaw, double duration);

/// The seesaw has come to the stop that it turns towards: it bounces, at the angle of the stop, or
/// time stands still for it.
void bounce_at_stop(Seesaw& seesaw);

}  // namespace carom

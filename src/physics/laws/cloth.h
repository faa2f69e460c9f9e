#pragma once

#include <cstdint>
#include <optional>

#include "geometry/vector.h"
#include "physics/world/model.h"

/// A ball on cloth, seen from above: it slides until its lowest point no longer slips, then rolls,
/// then lies still. What side spin it has dies away by itself.
///
/// The lowest point slips at u = velocity - roll, where `roll` says how the ball turns about
/// horizontal axes: it is the velocity with which a ball that turns so would roll without slipping
/// (with the angular velocity (x, y) it is r (y, -x)).
///
///   sliding  u is not 0     velocity' = -slide g u/|u|, roll' = slide g u/|u| / inertia: the slip
///                           keeps its direction, so the path is a parabola, and ends after
///                           |u| / (slide g (1 + 1/inertia)); 2|u| / (7 slide g) for a solid ball
///   rolling  u is 0         velocity' = roll' = -rolling g velocity/|velocity|: a straight line,
///                           ends after |velocity| / (rolling g)
///   still    nothing moves
///
/// Source: G. Coriolis, Theorie mathematique des effets du jeu de billard (1835), with a resistance
/// to rolling and one to spinning.
namespace carom {

enum class ClothMotion : std::uint8_t { sliding, rolling, still };

/// How a ball moves until that changes.
template <typename Real>
struct ClothPhase {
    ClothMotion motion = ClothMotion::still;
    Vector<Real> acceleration;       ///< of the velocity
    Vector<Real> roll_acceleration;  ///< of the roll
    std::optional<Real> lasts;       ///< s; none: for ever
};

/// The phase that begins with this velocity and roll. `inertia`: Model::spin. A slip that is
/// rounding counts as none.
template <typename Real>
ClothPhase<Real> cloth_phase(const Cloth& cloth, double inertia, const Vector<Real>& velocity,
                             const Vector<Real>& roll);

/// A ball, where it is and how it moves.
template <typename Real>
struct ClothState {
    Vector<Real> position;
    Vector<Real> velocity;
    Vector<Real> roll;
    Real spin{};  ///< rad/s
};

/// The state `duration` seconds later, if nothing is met on the way: exact, through however many
/// phases. Pre: duration >= 0.
template <typename Real>
ClothState<Real> cloth_state_after(const Cloth& cloth, double inertia, ClothState<Real> state,
                                   Real duration);

/// Side spin `duration` seconds later.
template <typename Real>
Real cloth_spin_after(const Cloth& cloth, const Real& spin, const Real& duration);

}  // namespace carom

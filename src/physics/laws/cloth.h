#pragma once

#include <cstdint>
#include <optional>

#include "geometry/vector.h"
#include "physics/world/model.h"

/// A ball on cloth, seen from above: it slides until its lowest point no longer slips, then rolls,
/// then lies still. Its side spin decays independently of that.
///
/// The lowest point slips at u = velocity - roll. `roll` stands for rotation about horizontal axes:
/// the velocity at which a ball with this rotation would roll without slipping. For the angular
/// velocity (x, y) it is r (y, -x).
///
///   sliding  u is not 0     velocity' = -slide g u/|u|, roll' = slide g u/|u| / inertia: the slip
///                           keeps its direction, so the path is a parabola, and ends after
///                           |u| / (slide g (1 + 1/inertia)); 2|u| / (7 slide g) for a solid ball
///   rolling  u is 0         velocity' = roll' = -rolling g velocity/|velocity|: a straight line,
///                           which ends after |velocity| / (rolling g)
///   still    nothing moves
///
/// Source: G. Coriolis, Theorie mathematique des effets du jeu de billard (1835), with a resistance
/// to rolling and one to spinning.
namespace carom {

enum class ClothMotion : std::uint8_t { sliding, rolling, still };

/// One phase of a ball's motion: constant acceleration.
template <typename Real>
struct ClothPhase {
    ClothMotion motion = ClothMotion::still;
    Vector<Real> acceleration;       ///< of the velocity
    Vector<Real> roll_acceleration;  ///< of the roll
    std::optional<Real> lasts;       ///< s; none: forever
};

/// The phase that begins with this velocity and roll, length/s. `inertia`: Model::spin. A slip no
/// larger than rounding counts as 0.
template <typename Real>
ClothPhase<Real> cloth_phase(const Cloth& cloth, double inertia, const Vector<Real>& velocity,
                             const Vector<Real>& roll);

/// Position and motion of a ball.
template <typename Real>
struct ClothState {
    Vector<Real> position;
    Vector<Real> velocity;
    Vector<Real> roll;
    Real spin{};  ///< rad/s
};

/// The state `duration` seconds later, without impacts. Exact, over any number of phases.
/// Pre: duration >= 0.
template <typename Real>
ClothState<Real> cloth_state_after(const Cloth& cloth, double inertia, ClothState<Real> state,
                                   Real duration);

/// Side spin `duration` seconds later, rad/s.
template <typename Real>
Real cloth_spin_after(const Cloth& cloth, const Real& spin, const Real& duration);

}  // namespace carom

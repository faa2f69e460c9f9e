#pragma once

#include <cstdint>
#include <optional>

#include "geometry/conservative_advancement.h"
#include "physics/event/motion/trajectories.h"
#include "physics/event/rest/supports.h"

namespace carom {

/// `value`, but no further from 0 than `most` >= 0: Coulomb's limit.
template <typename Real>
Real clamped(const Real& value, const Real& most) {
    return value < -most ? -most : (most < value ? most : value);
}

/// Friction between a ball and the side of an edge along which it slides or rolls, or between a
/// resting ball and its supports. Pre of all functions: Model::spin, no cloth.
///
/// While a ball slips, a force of its coefficient times its weight on the side acts against the
/// slip, which gives the ball and its spin constant accelerations. The end of the slip is a
/// transition, found in closed form. Then the ball rolls if friction suffices, with an acceleration
/// of gravity's component along the side divided by (1 + inertia). Under drag the friction that
/// rolling needs changes, so it is updated after every `rolling_piece` of drag's time constant.
///
/// Friction at both supports brakes the spin of a ball that two supports hold, until it is 0. Round
/// ends, pegs and resting balls exert no friction on a ball that turns round them.
template <typename Real>
class SideFriction {
  public:
    SideFriction(const EventScene<Real>& scene, const BallTable<Real>& balls,
                 const Supports<Real>& supports, Trajectories<Real>& trajectories,
                 ToiSearch<Real>& search)
        : scene_(scene),
          balls_(balls),
          supports_(supports),
          trajectories_(trajectories),
          search_(search) {}

    /// What friction does to a ball from now on.
    struct Effect {
        Vector<Real> acceleration;
        SpinTrajectory<Real> spin;
    };

    /// The coefficient of friction of the ball with a support; 0 where there is none.
    Real coefficient(std::uint32_t ball, const SupportId& support) const;
    /// On a side, for a ball at this velocity along it; `pull` is gravity's component along it.
    Effect on_side(std::uint32_t ball, const Support<Real>& support, const Vector<Real>& velocity,
                   const Vector<Real>& pull) const;
    /// Two supports hold the ball: `friction`, an acceleration, brakes its spin.
    void brake(std::uint32_t ball, const Real& friction);
    /// If friction on the supporting side drives the ball against another edge that it touches,
    /// puts the ball to rest there, where its spin is braked. Returns whether it did.
    bool rest_braced(std::uint32_t ball, const Support<Real>& support, const Vector<Real>& velocity,
                     const Effect& effect, const Vector<Real>& acceleration);
    /// Whether a ball at rest on two supports spins fast enough to roll off along `side`.
    bool rolls_off(std::uint32_t ball, const Support<Real>& side, const Support<Real>& other) const;
    /// When the slip of a sliding ball, or the spin of a resting one, ends; s, up to `horizon`.
    std::optional<Real> end_of_slip(std::uint32_t ball, const Real& horizon);
    /// At that transition: clears what rounding has left of the slip or spin.
    void end_slip(std::uint32_t ball);

  private:
    Real slip_tolerance(std::uint32_t ball, const Vector<Real>& velocity, const Real& change) const;
    Vector<Real> slip_direction(std::uint32_t ball) const;

    const EventScene<Real>& scene_;
    const BallTable<Real>& balls_;
    const Supports<Real>& supports_;
    Trajectories<Real>& trajectories_;
    ToiSearch<Real>& search_;
};

}  // namespace carom

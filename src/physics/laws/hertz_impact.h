#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/laws/simultaneous_impact.h"

/// Impacts that last: balls that press on one another for a time, while others join in.
///
/// A contact is Hertz's spring: at the depth d it pushes with k d^1.5 while the balls approach, and
/// with e^2 times that while they separate. So two balls alone separate at e times their approach
/// speed, whatever that speed, and no contact ever pulls. Other balls join when their gaps close.
/// The impact ends when nothing presses any more.
///
/// An impact is short. During it only these forces accelerate the bodies, normals keep their
/// directions, and the caller leaves the balls where they were. Impulses come in opposite pairs
/// along a line that both bodies share, so momentum and angular momentum are conserved.
///
/// Sources: Hertz, J. reine angew. Math. 92 (1881) 156; Landau and Lifshitz, Theory of Elasticity,
/// section 9; the law of unloading: Walton and Braun, J. Rheology 30 (1986) 949, with Hertz's force
/// in place of their linear one.
namespace carom {

/// A contact that is there, or that may close during the impact.
template <typename Real>
struct HertzContact {
    ImpactContact<Real> contact;  ///< of two bodies, not both immovable
    Real gap{};                   ///< length, >= 0
    Real stiffness{};             ///< k, force / length^1.5, > 0
};

/// A contact that has pressed.
template <typename Real>
struct HertzTouch {
    std::uint32_t contact = 0;  ///< by index
    Real approach{};            ///< when it first touched, length/s
    Real impulse{};             ///< >= 0
};

/// The stiffness of two balls of one material. `modulus`: E / (1 - nu^2), with Young's modulus E
/// and Poisson's ratio nu. Pre: all > 0.
template <typename Real>
Real hertz_stiffness(const Real& modulus, const Real& radius_a, const Real& radius_b);

/// The duration of an elastic contact of two bodies alone, s. `mass`: the reduced mass,
/// 1 / (1/m_a + 1/m_b). It falls with the fifth root of the speed. Pre: all > 0.
template <typename Real>
Real hertz_duration(const Real& stiffness, const Real& mass, const Real& speed);

/// The approach at which two bodies alone press on each other by `depth`, length/s. Pre: all > 0.
template <typename Real>
Real hertz_speed(const Real& stiffness, const Real& mass, const Real& depth);

/// Computes impacts that last. From one impact to the next it keeps nothing but allocated memory.
///
/// Method: leapfrog, in steps of 1/128 of the shortest contact at the fastest approach, but at most
/// 16,384 steps for the longest. Where these leave the shortest contact fewer than 32 steps, in
/// which the method would be unstable (mass ratios of millions), nothing presses, and the impact is
/// left to those that take no time. A last step corrects the energy: one factor scales all impulses
/// so that the bodies lose exactly what unloading has lost. So energy never grows, and is conserved
/// to rounding where every restitution is 1. A bound on the number of steps, which long chains do
/// not reach, may end an impact early; that conserves energy too, but may leave some approach.
template <typename Real>
class HertzImpact {
  public:
    /// The contacts that press, in the order in which they first touch. Changes no body: the caller
    /// applies the impulses. `speed` > 0: the approach with which it begins. The result is valid
    /// until the next call.
    const std::vector<HertzTouch<Real>>& press(std::span<const ImpactBody<Real>> bodies,
                                               std::span<const HertzContact<Real>> contacts,
                                               const Real& speed);

    /// Evaluations of a contact in the last impact.
    std::uint64_t work() const { return work_; }

  private:
    struct State {
        Real energy{};  ///< of loading to the depth of the last step
        Real kick{};    ///< of this step
        Real impulse{};
        bool has_touched = false;
    };

    void drift(const Real& time);
    bool kick(std::span<const ImpactBody<Real>> bodies,
              std::span<const HertzContact<Real>> contacts, const Real& step);
    void lose(State& state, const Real& restitution, const Real& energy);
    void lose_rest(std::span<const HertzContact<Real>> contacts);
    Real scale_of(std::span<const ImpactBody<Real>> bodies,
                  std::span<const HertzContact<Real>> contacts);

    std::vector<Vector<Real>> offset_;    ///< by body, from where it was
    std::vector<Vector<Real>> velocity_;  ///< by body
    std::vector<State> states_;           ///< by contact
    std::vector<HertzTouch<Real>> touches_;
    Real lost_{};  ///< energy, in unloading
    std::uint64_t work_ = 0;
};

}  // namespace carom

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/laws/simultaneous_impact.h"

/// Impacts that last: balls that press on one another for a time, while others join in.
///
/// A contact is Hertz's spring: at the depth d it pushes with k d^1.5 while the balls approach, and
/// with e^2 of that while they part. So a pair alone parts at e times its approach, however fast
/// that was, and no contact ever pulls. Other balls join where their gaps close in the meantime.
/// The impact ends when nothing presses any more.
///
/// The time of an impact is short: within it bodies move uniformly but for these forces, normals
/// keep their directions, and the caller leaves the balls where they were. Momentum and angular
/// momentum are therefore those of pairs of opposite impulses along lines that both bodies share.
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

/// How long two bodies touch that meet elastically and alone. `mass`: the reduced mass,
/// 1 / (1/m_a + 1/m_b). Pre: all > 0. It falls with the speed's fifth root.
template <typename Real>
Real hertz_duration(const Real& stiffness, const Real& mass, const Real& speed);

/// Computes such impacts; keeps only its memory from one to the next.
///
/// Method: leapfrog, in steps of 1/128 of the shortest contact at the given speed, but not more
/// than 16,384 of the longest. What its error does to the energy is put right in the end: all
/// impulses are scaled by the one factor with which the bodies lose exactly what unloading has
/// lost. So energy never grows, and is kept to rounding where every restitution is 1. A bound on
/// the steps, which long chains do not reach, may end it early; energy is kept then too, and some
/// approach may be left.
template <typename Real>
class HertzImpact {
  public:
    /// The contacts that press, in the order in which they first touch. Changes no body: the caller
    /// applies the impulses. `speed` > 0: the approach with which it begins, for the steps. The
    /// result is valid until the next call.
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

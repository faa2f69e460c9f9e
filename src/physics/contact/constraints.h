#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/f64x2.h"
#include "physics/contact/classification.h"
#include "physics/contact/pairs.h"
#include "physics/world/contact.h"

namespace carom {

class ContactEnergy;

/// A constraint in a substep: what the iterations need, one after another in their order.
struct ContactConstraint {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t pair = 0;
    bool is_persistent = false;  ///< pressed in the last substep too
    bool has_pressed = false;    ///< in this substep, before it gave its impulse back
    /// It is solved together with the next constraint, with which it shares no body but the fixed
    /// one.
    bool has_neighbour = false;
    Vec2 normal;
    /// Positive: the speed at which the gap may close. Negative: the speed at which the overlap
    /// must open. Length/s.
    double target = 0.0;
    double mass = 0.0;  ///< of a rigid contact
    double impulse = 0.0;
    double tangential_impulse = 0.0;
    double friction = 0.0;
};

/// The constraints of the solver `contact`: sequential impulses with warm starting.
///
/// A substep solves them once from the bottom up (`begin`), with the softness that opens overlaps,
/// and relaxes them once from the top down (`relax`), which takes back the speed with which
/// overlaps opened. All below a pair with a high mass ratio is solved `loaded_iterations` times.
///
/// Excess impulses: an impulse that has stopped an impact is no load to start the next substep
/// from. Where the last impulses make the upper of two bodies leave the lower one faster than
/// `most_excess` rest speeds, they are taken back from the top down, each pair as if the lower body
/// were held (shock propagation). Otherwise half of the excess would come back with every pair.
/// Where one of two neighbours in the order gives something back, both solve their friction again:
/// without that, some deep heaps of unequal masses gain energy (torture_test.cpp).
///
/// Neighbours that share no body are solved two at a time, in the lanes of an SIMD register, with
/// the same bits as one after the other. Without that, a pile of 2,000 with friction costs a tenth
/// more.
class ContactConstraints {
  public:
    ContactConstraints(const ContactSubstep& step, ContactBodies& bodies, ContactPairs& pairs,
                       const ContactClassification& classification, ContactEnergy& energy)
        : step_(step),
          bodies_(bodies),
          pairs_(pairs),
          classification_(classification),
          energy_(energy) {}

    /// Warm start from the pairs' impulses, and the first iteration.
    void begin();
    /// One more iteration, for kinematic bodies that have changed their velocities.
    void solve(bool downwards);
    /// The last iteration; then the pairs have their impulses. `most_push`: the longest
    /// displacement that impulses gave in the substep. `had_impacts`: then a pair that is about to
    /// bounce is left alone.
    void relax(double most_push, bool had_impacts);

    /// A pair that presses for the first time is a contact too. Tells `kinematics` of those with
    /// kinematic bodies.
    void report_new(std::vector<Contact>& contacts, ContactKinematics& kinematics);

    /// In their order. Impulses may be scaled down before `relax`.
    std::span<ContactConstraint> all() { return constraints_; }

  private:
    template <bool spin>
    void begin_all();
    double holding_target(const ContactPair& pair) const;
    template <bool spin>
    void apply(const ContactConstraint& constraint);
    template <bool spin>
    void change_impulses(ContactConstraint& first, ContactConstraint& second, F64x2 impulse);
    template <bool spin>
    void solve(ContactConstraint& first, ContactConstraint& second);
    template <bool spin>
    void solve_all(bool downwards);
    template <bool spin>
    void relax(ContactConstraint& first, ContactConstraint& second);
    template <bool spin>
    void relax_all();
    double separating_speed(const ContactConstraint& constraint) const;
    F64x2 separating_speeds(const ContactConstraint& first, const ContactConstraint& second) const;
    template <typename Visit>
    void upwards_by_twos(Visit&& visit);
    template <typename Visit>
    void downwards_by_twos(Visit&& visit);
    bool is_about_to_bounce(const ContactConstraint& constraint) const;
    void find_loaded();
    void store_impulses();

    /// How fast the upper of two bodies leaves the lower one, and what changes that.
    struct Excess {
        double speed = 0.0;
        double inverse_mass = 0.0;
    };
    bool has_excess() const;
    Excess excess_of(const ContactConstraint& constraint, Vec2 up) const;
    std::optional<double> without_excess(const ContactConstraint& constraint, Vec2 up) const;
    bool share_body(const ContactConstraint& one, const ContactConstraint& other) const;
    template <bool spin>
    void take_back_excess();

    const ContactSubstep& step_;
    ContactBodies& bodies_;
    ContactPairs& pairs_;
    const ContactClassification& classification_;
    ContactEnergy& energy_;
    std::vector<ContactConstraint> constraints_;
    ContactConstraint nothing_;          // the neighbour of one that has none
    std::vector<std::uint32_t> new_;     // indices of constraints that did not press yet
    std::vector<std::uint32_t> loaded_;  // indices of constraints below a high mass ratio
    std::vector<std::uint8_t> is_loaded_;
    bool had_impacts_ = false;
};

}  // namespace carom

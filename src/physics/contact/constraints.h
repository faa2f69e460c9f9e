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
    /// The last iteration. `most_push`: the longest displacement that impulses gave in the substep.
    /// `had_impacts`: then a pair that is about to bounce is left alone.
    void relax(double most_push, bool had_impacts);

    /// A pair that presses for the first time is a contact too. Tells `kinematics` of those with
    /// kinematic bodies.
    void report_new(std::vector<Contact>& contacts, ContactKinematics& kinematics);

  private:
    template <bool spin>
    void begin_all();
    double holding_target(const ContactPair& pair, double given_back) const;
    template <bool spin>
    void apply(const ContactPair& pair);
    template <bool spin>
    void change_impulses(ContactPair& first, ContactPair& second, F64x2 impulse);
    template <bool spin>
    void solve(ContactPair& first, ContactPair& second);
    template <bool spin>
    void solve_all(bool downwards);
    template <bool spin>
    [[gnu::always_inline]] void relax(ContactPair& first, ContactPair& second, double most_more);
    template <bool spin>
    void relax_all(double most_more);
    double separating_speed(const ContactPair& pair) const;
    F64x2 separating_speeds(const ContactPair& first, const ContactPair& second) const;
    template <typename Visit>
    void upwards_by_twos(Visit&& visit);
    template <typename Visit>
    void downwards_by_twos(Visit&& visit);
    bool is_about_to_bounce(const ContactPair& pair) const;
    void find_loaded();

    /// How fast the upper of two bodies leaves the lower one, and what changes that.
    struct Excess {
        double speed = 0.0;
        double inverse_mass = 0.0;
    };
    bool has_excess() const;
    Excess excess_of(const ContactPair& pair, Vec2 up) const;
    std::optional<double> without_excess(const ContactPair& pair, Vec2 up) const;
    bool share_body(const ContactPair& one, const ContactPair& other) const;
    template <bool spin>
    void take_back_excess();

    const ContactSubstep& step_;
    ContactBodies& bodies_;
    ContactPairs& pairs_;
    const ContactClassification& classification_;
    ContactEnergy& energy_;
    ContactPair nothing_;             // the neighbour of one that has none
    std::vector<std::uint32_t> new_;  // pairs that did not press yet, in the order of constraints
    std::vector<std::uint32_t> loaded_;  // pairs below a high mass ratio, in the same order
    std::vector<std::uint8_t> is_loaded_;
    bool had_impacts_ = false;
};

}  // namespace carom

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/contact/kinematics.h"
#include "physics/contact/pairs.h"
#include "physics/world/terms.h"

namespace carom {

/// Decides what each pair of the solver `contact` is in a substep: a constraint, a candidate for
/// continuous collision, or idle.
///
/// The first rule that applies decides:
///   1. It cannot touch in the substep: idle.
///   2. Both bodies are kinematic: ccd if they approach, else idle.
///   3. The turn of a curve leads the ball against the next piece: ccd, however slow, since the
///      ball rolls on there (laws/curve.h).
///   4. It approaches and moves more than `most_travel` radii: ccd, unless it touches and a
///      kinematic body pushes it.
///   5. Its restitution is above 0 and it approaches at the rest speed or faster: ccd, unless
///        - it overlaps, and was a constraint or would not bounce without gravity's share of this
///          substep: else a ball that gravity accelerates in every substep would sink in
///        - it is enclosed: each of its balls has `enclosed_contacts` pressing contacts, its
///          restitution is above 0 and below 1, and gravity acts
///        - a kinematic body pushes the ball faster than it would bounce off.
///      Where the rest speed is 0: ccd if it approaches, else idle, unless a kinematic body pushes.
///   6. The ball is not on the solid side of a one-way edge, or too far through it: idle.
///   7. Otherwise: a constraint.
class ContactClassification {
  public:
    ContactClassification(const ContactSubstep& step, ContactBodies& bodies, ContactPairs& pairs,
                          const ContactKinematics& kinematics)
        : step_(step), bodies_(bodies), pairs_(pairs), kinematics_(kinematics) {}

    /// Counts the pressing contacts of each ball at the end of the last substep. `is_reloaded`: the
    /// pairs are not those of the last `classify`.
    void count_contacts(bool is_reloaded);
    /// Measures all pairs and sets their states. What is no constraint forgets its impulses.
    void classify(const World& world);

    /// Indices of the pairs, in their order.
    std::span<const std::uint32_t> constraints() const { return constraints_; }
    std::span<const std::uint32_t> ccd() const { return ccd_; }
    /// Constraints with seesaws (hinges.h), which are not among `constraints`.
    std::span<const std::uint32_t> hinged() const { return hinged_; }
    /// Smallest separation of the constraints, 0 at most.
    double deepest() const { return deepest_; }

    /// Whether the two have no room to bounce.
    bool is_enclosed(const ContactPair& pair) const;

  private:
    template <Terms terms>
    void classify_all(const World& world);
    template <Terms terms>
    void measure(const World& world, ContactPair& pair);
    void hinge(ContactPair& pair) const;
    template <Terms terms>
    ContactState state_of(const World& world, const ContactPair& pair) const;
    bool is_fast(const ContactPair& pair, Vec2 relative) const;
    bool is_led_by_curve(const World& world, const ContactPair& pair, double approach) const;
    bool is_pushed(const World& world, const ContactPair& pair, double approach) const;

    const ContactSubstep& step_;
    ContactBodies& bodies_;
    ContactPairs& pairs_;
    const ContactKinematics& kinematics_;
    std::vector<std::uint32_t> constraints_;
    std::vector<std::uint32_t> ccd_;
    std::vector<std::uint32_t> hinged_;
    std::vector<std::uint8_t> contacts_on_;  // by body, counted up to enclosed_contacts; or empty
    double deepest_ = 0.0;
    double closing_gap_ = 0.0;
    double slowest_fast_square_ = 0.0;  // no slower pair of any size is fast, length^2/s^2
};

/// Restitution of the pair at this speed of approach.
double restitution_of(const World& world, const ContactBodies& bodies, const ContactPair& pair,
                      double approach);

/// A gap that constraints may close for other pairs in a substep, length.
double closing_gap(const ContactBodies& bodies);

}  // namespace carom

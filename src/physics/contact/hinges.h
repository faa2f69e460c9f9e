#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/contact/classification.h"
#include "physics/contact/kinematics.h"
#include "physics/contact/pairs.h"
#include "physics/world/contact.h"

namespace carom {

class ContactPaths;

/// The constraints of the solver `contact` between balls and seesaws, and between seesaws and their
/// stops: sequential impulses with warm starting, by the effective mass of laws/hinge.h. They have
/// the softness of the other constraints (constraints.h), and their own iterations, since the balls
/// on a plank feel one another through it.
///
/// A stop with a restitution takes only a seesaw that it would hardly bounce off, or that balls
/// press on it: else the seesaw comes to the stop at its time (ContactImpacts). A light plank under
/// a ball takes on the ball's speed, so it would bounce in every substep, and carry nothing
/// meanwhile.
///
/// Cost: nothing where there are no seesaws.
class ContactHinges {
  public:
    ContactHinges(const ContactSubstep& step, ContactBodies& bodies, ContactPairs& pairs,
                  ContactKinematics& kinematics, const ContactClassification& classification)
        : step_(step),
          bodies_(bodies),
          pairs_(pairs),
          kinematics_(kinematics),
          classification_(classification) {}

    /// Warm start from the pairs' impulses, and the first iterations.
    void begin();
    /// A pair that presses for the first time is a contact too.
    void report_new(std::vector<Contact>& contacts);
    /// Takes back from the seesaws what balls that have left their paths have not felt.
    void give_back(const ContactPaths& paths);
    /// The last iterations; then the pairs have their impulses. Pre: balls and seesaws are where
    /// they are at the end of the substep.
    void relax();
    /// Energy that seesaws have lost to balls through constraints in the substep.
    double given() const { return given_; }

  private:
    struct Constraint {
        std::uint32_t a = 0;
        std::uint32_t pair = 0;
        std::uint32_t edge = 0;  ///< index into ContactKinematics::edges
        Vec2 normal;
        double lever = 0.0;       ///< of the normal, length
        double side_lever = 0.0;  ///< of perpendicular(normal)
        double target = 0.0;      ///< as that of a ContactConstraint, length/s
        double mass = 0.0;
        double side_mass = 0.0;
        double impulse = 0.0;
        double tangential_impulse = 0.0;
    };
    struct Stop {
        std::uint32_t edge = 0;
        double direction = 1.0;  ///< in which it stops the seesaw
        double room = 0.0;       ///< rad/s: at this rate the seesaw reaches it with the substep
        double impulse = 0.0;    ///< angular
    };

    HeldEdge& edge_of(std::uint32_t edge) { return kinematics_.edges()[edge]; }
    void list();
    void list_stops();
    bool is_pressed(std::uint32_t edge, double direction) const;
    double energy_of_seesaws();
    void push(const Constraint& constraint, double impulse, double tangential);
    void solve(Constraint& constraint, bool is_soft);
    void solve_stops();

    const ContactSubstep& step_;
    ContactBodies& bodies_;
    ContactPairs& pairs_;
    ContactKinematics& kinematics_;
    const ContactClassification& classification_;
    std::vector<Constraint> constraints_;
    std::vector<Stop> stops_;
    double given_ = 0.0;
};

}  // namespace carom

#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/contact/constraints.h"
#include "physics/contact/press_groups.h"
#include "physics/contact/tolerances.h"

namespace carom {

/// Limits the energy of the constraints of the solver `contact`: they give back no more than they
/// took, plus at most `most_owed` of the energy of all balls.
///
/// Constraints are damped springs. The energy that they take out of the balls in a substep goes
/// into a *store*, one for the whole world. The store holds at most what springs compressed like
/// this would hold, and at most `most_stored` of the energy of all balls; the rest is lost. The
/// energy that constraints give, by lifting overlapping bodies or by iterations that have not
/// converged, comes out of the store. Below 0, the store says what they *owe*. If they owe more
/// than the limit, the excess is taken back at the end of the substep: each group of balls
/// (press_groups.h) that has gained energy moves less far, and more slowly; one that nothing
/// supports only moves more slowly. Embedded balls keep what they have moved to the side, which
/// costs no energy. While they owe more than the limit, constraints hold their load, but open no
/// overlaps except deep ones. So a heap keeps its overlaps while the store has no energy to open
/// them.
///
/// An impact may carry off what constraints have given in the same substep, to a ball that presses
/// on nothing. What the groups cannot give back comes out of the speed that such balls have gained.
///
/// Impacts, kicks, kinematic bodies and seesaws are not limited. A group that a kinematic body or a
/// seesaw carries is not moved back, nor is one that would be moved into a fast ball; so the store
/// may stay below the limit until later losses refill it.
class ContactEnergy {
  public:
    ContactEnergy(const ContactSubstep& step, ContactBodies& bodies, ContactPairs& pairs)
        : step_(step), bodies_(bodies), groups_(step, bodies, pairs) {}

    /// `stored`: what the last tick left in the world; below 0: what constraints owe.
    void begin_tick(double stored) {
        stored_ = stored;
        energy_.reset();
    }
    double stored() const { return stored_; }

    /// Whether constraints may open overlaps in this substep. Otherwise they only hold their load.
    bool may_open();
    /// The order of the bodies has changed.
    void forget_groups() { groups_.forget(); }
    /// `springs`: the energy that the springs hold at most, as they are compressed now.
    void begin_substep(double springs) { stored_ = std::min(stored_, springs); }
    /// Takes back what the constraints have given beyond the store. `impacts`: balls that have
    /// collided with one another in the substep. `given`: the energy that impacts and kinematic
    /// bodies gave. Pre: velocities, positions and displacements are those of the end of the
    /// substep.
    void end_substep(std::span<const std::uint32_t> constraints, std::span<const BodyPair> impacts,
                     double given);

  private:
    /// What the balls of a group lose.
    struct Reduction {
        double part = 0.0;         ///< of its gain
        double kept = 1.0;         ///< of the velocity relative to `centre`
        Vec2 centre;               ///< velocity that it keeps
        bool goes_back = false;    ///< `part` of the displacements, too
        bool is_embedded = false;  ///< they go back by their heights alone
    };

    /// By how much constraints owe more than they may.
    double excess() const { return -contact_tolerance::most_owed * *energy_ - stored_; }
    double energy_of_balls() const;
    template <bool spin>
    double gain_of_balls() const;
    double take_from_hit(std::span<const BodyPair> impacts, double excess);
    double take_back(double excess);
    Reduction reduction_of(const PressGroup& group, double share) const;
    double reduce(std::uint32_t ball, const Reduction& reduction);

    const ContactSubstep& step_;
    ContactBodies& bodies_;
    double stored_ = 0.0;
    std::optional<double> energy_{};  // of all balls, found once a tick, when it is first needed
    PressGroups groups_;
    std::vector<Reduction> reductions_;  // by group
    std::vector<std::uint32_t> hit_;  // balls hit by groups that they do not belong to, ascending
};

}  // namespace carom

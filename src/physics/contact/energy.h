#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/contact/constraints.h"

namespace carom {

/// The energy of the constraints of the solver `contact`: they give back no more than they took.
///
/// Constraints are damped springs. What they take out of the balls' energy in a substep is
/// *stored*, up to what springs that are compressed like this hold, and up to `most_stored` of the
/// energy of all balls; the rest is lost. What they give, by lifting what overlaps or by iterations
/// that have not converged, comes out of the store. What they have given beyond it is taken back at
/// the end of the substep: each group of balls that press on one another and have gained goes less
/// far, and is slower. So a heap that nothing pays for stays as deep as it is.
///
/// Kinetic and potential energy and the store together never rise, but for what impacts, kicks and
/// kinematic bodies give. A ball that is carried by a kinematic body is not put back, so there the
/// store may owe, until later losses have paid.
class ContactEnergy {
  public:
    ContactEnergy(const ContactSubstep& step, ContactBodies& bodies, const ContactPairs& pairs)
        : step_(step), bodies_(bodies), pairs_(pairs) {}

    /// What is stored in the world; below 0 where more has been given than taken.
    void begin_tick(double stored) { stored_ = stored; }
    double stored() const { return stored_; }

    /// `springs`: the energy that the springs hold at most, as they are compressed now.
    void begin_substep(double springs) { stored_ = std::min(stored_, springs); }
    /// Takes back what the constraints have given beyond the store. `given`: by impacts and
    /// kinematic bodies. Pre: velocities, positions and displacements are those of the end.
    void end_substep(std::span<const ContactConstraint> constraints, double given);

  private:
    /// Balls that press on one another.
    struct Group {
        double gain = 0.0;  ///< of energy in the substep
        double lift = 0.0;  ///< of potential energy
        double kinetic = 0.0;
        double mass = 0.0;
        Vec2 momentum;
        bool is_supported = false;  ///< by a body that they cannot move
        bool is_carried = false;    ///< by a kinematic body
    };

    double squares_of(Vec2 velocity, double surface_speed) const;
    double kinetic_energy_of(std::uint32_t body) const;
    double gain_of(std::uint32_t body) const;
    std::uint32_t group_of(std::uint32_t body);
    void find_groups(std::span<const ContactConstraint> constraints);
    double take_back(double excess);
    double take_back(std::uint32_t body, const Group& group, double share);

    const ContactSubstep& step_;
    ContactBodies& bodies_;
    const ContactPairs& pairs_;
    double stored_ = 0.0;
    // Scratch of taking back.
    std::vector<std::uint32_t> parent_;  // by ball: another one of its group, or itself
    std::vector<Group> groups_;          // by the ball that is its own parent
};

}  // namespace carom

#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/contact/constraints.h"
#include "physics/contact/tolerances.h"

namespace carom {

/// Limits the energy of the constraints of the solver `contact`: they give back no more than they
/// took, plus at most `most_owed` of the energy of all balls.
///
/// Constraints are damped springs. The energy that they take out of the balls in a substep goes
/// into a *store*. The store holds at most what springs compressed like this would hold, and at
/// most `most_stored` of the energy of all balls; the rest is lost. The energy that constraints
/// give, by lifting overlapping bodies or by iterations that have not converged, comes out of the
/// store. If they give more than the limit allows, the excess is taken back at the end of the
/// substep: each group of balls that press on one another and have gained energy moves less far,
/// and more slowly; one that nothing supports only moves more slowly. Embedded balls keep what they
/// have moved to the side, which costs no energy. So a heap keeps its overlaps while the store has
/// no energy to open them.
///
/// An impact may carry off what constraints have given in the same substep, to a ball that presses
/// on nothing. What the groups cannot give back comes out of the speed that such balls have gained.
///
/// Impacts, kicks, kinematic bodies and seesaws are not limited. A group that one of these bodies
/// carries is not moved back, nor is one that would be moved into a ball that has followed it; so
/// there the store may fall below the limit until later losses refill it.
class ContactEnergy {
  public:
    ContactEnergy(const ContactSubstep& step, ContactBodies& bodies, const ContactPairs& pairs)
        : step_(step), bodies_(bodies), pairs_(pairs) {}

    /// What is stored in the world; below 0 where more has been given than taken.
    void begin_tick(double stored) {
        stored_ = stored;
        energy_.reset();
    }
    double stored() const { return stored_; }

    /// `springs`: the energy that the springs hold at most, as they are compressed now.
    void begin_substep(double springs) { stored_ = std::min(stored_, springs); }
    /// Takes back what the constraints have given beyond the store. `impacts`: balls that have
    /// collided with one another in the substep. `given`: the energy that impacts and kinematic
    /// bodies gave. Pre: velocities, positions and displacements are those of the end of the
    /// substep.
    void end_substep(std::span<const ContactConstraint> constraints,
                     std::span<const BodyPair> impacts, double given);

  private:
    /// Balls that press on one another.
    struct Group {
        double gain = 0.0;  ///< of energy in the substep
        double lift = 0.0;  ///< of potential energy
        double kinetic = 0.0;
        double mass = 0.0;
        Vec2 momentum;
        bool is_pressed = false;    ///< by a constraint
        bool is_supported = false;  ///< by a body that they cannot move
        bool stays = false;         ///< it may not be moved back
        bool is_embedded = false;   ///< has balls that are embedded

        bool may_go_back() const { return is_supported && !stays; }
    };

    double excess() const { return -contact_tolerance::most_owed * *energy_ - stored_; }
    double energy_of_balls() const;
    template <bool spin>
    double gain_of_balls() const;
    double squares_of(Vec2 velocity, double surface_speed) const;
    double kinetic_energy_of(std::uint32_t body) const;
    double gain_of(std::uint32_t body) const;
    std::uint32_t root_of(std::uint32_t body);
    void find_groups(std::span<const ContactConstraint> constraints);
    bool have_room(const ContactPair& pair);
    void find_staying();
    double take_from_hit(std::span<const BodyPair> impacts, double excess);
    double take_back(double excess);
    double take_back(std::uint32_t body, const Group& group, double share);

    const ContactSubstep& step_;
    ContactBodies& bodies_;
    const ContactPairs& pairs_;
    double stored_ = 0.0;
    std::optional<double> energy_{};  // of all balls, counted once a tick where they touch
    // Scratch of taking back.
    std::vector<std::uint32_t> parent_;  // by ball: its group, once groups are found
    std::vector<Group> groups_;          // by the ball that is its own parent
    std::vector<std::uint32_t> hit_;  // balls hit by groups that they do not belong to, ascending
};

}  // namespace carom

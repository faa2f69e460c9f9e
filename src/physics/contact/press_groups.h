#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/contact/constraints.h"
#include "physics/contact/pairs.h"

namespace carom {

/// The kinetic energy of a ball that is not kinematic, with that of its spin.
double kinetic_energy_of(const ContactSubstep& step, const ContactBodies& bodies,
                         std::uint32_t ball);
/// The kinetic and potential energy that the ball has gained in the substep.
double gain_of(const ContactSubstep& step, const ContactBodies& bodies, std::uint32_t ball);

/// Balls that press on one another, and all that goes back with them.
struct PressGroup {
    double gain = 0.0;     ///< of energy in the substep; of groups that are pressed
    double lift = 0.0;     ///< of potential energy in the substep
    double kinetic = 0.0;  ///< energy at the end of the substep
    double mass = 0.0;
    Vec2 momentum;
    std::uint32_t joined = 0;   ///< index of the group that it has joined; its own if none
    bool is_pressed = false;    ///< by a constraint, before others joined it
    bool is_supported = false;  ///< by a body that they cannot move
    bool stays = false;         ///< a kinematic body carries it, or a fast ball is in its way
    bool is_embedded = false;   ///< has balls that are embedded

    bool may_go_back() const { return is_supported && !stays; }
    /// Whether its balls return on the way that they came.
    bool goes_back() const { return gain > 0.0 && lift > 0.0 && may_go_back(); }
    void join(const PressGroup& other);
};

/// The groups of balls in a substep of the solver `contact`.
class PressGroups {
  public:
    PressGroups(const ContactSubstep& step, const ContactBodies& bodies, ContactPairs& pairs)
        : step_(step), bodies_(bodies), pairs_(pairs) {}

    /// The next `find` looks for the groups anew. To be called whenever the order of the bodies has
    /// changed, and at the start of a tick.
    void forget() { found_.clear(); }
    /// Balls that touch are of one group, until they are forgotten. A ball that touches nothing is
    /// one by itself.
    void find(std::span<const ContactConstraint> constraints);
    /// Groups of which one can go back only with the other become one: until each may go back by
    /// its displacements without a ball entering one that has followed it into the room that it
    /// left, deeper than it is in there. Where such a ball is fast, both groups stay.
    void join_followers();

    /// In the order of their first balls. Those that have joined another one no longer count.
    std::span<const PressGroup> all() const { return groups_; }
    /// The group of a ball that is not kinematic, with all that has joined it.
    std::uint32_t index_of(std::uint32_t ball) const { return root_of(group_[ball]); }
    const PressGroup& of(std::uint32_t ball) const { return groups_[index_of(ball)]; }
    /// Whether a constraint presses its group, before others joined it.
    bool is_pressed(std::uint32_t ball) const { return groups_[group_[ball]].is_pressed; }
    bool are_together(std::uint32_t a, std::uint32_t b) const { return group_[a] == group_[b]; }
    /// Of all groups that have gained.
    double gains() const;

  private:
    enum class State : std::uint8_t { free, pressed_by_ball, kinematic };

    std::uint32_t root_of(std::uint32_t group) const {
        while (groups_[group].joined != group)
            group = groups_[group].joined;
        return group;
    }
    bool is_free_ball(std::uint32_t body) const {
        return bodies_.is_ball(body) && state_[body] != State::kinematic;
    }
    std::uint32_t first_of(std::uint32_t ball);
    void join_balls(std::span<const ContactConstraint> constraints);
    void number_groups();
    void mark(std::span<const ContactConstraint> constraints);
    void mark_hinged();
    void sum_up();
    std::uint32_t largest() const;
    bool is_slow(std::uint32_t ball) const;
    bool have_room(const ContactPair& pair) const;

    const ContactSubstep& step_;
    const ContactBodies& bodies_;
    ContactPairs& pairs_;
    std::vector<std::uint32_t> earlier_;  // by ball: an earlier ball of its group, or itself
    std::vector<std::uint32_t> group_;    // by ball: index of its group
    std::vector<State> state_;            // by ball
    std::vector<std::uint32_t> others_;   // indices of constraints that `mark` looks at
    std::vector<PressGroup> found_;       // nothing summed up or joined
    std::vector<PressGroup> groups_;
};

}  // namespace carom

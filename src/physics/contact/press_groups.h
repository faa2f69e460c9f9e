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

/// Balls that touch, and the groups that go back with them.
struct PressGroup {
    double gain = 0.0;     ///< of energy in the substep, by balls of groups that are pressed
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
    /// Whether the displacements of its balls are to be taken back.
    bool goes_back() const { return gain > 0.0 && lift > 0.0 && may_go_back(); }
    void join(const PressGroup& other);
};

/// Groups of balls that touch, in the solver `contact`.
///
/// The first `find` of a tick finds them from the constraints of its substep: balls that overlap,
/// or have pressed on one another, even if they no longer do when it ends. They last for the
/// rest of the tick, though contacts change, since finding them costs a pass over all constraints;
/// their sums, and which have joined, are those of the present substep. Indices are those of
/// bodies, so a new order of bodies ends the groups.
class PressGroups {
  public:
    PressGroups(const ContactSubstep& step, const ContactBodies& bodies, ContactPairs& pairs)
        : step_(step), bodies_(bodies), pairs_(pairs) {}

    /// The next `find` finds the groups anew. To be called at the start of a tick, and whenever the
    /// order of the bodies has changed.
    void forget() { found_.clear(); }
    /// Finds the groups, unless they are known, and sums up what they have in this substep. A ball
    /// that touches nothing is a group by itself.
    void find(std::span<const std::uint32_t> constraints);
    /// Joins groups until each can go back without a ball of it going deeper into a ball of another
    /// group, which has followed it into the room that it left. Two such groups go back together,
    /// or neither does if one of the two balls is fast.
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
    void join_balls(std::span<const std::uint32_t> constraints);
    void number_groups();
    void mark();
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
    std::vector<PressGroup> found_;       // nothing summed up or joined; empty: to be found
    std::vector<PressGroup> groups_;      // of this substep
};

}  // namespace carom

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/contact/pairs.h"
#include "physics/tick/kinematic.h"
#include "physics/world/contact.h"

namespace carom {

/// A ball that a player holds, in a substep.
struct ContactHeldBall {
    std::uint32_t body = 0;
    std::uint32_t held = 0;  ///< index into World::held_balls
    Vec2 velocity;           ///< towards its target
    double share = 1.0;      ///< of `velocity`, at which it moves
};

/// The kinematic bodies of the solver `contact`: how far held balls and edges move in a substep,
/// and what holds them back.
///
/// Rule: a kinematic body enters a ball by at most `kinematic_overlap` of the ball's radius, and
/// goes no further until the ball gives way. A body that was held back does not catch up: for the
/// rest of the tick, each substep gives it the velocity that would cover the rest of its
/// displacement in a whole tick.
class ContactKinematics {
  public:
    /// Lists the kinematic bodies of the world, and makes held balls immovable. Pre: `bodies` are
    /// loaded.
    void load(const World& world, ContactBodies& bodies);
    void begin_tick() {
        was_held_back_.clear();
        pressing_.clear();
    }
    /// Gives each the velocity that covers `share_of_displacement` of the rest of its displacement
    /// in this substep, unless it was held back.
    void begin_substep(const World& world, const ContactSubstep& step, const ContactBodies& bodies,
                       double share_of_displacement);
    /// Writes these velocities of held balls to the bodies, at the start of the substep.
    void set_velocities(ContactBodies& bodies) const;
    void set_displacements(ContactBodies& bodies, const ContactSubstep& step) const;
    /// Moves the edges in the world.
    void end_substep(World& world, const ContactSubstep& step);
    void stop_held_balls(World& world, const ContactBodies& bodies) const;

    bool is_empty() const { return balls_.empty() && edges_.empty(); }
    std::span<const HeldEdge> edges() const { return edges_; }
    /// Calls visit(body) for each held ball.
    template <typename Visit>
    void for_each_held_ball(Visit&& visit) const {
        for (const ContactHeldBall& ball : balls_)
            visit(ball.body);
    }
    const HeldEdge& edge_of(const ContactPair& pair) const {
        return *find_edge(std::span<const HeldEdge>(edges_), pair.edge);
    }
    std::span<HeldEdge> edges() { return edges_; }
    HeldEdge& edge_of(const ContactPair& pair) {
        return *find_edge(std::span<HeldEdge>(edges_), pair.edge);
    }

    /// Shortens the displacement of every kinematic body that would enter a ball too far, but for
    /// edges at CCD contacts, whose impacts move the ball away. Returns whether there was one.
    bool hold_back(const ContactPairs& pairs, ContactBodies& bodies, const ContactSubstep& step);

    /// Limits the speed of jammed balls (those that a kinematic body presses on but cannot move,
    /// and all balls in touch with one) to the speed at which they moved in the substep. Otherwise
    /// they would keep the speed of a body whose target is far away. Here bodies touch if their gap
    /// at the start of the substep was at most `kinematic_overlap` of the smaller radius.
    void settle_jams(ContactPairs& pairs, ContactBodies& bodies, const ContactSubstep& step);

    /// The contact of a new constraint, which `ContactConstraints::report_new` has reported.
    void note_reported(const ContactPair& pair, const Contact& contact) {
        if (!pair.is_kinematic || pair.is_hinged) return;
        pressing_.push_back(contact);
        pressing_.back().impulse = -contact.impulse;
    }
    /// Adds what the constraints of the substep gave. Pre: the pairs have their impulses.
    void note_pressing(const ContactPairs& pairs, const ContactBodies& bodies,
                       const ContactSubstep& step);
    /// ContactSolver::pressing.
    std::span<const Contact> pressing() const { return pressing_; }

    /// The work that kinematic bodies have done on balls through constraints in the substep.
    double work(const ContactPairs& pairs, const ContactBodies& bodies) const;

  private:
    std::size_t index_of_pair(const ContactPair& pair, const ContactBodies& bodies) const;
    double& share_of(std::size_t index) {
        return index < balls_.size() ? balls_[index].share : edges_[index - balls_.size()].share;
    }

    std::vector<ContactHeldBall> balls_;
    std::vector<HeldEdge> edges_;
    // By ball, then by edge.
    std::vector<std::uint8_t> was_held_back_;  // in this tick
    std::vector<double> shortened_;            // to this share, in this round of holding back
    std::vector<Contact> pressing_;
    // Scratch of settle_jams.
    std::vector<std::uint32_t> jammed_;
    std::vector<std::uint8_t> is_jammed_;
};

}  // namespace carom

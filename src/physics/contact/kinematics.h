#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/contact/pairs.h"
#include "physics/tick/kinematic.h"

namespace carom {

/// A ball that a player holds, in a substep.
struct ContactHeldBall {
    std::uint32_t body = 0;
    std::uint32_t held = 0;  ///< index into World::held_balls
    Vec2 velocity;           ///< towards its target
    double share = 1.0;      ///< of this that it goes at
};

/// The kinematic bodies of the solver `contact`: how far held balls and edges go in a substep, and
/// what holds them back.
///
/// Rule: a kinematic body goes no further into a ball than `kinematic_overlap` of its radius.
/// Beyond that it waits for the ball. One that was held back does not catch up: in each substep for
/// the rest of the tick it is aimed to cover its remaining way in a whole tick.
class ContactKinematics {
  public:
    /// Lists them; held balls become immovable bodies. Pre: `bodies` are loaded.
    void load(const World& world, ContactBodies& bodies);
    void begin_tick() { was_held_back_.clear(); }
    /// Aims each at its target: it is to cover `share_of_way` of its remaining way in this substep.
    void begin_substep(const World& world, const ContactSubstep& step, const ContactBodies& bodies,
                       double share_of_way);
    /// Gives held balls the velocity that they are aimed at, at the start of the substep.
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
    HeldEdge& edge_of(const ContactPair& pair) {
        return *find_edge(std::span<HeldEdge>(edges_), pair.edge);
    }

    /// Shortens the way of every kinematic body that would go too far into a ball. Whether one had
    /// to be.
    bool hold_back(const ContactPairs& pairs, ContactBodies& bodies, const ContactSubstep& step);

    /// Balls that a kinematic body presses on without being able to move them, and all that touch
    /// such balls, keep at most the speed at which they moved in the substep. Otherwise they would
    /// keep that of a body whose target is far away. Here bodies touch if their gap at the start of
    /// the substep was at most `kinematic_overlap` of the smaller radius.
    void settle_jams(ContactPairs& pairs, ContactBodies& bodies, const ContactSubstep& step);

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
    // Scratch of settle_jams.
    std::vector<std::uint32_t> jammed_;
    std::vector<std::uint8_t> is_jammed_;
};

}  // namespace carom

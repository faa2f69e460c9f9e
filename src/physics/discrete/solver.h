#pragma once

#include <span>
#include <vector>

#include "physics/broad_phase/neighbour_list.h"
#include "physics/laws/cloth.h"
#include "physics/laws/free_motion.h"
#include "physics/tick/cancellation.h"
#include "physics/world/contact.h"
#include "physics/world/terms.h"

/// The solvers `discrete` and `substep`: move, push overlaps apart, exchange momentum.
///
/// A tick is cut into `updates`, an update into at most `steps`. In a step every ball that has time
/// left moves for all of it. Then the balls that overlap are parted, each pair once, in the order
/// of their numbers, by half of the depth each (a held ball does not give way); then the balls that
/// overlap edges are pushed out of them. A ball whose way was cut short keeps the rest of its time
/// for the next step, time spent = time * distance covered / distance intended, and gives gravity
/// back what it took for that rest. Momentum is exchanged when all overlaps are parted, along the
/// normals as they are then, and only by pairs that approach; friction follows each exchange, with
/// its impulse. `discrete` is one update of one step.
///
/// Which balls overlap is settled when all have moved and before any is pushed; which overlap edges
/// when the balls are parted. So the result is a matter of positions and numbers, not of cells.
///
/// Fails by nature: what moves further than its size in a step passes through what is thin or
/// small; a row of touching balls is parted only pair by pair; under gravity pushing apart changes
/// the potential energy, so a heap jitters.
namespace carom {

class OverlapSolver {
  public:
    /// Moves everything by one tick and appends the exchanges to `contacts`. `touched`: see
    /// surroundings.h. Where `patience` ends, which is asked between two steps, the world stays as
    /// the last step left it.
    void tick(World& world, int updates, int steps, std::vector<Contact>& contacts,
              std::vector<std::uint8_t>& touched, Patience& patience);

    /// Those of the smallest balls.
    const CellFrame& cells() const { return neighbours_.grid().finest(); }

  private:
    // The way out for two bodies with the same centre: any way will do, but always the same.
    static constexpr Vec2 when_coincident{1.0, 0.0};

    struct Pair {
        std::uint32_t ball = 0;
        std::uint32_t other = 0;
        ContactKind kind = ContactKind::ball_ball;
        Vec2 shift;  // of the capsule's image
    };

    // A ball that was pushed in this step: where the step began for it, and the length of the way
    // that it would have gone.
    struct Pushed {
        std::uint32_t ball = 0;
        double intended = 0.0;
        Vec2 origin;
    };

    struct HandWay {
        Vec2 start;  // velocities of the ends
        Vec2 end;
    };

    template <Terms terms>
    void update(World& world, int updates, int steps, double end_time,
                std::vector<Contact>& contacts, Patience& patience);
    template <Terms terms, bool forced>
    Vec2 move(World& world, std::uint32_t ball, const Flight& flight);
    Vec2 move_on_cloth(World& world, std::uint32_t ball, double duration);
    // Returns the longest way that a ball has gone; 0 where nobody asks.
    template <Terms terms, bool forced>
    double move_all(World& world);
    void look(const World& world, double way);
    bool still_cover(const World& world, double way);
    template <Terms terms, bool forced>
    void move_active(World& world);
    void part_bodies(World& world);
    template <Terms terms>
    void part_active(World& world);
    template <Terms terms>
    bool are_near(const World& world, const BallPair& pair) const;
    template <Terms terms>
    void part_overlapping(World& world, std::span<const BallPair> pairs);
    template <Terms terms>
    void part(World& world, std::uint32_t i, std::uint32_t j);
    template <Terms terms>
    void push_out_of_edges(World& world);
    bool knows_edges(const World& world, const Pushed& pushed) const;
    template <Terms terms>
    void push_out_of_edge(World& world, const EdgePair& pair);
    Vec2 way_of(const World& world, std::uint32_t ball) const;
    void note_push(const World& world, std::uint32_t ball);
    void exchange_momentum(World& world, double time, std::vector<Contact>& contacts);
    template <Terms terms>
    void bounce_pairs(World& world, double time, std::vector<Contact>& contacts);
    void keep_time(World& world);
    void end_step(const World& world);
    void move_hands(World& world, double share);
    bool is_driven(const World& world, std::uint32_t capsule) const;
    Vec2 hand_velocity(const World& world, std::uint32_t capsule, Vec2 point) const;

    Neighbours neighbours_;
    double margin_ = 0.0;
    double widest_ = 0.0;                // no two that are further apart overlap
    bool are_alike_ = false;             // all radii are the same: all that are nearer overlap
    bool looks_around_ = false;          // steps share a look
    bool keeps_time_ = false;            // there is more than one step
    bool is_first_step_ = false;         // every ball is active
    bool keeps_ways_ = false;            // a way is not just the velocity times its time
    bool has_asked_all_ = false;         // in this tick, where they are
    bool has_strayed_ = false;           // a ball went further than the neighbours cover
    double duration_ = 0.0;              // of an update, s
    double hands_way_ = 0.0;             // longest way of a held ball in this update
    std::vector<std::uint32_t> active_;  // empty in the first step
    std::vector<std::uint8_t> is_active_;
    std::vector<std::uint8_t> is_pushed_;
    std::vector<double> left_;              // s of the update, by ball; of the active ones
    std::vector<Vec2> way_;                 // in this step, by ball; where keeps_ways_
    std::span<const double> inverse_mass_;  // 0 where a hand holds the ball
    std::vector<double> with_held_balls_;
    std::vector<ClothState<double>> before_;  // the step, on cloth
    std::vector<HandWay> hands_;              // by World::held_capsules
    std::vector<BallPair> near_active_;
    std::vector<BallPair> overlapping_;
    PairOrder order_;
    std::vector<EdgePair> at_edge_;
    std::vector<Pair> pairs_;
    std::vector<Pushed> pushed_;
};

}  // namespace carom

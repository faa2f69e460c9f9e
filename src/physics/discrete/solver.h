#pragma once

#include <span>
#include <vector>

#include "physics/broad_phase/neighbour_list.h"
#include "physics/laws/cloth.h"
#include "physics/laws/free_motion.h"
#include "physics/tick/cancellation.h"
#include "physics/tick/kinematic.h"
#include "physics/world/contact.h"
#include "physics/world/terms.h"

/// The solvers `discrete` and `substep`: move, separate overlaps, exchange momentum.
///
///     for each of `updates` updates of a tick:
///         all balls are active, with the whole update as their time
///         for at most `steps` steps, while any ball is active:
///             each active ball moves for all of its time
///             overlapping balls are separated, each pair once, by half of the depth each
///             balls are pushed out of edges
///             a ball whose way was cut short keeps the rest of its time, and is active again
///             pairs that overlapped and approach exchange momentum, then friction
///
/// Time spent = time * distance covered / distance intended; a ball gives gravity back what it took
/// for the rest. Pairs go by the numbers of their balls, and a held ball does not give way.
/// `discrete` is one update of one step.
///
/// Which balls overlap is decided when all have moved and before any is pushed, and which overlap
/// edges when the balls are separated. So the result depends on positions and numbers, not on
/// cells.
///
/// Fails by nature: what moves further than its size in a step passes through what is thin or
/// small; a row of touching balls is separated only pair by pair; under gravity, separating changes
/// the potential energy, so a pile jitters.
namespace carom {

class OverlapSolver {
  public:
    /// Moves everything by one tick, appends the exchanges to `contacts`, and sets `touched` for
    /// each ball that meets something. `patience` is asked between two steps; once it is out, the
    /// world stays as the last step left it.
    void tick(World& world, int updates, int steps, std::vector<Contact>& contacts,
              std::vector<std::uint8_t>& touched, Patience& patience);

    /// The cells of the smallest balls.
    const CellFrame& cells() const { return neighbours_.grid().finest(); }

  private:
    // The normal of two bodies with the same centre: any will do, but always the same.
    static constexpr Vec2 when_coincident{1.0, 0.0};

    struct Pair {
        std::uint32_t ball = 0;
        std::uint32_t other = 0;
        ContactKind kind = ContactKind::ball_ball;
        Vec2 shift;  // of the capsule's image
    };

    // A ball that was pushed in this step: where the step began for it, and the length of the
    // displacement that it would have had.
    struct Pushed {
        std::uint32_t ball = 0;
        double intended = 0.0;
        Vec2 origin;
    };

    template <Terms terms>
    void update(World& world, int updates, int steps, double end_time,
                std::vector<Contact>& contacts, Patience& patience);
    template <Terms terms, bool forced>
    Vec2 move(World& world, std::uint32_t ball, const Flight& flight);
    Vec2 move_on_cloth(World& world, std::uint32_t ball, double duration);
    // Returns the longest displacement of a ball; 0 where it is not needed.
    template <Terms terms, bool forced>
    double move_all(World& world);
    void find_neighbours(const World& world, double way);
    bool neighbours_are_valid(const World& world, double way);
    template <Terms terms, bool forced>
    void move_active(World& world);
    void separate_bodies(World& world);
    template <Terms terms>
    void separate_active(World& world);
    template <Terms terms>
    bool are_near(const World& world, const BallPair& pair) const;
    template <Terms terms>
    void separate_overlapping(World& world, std::span<const BallPair> pairs);
    template <Terms terms>
    void separate(World& world, std::uint32_t i, std::uint32_t j);
    template <Terms terms>
    void push_out_of_edges(World& world);
    bool knows_edges(const World& world, const Pushed& pushed) const;
    template <Terms terms>
    void push_out_of_edge(World& world, const EdgePair& pair);
    Vec2 displacement_of(const World& world, std::uint32_t ball) const;
    void note_push(const World& world, std::uint32_t ball);
    void exchange_momentum(World& world, double time, std::vector<Contact>& contacts);
    template <Terms terms>
    void bounce_pairs(World& world, double time, std::vector<Contact>& contacts);
    void keep_time(World& world);
    void end_step(const World& world);
    void move_kinematic(World& world, double share);

    Neighbours neighbours_;
    double margin_ = 0.0;
    double widest_ = 0.0;                // no two balls that are further apart overlap
    bool are_alike_ = false;             // all radii are equal: two balls that are nearer overlap
    bool shares_neighbours_ = false;     // steps share a list of neighbours
    bool keeps_time_ = false;            // there is more than one step
    bool is_first_step_ = false;         // every ball is active
    bool keeps_displacements_ = false;   // a displacement is not just the velocity times its time
    bool has_checked_all_ = false;       // in this tick: all balls have been checked
    bool has_escaped_ = false;           // a ball went further than its neighbours are known
    double duration_ = 0.0;              // of an update, s
    double kinematic_way_ = 0.0;         // longest displacement of a held ball in this update
    std::vector<std::uint32_t> active_;  // empty in the first step
    std::vector<std::uint8_t> is_active_;
    std::vector<std::uint8_t> is_pushed_;
    std::vector<double> left_;              // s of the update, by ball; of the active ones
    std::vector<Vec2> displacement_;        // in this step, by ball; where keeps_displacements_
    std::span<const double> inverse_mass_;  // 0 where the ball is held
    std::vector<double> with_held_balls_;
    std::vector<ClothState<double>> before_;  // the step, on cloth
    std::vector<HeldEdge> kinematic_edges_;
    std::vector<BallPair> near_active_;
    std::vector<BallPair> overlapping_;
    PairOrder order_;
    std::vector<EdgePair> at_edge_;
    std::vector<Pair> pairs_;
    std::vector<Pushed> pushed_;
};

}  // namespace carom

#pragma once

#include <vector>

#include "physics/capsule_cells.h"
#include "physics/contact.h"
#include "physics/solver.h"
#include "physics/terms.h"

/// The solvers `discrete` and `substep`: move, push overlaps apart, exchange momentum.
///
/// A tick is cut into `updates`, an update into at most `steps`. In a step every ball that has time
/// left moves for all of it; overlaps are then parted, each pair once, by half of the depth each
/// (an edge or a held ball does not give way); a ball whose way was cut short keeps the rest of its
/// time for the next step, time spent = time * distance covered / distance intended, and gives
/// gravity back what it took for that rest. Momentum is exchanged when all overlaps are parted,
/// along the normals as they are then, and only by pairs that approach; friction follows each
/// exchange, with its impulse. `discrete` is one update of
/// one step.
///
/// Fails by nature: what moves further than its size in a step passes through what is thin or
/// small; a row of touching balls is parted only pair by pair; under gravity pushing apart changes
/// the potential energy, so a heap jitters.
namespace carom {

class OverlapSolver {
  public:
    /// Moves everything by one tick and appends the exchanges to `contacts`. `touched`: see
    /// surroundings.h.
    void tick(World& world, int updates, int steps, std::vector<Contact>& contacts,
              std::vector<std::uint8_t>& touched);

    const CellFrame& cells() const { return cells_.frame(); }

  private:
    struct Pair {
        std::uint32_t ball = 0;
        std::uint32_t other = 0;
        ContactKind kind = ContactKind::ball_ball;
        Vec2 shift;  // of the capsule's image
    };

    struct HandWay {
        Vec2 start;  // velocities of the ends
        Vec2 end;
    };

    template <Terms terms>
    void update(World& world, double duration, int steps, double end_time,
                std::vector<Contact>& contacts);
    template <Terms terms>
    void move(World& world, int step);
    Vec2 move_on_cloth(World& world, std::uint32_t ball);
    template <Terms terms>
    void part_overlaps(World& world, bool all_active);
    template <Terms terms>
    void push_out_of_edge(World& world, std::uint32_t ball, std::uint32_t capsule, Vec2 shift);
    template <Terms terms>
    void exchange_momentum(World& world, double time, std::vector<Contact>& contacts);
    void keep_time(World& world);
    void move_hands(World& world, double share, double duration);
    bool is_driven(const World& world, std::uint32_t capsule) const;
    Vec2 hand_velocity(const World& world, std::uint32_t capsule, Vec2 point) const;

    PointCells cells_;
    CapsuleCells edges_;
    std::vector<std::uint32_t> active_;
    std::vector<std::uint8_t> is_active_;
    std::vector<std::uint8_t> is_touched_;    // in this step
    std::vector<double> left_;                // s of the update, by ball
    std::vector<Vec2> origin_;                // where the step began
    std::vector<double> intended_;            // length of the way it would have gone
    std::vector<ClothState<double>> before_;  // the step, on cloth
    std::vector<HandWay> hands_;              // by World::held_capsules
    std::vector<double> inverse_mass_;        // 0 where a hand holds the ball
    std::vector<Pair> pairs_;
    std::vector<std::uint32_t> moved_;
};

}  // namespace carom

#pragma once

#include <cstdint>

#include "physics/broad_phase/neighbour_list.h"
#include "physics/discrete/step.h"

namespace carom {

/// The neighbour list that the steps of a tick share in the solvers `discrete` and `substep`, and
/// often several ticks: it is built with a margin, and holds until a ball has gone further.
class SharedNeighbours {
  public:
    explicit SharedNeighbours(const OverlapStep& step) : step_(step) {}

    void begin_tick() { has_checked_all_ = false; }
    /// Whether steps share a list at all: else displacements need not be measured.
    bool are_shared() const { return step_.updates > 1 || step_.has_several; }
    /// All balls have moved, none further than `displacement`: rebuilds the list if it is no longer
    /// valid.
    void update(const World& world, double displacement, double kinematic_displacement);
    /// Some balls have moved or were pushed, each reported to `note_place`: rebuilds the list if
    /// one of them has gone beyond the margin.
    void update_after_notes(const World& world);
    void note_place(std::uint32_t ball, Vec2 position) {
        if (!list_.note_place(ball, position)) has_escaped_ = true;
    }

    /// Whether the list has all edges that the ball, which was pushed, may touch where it is now.
    bool has_edges_of(const World& world, const PushedBall& pushed) const;
    /// Two balls further apart than this do not overlap, length; infinite if it is not known.
    double widest() const { return widest_; }
    /// All radii are equal: any two balls nearer than `widest` overlap.
    bool are_alike() const { return are_alike_; }

    NeighbourList& list() { return list_; }
    const NeighbourList& list() const { return list_; }

  private:
    void build(const World& world, double displacement);

    const OverlapStep& step_;
    NeighbourList list_;
    double margin_ = 0.0;
    double widest_ = 0.0;
    bool are_alike_ = false;
    bool has_checked_all_ = false;  // in this tick: where every ball is
    bool has_escaped_ = false;      // a ball has gone beyond the margin
};

}  // namespace carom

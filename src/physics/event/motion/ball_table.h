#pragma once

#include <cstdint>
#include <vector>

#include "physics/event/motion/event.h"
#include "physics/event/motion/trajectory.h"
#include "physics/memory/large_pages.h"
#include "physics/memory/prefetch.h"

/// The records of all balls, laid out by access: one cache line that a walk over neighbours reads
/// (BallRecord), and one that only the ball's own events need (BallPlan).
///
/// Writers:
///
///   line, curve, version      Trajectories starts them. RestingContact, ClothPhases, Transitions
///                             and CollapseGuard choose the motion of one that has just started;
///                             Standstill keeps its count and roll. WorldSync restores stored ones
///   image in line             BallCells
///   next, CellPlace           BallCells
///   next event, collision     Predictor
///   radius, inverse_mass      WorldSync, when a tick rebuilds; KinematicBodies for what is held
namespace carom {

/// Where a ball stands in BallCells.
struct CellPlace {
    /// Unbounded, so that on a torus they say in which periodic image the ball is.
    int column = 0;
    int row = 0;
    std::uint32_t cell = 0;    ///< of an oversized ball: BallRecord::none
    std::uint32_t before = 0;  ///< the previous ball in the same cell
};

template <typename Real>
struct alignas(64) BallRecord {
    static constexpr std::uint32_t none = 0xffffffffu;

    LinearPart<Real> line;  ///< of its trajectory
    Real radius{};
    std::uint32_t next = none;  ///< ball in the same cell
    /// Counts the ball's trajectories: predictions made for another version are void.
    std::uint32_t version = 0;
};
static_assert(sizeof(BallRecord<double>) == 64);

template <typename Real>
class alignas(64) BallPlan {
  public:
    Real inverse_mass{};  ///< 0: held
    CellPlace place;

    /// The first of the events that were predicted for the ball.
    BallEvent<Real> next_event() const { return event(next_time_, next_); }
    void set_next_event(const BallEvent<Real>& event) {
        next_time_ = event.time;
        next_ = What(event);
    }
    /// The first ball that it will meet, however late, if all balls around it keep to their
    /// trajectories. EventKind::unknown where that is not known: see predictor.h.
    BallEvent<Real> collision() const { return event(collision_time_, collision_); }
    void set_collision(const BallEvent<Real>& event) {
        collision_time_ = event.time;
        collision_ = What(event);
    }

  private:
    // An event without its time, without padding.
    struct What {
        std::uint32_t other = 0;
        std::uint32_t other_version = 0;
        EventKind kind = EventKind::none;
        std::int8_t across = 0;
        std::int8_t along = 0;

        What() = default;
        explicit What(const BallEvent<Real>& event)
            : other(event.other),
              other_version(event.other_version),
              kind(event.kind),
              across(event.across),
              along(event.along) {}
    };
    static BallEvent<Real> event(const Real& time, const What& what) {
        return {time, what.kind, what.across, what.along, what.other, what.other_version};
    }

    Real next_time_{};
    Real collision_time_{};
    What next_;
    What collision_{BallEvent<Real>{.kind = EventKind::unknown}};
};
static_assert(sizeof(BallPlan<double>) == 64);

template <typename Real>
class BallTable {
  public:
    std::size_t size() const { return records_.size(); }
    /// `may_curve`: whether trajectories have acceleration parts (event_memory.h).
    void resize(std::size_t count, bool may_curve) {
        records_.resize(count);
        plans_.resize(count);
        curves_.resize(may_curve ? count : 0);
    }
    BallRecord<Real>& operator[](std::size_t ball) { return records_[ball]; }
    const BallRecord<Real>& operator[](std::size_t ball) const { return records_[ball]; }
    const Real& radius(std::size_t ball) const { return records_[ball].radius; }
    Trajectory<Real> trajectory(std::size_t ball) const {
        return curves_.empty() ? Trajectory<Real>{records_[ball].line, {}}
                               : Trajectory<Real>{records_[ball].line, curves_[ball]};
    }
    /// Pre: the trajectory is straight, unless trajectories may curve.
    void set_trajectory(std::size_t ball, const Trajectory<Real>& trajectory) {
        records_[ball].line = trajectory;
        if (!curves_.empty()) curves_[ball] = trajectory;
    }
    bool may_curve() const { return !curves_.empty(); }
    /// Pre: may_curve().
    AccelerationPart<Real>& curve(std::size_t ball) { return curves_[ball]; }
    const AccelerationPart<Real>& curve(std::size_t ball) const { return curves_[ball]; }
    BallPlan<Real>& plan(std::size_t ball) { return plans_[ball]; }
    const BallPlan<Real>& plan(std::size_t ball) const { return plans_[ball]; }
    const BallRecord<Real>* data() const { return records_.data(); }
    auto begin() { return records_.begin(); }
    auto end() { return records_.end(); }
    auto begin() const { return records_.begin(); }
    auto end() const { return records_.end(); }

    /// Prefetches what is read of a neighbour, or all that a ball's own events need.
    void prefetch_neighbour(std::size_t ball) const { prefetch_line(&records_[ball]); }
    void prefetch(std::size_t ball) const {
        prefetch_neighbour(ball);
        prefetch_line(&plans_[ball]);
    }

  private:
    LargeVector<BallRecord<Real>> records_;
    LargeVector<BallPlan<Real>> plans_;
    LargeVector<AccelerationPart<Real>> curves_;  ///< empty where trajectories do not curve
};

}  // namespace carom

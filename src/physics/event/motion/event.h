#pragma once

#include <array>
#include <cstdint>

#include "physics/memory/branchless.h"

/// Events of the solver `event`, and the total order in which they happen.
namespace carom {

/// What can happen to a ball. Events at the same time happen in the order of this list.
enum class EventKind : std::uint8_t {
    ball_ball,       ///< impact with another ball
    ball_edge,       ///< impact with an edge that nothing moves
    kinematic_edge,  ///< impact with one of KinematicBodies::edges: held, driven, or a seesaw's
    transition,      ///< the ball's motion changes by itself: see transitions.h
    cell_transfer,   ///< bookkeeping: see namespace cell_transfer
    none,
    unknown,  ///< of BallPlan::collision alone: not predicted
};

/// What `BallEvent::other` says of a cell transfer: the side to which the ball leaves its cell, or
/// one of two other chores, in which it stays in its cell. Only `restart_in_frame` starts a
/// trajectory.
namespace cell_transfer {
inline constexpr std::uint32_t to_right = 0;
inline constexpr std::uint32_t to_left = 1;
inline constexpr std::uint32_t up = 2;
inline constexpr std::uint32_t down = 3;
inline constexpr std::uint32_t sides = 4;
struct Step {
    int columns = 0;
    int rows = 0;
};
inline constexpr std::array<Step, sides> steps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
/// Nothing happens: a prediction that was cut short is to be made again.
inline constexpr std::uint32_t predict_again = 4;
/// The trajectory has led far from the frame of a torus, and starts again inside of it.
inline constexpr std::uint32_t restart_in_frame = 5;
}  // namespace cell_transfer

/// An event of a ball; which ball, the context says.
template <typename Real>
struct alignas(8) BallEvent {  // aligned on every machine, for assign_if
    Real time{};               ///< s
    EventKind kind = EventKind::none;
    /// Periodic image of the other that is met, relative to its trajectory.
    std::int8_t across = 0;
    std::int8_t along = 0;
    std::uint32_t other = 0;  ///< ball, capsule, index of a kinematic edge, or cell_transfer
    /// The other ball's version when this was predicted. If the ball has another by the time of the
    /// event, the prediction is void.
    std::uint32_t other_version = 0;
};

/// Whether event `a` of ball `ball_a` comes before event `b` of ball `ball_b`: by time, kind, lower
/// ball, higher ball, and then by whose event it is. A total order, so no history of insertions
/// shows. `none` comes last.
template <typename Real>
bool comes_before(std::uint32_t ball_a, const BallEvent<Real>& a, std::uint32_t ball_b,
                  const BallEvent<Real>& b);

/// Sets `best`, an event of `ball` or none, to `event` if that comes before it. Without a branch,
/// since no processor can predict which of two events comes first.
template <typename Real>
inline void keep_earlier(std::uint32_t ball, const BallEvent<Real>& event, BallEvent<Real>& best) {
    const auto is_event = static_cast<int>(event.kind != EventKind::none);
    const auto is_none = static_cast<int>(best.kind == EventKind::none);
    int comes = is_event & (is_none | static_cast<int>(event.time < best.time));
    if (event.time == best.time) comes = comes_before(ball, event, ball, best);
    assign_if(comes != 0, best, event);
}

}  // namespace carom

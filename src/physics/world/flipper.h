#pragma once

#include <cstdint>

#include "geometry/vec2.h"
#include "physics/world/ids.h"

/// Flippers: capsules that turn about one of their ends while a button is down, and back when it is
/// not.
namespace carom {

class World;

/// A solenoid drives it from `rest` to `up` and back at constant angular acceleration. It starts
/// without a jump and is fastest where it stops, so a ball that lies on it is pushed along, and
/// thrown off only there.
///
/// At the top it recoils from its stop, with a tenth of its speed, and the hold winding, which has
/// three tenths of the force, brings it back: for some 16 ms it gives way to a ball that lands on
/// it (a live catch). Sources: the window of 16 ms and the end-of-stroke torque of 0.3 are nFozzy's
/// and the VPW's settings for Visual Pinball, measured on real machines. The recoil is what gives
/// that window.
struct Flipper {
    CapsuleId capsule{};  ///< its start is the pivot
    double length = 0.0;  ///< from the pivot to the end
    Vec2 rest;            ///< direction from the pivot to the end at rest, a unit vector
    double sweep = 0.0;   ///< from there to where it is up, radians, counter-clockwise
    double rise = 0.02;   ///< s from rest to up, from a standstill, > 0
    double fall = 0.08;   ///< s back, > 0
    bool is_pressed = false;

    double progress = 0.0;  ///< 0 at rest, 1 up
    double rate = 0.0;      ///< of progress, 1/s
    /// Whether the flipper has jammed while it moved up or back, for example on a ball between the
    /// tips of two flippers. It then does not move until its button is released, or pressed.
    enum class Stall : std::uint8_t { none, up, back };
    Stall stall = Stall::none;

    bool is_stalled() const { return stall == (is_pressed ? Stall::up : Stall::back); }

    friend bool operator==(const Flipper&, const Flipper&) = default;
};

/// Where the flipper's end is when it has come this far.
Vec2 flipper_end(const Flipper& flipper, Vec2 pivot, double progress);

/// Begins a tick: a flipper that turns in it becomes a held edge (World::held_capsules), whose end
/// moves in a straight line from where it is to where it will be when the tick ends.
void drive_flippers(World& world);

/// Ends a tick: reads from the edges how far the flippers have turned. A flipper that was stopped
/// continues from there, from rest. Then no edge is driven any more, by a flipper or a mover.
void rest_flippers(World& world);

/// Stalls all flippers between rest and up. Called at the end of a tick in which time stood still
/// for a ball, since a ball on which flippers jam causes impacts without end.
void stall_flippers(World& world);

}  // namespace carom

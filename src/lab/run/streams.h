#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "physics/world/contact.h"
#include "physics/world/world.h"

/// The streams that a run writes tick by tick: events and trace.
namespace carom {

/// The contacts of tick number `tick` (from 1), one JSON object a line, in the order in which the
/// solver made them:
///
///     {"t": 0.5, "tick": 60, "kind": "ball_edge", "a": 0, "b": 3, "x": ..., "y": ..., "nx": ...,
///      "ny": ..., "approach": ..., "impulse": ...}
///
/// The normal points from b to a; the impulse is its magnitude along the normal, mass times
/// velocity. a and b are ball ids; in a "ball_edge", b is the id of the edge.
std::string event_lines(std::span<const Contact> contacts, std::uint64_t tick);

/// The first line of a trace, CSV: tick,time,id,x,y,vx,vy and, where balls turn, w.
std::string trace_header(const World& world);
/// One row per ball, by id, of the present world.
std::string trace_rows(const World& world);

}  // namespace carom

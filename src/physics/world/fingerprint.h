#pragma once

#include <cstdint>
#include <string>

#include "physics/world/world.h"

namespace carom {

/// 64 bits over all of the state that moves: the tick, every ball (id and all its numbers, bit by
/// bit), every capsule, the counters, what is held, and what solvers go on from (paths, impulses,
/// homes). Two worlds with the same history have the same fingerprint on every machine.
std::uint64_t fingerprint(const World& world);

/// 16 lower-case hexadecimal digits.
std::string hexadecimal(std::uint64_t fingerprint);

}  // namespace carom

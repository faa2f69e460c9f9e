#pragma once

#include <span>

#include "game/pool/pool.h"

/// The record of a shot, from which the referee judges it: what the cue ball hit first, which balls
/// met edges, and which were pocketed.
namespace carom {

/// The cue ball has been struck. Pre: not refused.
void begin_shot(const World& world, PoolPlay& play);

/// Records the events of a tick. Pre: called after every tick of a shot, with its contacts.
void record_tick(const Scene& scene, const World& world, PoolPlay& play,
                 std::span<const Contact> contacts);

}  // namespace carom

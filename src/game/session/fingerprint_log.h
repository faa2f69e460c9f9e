#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "game/session/fingerprint_mark.h"
#include "game/session/game_state.h"
#include "physics/world/fingerprint.h"
#include "physics/world/world.h"

namespace carom {

/// The fingerprints that a session has passed, one for each simulated second: what a recording is
/// verified against. Invariant: in ascending order of ticks, all of one version.
class FingerprintLog {
  public:
    /// `version`: which fingerprint (physics/world/fingerprint.h).
    explicit FingerprintLog(int version = fingerprint_version) : version_(version) {}

    std::span<const FingerprintMark> marks() const { return marks_; }
    int version() const { return version_; }

    /// Adds a mark of the present, where one is due and the log has none of this tick or a later
    /// one. To be called after all commands of the tick.
    void add_if_due(const World& world, const GameState& game);
    /// Drops the marks of this tick and of all later ones.
    void forget_from(std::uint64_t tick);

  private:
    std::vector<FingerprintMark> marks_;
    int version_;
};

}  // namespace carom

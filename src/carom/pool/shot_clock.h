#pragma once

#include <cstdint>
#include <optional>

#include "game/pool/pool.h"
#include "game/session/session.h"

namespace carom {

/// The shot clock of a game of pool. It counts the player's seconds, however fast or slowly the
/// game runs, from the moment at which a shot or a choice is due. The end is no part of the rules:
/// the controller applies command::TimeOut, so recordings replay without a clock.
class ShotClock {
  public:
    /// s left; none: the level has no clock, or nothing is due.
    std::optional<double> left(const Session& session) const;
    /// Lets the player's seconds pass. Returns whether the time is up. Pre: the player could shoot
    /// or choose in these seconds.
    bool pass(const Session& session, double seconds);
    /// The clock of a resumed game.
    void resume(const Session& session, double left);

  private:
    /// What changes when another shot or choice is due.
    struct Turn {
        std::uint32_t shots = 0;
        std::uint32_t frames = 0;
        int player = 0;
        int breaker = 0;
        PoolPhase phase = PoolPhase::breaking;

        friend bool operator==(const Turn&, const Turn&) = default;
    };
    static Turn turn_of(const PoolPlay& pool);

    std::optional<Turn> turn_;
    double gone_ = 0.0;  ///< s of that turn
};

}  // namespace carom

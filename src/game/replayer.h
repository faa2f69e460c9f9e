#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "game/replay_text.h"
#include "game/session.h"

/// Between a session and its replay.
namespace carom {

/// The session so far, written down, its replayable future included, with a fingerprint where it
/// stands. `level` and `overrides`: what the scene was loaded from and with. Pre:
/// session.is_complete().
Replay record(const Session& session, std::string level, std::span<const std::string> overrides);

/// Plays a replay again, a bounded number of ticks at a time, so that a long one can show how far
/// it is.
class Replayer {
  public:
    /// Pre: the scene was loaded from the replay's level, with its seed, rate and overrides, and
    /// its hash is the replay's; the replay's solvers are available.
    Replayer(Replay replay, Scene scene, std::size_t rewind_bytes = Session::default_rewind_bytes);

    /// Up to `ticks` ticks further. False once it stands where the replay stood, or has failed.
    bool advance(std::uint64_t ticks);
    /// 0..1 of the way.
    double progress() const;
    /// Why the replay cannot be trusted: a refused command or a wrong fingerprint, with its tick.
    const std::optional<std::string>& failure() const { return failure_; }

    const Session& session() const { return session_; }
    /// The session, to go on with.
    Session take() && { return std::move(session_); }

  private:
    void obey();
    void check();

    Replay replay_;
    Session session_;
    std::size_t next_command_ = 0;
    std::size_t next_mark_ = 0;
    std::optional<std::string> failure_;
};

}  // namespace carom

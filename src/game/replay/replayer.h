#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "game/replay/replay_text.h"
#include "game/session/session.h"

/// Between a session and its replay.
namespace carom {

/// What a replay says before its first command: a scene, the solver at its start, and what it was
/// loaded from and with. The names of the files are not in it, but for `level`.
Replay begin_replay(const Scene& scene, const SolverSettings& solver, std::string level,
                    std::span<const std::string> overrides);

/// The session so far, written down, its replayable future included, with its marks and one where
/// it stands. Pre: session.is_complete().
Replay record(const Session& session, std::string level, std::span<const std::string> overrides);

/// The scene that a replay begins with, from the texts in it; or why there is none.
std::variant<Scene, ReplayError> scene_of(const Replay& replay);

/// Plays a replay again, a bounded number of ticks at a time, so that a long one can show how far
/// it is, and compares its marks.
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
    /// The last mark that was the same, and the first that was not; none: there was none.
    const std::optional<FingerprintMark>& last_equal() const { return last_equal_; }
    const std::optional<FingerprintMark>& first_different() const { return first_different_; }

    const Session& session() const { return session_; }
    /// The session, to go on with.
    Session take() &&;

  private:
    void check();

    Replay replay_;
    Session session_;
    std::size_t next_mark_ = 0;
    std::optional<std::string> failure_;
    std::optional<FingerprintMark> last_equal_;
    std::optional<FingerprintMark> first_different_;
};

}  // namespace carom

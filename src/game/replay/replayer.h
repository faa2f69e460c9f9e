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

/// Turns a session into its recording, and a recording into a session.
namespace carom {

/// A recording without commands: a scene, the solver at its start, and the texts and overrides it
/// was loaded with. Of the file names, only `level` is stored.
Replay begin_replay(const Scene& scene, const SolverSettings& solver, std::string level,
                    std::span<const std::string> overrides);

/// The session so far as a recording, including its replayable future, with its fingerprint marks
/// and one for the present. Pre: session.is_complete().
Replay record(const Session& session, std::string level, std::span<const std::string> overrides);

/// The scene that a recording starts with, loaded from its texts; or why that fails.
std::variant<Scene, ReplayError> scene_of(const Replay& replay);

/// Plays a recording and compares its fingerprints. It computes a bounded number of ticks at a
/// time, so that a long recording can show its progress.
class Replayer {
  public:
    /// Pre: the scene was loaded from the replay's level, with its seed, rate and overrides, and
    /// its hash is the replay's; the replay's solvers are available.
    Replayer(Replay replay, Scene scene, std::size_t rewind_bytes = Session::default_rewind_bytes);

    /// Computes up to `ticks` more ticks. False once it has reached the tick at which the recording
    /// was left, or has failed.
    bool advance(std::uint64_t ticks);
    /// The completed share, 0..1.
    double progress() const;

    /// Why the replay cannot be trusted: a refused command or a wrong fingerprint, with its tick.
    const std::optional<std::string>& failure() const { return failure_; }
    /// The last mark that agreed, and the first that did not; none: there was no such mark.
    const std::optional<FingerprintMark>& last_equal() const { return last_equal_; }
    const std::optional<FingerprintMark>& first_different() const { return first_different_; }

    const Session& session() const { return session_; }
    /// The session, to be continued.
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

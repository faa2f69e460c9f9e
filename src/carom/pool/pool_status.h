#pragma once

#include <optional>
#include <string>

#include "game/pool/pool.h"
#include "game/pool/pool_words.h"
#include "game/session/session.h"
#include "terminal/panels/hud.h"

/// Messages of a game of pool or of shots, in play and in a watched recording.
namespace carom {

/// The state of the session's game of pool; null if there is none.
const PoolPlay* pool_of(const Session& session);
/// The state of the session's game of shots (game/shots/shots.h); null if there is none.
const ShotsState* shots_of(const Session& session);
/// Whether the next shot is the break of a game of pool.
bool is_break(const Session& session);
/// Whether the next shot opens a frame that begins with a safety: the break of straight pool and
/// one-pocket, and the break-off of snooker, which the rules judge as any other stroke.
bool is_safe_opening(const Session& session);
/// Whether rules decide who shoots: a game of pool or of shots.
bool has_turns(const Session& session);

/// Puts the score and the turn into the title, and the time left for the shot, s, if there is any.
/// Does nothing without a game.
void add_pool_title(const Session& session, const PlayerNames& names,
                    std::optional<double> time_left, HudInfo& info);

/// The outcome of the last shot, empty while the balls roll; none: no game is played.
std::optional<std::string> outcome_of(const Session& session, const PlayerNames& names);

/// Announces the outcome of each shot once.
class ShotAnnouncer {
  public:
    /// The outcome, if it has changed since the last call and is worth announcing.
    std::optional<std::string> tell(const Session& session, const PlayerNames& names);
    /// Treats the present outcome as announced.
    void skip(const Session& session, const PlayerNames& names);

  private:
    std::string told_;
};

}  // namespace carom

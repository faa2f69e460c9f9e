#pragma once

#include <optional>
#include <string>

#include "game/pool/pool.h"
#include "game/pool/pool_words.h"
#include "game/session/session.h"
#include "terminal/panels/hud.h"

/// What a game of pool tells the player, whether it is played or watched.
namespace carom {

/// The state of the session's game of pool; null where none is played.
const PoolPlay* pool_of(const Session& session);

/// Puts the score, the turn and the shot clock into the title. No game of pool: nothing.
void add_pool_title(const Session& session, const PlayerNames& names, HudInfo& info);

/// Tells the outcome of each shot once.
class ShotAnnouncer {
  public:
    /// The outcome, where it has changed since the last call and there is something to say.
    std::optional<std::string> tell(const Session& session, const PlayerNames& names);
    /// Counts the present outcome as told.
    void skip(const Session& session, const PlayerNames& names);

  private:
    std::string told_;
};

}  // namespace carom

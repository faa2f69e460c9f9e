#pragma once

#include "game/pool/pool_words.h"
#include "game/session/session.h"
#include "geometry/shapes.h"
#include "terminal/panels/pool_panel.h"

namespace carom {

/// The panel of a table as it stands: players and groups if a game is played, and the balls that
/// are off the table. Without its tip.
PoolPanel scoreboard_of(const Session& session, const PlayerNames& names);

/// Takes the room for the panel from `area`, which shows `shown`: see cut_pool_panel().
CellArea cut_scoreboard(CellArea& area, const Box& shown);

}  // namespace carom

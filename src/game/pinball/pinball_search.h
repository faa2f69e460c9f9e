#pragma once

#include "game/pinball/pinball_table.h"

namespace carom {

/// The ball search of real tables: a ball that has not got on for a while is kicked away from what
/// it is nearest to, a few times, and is then taken back to the plunger. A ball that lies on the
/// plunger, or on a flipper that is held up, may stay. What has left the table is taken back too.
void search_balls(Pinball game);

}  // namespace carom

#pragma once

#include "game/pinball/pinball_table.h"

namespace carom {

/// The ball search of real tables. A ball without progress for a while is kicked away from the
/// nearest edge, a few times; then it is removed and served again. A ball on the plunger, in a
/// hole, or on a raised flipper may stay. A ball that has left the table is served again too.
void search_balls(Pinball game);

}  // namespace carom

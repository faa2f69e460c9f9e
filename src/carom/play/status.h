#pragma once

#include "carom/context/play_context.h"
#include "terminal/panels/hud.h"

/// The status lines below the world.
namespace carom {

HudInfo status_of(const PlayContext& play);

}  // namespace carom

#pragma once

#include <memory>

#include "carom/context/controller.h"
#include "game/session/session.h"

/// Makes the controller for a session's way of playing.
namespace carom {

std::unique_ptr<Controller> make_controller(const Session& session);

}  // namespace carom

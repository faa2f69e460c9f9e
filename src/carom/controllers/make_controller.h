#pragma once

#include <memory>

#include "carom/context/controller.h"
#include "game/session/session.h"

/// The way of playing that a session calls for.
namespace carom {

std::unique_ptr<Controller> make_controller(const Session& session);

}  // namespace carom

#include "carom/controllers/make_controller.h"

#include "carom/controllers/free_controller.h"
#include "carom/controllers/pinball_controller.h"
#include "carom/controllers/pool_controller.h"
#include "carom/controllers/watch_controller.h"

namespace carom {

std::unique_ptr<Controller> make_controller(const Session& session) {
    if (session.is_following()) return std::make_unique<WatchController>(session);
    if (PinballFeedback::is_at(session)) return std::make_unique<PinballController>();
    if (PoolAim::is_at(session.scene())) return std::make_unique<PoolController>(session);
    return std::make_unique<FreeController>();
}

}  // namespace carom

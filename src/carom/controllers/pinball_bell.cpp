#include "carom/controllers/pinball_bell.h"

#include <algorithm>

#include "game/pinball/pinball.h"

namespace carom {
namespace {

constexpr double bell_pause = 0.12;  // s; least time between two bells

std::uint64_t last_flash(const PinballState& state) {
    std::uint64_t last = 0;
    for (const std::uint64_t until : state.flash_until)
        last = std::max(last, until);
    return last;
}

}  // namespace

bool PinballBell::rings(const Session& session, double seconds) {
    since_bell_ += seconds;
    const auto& state = std::get<PinballState>(session.game());
    const std::uint64_t flash = last_flash(state);
    const bool is_new = flash > heard_flash_ || state.held.size() > heard_held_;
    heard_flash_ = flash;  // it decreases after a step back
    heard_held_ = state.held.size();
    if (!is_new || since_bell_ < bell_pause) return false;
    since_bell_ = 0.0;
    return true;
}

}  // namespace carom

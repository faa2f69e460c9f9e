#include "game/session/fingerprint_log.h"

namespace carom {

void FingerprintLog::add_if_due(const World& world, const GameState& game) {
    if (world.tick() % mark_interval(world.rate()) != 0) return;
    if (!marks_.empty() && marks_.back().tick >= world.tick()) return;
    marks_.push_back({world.tick(), fingerprint(world, game, version_)});
}

void FingerprintLog::forget_from(std::uint64_t tick) {
    while (!marks_.empty() && marks_.back().tick >= tick)
        marks_.pop_back();
}

}  // namespace carom

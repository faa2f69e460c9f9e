#include "game/session/history.h"

#include <algorithm>
#include <utility>

namespace carom {
namespace {

constexpr auto tick_of = [](const auto& kept) { return kept.snapshot.world.tick(); };

std::uint64_t apart(std::uint64_t a, std::uint64_t b) {
    return a < b ? b - a : a - b;
}

}  // namespace

std::size_t bytes_of_snapshot(const World& world) {
    return sizeof(Snapshot) - sizeof(World) + bytes_of(world);
}

void History::keep(const World& world, const SolverSettings& solver, const GameState& game) {
    const auto place = std::ranges::lower_bound(snapshots_, world.tick(), {}, tick_of);
    if (place != snapshots_.end() && tick_of(*place) == world.tick()) return;
    Kept kept{{world, solver, game}, 0};
    kept.bytes = bytes_of_snapshot(kept.snapshot.world) +
                 bytes_of(kept.snapshot.game);  // of the copy, which has no spare capacity
    if (kept.bytes > limit_) return;
    bytes_ += kept.bytes;
    snapshots_.insert(place, std::move(kept));
    if (bytes_ > limit_) thin(world.tick());
}

// Walks away from the present on both sides. A snapshot is dropped if the gap that it leaves,
// between the last one kept and the next one, is no more than the next one's distance from the
// present divided by the sharpness. The sharpness is lowered until a quarter of the memory is free,
// so that thinning is rare.
void History::thin(std::uint64_t present) {
    const auto count = static_cast<std::ptrdiff_t>(snapshots_.size());
    const auto middle =
        std::ranges::upper_bound(snapshots_, present, {}, tick_of) - snapshots_.begin();
    const auto at = [&](std::ptrdiff_t i) -> const Kept& {
        return snapshots_[static_cast<std::size_t>(i)];
    };
    std::vector<char> stays(snapshots_.size());
    const auto walk = [&](std::ptrdiff_t from, std::ptrdiff_t end, std::ptrdiff_t step,
                          double sharpness) {
        std::size_t bytes = 0;
        std::uint64_t last = present;
        for (std::ptrdiff_t i = from; i != end; i += step) {
            const std::uint64_t tick = tick_of(at(i));
            const std::uint64_t beyond = step < 0 ? 0 : tick;
            const std::uint64_t next = i + step == end ? beyond : tick_of(at(i + step));
            const bool goes =
                tick != present && static_cast<double>(apart(last, next)) * sharpness <=
                                       static_cast<double>(apart(present, next));
            stays[static_cast<std::size_t>(i)] = !goes;
            if (goes) continue;
            bytes += at(i).bytes;
            last = tick;
        }
        return bytes;
    };
    const std::size_t enough = limit_ / 4 * 3;
    for (double sharpness = static_cast<double>(count);; sharpness *= 0.9) {
        if (sharpness < 0.5) sharpness = 0.0;
        const std::size_t bytes =
            walk(middle - 1, -1, -1, sharpness) + walk(middle, count, 1, sharpness);
        if (bytes <= enough || sharpness == 0.0) break;
    }
    std::vector<Kept> thinned;
    bytes_ = 0;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        // At sharpness 0 only the present is kept; it may still exceed a lowered limit.
        if (!stays[static_cast<std::size_t>(i)] || bytes_ + at(i).bytes > limit_) continue;
        bytes_ += at(i).bytes;
        thinned.push_back(std::move(snapshots_[static_cast<std::size_t>(i)]));
    }
    snapshots_ = std::move(thinned);
}

const Snapshot* History::at_or_before(std::uint64_t tick) const {
    const auto after = std::ranges::upper_bound(snapshots_, tick, {}, tick_of);
    return after == snapshots_.begin() ? nullptr : &(after - 1)->snapshot;
}

bool History::has(std::uint64_t tick) const {
    const Snapshot* found = at_or_before(tick);
    return found && found->world.tick() == tick;
}

void History::forget_from(std::uint64_t tick) {
    while (!snapshots_.empty() && tick_of(snapshots_.back()) >= tick) {
        bytes_ -= snapshots_.back().bytes;
        snapshots_.pop_back();
    }
}

void History::forget_before(std::uint64_t tick) {
    const auto end = std::ranges::lower_bound(snapshots_, tick, {}, tick_of);
    for (auto kept = snapshots_.begin(); kept != end; ++kept)
        bytes_ -= kept->bytes;
    snapshots_.erase(snapshots_.begin(), end);
}

void History::clear() {
    snapshots_.clear();
    bytes_ = 0;
}

void History::set_limit(std::size_t limit_bytes, std::uint64_t present) {
    limit_ = limit_bytes;
    if (bytes_ > limit_) thin(present);
}

}  // namespace carom

#include "lab/measure/difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/broad_phase/cell_frame.h"

namespace carom {
namespace {

double distance_squared(Vec2 a, Vec2 b, const std::optional<Vec2>& torus) {
    const Vec2 offset = torus ? nearest_image(a - b, *torus) : a - b;
    const double squared = length_squared(offset);
    return std::isfinite(squared) ? squared : std::numeric_limits<double>::infinity();
}

}  // namespace

Positions positions_of(const World& world) {
    return {world.balls().id, world.balls().position};
}

Difference difference(const Positions& a, const Positions& b, const std::optional<Vec2>& torus) {
    Difference found;
    double sum = 0.0;
    double largest = 0.0;
    std::size_t pairs = 0;
    std::size_t j = 0;
    for (std::size_t i = 0; i < a.id.size(); ++i) {
        while (j < b.id.size() && b.id[j] < a.id[i])
            ++j;
        if (j == b.id.size() || b.id[j] != a.id[i]) continue;
        const double squared = distance_squared(a.position[i], b.position[j], torus);
        if (squared > largest) {
            largest = squared;
            found.farthest = a.id[i];
        }
        sum += squared;
        ++pairs;
    }
    found.max = std::sqrt(largest);
    found.rms = pairs == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(pairs));
    found.unpaired = a.id.size() + b.id.size() - 2 * pairs;
    return found;
}

Difference difference(const World& a, const World& b) {
    return difference(positions_of(a), positions_of(b), torus_of(a));
}

std::optional<Vec2> torus_of(const World& world) {
    if (!world.model().wrap) return std::nullopt;
    return size(*world.model().wrap);
}

double mean_radius(const World& world) {
    double sum = 0.0;
    double count = 0.0;
    for (const double radius : world.balls().radius)
        sum += radius;
    count += static_cast<double>(world.balls().size());
    for (const Emitter& emitter : world.emitters()) {
        const double to_come = emitter.count - emitter.emitted;
        sum += to_come * world.kinds()[emitter.kind].radius;
        count += to_come;
    }
    return count > 0.0 ? sum / count : 1.0;
}

}  // namespace carom

#include "lab/run/promise.h"

#include <algorithm>

namespace carom {
namespace {

// Falls in a tick, in radii. `contact` has at most 64 substeps, and holds a ball that has fallen a
// quarter of its radius. Under `swept` a ball that comes to rest separates at 1.5e-6 of what
// gravity gives in a tick, which must not move it by a radius. Under `event` an approach of 8e-10
// of the speed of a fall through the radius is rounding, which must not move it by a thousandth of
// a radius.
constexpr double most_fall_of_contact = 64.0 * 64.0 * 0.25;
constexpr double most_fall_of_swept = 1.0 / 1.5e-6;
constexpr double most_fall_of_event = 1e-3 / 8e-10 * (1e-3 / 8e-10);

}  // namespace

Promise promise_of(SolverKind solver) {
    switch (solver) {
        case SolverKind::event:
            return {.energy = 1e-9,
                    .energy_of_clustered = 1e-2,
                    .overlap = 1e-3,
                    .overlap_of_clustered = 0.75,
                    .parted = 1e-6,
                    .most_fall = most_fall_of_event,
                    .keeps_sides = true,
                    .moves = true};
        case SolverKind::swept:
            return {.energy = 1e-3,
                    .overlap = 1e-3,
                    .most_fall = most_fall_of_swept,
                    .keeps_sides = true,
                    .moves = true};
        case SolverKind::contact:
            return {.energy = 1e-2,
                    .counts_heights = true,
                    .overlap = 0.75,
                    .overlap_of_clustered = 0.75,
                    .lifts_overlaps = true,
                    .most_fall = most_fall_of_contact,
                    .keeps_sides = true,
                    .moves = true,
                    .iterates = true};
        default:
            return {};
    }
}

std::size_t count_too_small(const Promise& promise, const World& world) {
    if (!promise.most_fall || !world.model().gravity || world.model().cloth) return 0;
    const double tick = world.tick_length();
    const double least = length(*world.model().gravity) * tick * tick / *promise.most_fall;
    return static_cast<std::size_t>(
        std::ranges::count_if(world.balls().radius, [&](double r) { return r < least; }));
}

}  // namespace carom

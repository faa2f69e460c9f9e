#include "physics/world/flipper.h"

#include <algorithm>

#include "geometry/elementary.h"
#include "physics/world/world.h"

namespace carom {
namespace {

/// A solver's rounding of a way, as a share of the length.
constexpr double rounding = 1e-9;

struct Swing {
    double progress = 0.0;
    double rate = 0.0;
};

// At the end of a tick that nothing stops.
Swing swing_after(const Flipper& flipper, double duration) {
    // From a standstill, half the acceleration times the square of the time is 1.
    const double acceleration = flipper.is_pressed ? 2.0 / (flipper.rise * flipper.rise)
                                                   : -2.0 / (flipper.fall * flipper.fall);
    const double rate = flipper.rate + acceleration * duration;
    const double progress = flipper.progress + 0.5 * (flipper.rate + rate) * duration;
    if (progress >= 1.0) return {1.0, 0.0};
    if (progress <= 0.0) return {0.0, 0.0};
    return {progress, rate};
}

}  // namespace

Vec2 flipper_end(const Flipper& flipper, Vec2 pivot, double progress) {
    const auto [sine, cosine] = sin_cos(flipper.sweep * progress);
    return pivot + (flipper.rest * cosine + perpendicular(flipper.rest) * sine) * flipper.length;
}

void drive_flippers(World& world) {
    for (const Flipper& flipper : world.flippers()) {
        const auto index = index_of(world, flipper.capsule);
        if (!index) continue;
        const Swing next = swing_after(flipper, world.tick_length());
        if (next.progress == flipper.progress) continue;
        const Vec2 pivot = world.capsules().shape[*index].start;
        const auto place =
            std::ranges::lower_bound(world.held_capsules(), flipper.capsule, {}, &HeldCapsule::id);
        world.edit_held_capsules().insert(place,
                                          {.id = flipper.capsule,
                                           .start_target = pivot,
                                           .end_target = flipper_end(flipper, pivot, next.progress),
                                           .is_driven = true});
    }
}

void rest_flippers(World& world) {
    for (Flipper& flipper : world.edit_flippers()) {
        const auto index = index_of(world, flipper.capsule);
        if (!index) continue;
        const Swing next = swing_after(flipper, world.tick_length());
        if (next.progress == flipper.progress) {
            flipper.rate = next.rate;
            continue;
        }
        Capsule& shape = world.edit_capsules().shape[*index];
        const Vec2 from = flipper_end(flipper, shape.start, flipper.progress);
        const Vec2 to = flipper_end(flipper, shape.start, next.progress);
        if (distance(shape.end, to) <= rounding * flipper.length) {
            shape.end = to;
            flipper.progress = next.progress;
            flipper.rate = next.rate;
            continue;
        }
        const double share = std::clamp(length(shape.end - from) / length(to - from), 0.0, 1.0);
        flipper.progress += share * (next.progress - flipper.progress);
        flipper.rate = 0.0;
    }
    // A world whose flippers rest keeps its stamp.
    if (std::ranges::any_of(world.held_capsules(), &HeldCapsule::is_driven))
        std::erase_if(world.edit_held_capsules(),
                      [](const HeldCapsule& held) { return held.is_driven; });
}

}  // namespace carom

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

// Shares of the speed at the end of a whole stroke: with which a flipper recoils from the stop at
// the top, the slowest that recoils, and the fastest at which it comes back from a recoil.
constexpr double recoil = 0.1;
constexpr double least_to_recoil = 0.2;
constexpr double return_speed = 0.04;
// From this progress on, the end-of-stroke switch is open: a flipper that is not on its way up at
// speed is pulled by the hold winding alone, with this share of the force.
constexpr double end_of_stroke = 0.9;
constexpr double hold_force = 0.3;

// At the end of a tick that nothing stops.
Swing swing_after(const Flipper& flipper, double duration) {
    if (flipper.is_stalled()) return {flipper.progress, 0.0};
    const double full_speed = 2.0 / flipper.rise;
    const bool is_held = flipper.is_pressed && flipper.progress >= end_of_stroke &&
                         flipper.rate < least_to_recoil * full_speed;
    // Of progress, 1/s^2. From a standstill, half of it times the square of the time is 1.
    const double power = 2.0 / (flipper.rise * flipper.rise);
    const double acceleration = is_held              ? hold_force * power
                                : flipper.is_pressed ? power
                                                     : -2.0 / (flipper.fall * flipper.fall);
    double rate = flipper.rate + acceleration * duration;
    if (is_held) rate = std::min(rate, return_speed * full_speed);
    const double progress = flipper.progress + 0.5 * (flipper.rate + rate) * duration;
    if (progress >= 1.0) return {1.0, rate > least_to_recoil * full_speed ? -recoil * rate : 0.0};
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
        hold(world, {.id = flipper.capsule,
                     .start_target = pivot,
                     .end_target = flipper_end(flipper, pivot, next.progress),
                     .is_driven = true});
    }
}

void rest_flippers(World& world) {
    for (Flipper& flipper : world.edit_flippers()) {
        const auto index = index_of(world, flipper.capsule);
        if (!index) continue;
        if (!flipper.is_stalled()) flipper.stall = Flipper::Stall::none;
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

void stall_flippers(World& world) {
    for (Flipper& flipper : world.edit_flippers()) {
        if (flipper.progress == 0.0 || flipper.progress == 1.0) continue;
        flipper.stall = flipper.is_pressed ? Flipper::Stall::up : Flipper::Stall::back;
        flipper.rate = 0.0;
    }
}

}  // namespace carom

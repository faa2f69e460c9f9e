#include "physics/world/seesaw.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "physics/world/world.h"

namespace carom {

double bar_inertia(const Capsule& edge, Vec2 pivot) {
    const Vec2 start = edge.start - pivot;
    const Vec2 end = edge.end - pivot;
    return (length_squared(start) + dot(start, end) + length_squared(end)) / 3.0;
}

Capsule seesaw_shape(const Seesaw& seesaw, double angle) {
    if (angle == 0.0) return seesaw.home;
    Capsule shape = seesaw.home;
    const auto [sine, cosine] = sin_cos(angle);
    for (Vec2* const end : {&shape.start, &shape.end}) {
        const Vec2 arm = *end - seesaw.pivot;
        *end = seesaw.pivot + arm * cosine + perpendicular(arm) * sine;
    }
    return shape;
}

void add_seesaw(World& world, const Seesaw& seesaw) {
    const auto place =
        std::ranges::lower_bound(world.seesaws(), seesaw.capsule, {}, &Seesaw::capsule);
    world.edit_seesaws().insert(place, seesaw);
    if (!world.model().hinged) world.edit_definition().model.hinged = true;
    const bool has_stops = std::isfinite(seesaw.least) || std::isfinite(seesaw.most);
    if (has_stops && seesaw.stop_restitution < 1.0) become_inelastic(world);
    if (const auto index = index_of(world, seesaw.capsule))
        world.edit_capsules().shape[*index] = seesaw_shape(seesaw, seesaw.angle);
}

std::optional<std::uint32_t> seesaw_of(const World& world, CapsuleId id) {
    const auto found = std::ranges::lower_bound(world.seesaws(), id, {}, &Seesaw::capsule);
    if (found == world.seesaws().end() || found->capsule != id) return std::nullopt;
    return static_cast<std::uint32_t>(found - world.seesaws().begin());
}

void release_seesaws(World& world) {
    for (const Seesaw& seesaw : world.seesaws()) {
        const auto index = index_of(world, seesaw.capsule);
        if (!index) continue;
        const Capsule& shape = world.capsules().shape[*index];
        hold(world, {.id = seesaw.capsule,
                     .start_target = shape.start,
                     .end_target = shape.end,
                     .is_seesaw = true});
    }
    const auto is_too_fast = [&](const Seesaw& seesaw) {
        return std::fabs(seesaw.rate) * world.tick_length() > most_turning_in_a_tick;
    };
    if (std::ranges::none_of(world.seesaws(), is_too_fast)) return;
    for (Seesaw& seesaw : world.edit_seesaws())
        if (is_too_fast(seesaw)) seesaw.bounces = most_bounces_at_stops + 1;
}

void keep_seesaws(World& world) {
    if (world.seesaws().empty()) return;
    std::erase_if(world.edit_held_capsules(), &HeldCapsule::is_seesaw);
    if (std::ranges::all_of(world.seesaws(),
                            [](const Seesaw& seesaw) { return seesaw.bounces == 0; }))
        return;
    for (Seesaw& seesaw : world.edit_seesaws())
        seesaw.bounces = 0;
}

std::size_t count_standing_seesaws(const World& world) {
    return static_cast<std::size_t>(std::ranges::count_if(world.seesaws(), is_standing));
}

double fastest_point(const Seesaw& seesaw) {
    const double arm = std::max(distance(seesaw.home.start, seesaw.pivot),
                                distance(seesaw.home.end, seesaw.pivot));
    return std::fabs(seesaw.rate) * (arm + seesaw.home.radius);
}

double time_to_stop(const Seesaw& seesaw) {
    if (seesaw.rate == 0.0 || is_standing(seesaw)) return std::numeric_limits<double>::infinity();
    const double left = (seesaw.rate > 0.0 ? seesaw.most : seesaw.least) - seesaw.angle;
    return std::max(0.0, left / seesaw.rate);
}

void turn_on(Seesaw& seesaw, double duration) {
    if (is_standing(seesaw)) return;
    seesaw.angle = std::clamp(seesaw.angle + seesaw.rate * duration, seesaw.least, seesaw.most);
}

void bounce_at_stop(Seesaw& seesaw) {
    seesaw.angle = seesaw.rate > 0.0 ? seesaw.most : seesaw.least;
    ++seesaw.bounces;
    // A zero of either sign is one zero: a fingerprint sees the difference.
    seesaw.rate = 0.0 - seesaw.stop_restitution * seesaw.rate;
}

}  // namespace carom

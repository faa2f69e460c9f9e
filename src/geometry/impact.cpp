#include "geometry/impact.h"

#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "geometry/conservative_advancement.h"
#include "geometry/elementary.h"

namespace carom {
namespace {

// An approach to a moving capsule that is slower than this share of the relative speed is rounding.
constexpr double rounding = 1e-14;

// The time at which a point at `offset` from a fixed centre, moving at constant `velocity`, first
// comes within `reach` of it.
std::optional<double> time_to_reach(Vec2 offset, Vec2 velocity, double reach, double horizon) {
    const double closing = -dot(offset, velocity);
    if (!(closing > 0.0)) return std::nullopt;
    const double away = length(offset);
    const double gap = away - reach;
    if (gap <= 0.0) return 0.0;
    const double speed_squared = length_squared(velocity);
    const double miss = cross(offset, velocity);
    // b^2 - ac of the quadratic, written so that large distances do not cancel.
    const double discriminant = speed_squared * reach * reach - miss * miss;
    if (!(discriminant > 0.0)) return std::nullopt;
    // Both terms of the denominator are positive, so nothing cancels.
    const double time = gap * (away + reach) / (closing + std::sqrt(discriminant));
    if (!(time <= horizon)) return std::nullopt;
    return time;
}

// The impact with the long sides of a capsule of non-zero length; none if the path meets an end
// first. The caller decides whether they touch, so that rounding cannot turn contact into a gap.
std::optional<Impact> side_impact(const Disc& disc, Vec2 velocity, const Capsule& capsule,
                                  bool touching, double horizon) {
    const Vec2 span = capsule.end - capsule.start;
    const double whole = length(span);
    const Vec2 along = span / whole;
    const Vec2 offset = disc.center - capsule.start;
    const double height = cross(along, offset);
    const double rise = cross(along, velocity);
    if (height == 0.0) return std::nullopt;
    const double up = height > 0.0 ? 1.0 : -1.0;
    const double sinking = -rise * up;
    if (!(sinking > 0.0)) return std::nullopt;
    const double reach = disc.radius + capsule.radius;
    const double gap = touching ? 0.0 : std::max(0.0, height * up - reach);
    const double time = gap / sinking;
    if (!(time <= horizon)) return std::nullopt;
    const double place = dot(along, offset) + dot(along, velocity) * time;
    if (!(place >= 0.0 && place <= whole)) return std::nullopt;
    return Impact{time, perpendicular(along) * up};
}

// Whether a disc beside a capsule moves away from, or along, the line through the spine.
bool is_leaving(const Disc& disc, Vec2 velocity, const Capsule& capsule) {
    const Vec2 span = capsule.end - capsule.start;
    return cross(span, disc.center - capsule.start) * cross(span, velocity) >= 0.0;
}

// A disc that goes along an edge at the edge's own speed approaches it by rounding alone.
std::optional<Impact> without_rounding(const std::optional<Impact>& impact, Vec2 relative) {
    if (!impact || dot(relative, impact->normal) < -rounding * length(relative)) return impact;
    return std::nullopt;
}

}  // namespace

std::optional<Impact> first_impact(const Disc& disc, Vec2 velocity, const Disc& other,
                                   double horizon) {
    const Vec2 offset = disc.center - other.center;
    if (stays_apart(offset, velocity, disc.radius + other.radius, horizon)) return std::nullopt;
    const auto time = time_to_reach(offset, velocity, disc.radius + other.radius, horizon);
    if (!time) return std::nullopt;
    return Impact{*time, direction(offset + velocity * *time, direction(offset, {1.0, 0.0}))};
}

std::optional<Impact> first_impact(const Disc& disc, Vec2 velocity, const Capsule& capsule,
                                   double horizon) {
    const Disc start_cap{capsule.start, capsule.radius};
    if (capsule.start == capsule.end) return first_impact(disc, velocity, start_cap, horizon);

    const Vec2 offset = disc.center - closest_point(capsule.start, capsule.end, disc.center);
    const double reach = disc.radius + capsule.radius;
    if (stays_apart(offset, velocity, reach, horizon)) return std::nullopt;
    const double place = closest_parameter(capsule.start, capsule.end, disc.center);
    const bool touching = length_squared(offset) <= reach * reach;
    if (place > 0.0 && place < 1.0) {
        const auto side = side_impact(disc, velocity, capsule, touching, horizon);
        if (side || touching || is_leaving(disc, velocity, capsule)) return side;
    } else {
        if (dot(offset, velocity) >= 0.0) return std::nullopt;
        if (touching) return Impact{0.0, direction(offset, {})};
        if (const auto side = side_impact(disc, velocity, capsule, false, horizon)) return side;
    }
    const auto at_start = first_impact(disc, velocity, start_cap, horizon);
    const auto at_end = first_impact(disc, velocity, Disc{capsule.end, capsule.radius}, horizon);
    if (!at_start) return at_end;
    if (!at_end) return at_start;
    return at_start->time <= at_end->time ? at_start : at_end;
}

std::optional<Impact> first_impact(const Disc& disc, Vec2 velocity, const Capsule& capsule,
                                   Vec2 start_velocity, Vec2 end_velocity, double horizon) {
    if (start_velocity == end_velocity)
        return without_rounding(first_impact(disc, velocity - start_velocity, capsule, horizon),
                                velocity - start_velocity);
    const double start_speed = length(velocity - start_velocity);
    const double end_speed = length(velocity - end_velocity);
    const double fastest = std::max(start_speed, end_speed);
    if (!(fastest > 0.0)) return std::nullopt;
    const double reach = disc.radius + capsule.radius;
    const double near = 1e-12 * (reach + fastest * horizon);
    // The least steps, of the horizon; in them the disc goes no further than a share of its reach.
    const double most = reach > 0.0 ? 1e-2 * reach / fastest : horizon;
    const double least_near = std::min(1e-4 * horizon, most);
    const double least_touching = std::min(1e-3 * horizon, most);
    struct Separation {
        double gap;
        double approach;
        Vec2 normal;
    };
    const auto separation_at = [&](double time) -> Separation {
        const Vec2 start = capsule.start + start_velocity * time;
        const Vec2 end = capsule.end + end_velocity * time;
        const Vec2 center = disc.center + velocity * time;
        const double place = closest_parameter(start, end, center);
        const Vec2 relative = velocity - (start_velocity + (end_velocity - start_velocity) * place);
        const Vec2 offset = center - (start + (end - start) * place);
        const Vec2 normal = direction(offset, {});
        return {length(offset) - reach, -dot(relative, normal), normal};
    };
    double before = 0.0;
    double time = 0.0;
    while (true) {
        Separation now = separation_at(time);
        if (now.gap < -near && time > before && separation_at(before).gap > near) {
            // The minimum step overshot the contact: bisect back to it.
            double outside = before;
            for (int i = 0; i < 60 && now.gap < -near; ++i) {
                const double middle = outside + (time - outside) / 2;
                const Separation there = separation_at(middle);
                if (there.gap > near) {
                    outside = middle;
                } else {
                    time = middle;
                    now = there;
                }
            }
        }
        if (now.gap <= near && now.approach > rounding * fastest) return Impact{time, now.normal};
        // Conservative advancement: no point of the capsule approaches faster than `fastest`, so
        // the gap stays open for at least gap / fastest.
        before = time;
        time += now.gap > near ? std::max(now.gap / fastest, least_near) : least_touching;
        if (!(time <= horizon)) return std::nullopt;
    }
}

Capsule turned(const Capsule& capsule, const HingeTurn& turn, double time) {
    const auto [sine, cosine] = sin_cos(turn.rate * time);
    Capsule moved = capsule;
    for (Vec2* const end : {&moved.start, &moved.end}) {
        const Vec2 arm = *end - turn.pivot;
        *end = turn.pivot + arm * cosine + perpendicular(arm) * sine;
    }
    return moved;
}

std::optional<Impact> first_impact(const Disc& disc, Vec2 velocity, const Capsule& capsule,
                                   const HingeTurn& turn, double horizon) {
    if (turn.rate == 0.0)
        return without_rounding(first_impact(disc, velocity, capsule, horizon), velocity);
    const double reach = disc.radius + capsule.radius;
    const double rate = std::fabs(turn.rate);
    const double furthest = distance(disc.center, turn.pivot) + length(velocity) * horizon;
    const double fastest = length(velocity) + rate * furthest;
    Vec2 normal;
    const auto separation_at = [&](double time) -> Separation<double> {
        const Capsule now = turned(capsule, turn, time);
        const Vec2 center = disc.center + velocity * time;
        const Vec2 foot = closest_point(now.start, now.end, center);
        normal = direction(center - foot, {});
        const Vec2 surface = perpendicular(foot - turn.pivot) * turn.rate;
        return {distance(center, foot) - reach, dot(velocity - surface, normal), 0.0};
    };
    // The Coriolis and the centrifugal acceleration.
    const double bound = rate * (2.0 * length(velocity) + rate * furthest);
    ToiSearch<double> search;
    const auto time = first_time_of_impact<double>(
        separation_at, 0.0, horizon, bound,
        {1e-12 * (reach + fastest * horizon), rounding * fastest}, search);
    if (!time) return std::nullopt;
    return Impact{*time, normal};
}

}  // namespace carom

#include "lab/observe/region.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

double mean_radius_of_balls(const World& world) {
    const std::vector<double>& radius = world.balls().radius;
    double sum = 0.0;
    for (const double r : radius)
        sum += r;
    return radius.empty() ? 0.0 : sum / static_cast<double>(radius.size());
}

double signed_area(std::span<const Capsule> spines) {
    double twice = 0.0;
    for (const Capsule& spine : spines)
        twice += cross(spine.start - spines.front().start, spine.end - spines.front().start);
    return twice / 2.0;
}

// The area of a polygon with every edge offset inwards by `offset`: A - P d, plus what the strips
// cover twice at a convex corner, minus the sector that they leave out at a reflex one.
double inner_area(std::span<const Capsule> spines, double offset) {
    const double whole = signed_area(spines);
    const double turn_sign = whole < 0.0 ? -1.0 : 1.0;
    double area = std::fabs(whole);
    for (std::size_t i = 0; i < spines.size(); ++i) {
        const Vec2 along = spines[i].end - spines[i].start;
        const Capsule& following = spines[(i + 1) % spines.size()];
        const Vec2 next = following.end - following.start;
        area -= length(along) * offset;
        const double turn = turn_sign * std::atan2(cross(along, next), dot(along, next));
        area += offset * offset * (turn > 0.0 ? std::tan(turn / 2.0) : turn / 2.0);
    }
    return area;
}

// The sides of an upright rectangle; none: it is none.
std::optional<Vec2> rectangle(std::span<const Capsule> spines) {
    if (spines.size() != 4) return std::nullopt;
    Box bounds{spines[0].start, spines[0].start};
    for (const Capsule& spine : spines) {
        if (spine.start.x != spine.end.x && spine.start.y != spine.end.y) return std::nullopt;
        bounds = join(bounds, carom::bounds(Capsule{spine.start, spine.end, 0.0}));
    }
    return size(bounds);
}

std::vector<Capsule> shapes_of(std::span<const CapsuleId> ids, const World& world) {
    std::vector<Capsule> shapes;
    for (const CapsuleId id : ids)
        if (const auto index = index_of(world, id))
            shapes.push_back(world.capsules().shape[*index]);
    return shapes;
}

}  // namespace

bool is_inside(std::span<const Capsule> spines, Vec2 point) {
    bool inside = false;
    for (const Capsule& spine : spines) {
        const bool spans = (spine.start.y > point.y) != (spine.end.y > point.y);
        if (!spans) continue;
        const double share = (point.y - spine.start.y) / (spine.end.y - spine.start.y);
        if (point.x < spine.start.x + share * (spine.end.x - spine.start.x)) inside = !inside;
    }
    return inside;
}

std::optional<Region> region_of(const Scene& scene, const World& world) {
    if (world.model().wrap) {
        const Vec2 sides = size(*world.model().wrap);
        return Region{sides.x * sides.y, sides, true};
    }
    if (scene.outlines.size() != 1) return std::nullopt;
    const std::vector<Capsule> spines = shapes_of(scene.outlines.front(), world);
    if (spines.size() < 3 || spines.size() != scene.outlines.front().size()) return std::nullopt;
    const bool has_all = std::ranges::all_of(world.balls().position,
                                             [&](Vec2 place) { return is_inside(spines, place); });
    if (!has_all) return std::nullopt;
    const double offset = spines.front().radius + mean_radius_of_balls(world);
    Region region{inner_area(spines, offset), rectangle(spines), false};
    if (region.sides) *region.sides -= Vec2{2.0 * offset, 2.0 * offset};
    if (!(region.area > 0.0) || (region.sides && !(region.sides->x > 0.0 && region.sides->y > 0.0)))
        return std::nullopt;
    return region;
}

}  // namespace carom

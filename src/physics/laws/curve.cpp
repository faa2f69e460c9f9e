#include "physics/laws/curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "physics/broad_phase/nearest_image.h"

namespace carom {
namespace {

// An edge is so many times longer than its neighbour: it is straight, and the other one is curved.
constexpr double far_longer = 2.0;

// A joint of a piece, seen along it.
struct Joint {
    Vec2 point;
    Vec2 outwards;        // unit, along the piece, towards the joint
    Vec2 onwards;         // unit, along the other edge, away from it
    double length = 0.0;  // of the other edge
};

// The unit vector from `point`, which is an end of the edge, to its other end; and its length.
std::optional<std::pair<Vec2, double>> direction_from(Vec2 point, const Capsule& edge) {
    Vec2 far = edge.end;
    if (edge.end == point)
        far = edge.start;
    else if (!(edge.start == point))
        return std::nullopt;
    const double size = distance(far, point);
    if (!(size > 0.0)) return std::nullopt;
    return std::pair((far - point) / size, size);
}

// The joint at the start (0) or the end (1) of an edge, if there is one.
std::optional<Joint> joint_of(const World& world, std::size_t capsule, std::size_t end) {
    const Capsules& capsules = world.capsules();
    const CapsuleId id = capsules.joints[capsule][end];
    if (id == no_joint) return std::nullopt;
    const auto other = index_of(world, id);
    if (!other) return std::nullopt;
    const Capsule& shape = capsules.shape[capsule];
    const Vec2 point = end == 0 ? shape.start : shape.end;
    const auto own = direction_from(point, shape);
    const auto theirs = direction_from(point, capsules.shape[*other]);
    if (!own || !theirs) return std::nullopt;
    return Joint{point, -own->first, theirs->first, theirs->second};
}

// The normal of the curve at a joint, on the side of `normal`, which is that of the piece: that of
// the circle through the three ends. Pre: the piece has this length.
Vec2 normal_at(const Joint& joint, Vec2 normal, double size) {
    if (size > far_longer * joint.length) return normal;
    Vec2 theirs = perpendicular(joint.onwards);
    if (dot(theirs, normal) < 0.0) theirs = -theirs;
    if (joint.length > far_longer * size) return theirs;
    const Vec2 between = normal * joint.length + theirs * size;
    return between / length(between);
}

// The normal of the curve where the ball touches the piece, among the places where the centre of a
// ball can be; none where the ball is larger than the curve.
std::optional<Vec2> normal_between(const Capsule& shape, const std::array<Vec2, 2>& normals,
                                   Vec2 position, const CurveImpact& impact) {
    const auto place = [&](Vec2 point, Vec2 normal) {
        return point + normal * (impact.reach / dot(normal, impact.normal));
    };
    const Vec2 first = place(shape.start, normals[0]);
    const Vec2 span = place(shape.end, normals[1]) - first;
    if (!(dot(span, shape.end - shape.start) > 0.0)) return std::nullopt;
    const double share = std::clamp(dot(position - first, span) / length_squared(span), 0.0, 1.0);
    const Vec2 normal = normals[0] * (1.0 - share) + normals[1] * share;
    return normal / length(normal);
}

// The image of the place on a torus that is nearest to the edge.
Vec2 seen_from(const World& world, const Capsule& edge, Vec2 place) {
    if (!world.model().wrap) return place;
    const Vec2 middle = (edge.start + edge.end) * 0.5;
    return middle + nearest_image(world, place - middle);
}

// Whether the ball comes from the other edge of the joint, straight along it.
bool comes_along(const Joint& joint, Vec2 velocity, double speed) {
    constexpr double hair = 1e-6;
    return dot(velocity, joint.onwards) < 0.0 &&
           std::abs(cross(velocity, joint.onwards)) <= hair * speed;
}

}  // namespace

CurveBounce curve_bounce(const World& world, std::size_t capsule, const CurveImpact& impact) {
    const Capsule& shape = world.capsules().shape[capsule];
    const Vec2 along = shape.end - shape.start;
    const double size = length(along);
    const double speed = length(impact.velocity);
    const double approach = -dot(impact.velocity, impact.normal);
    if (!(size > 0.0) || !(approach > 0.0)) return {};
    const Vec2 position = seen_from(world, shape, impact.position);
    double turn = 0.0;  // sine of the larger one
    bool is_near = false;
    bool slides_on = false;
    std::array<Vec2, 2> normals{impact.normal, impact.normal};
    for (std::size_t end = 0; end < 2; ++end) {
        const auto joint = joint_of(world, capsule, end);
        if (!joint) continue;
        if (dot(joint->point - position, joint->outwards) > joint_reach * joint->length) continue;
        is_near = true;
        turn = std::max(turn, std::abs(cross(joint->outwards, joint->onwards)));
        slides_on = slides_on || comes_along(*joint, impact.velocity, speed);
        normals[end] = normal_at(*joint, impact.normal, size);
    }
    if (!is_near) return {};
    using enum CurveBounce::Way;
    const bool is_flat = approach <= flat_turns * turn * speed;
    if (is_flat && (impact.restitution < 1.0 || slides_on)) return {rolls_on, {}, true};
    constexpr double oblique = 1e-9;
    const bool is_side = std::abs(dot(impact.normal, along)) <= oblique * size;
    if (const auto normal =
            is_side ? normal_between(shape, normals, position, impact) : std::nullopt) {
        const double into = -dot(impact.velocity, *normal);
        const Vec2 after = impact.velocity + *normal * ((1.0 + impact.restitution) * into);
        if (into > 0.0 && dot(after, impact.normal) > 0.0) return {bounces, *normal, is_flat};
    }
    return {is_flat ? rolls_on : as_usual, {}, is_flat};
}

bool can_join(const Capsule& one, const Capsule& other, Vec2 point) {
    constexpr double sine_of_20_degrees = 0.34202014332566871;
    if (one.radius != other.radius) return false;
    const auto own = direction_from(point, one);
    const auto theirs = direction_from(point, other);
    return own && theirs && dot(own->first, theirs->first) < 0.0 &&
           std::abs(cross(own->first, theirs->first)) <= sine_of_20_degrees;
}

}  // namespace carom

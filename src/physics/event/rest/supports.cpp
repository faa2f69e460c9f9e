#include "physics/event/rest/supports.h"

#include <algorithm>
#include <tuple>

#include "physics/event/motion/edge_impact.h"
#include "physics/event/motion/tolerances.h"

namespace carom {

template <typename Real>
const std::vector<Support<Real>>& Supports<Real>::of(std::uint32_t ball, bool also_moving) {
    const LinearPart<Real>& line = balls_[ball].line;
    const Real size = balls_.radius(ball);
    sides_.clear();
    points_.clear();
    bars_.clear();
    // Moving balls may be apart by the height of a bounce that loses no energy.
    const Real near = size * Real(also_moving ? 4.0 * moving_rest_height : contact_slop);
    space_.for_each_edge_near(ball, [&](std::uint32_t capsule, Vec2 shift, int across, int along) {
        add_edge(line, size, near, capsule, shift,
                 {SupportId::Kind::edge, static_cast<std::int8_t>(across),
                  static_cast<std::int8_t>(along), number(scene_.world->capsules().id[capsule])});
    });
    space_.for_each_ball_near(ball, [&](std::uint32_t other, int across, int along) {
        if (!scene_.balls_collide(ball, other)) return;
        if (!also_moving && balls_[other].line.motion != Motion::resting) return;
        add_ball(line, size, near, other,
                 {SupportId::Kind::ball, static_cast<std::int8_t>(across),
                  static_cast<std::int8_t>(along), number(scene_.world->balls().id[other])});
    });
    // By number: the cells must not show.
    for (std::vector<Support<Real>>* const some : {&points_, &bars_}) {
        std::sort(some->begin(), some->end(), [](const Support<Real>& a, const Support<Real>& b) {
            const auto key = [](const SupportId& id) {
                return std::tuple(id.kind, id.number, id.across, id.along);
            };
            return key(a.id) < key(b.id);
        });
        sides_.insert(sides_.end(), some->begin(), some->end());
    }
    return sides_;
}

// Adds the support to `bearing`, or to bars_ where gravity does not press the ball on it, unless
// the ball would rise from it.
template <typename Real>
void Supports<Real>::add(const LinearPart<Real>& line, const Real& size, Support<Real>& support,
                         std::vector<Support<Real>>& bearing) {
    const Vector<Real>& gravity = scene_.field.gravity;
    const Real press = -dot(gravity, support.normal);
    support.bears_weight = press > Real(component_rounding<Real>) * length(gravity);
    const Real pressing = support.bears_weight ? press : length(gravity);
    const Real rate = dot(line.velocity, support.normal);
    const Real rounding = Real(component_rounding<Real>) * length(line.velocity);
    if (absolute(rate) <= rounding || rate * rate <= Real(2.0 * rest_height) * pressing * size)
        (support.bears_weight ? bearing : bars_).push_back(support);
}

template <typename Real>
void Supports<Real>::add_edge(const LinearPart<Real>& line, const Real& size, const Real& near,
                              std::uint32_t capsule, Vec2 shift, SupportId id) {
    const Edge<Real> edge(scene_.world->capsules().shape[capsule], shift);
    const auto contact = contact_with(edge, line.position, size);
    const Real rounding = Real(gap_roundings) * rounding_at(line.position, size + edge.radius);
    if (contact.gap > near + rounding || !scene_.is_solid(capsule, line.position, shift)) return;
    Support<Real> support;
    support.id = id;
    support.center = edge.start;
    if (!edge.is_point()) {
        const Vector<Real> span = edge.end - edge.start;
        const Real whole = length(span);
        const Vector<Real> direction = span / whole;
        const Real place = dot(direction, line.position - edge.start);
        const Real slack = (near + rounding) * Real(4.0);
        const Vector<Real> left = perpendicular(direction);
        const Vector<Real> normal = dot(left, line.position - edge.start) < Real{} ? -left : left;
        // At an end, the direction in which the ball goes decides whether it is beside the edge.
        Real speed = dot(direction, line.velocity);
        if (absolute(speed) <= Real(component_rounding<Real>) * length(line.velocity))
            speed = dot(direction, scene_.field.gravity);
        const bool is_side = (place > slack && place < whole - slack) ||
                             (place >= -slack && place <= slack && speed > Real{}) ||
                             (place >= whole - slack && place <= whole + slack && speed < Real{});
        if (is_side) {
            support.center = {};
            support.normal = normal;
            support.is_side = true;
            return add(line, size, support, sides_);
        }
        support.center = place < whole * Real(0.5) ? edge.start : edge.end;
    }
    const Vector<Real> arm = line.position - support.center;
    const Real distance = length(arm);
    if (!(distance > Real{})) return;
    support.normal = arm / distance;
    add(line, size, support, points_);
}

template <typename Real>
void Supports<Real>::add_ball(const LinearPart<Real>& line, const Real& size, const Real& near,
                              std::uint32_t other, SupportId id) {
    Support<Real> support;
    support.center =
        trajectories_.state_now(other).position + scene_.image_shift(id.across, id.along);
    const Vector<Real> arm = line.position - support.center;
    const Real distance = length(arm);
    const Real reach = size + balls_.radius(other);
    if (!(distance > Real{}) ||
        distance - reach > near + Real(gap_roundings) * rounding_at(line.position, reach))
        return;
    support.normal = arm / distance;
    support.id = id;
    add(line, size, support, points_);
}

template <typename Real>
std::optional<Support<Real>> Supports<Real>::barrier_to(std::uint32_t ball,
                                                        const Vector<Real>& velocity,
                                                        const Vector<Real>& acceleration) const {
    const Vector<Real>& position = balls_[ball].line.position;
    const Real size = balls_.radius(ball);
    std::optional<Support<Real>> found;
    space_.for_each_edge_near(ball, [&](std::uint32_t capsule, Vec2 shift, int across, int along) {
        const Edge<Real> edge(scene_.world->capsules().shape[capsule], shift);
        const auto contact = contact_with(edge, position, size);
        const Real near = size * Real(contact_slop) +
                          Real(gap_roundings) * rounding_at(position, size + edge.radius);
        if (found || contact.gap > near || !scene_.is_solid(capsule, position, shift)) return;
        const Real press = -dot(acceleration, contact.normal);
        if (!(press > Real(pressing_share) * length(acceleration))) return;
        const Real rate = dot(velocity, contact.normal);
        if (rate * rate > Real(wedge_rest_heights * rest_height) * press * size) return;
        Support<Real> support;
        support.normal = contact.normal;
        support.id = {SupportId::Kind::edge, static_cast<std::int8_t>(across),
                      static_cast<std::int8_t>(along),
                      number(scene_.world->capsules().id[capsule])};
        found = support;
    });
    return found;
}

template class Supports<double>;
template class Supports<DoubleDouble>;

}  // namespace carom

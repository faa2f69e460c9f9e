#include "game/commands/picking.h"

#include <algorithm>

#include "geometry/closest.h"
#include "physics/broad_phase/nearest_image.h"

namespace carom {
namespace {

/// Keeps the nearest of the candidates offered; the earlier one in a tie.
template <typename T>
class Nearest {
  public:
    explicit Nearest(double limit) : limit_(limit) {}

    /// `distance` is compared with the limit; `then` breaks ties.
    void offer(const T& what, double distance, double then = 0.0) {
        if (distance > limit_) return;
        if (found_ && (distance > distance_ || (distance == distance_ && then >= then_))) return;
        found_ = what;
        distance_ = distance;
        then_ = then;
    }
    std::optional<T> found() const { return found_; }

  private:
    double limit_;
    double distance_ = 0.0;
    double then_ = 0.0;
    std::optional<T> found_;
};

/// The image of `point` that is nearest to the edge.
Vec2 beside(const World& world, const Capsule& edge, Vec2 point) {
    const Vec2 middle = (edge.start + edge.end) * 0.5;
    return middle + offset(world, middle, point);
}

const Capsule& shape(const World& world, CapsuleId id) {
    return world.capsules().shape[*index_of(world, id)];
}

EdgeGrip grip_ends(const World& world, const std::vector<EdgeEnd>& ends, Vec2 hand) {
    EdgeGrip grip{{}, hand};
    for (const EdgeEnd& end : ends) {
        if (grip.parts.empty() || grip.parts.back().capsule != end.capsule) {
            const Capsule& edge = shape(world, end.capsule);
            grip.parts.push_back({end.capsule, edge.start, edge.end, false, false});
        }
        (end.is_end ? grip.parts.back().moves_end : grip.parts.back().moves_start) = true;
    }
    return grip;
}

template <typename Move>
std::vector<Command> for_each_part(const World& world, const EdgeGrip& grip, Vec2 hand) {
    const Vec2 way = hand - grip.taken_at;
    std::vector<Command> commands;
    for (const EdgeGrip::Part& part : grip.parts) {
        if (!index_of(world, part.capsule)) continue;
        commands.push_back(Move{part.capsule, part.moves_start ? part.start + way : part.start,
                                part.moves_end ? part.end + way : part.end});
    }
    return commands;
}

}  // namespace

Vec2 offset(const World& world, Vec2 a, Vec2 b) {
    return nearest_image(world, b - a);
}

std::optional<BallId> ball_at(const World& world, Vec2 point, double slack) {
    Nearest<BallId> nearest(slack);
    const Balls& balls = world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double from_center = length(offset(world, balls.position[i], point));
        nearest.offer(balls.id[i], std::max(0.0, from_center - balls.radius[i]), from_center);
    }
    return nearest.found();
}

Vec2 position(const World& world, const EdgeEnd& end) {
    const Capsule& edge = shape(world, end.capsule);
    return end.is_end ? edge.end : edge.start;
}

std::optional<EdgeEnd> edge_end_at(const World& world, Vec2 point, double slack) {
    Nearest<EdgeEnd> nearest(slack);
    const Capsules& capsules = world.capsules();
    for (std::size_t i = 0; i < capsules.size(); ++i) {
        const Capsule& edge = capsules.shape[i];
        for (const bool is_end : {false, true}) {
            const double from_center = length(offset(world, is_end ? edge.end : edge.start, point));
            nearest.offer({capsules.id[i], is_end}, std::max(0.0, from_center - edge.radius),
                          from_center);
        }
    }
    return nearest.found();
}

std::optional<CapsuleId> edge_at(const World& world, Vec2 point, double slack) {
    Nearest<CapsuleId> nearest(slack);
    const Capsules& capsules = world.capsules();
    for (std::size_t i = 0; i < capsules.size(); ++i) {
        const Capsule& edge = capsules.shape[i];
        const double apart = separation(Disc{beside(world, edge, point), 0.0}, edge);
        nearest.offer(capsules.id[i], std::max(0.0, apart), apart);
    }
    return nearest.found();
}

std::vector<EdgeEnd> joint(const World& world, const EdgeEnd& end) {
    const Vec2 place = position(world, end);
    std::vector<EdgeEnd> ends;
    const Capsules& capsules = world.capsules();
    for (std::size_t i = 0; i < capsules.size(); ++i) {
        if (capsules.shape[i].start == place) ends.push_back({capsules.id[i], false});
        if (capsules.shape[i].end == place) ends.push_back({capsules.id[i], true});
    }
    return ends;
}

std::optional<BallId> next_ball(const World& world, std::optional<BallId> from, bool backwards) {
    const std::vector<BallId>& ids = world.balls().id;
    if (ids.empty()) return std::nullopt;
    if (!from) return backwards ? ids.back() : ids.front();
    if (backwards) {
        const auto place = std::ranges::lower_bound(ids, *from);
        return place == ids.begin() ? ids.back() : *(place - 1);
    }
    const auto place = std::ranges::upper_bound(ids, *from);
    return place == ids.end() ? ids.front() : *place;
}

EdgeGrip grip_joint(const World& world, const EdgeEnd& end, Vec2 hand) {
    return grip_ends(world, joint(world, end), hand);
}

EdgeGrip grip_edge(const World& world, CapsuleId capsule, Vec2 hand) {
    std::vector<EdgeEnd> ends = joint(world, {capsule, false});
    if (const Capsule& edge = shape(world, capsule); !(edge.start == edge.end)) {
        const std::vector<EdgeEnd> others = joint(world, {capsule, true});
        ends.insert(ends.end(), others.begin(), others.end());
        std::ranges::sort(ends, {}, &EdgeEnd::capsule);
    }
    return grip_ends(world, ends, hand);
}

std::vector<Command> carry(const World& world, const EdgeGrip& grip, Vec2 hand) {
    return for_each_part<command::HoldCapsule>(world, grip, hand);
}

std::vector<Command> place(const World& world, const EdgeGrip& grip, Vec2 hand) {
    return for_each_part<command::PlaceCapsule>(world, grip, hand);
}

std::vector<Command> drop(const World& world, const EdgeGrip& grip) {
    std::vector<Command> commands;
    for (const EdgeGrip::Part& part : grip.parts)
        if (is_held(world, part.capsule)) commands.push_back(command::DropCapsule{part.capsule});
    return commands;
}

}  // namespace carom

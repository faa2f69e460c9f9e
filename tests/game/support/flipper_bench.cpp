#include "game/support/flipper_bench.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/closest.h"

namespace carom::test {
namespace {

constexpr double degrees = 180.0 / 3.14159265358979323846;

bool is_flipper(const World& world, std::size_t capsule) {
    return std::ranges::any_of(world.flippers(), [&](const Flipper& flipper) {
        return flipper.capsule == world.capsules().id[capsule];
    });
}

// Edges that a ball on the table meets.
bool stands(const World& world, std::size_t capsule) {
    if (is_flipper(world, capsule)) return false;
    const ClassIndex material = world.capsules().material[capsule];
    if (!world.model().filtered) return true;
    const std::size_t classes = world.kinds().size() + world.materials().size();
    return world.definition()
               .meets[world.balls().kind[0] * classes + world.kinds().size() + material] != 0;
}

/// An edge, from its lower end on the chain to its upper one.
struct Link {
    std::size_t capsule = 0;
    Vec2 low;
    Vec2 high;
};

std::optional<Link> first_link(const World& world, const Flipper& flipper, Vec2 pivot,
                               double thickness) {
    const double ball = world.balls().radius[0];
    std::optional<Link> best;
    double nearest = thickness + ball;
    for (std::size_t i = 0; i < world.capsules().size(); ++i) {
        if (!stands(world, i)) continue;
        const Capsule& shape = world.capsules().shape[i];
        for (const bool flipped : {false, true}) {
            const Vec2 low = flipped ? shape.end : shape.start;
            const Vec2 high = flipped ? shape.start : shape.end;
            // Behind the pivot, and above it.
            if (!(dot(high - low, flipper.rest) < -ball)) continue;
            if (distance(low, pivot) >= nearest) continue;
            nearest = distance(low, pivot);
            best = Link{i, low, high};
        }
    }
    return best;
}

std::optional<Link> next_link(const World& world, const Link& link) {
    for (std::size_t i = 0; i < world.capsules().size(); ++i) {
        if (i == link.capsule || !stands(world, i)) continue;
        const Capsule& shape = world.capsules().shape[i];
        if (shape.start == link.high && shape.end != link.low) return Link{i, link.high, shape.end};
        if (shape.end == link.high && shape.start != link.low)
            return Link{i, link.high, shape.start};
    }
    return std::nullopt;
}

// The gap between a ball here and the nearest edge that does not belong to the guide.
double gap_to_others(const World& world, const std::vector<std::size_t>& guide, Vec2 at) {
    double gap = 1e9;
    for (std::size_t i = 0; i < world.capsules().size(); ++i)
        if (stands(world, i) && std::ranges::count(guide, i) == 0)
            gap = std::min(
                gap, separation(Disc{at, world.balls().radius[0]}, world.capsules().shape[i]));
    return gap;
}

double gap_to_guide(const World& world, const std::vector<std::size_t>& guide, Vec2 at) {
    double gap = 1e9;
    for (const std::size_t i : guide)
        gap =
            std::min(gap, separation(Disc{at, world.balls().radius[0]}, world.capsules().shape[i]));
    return gap;
}

}  // namespace

std::vector<Inlane> inlanes_of(const Scene& scene) {
    const World& world = scene.world;
    std::vector<Inlane> found;
    const double ball = world.balls().radius[0];
    for (std::size_t f = 0; f < world.flippers().size(); ++f) {
        const Flipper& flipper = world.flippers()[f];
        const Capsule& shape = world.capsules().shape[*index_of(world, flipper.capsule)];
        Inlane lane{.flipper = f, .guide = {}, .starts = {}};
        std::vector<Link> chain;
        double whole = 0.0;
        for (auto link = first_link(world, flipper, shape.start, shape.radius);
             link && chain.size() < 400; link = next_link(world, *link)) {
            if (std::ranges::count(lane.guide, link->capsule) > 0) break;
            chain.push_back(*link);
            lane.guide.push_back(link->capsule);
            whole += distance(link->low, link->high);
        }
        if (whole < 4.0 * ball) continue;
        const double side = flipper.sweep > 0.0 ? 1.0 : -1.0;
        for (const Link& link : chain) {
            const Vec2 along = direction(link.high - link.low, {0.0, 1.0});
            const Vec2 out = perpendicular(along) * -side;  // into the lane
            const double reach = world.capsules().shape[link.capsule].radius + ball;
            const double length = distance(link.low, link.high);
            const int places = std::max(1, static_cast<int>(length / (0.75 * ball)));
            for (int i = 0; i < places; ++i) {
                const Vec2 touching =
                    link.low + along * (length * (i + 0.5) / places) + out * reach;
                double room = 0.0;
                const double most = 3.0 * ball;
                while (room < most && gap_to_others(world, lane.guide, touching + out * room) > 0.0)
                    room += 0.0005;
                if (room <= 0.0005) continue;
                // Without a wall above it, a lane is what lies on its guide.
                for (const double share : {0.0, 0.5, 1.0}) {
                    if (room >= most && share > 0.0) continue;
                    const Vec2 at = touching + out * (0.0001 + share * (room - 0.0006));
                    if (gap_to_guide(world, lane.guide, at) > 0.0 &&
                        separation(Disc{at, ball}, shape) > 0.0)
                        lane.starts.push_back(at);
                }
            }
        }
        if (!lane.starts.empty()) found.push_back(std::move(lane));
    }
    return found;
}

FlipperBench::FlipperBench(const Scene& scene, const Inlane& lane, Vec2 at, Vec2 velocity)
    : lane_(&lane), world_(scene.world), solver_(pick_solver(scene.world).settings) {
    while (world_.balls().size() > 1)
        remove_ball(world_, world_.balls().id[1]);
    place(at, velocity);
}

FlipperBench::FlipperBench(const Inlane& lane, World world, double time)
    : lane_(&lane), world_(std::move(world)), solver_(pick_solver(world_).settings), time_(time) {}

FlipperBench FlipperBench::fork() const {
    return {*lane_, world_, time_};
}

void FlipperBench::place(Vec2 at, Vec2 velocity) {
    world_.edit_balls().position[0] = at;
    world_.edit_balls().velocity[0] = velocity;
    if (world_.model().spin) world_.edit_balls().spin[0] = 0.0;
}

void FlipperBench::settle_flipper(bool is_up) {
    Flipper& flipper = world_.edit_flippers()[lane_->flipper];
    const std::size_t capsule = *index_of(world_, flipper.capsule);
    flipper.is_pressed = is_up;
    flipper.progress = is_up ? 1.0 : 0.0;
    flipper.rate = 0.0;
    Capsule& shape = world_.edit_capsules().shape[capsule];
    shape.end = flipper_end(flipper, shape.start, flipper.progress);
}

void FlipperBench::press(bool is_down) {
    world_.edit_flippers()[lane_->flipper].is_pressed = is_down;
}

void FlipperBench::press_other(bool is_down) {
    world_.edit_flippers()[other()].is_pressed = is_down;
}

void FlipperBench::tick() {
    solver_.tick(world_);
    time_ += world_.tick_length();
}

void FlipperBench::run(double seconds) {
    const auto ticks = static_cast<int>(std::lround(seconds * world_.rate()));
    for (int i = 0; i < ticks; ++i)
        tick();
}

Capsule FlipperBench::shape_of(std::size_t flipper) const {
    return world_.capsules().shape[*index_of(world_, world_.flippers()[flipper].capsule)];
}

std::size_t FlipperBench::other() const {
    const Vec2 pivot = shape_of(lane_->flipper).start;
    std::size_t nearest = lane_->flipper;
    for (std::size_t i = 0; i < world_.flippers().size(); ++i)
        if (i != lane_->flipper &&
            (nearest == lane_->flipper ||
             distance(shape_of(i).start, pivot) < distance(shape_of(nearest).start, pivot)))
            nearest = i;
    return nearest;
}

double FlipperBench::along() const {
    const Capsule shape = shape_of(lane_->flipper);
    const Vec2 span = shape.end - shape.start;
    return dot(at() - shape.start, span) / dot(span, span);
}

double FlipperBench::gap() const {
    return separation(Disc{at(), world_.balls().radius[0]}, shape_of(lane_->flipper));
}

double FlipperBench::gap_to_lane() const {
    return std::min(gap(), gap_to_guide(world_, lane_->guide, at()));
}

bool FlipperBench::is_on_other() const {
    const Capsule shape = shape_of(other());
    const Vec2 span = shape.end - shape.start;
    const double along = dot(at() - shape.start, span) / dot(span, span);
    const double side = cross(span, at() - shape.start) * world_.flippers()[other()].sweep;
    return separation(Disc{at(), world_.balls().radius[0]}, shape) < 0.0003 && side > 0.0 &&
           along > 0.0 && along < 0.95;
}

bool FlipperBench::is_above_flipper() const {
    const Capsule shape = shape_of(lane_->flipper);
    const double side = cross(shape.end - shape.start, at() - shape.start);
    return flipper().sweep > 0.0 ? side > 0.0 : side < 0.0;
}

double FlipperBench::direction() const {
    const double side = flipper().sweep > 0.0 ? 1.0 : -1.0;
    return std::atan2(side * velocity().x, velocity().y) * degrees;
}

Vec2 FlipperBench::flipper_at(double along) const {
    const Capsule shape = shape_of(lane_->flipper);
    return shape.start + (shape.end - shape.start) * along;
}

Vec2 FlipperBench::rest_at(double along) const {
    const Capsule shape = shape_of(lane_->flipper);
    const double side = flipper().sweep > 0.0 ? 1.0 : -1.0;
    const double reach = shape.radius + world_.balls().radius[0];
    return shape.start + flipper().rest * (flipper().length * along) +
           perpendicular(flipper().rest) * (side * (reach + 1e-6));
}

}  // namespace carom::test

#include "physics/tick/emitters_and_sinks.h"

#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "physics/broad_phase/nearest_image.h"
#include "physics/world/columns.h"
#include "physics/world/random.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

// Random draw 0..3 for ball `n` of an emitter, in -1..1.
double jitter(const World& world, std::size_t emitter, std::uint32_t n, std::uint32_t draw) {
    return random_between(-1.0, 1.0, world.seed(), RandomStream::emitter, emitter,
                          std::uint64_t{n} * 4 + draw);
}

bool is_free(const World& world, ClassIndex kind, Vec2 place) {
    if (!world.model().ball_ball) return true;
    const double radius = world.kinds()[kind].radius;
    const Balls& balls = world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Vec2 offset = nearest_image(world, balls.position[i] - place);
        const double reach = balls.radius[i] + radius;
        if (length_squared(offset) < reach * reach && kinds_meet(world, kind, balls.kind[i]))
            return false;
    }
    return true;
}

bool is_sink(const Zone& zone) {
    return zone.effect == Zone::Effect::sink;
}

}  // namespace

void emit(World& world) {
    const double end = static_cast<double>(world.tick() + 1) / world.rate();
    for (std::size_t e = 0; e < world.emitters().size(); ++e) {
        Emitter& emitter = world.edit_emitters()[e];
        while (emitter.emitted < emitter.count && emitter.emitted * emitter.every < end) {
            const std::uint32_t n = emitter.emitted;
            const Vec2 place = emitter.at + Vec2{emitter.jitter.x * jitter(world, e, n, 0),
                                                 emitter.jitter.y * jitter(world, e, n, 1)};
            if (!is_free(world, emitter.kind, place)) break;
            const Vec2 velocity =
                emitter.velocity + Vec2{emitter.velocity_jitter.x * jitter(world, e, n, 2),
                                        emitter.velocity_jitter.y * jitter(world, e, n, 3)};
            add_ball(world, {.kind = emitter.kind,
                             .position = place,
                             .velocity = velocity,
                             .radius = {},
                             .mass = {},
                             .restitution = {}});
            ++emitter.emitted;
        }
    }
}

void stop_slow_balls(World& world, const std::vector<std::uint8_t>& touched) {
    if (!world.model().stop_speed) return;
    const double limit = *world.model().stop_speed * *world.model().stop_speed;
    Balls& balls = SolverAccess(world).balls();
    bool any_stopped = false;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (!(length_squared(balls.velocity[i]) < limit)) continue;
        if (world.model().gravity && !touched[i]) continue;
        bool moves = !(balls.velocity[i] == Vec2{});
        if (world.model().spin) {
            const double rim = balls.spin[i] * balls.radius[i];
            if (!(rim * rim < limit)) continue;
            if (world.model().cloth && !(length_squared(balls.roll[i]) < limit)) continue;
            moves = moves || balls.spin[i] != 0.0;
            balls.spin[i] = 0.0;
        }
        if (world.model().cloth) {
            moves = moves || !(balls.roll[i] == Vec2{});
            balls.roll[i] = {};
        }
        any_stopped = any_stopped || moves;
        balls.velocity[i] = {};
    }
    if (any_stopped) SolverAccess(world).stamp_motion();
}

void SinkDrain::Gap::leave_out(double low, double high, double middle) {
    if (low < middle) after = std::max(after, high);
    if (!(high < middle)) before = std::min(before, low);
}

void SinkDrain::take_sinks(const World& world) {
    definition_ = world.stamps().definition;
    has_sinks_ = false;
    across_ = along_ = {};
    Vec2 sum;
    double count = 0.0;
    for (const Zone& zone : world.zones()) {
        if (!is_sink(zone)) continue;
        has_sinks_ = true;
        sum += zone.shape.start;
        ++count;
    }
    const Vec2 middle = sum / std::max(count, 1.0);
    for (const Zone& zone : world.zones()) {
        if (!is_sink(zone)) continue;
        const Box box = bounds(zone.shape);
        across_.leave_out(box.low.x, box.high.x, middle.x);
        along_.leave_out(box.low.y, box.high.y, middle.y);
    }
}

void SinkDrain::drain(World& world) {
    if (definition_ != world.stamps().definition) take_sinks(world);
    if (!has_sinks_) return;
    const Balls& balls = world.balls();
    std::size_t first = 0;
    while (first < balls.size() &&
           (along_.contains(balls.position[first].y) || across_.contains(balls.position[first].x)))
        ++first;
    if (first == balls.size()) return;
    std::vector<std::uint8_t> gone;
    for (std::size_t z = 0; z < world.zones().size(); ++z) {
        const Zone& zone = world.zones()[z];
        if (!is_sink(zone)) continue;
        const Box box = bounds(zone.shape);
        for (std::size_t i = first; i < balls.size(); ++i) {
            if (!contains(box, balls.position[i]) || !is_inside(zone.shape, balls.position[i]))
                continue;
            if (gone.empty()) gone.assign(balls.size(), 0);
            if (gone[i]) continue;
            gone[i] = 1;
            ++world.edit_ledger().counters[zone.counter];
            world.edit_ledger().removed.push_back(
                {.id = balls.id[i], .zone = static_cast<std::int32_t>(z), .tick = world.tick()});
        }
    }
    if (gone.empty()) return;
    std::erase_if(world.edit_held_balls(), [&](const HeldBall& held) {
        const auto index = index_of(world, held.id);
        return index && gone[*index];
    });
    erase_rows(world.edit_balls(), gone);
}

int substeps_needed(const World& world, int wanted) {
    if (!world.model().wrap) return wanted;
    const Vec2 torus = size(*world.model().wrap);
    double fastest = 0.0;
    for (const Vec2 velocity : world.balls().velocity)
        fastest = std::max(fastest, length_squared(velocity));
    double speed = std::sqrt(fastest);
    if (world.model().gravity) speed += length(*world.model().gravity) * world.tick_length();
    const double furthest = std::min(torus.x, torus.y) / 8.0;
    const double needed = std::ceil(speed * world.tick_length() / furthest);
    return std::max(wanted, static_cast<int>(std::min(needed, 10'000.0)));
}

}  // namespace carom

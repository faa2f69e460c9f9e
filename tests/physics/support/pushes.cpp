#include "physics/support/pushes.h"

#include <algorithm>
#include <cmath>

#include "physics/support/dice.h"
#include "physics/support/scenes.h"

namespace carom::pushes {
namespace {

constexpr int most_ticks = 150;

double kinetic_energy(const World& world) {
    const Balls& balls = world.balls();
    double sum = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double mass = 1.0 / balls.inverse_mass[i];
        sum += 0.5 * mass * length_squared(balls.velocity[i]);
        if (!world.model().spin) continue;
        const double inertia = *world.model().spin * mass;
        const double rim = balls.spin[i] * balls.radius[i];
        sum += 0.5 * inertia * rim * rim;
        if (world.model().cloth) sum += 0.5 * inertia * length_squared(balls.roll[i]);
    }
    return sum;
}

// 0 at the floor.
double potential_energy(const World& world) {
    const Vec2 gravity = world.model().gravity.value_or(Vec2{});
    double sum = 0.0;
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        sum -= dot(gravity, world.balls().position[i]) / world.balls().inverse_mass[i];
    return sum;
}

double fastest(const World& world) {
    double most = 0.0;
    for (const Vec2 velocity : world.balls().velocity)
        most = std::max(most, length(velocity));
    return most;
}

Vec2 nearest_on(const Capsule& edge, Vec2 place) {
    const Vec2 span = edge.end - edge.start;
    const double square = length_squared(span);
    const double at =
        square > 0.0 ? std::clamp(dot(place - edge.start, span) / square, 0.0, 1.0) : 0.0;
    return edge.start + span * at;
}

// In radii, of all pairs.
double overlap_of(const World& world) {
    const Balls& balls = world.balls();
    double most = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double reach = balls.radius[i] + balls.radius[j];
            const double small = std::min(balls.radius[i], balls.radius[j]);
            most = std::max(most, (reach - distance(balls.position[i], balls.position[j])) / small);
        }
        for (const Capsule& edge : world.capsules().shape) {
            const double reach = balls.radius[i] + edge.radius;
            const double away = distance(balls.position[i], nearest_on(edge, balls.position[i]));
            most = std::max(most, (reach - away) / balls.radius[i]);
        }
    }
    return most;
}

// On which side of each edge each ball is, while it is beside it; 0 elsewhere.
double side_of(const Capsule& edge, Vec2 place) {
    const Vec2 span = edge.end - edge.start;
    const double at = dot(place - edge.start, span);
    if (at < 0.0 || at > length_squared(span)) return 0.0;
    return cross(span, place - edge.start) < 0.0 ? -1.0 : 1.0;
}

int count_passed(const World& before, const World& after) {
    int count = 0;
    for (std::size_t i = 0; i < after.balls().size(); ++i)
        for (std::size_t e = 0; e < after.capsules().size(); ++e) {
            const double was = side_of(before.capsules().shape[e], before.balls().position[i]);
            const double is = side_of(after.capsules().shape[e], after.balls().position[i]);
            if (was * is < 0.0) ++count;
        }
    return count;
}

}  // namespace

Push random_push(std::uint64_t number, bool with_cloth) {
    Dice dice{number * 0x2545f4914f6cdd1du + 12345};
    Push push;
    push.world = scenes::empty();
    World& world = push.world;
    Model& model = world.edit_definition().model;
    push.restitution = dice.chance(0.2) ? 0.0 : dice.between(0.0, 0.5);
    const bool has_gravity = !with_cloth && dice.chance(0.6);
    const bool has_friction = with_cloth || dice.chance(0.3);
    const double mu = dice.between(0.05, 0.6);
    if (has_gravity) model.gravity = Vec2{0.0, -10.0};
    model.inelastic = true;
    if (has_friction) model.spin = with_cloth ? 0.4 : 0.5;
    if (with_cloth)
        model.cloth = Cloth{.slide = dice.between(1.0, 3.0),
                            .roll = dice.between(0.05, 0.3),
                            .spin = dice.between(0.2, 1.0)};
    world.edit_definition().rate = std::round(dice.scaled(60.0, 1000.0));
    world.edit_definition().kinds = {
        {.radius = 1.0, .mass = 1.0, .restitution = push.restitution, .friction = mu}};
    world.edit_definition().materials = {{.restitution = push.restitution, .friction = mu}};
    const double wide = dice.between(12.0, 40.0);
    const double high = 24.0;
    const double thick = dice.chance(0.5) ? 0.0 : 0.5;
    add_capsule(world, {{-2.0, 0.0}, {wide + 2.0, 0.0}, thick}, 0);
    add_capsule(world, {{0.0, -2.0}, {0.0, high}, thick}, 0);
    const double floor = thick;
    const double shake = dice.chance(0.5) ? 0.0 : dice.scaled(1e-6, 2.0);
    const auto put = [&](Vec2 place, double radius) {
        add_ball(world, {.position = place,
                         .velocity = {dice.between(-shake, shake), dice.between(-shake, shake)},
                         .radius = radius});
    };
    const int what = dice.below(3);
    push.speed = dice.scaled(0.1, 30.0);
    if (what == 0) {
        push.name = "row";
        const int count = 3 + dice.below(10);
        const double gap = dice.chance(0.3) ? 0.0 : dice.scaled(1e-6, 1.0);
        const double off = dice.chance(0.5) ? 0.0 : dice.scaled(1e-9, 0.3);
        double x = thick + 1.0;
        for (int i = 0; i < count && x + 2.0 < wide; ++i, x += 2.0 + gap)
            put({x, floor + 1.0 + (has_gravity ? 0.0 : dice.between(0.0, off))}, 1.0);
    } else {
        push.name = what == 1 ? "heap" : "bucket";
        const double spread = dice.chance(0.5) ? 0.0 : 0.3;
        double y = floor + 1.4;
        const int rows = 2 + dice.below(4);
        for (int row = 0; row < rows; ++row, y += 2.7)
            for (double x = thick + 1.4 + (row % 2) * 0.6; x + 2.5 < wide; x += 2.7)
                if (!dice.chance(0.15))
                    put({x + dice.between(-0.05, 0.05), y + dice.between(-0.05, 0.05)},
                        1.0 + dice.between(-spread, spread));
    }
    double most_right = 0.0;
    double most_high = 0.0;
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const Vec2 place = world.balls().position[i];
        most_right = std::max(most_right, place.x + world.balls().radius[i]);
        most_high = std::max(most_high, place.y + world.balls().radius[i]);
    }
    // No more ticks than a test has time for: slow hands begin near the balls.
    const double reach = push.speed * most_ticks / world.rate();
    const double gap = dice.between(0.0, 0.3) * reach;
    const double side = std::min(wide, std::max(thick + 2.5, most_right + thick + gap));
    const double top = std::min(high - 1.0, most_high + thick + gap);
    const CapsuleId right =
        add_capsule(world, {{side, floor + thick + 0.01}, {side, high}, thick}, 0);
    const double way = std::min(dice.between(0.3, 1.0) * side, reach);
    push.edges = {right};
    push.ways = {{-way, 0.0}};
    if (what == 2) {
        // A lid comes down, or the hand turns as it goes.
        const CapsuleId lid =
            add_capsule(world, {{thick + 0.01, top}, {side * 0.9, top}, thick}, 0);
        const bool also_right = dice.chance(0.5);
        if (!also_right) {
            push.edges = {lid};
            push.ways = {{0.0, -std::min(way, top)}};
        } else {
            push.edges.push_back(lid);
            push.ways = {{-0.05 * side, 0.0}, {0.0, -std::min(way, top)}};
        }
    }
    double longest = 0.0;
    for (const Vec2 each : push.ways)
        longest = std::max(longest, length(each));
    push.ticks = static_cast<int>(longest / push.speed * world.rate()) + 1;
    return push;
}

Result run(const Push& push, SolverKind kind, bool is_measured_without) {
    Result result;
    World world = push.world;
    World undisturbed = push.world;
    Solver solver({.kind = kind});
    Solver other({.kind = kind});
    const double gravity = length(world.model().gravity.value_or(Vec2{}));
    double may = 0.0;
    const double start = kinetic_energy(world) + potential_energy(world);
    double most_energy = start;
    const int hand_ticks = std::min(push.ticks, most_ticks);
    std::vector<Vec2> begin_start;
    std::vector<Vec2> begin_end;
    for (std::size_t h = 0; h < push.edges.size(); ++h) {
        const std::size_t index = *index_of(world, push.edges[h]);
        begin_start.push_back(world.capsules().shape[index].start);
        begin_end.push_back(world.capsules().shape[index].end);
    }
    const int hold = hand_ticks + 30;
    for (int tick = 0; tick < hold; ++tick) {
        const double share = static_cast<double>(std::min(tick + 1, hand_ticks)) / push.ticks;
        std::vector<HeldCapsule> held;
        for (std::size_t h = 0; h < push.edges.size(); ++h)
            held.push_back({push.edges[h], begin_start[h] + push.ways[h] * share,
                            begin_end[h] + push.ways[h] * share});
        world.edit_held_capsules() = held;
        may = std::max({may, fastest(world), push.speed,
                        gravity > 0.0 ? std::sqrt(2.0 * gravity * 24.0) : 0.0});
        const World before = world;
        const double energy_before = kinetic_energy(world) + potential_energy(world);
        solver.tick(world);
        double work = 0.0;
        const auto add_work = [&](const Contact& contact) {
            if (contact.kind != ContactKind::ball_edge) return;
            for (std::size_t h = 0; h < push.edges.size(); ++h) {
                if (contact.b != number(push.edges[h])) continue;
                const double part = world.hands().share;
                const Vec2 along = push.ways[h] / length(push.ways[h]);
                work +=
                    contact.impulse * std::max(0.0, dot(contact.normal, along) * push.speed * part);
            }
        };
        for (const Contact& contact : solver.contacts())
            add_work(contact);
        for (const Contact& contact : solver.pressing())
            add_work(contact);
        const double energy = kinetic_energy(world) + potential_energy(world);
        most_energy = std::max(most_energy, energy);
        result.gain = std::max(result.gain, (energy - energy_before - work) / most_energy);
        result.passed += count_passed(before, world);
        result.speed = std::max(result.speed, fastest(world) / may);
        result.overlap = std::max(result.overlap, overlap_of(world));
        ++result.ticks;
        if (is_measured_without) {
            other.tick(undisturbed);
            result.without = std::max(result.without, overlap_of(undisturbed));
        }
    }
    for (std::size_t h = 0; h < push.edges.size(); ++h) {
        const Capsule& shape = world.capsules().shape[*index_of(world, push.edges[h])];
        const double share = static_cast<double>(hand_ticks) / push.ticks;
        result.lag =
            std::max(result.lag, distance(shape.start, begin_start[h] + push.ways[h] * share));
    }
    return result;
}

}  // namespace carom::pushes

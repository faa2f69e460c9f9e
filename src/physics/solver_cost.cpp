#include "physics/solver_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/shapes.h"

namespace carom {
namespace {

// Operations of a solver: measured over the levels that ship and 180 random scenes.
struct Rates {
    double tick;     ///< a tick, whatever is in it
    double flight;   ///< a ball that flies, a tick
    double gravity;  ///< more, under gravity
    double curve;    ///< more, on paths that are no parabolas
    double special;  ///< more, with collision filters, kicks or one-way edges
    double one_way;  ///< more, with one-way edges
    double hit;      ///< an impact
    double rest;     ///< a ball that lies on others, a tick
    double deep;     ///< more, in a deep heap
};
constexpr Rates discrete_rates{250, 18, 2, 0, 10, 0, 200, 60, 40};
constexpr Rates substep_rates{300, 30, 2, 0, 15, 0, 300, 200, 1300};
constexpr Rates swept_rates{450, 50, 5, 5, 40, 20, 450, 300, 3500};
constexpr Rates contact_rates{500, 90, 20, 10, 40, 20, 600, 450, 450};
constexpr Rates event_rates{200, 10, 25, 700, 150, 1200, 500, 450, 1900};
// A scene is judged by its first seconds, as `carom run` computes them by default.
constexpr double first_seconds = 10.0;

// The share of the costs of a tick that every further substep or update costs again.
constexpr double substep_share = 0.5;
constexpr double contact_substep_share = 0.15;

double growth_of(const Load& load) {
    return 1.0 + load.path / load.radius;
}

double power(double base, double exponent) {  // base >= 1; infinite beyond doubles
    double result = 1.0;
    for (double done = 0.0; done < exponent && result < 1e300; done += 1.0)
        result *= base;
    return result;
}

Box extent_of(const World& world) {
    if (world.model().wrap) return *world.model().wrap;
    constexpr double far = std::numeric_limits<double>::infinity();
    Box box{{far, far}, {-far, -far}};
    const auto add = [&](Vec2 p) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    };
    for (const Capsule& capsule : world.capsules().shape) {
        add(capsule.start);
        add(capsule.end);
    }
    for (const Vec2 position : world.balls().position)
        add(position);
    return box;
}

// The time, s, until balls lie on one another, after a fall of `fall` s and its bounces. Fitted to
// within 10 % to 12 balls with a restitution of 0.4 to 0.9, friction of 0.03 to 0.8, or drag of 0.2
// to 2 /s. Slip counts as restitution that is lower by half the friction, at most by 0.1.
double settling_time(const World& world, double fall) {
    const Model& model = world.model();
    const Balls& balls = world.balls();
    const double count = static_cast<double>(balls.size());
    double lost = balls.size() == 0 ? 0.5 : 0.0;  // of the speed, at an impact
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (model.inelastic) lost += (1.0 - balls.restitution[i]) / count;
        if (model.spin) lost += std::min(0.1, 0.5 * world.kinds()[balls.kind[i]].friction) / count;
    }
    const double bounces = 0.25 * (2.0 - lost) / std::max(1e-3, lost);
    return 1.0 / (1.0 / (fall * (1.0 + bounces)) + model.drag.value_or(0.0) / 7.0);
}

}  // namespace

Load load_of(const World& world) {
    const Model& model = world.model();
    const Balls& balls = world.balls();
    Load load;
    load.balls = static_cast<double>(balls.size());
    double squares = 0.0;
    double radii = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        squares += dot(balls.velocity[i], balls.velocity[i]);
        radii += balls.radius[i];
    }
    for (const Emitter& emitter : world.emitters()) {
        const double count = static_cast<double>(emitter.count - emitter.emitted);
        load.balls += count;
        squares += count * dot(emitter.velocity, emitter.velocity);
        radii += count * world.kinds()[emitter.kind].radius;
    }
    if (load.balls > 0.0) load.radius = radii / load.balls;
    const Box extent = extent_of(world);
    const double width = std::max(extent.high.x - extent.low.x, 2.0 * load.radius);
    const double height = std::max(extent.high.y - extent.low.y, 2.0 * load.radius);
    const double pull = model.gravity ? length(*model.gravity) : 0.0;
    const double square = squares / std::max(load.balls, 1.0) + pull * height;
    load.speed = std::sqrt(square);
    if (model.speed_limit) load.speed = std::min(load.speed, *model.speed_limit);
    // 2 sqrt(2) r n v for balls, and v / (pi A / perimeter) for walls.
    const double area = width * height;
    const double of_balls = model.ball_ball ? 2.83 * load.radius * load.balls / area : 0.0;
    const double of_walls = model.ball_edge && !world.capsules().shape.empty()
                                ? 2.0 * (width + height) / (3.14 * area)
                                : 0.0;
    load.hits = load.speed * (of_balls + of_walls);
    load.path = of_balls + of_walls > 0.0 ? 1.0 / (of_balls + of_walls) : 0.0;
    bool drains = false;
    for (const Zone& zone : world.zones())
        drains = drains || zone.effect == Zone::Effect::sink;
    // They lie on one another if not all fit beside one another on the floor, after a fall through
    // half the scene and its bounces.
    const double row = std::max(width, 2.0 * load.radius);
    if (pull > 0.0 && loses_energy(model) && model.ball_ball && !drains && 2.0 * radii > row) {
        const double settling = settling_time(world, std::sqrt(height / pull));
        load.rest = std::max(0.0, 1.0 - settling / first_seconds);
        load.depth = std::min(1.0, 2.0 * radii / row / 4.0);
    }
    load.is_straight = !model.gravity && !model.drag;
    load.is_curved = model.drag || model.speed_limit;
    load.is_one_way = model.one_way;
    load.is_special = model.ball_ball && (model.filtered || model.kicks || model.one_way);
    return load;
}

double predicted_work(const SolverSettings& solver, const World& world, const Load& load) {
    const auto work = [&](const Rates& rates) {
        const double flying =
            rates.flight + (world.model().gravity ? rates.gravity : 0.0) +
            (load.is_curved ? rates.curve : 0.0) + (load.is_special ? rates.special : 0.0) +
            (load.is_one_way ? rates.one_way : 0.0) + load.hits / world.rate() * rates.hit;
        const double lying = rates.rest + load.depth * rates.deep;
        return rates.tick + load.balls * ((1.0 - load.rest) * flying + load.rest * lying);
    };
    switch (solver.kind) {
        case SolverKind::discrete:
            return work(discrete_rates);
        case SolverKind::substep:
            return work(substep_rates) * (1.0 + substep_share * (solver.updates - 4) / 4.0);
        case SolverKind::swept:
            return work(swept_rates) * (1.0 + substep_share * (solver.substeps - 1));
        case SolverKind::contact:
            if (load.is_straight && !world.model().inelastic) return work(swept_rates) * 1.05;
            return work(contact_rates) *
                   (1.0 + contact_substep_share * (solver.contact_substeps - 4));
        default:
            return work(event_rates);
    }
}

double predicted_error(const SolverSettings& solver, const World& world, const Load& load,
                       double time) {
    constexpr double rounding = 1e-15;
    const Model& model = world.model();
    const double growth = power(growth_of(load), load.hits * time);
    const auto grown = [&](double first) { return std::max(first, rounding) * growth; };
    const double tick = world.tick_length();
    const auto after_steps = [&](double steps) {
        const double h = tick / steps;
        const double pull = model.gravity ? length(*model.gravity) : 0.0;
        const double bend = pull + model.drag.value_or(0.0) * load.speed;
        return bend * h * h / 8.0 / load.radius;
    };
    switch (solver.kind) {
        case SolverKind::discrete:
            return grown(load.speed * tick / load.radius);
        case SolverKind::substep:
            return grown(load.speed * tick / solver.updates / load.radius);
        case SolverKind::swept:
            return grown(load.is_straight ? 0.0 : after_steps(solver.substeps));
        case SolverKind::contact:
            return grown(
                load.is_straight && !model.inelastic ? 0.0 : after_steps(solver.contact_substeps));
        default:
            return grown(0.0);
    }
}

}  // namespace carom

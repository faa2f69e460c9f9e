#include <algorithm>
#include <cmath>

#include "physics/swept/response.h"
#include "physics/swept/tolerances.h"

// What it costs to lift a ball that rests, in the solver `swept`.
//
// A ball that rests feels no gravity towards its supports for the rest of the substep. Where it
// rises with them, or leaves them, gravity would do no work on it. So the energy of a ball counts
// the whole lift of its path at the time at which the path starts:
//
//     kinetic + potential + m b . d, where it is positive
//
// with d the displacement of the rest of the path, and b the gravity that the supports bear,
// upwards. Between impacts the sum changes by losses alone, and no impact may let that of all balls
// grow. What an impact adds to lifts is paid by what it has taken, else by those that lift.
namespace carom {

// The energy that the supports of the ball give it if it goes on at `velocity`.
double SweptResponse::lift(std::uint32_t ball, Vec2 velocity, double now) const {
    const SweptPath& path = paths_[ball];
    if (!path.is_resting || path.is_frozen || paths_.is_held(ball)) return 0.0;
    const double rise = dot(velocity, paths_.rest(ball).borne);
    return std::max(0.0, rise) * (step_.duration - now) / paths_.inverse_mass(ball);
}

double SweptResponse::lifts(const BallImpact& impact) const {
    return lift(impact.a, impact.velocity_a, impact.now) +
           lift(impact.b, impact.velocity_b, impact.now);
}

// The kinetic energy that a change of velocity takes.
double SweptResponse::energy_lost(std::uint32_t ball, Vec2 before, Vec2 after) const {
    if (paths_.is_held(ball)) return 0.0;
    return 0.5 * dot(before - after, before + after) / paths_.inverse_mass(ball);
}

double SweptResponse::energy_lost(const BallImpact& before, const BallImpact& after) const {
    return energy_lost(before.a, before.velocity_a, after.velocity_a) +
           energy_lost(before.b, before.velocity_b, after.velocity_b);
}

// A lift at a speed that is rounding.
double SweptResponse::lift_by_rounding(std::uint32_t ball, Vec2 velocity, double now) const {
    if (paths_.is_held(ball)) return 0.0;
    const double speed = length(velocity) + step_.rest_speed;
    return swept_tolerance::rounding * speed * length(step_.gravity) * (step_.duration - now) /
           paths_.inverse_mass(ball);
}

// The ball pays for its lift with the speed at which it rises.
void SweptResponse::pay(std::uint32_t ball, double now, Vec2& velocity) const {
    if (!(lift(ball, velocity, now) > 0.0)) return;
    const Vec2 borne = paths_.rest(ball).borne;
    const double size = length(borne);
    const Vec2 up = borne / size;
    const double rise = dot(velocity, up);
    const double fall = size * (step_.duration - now);
    velocity += up * (rise * rise / (std::sqrt(rise * rise + fall * fall) + fall) - rise);
}

void SweptResponse::pay_for_lifts(BallImpact& impact, const BallImpact& before, double most) const {
    const double rounding = lift_by_rounding(impact.a, before.velocity_a, impact.now) +
                            lift_by_rounding(impact.b, before.velocity_b, impact.now);
    if (!(lifts(impact) > most + rounding)) return;
    const BallImpact unpaid = impact;
    weigh_on(impact, before);
    if (!(lifts(impact) > most + energy_lost(unpaid, impact) + rounding)) return;
    pay(impact.a, impact.now, impact.velocity_a);
    pay(impact.b, impact.now, impact.velocity_b);
}

// A ball that comes to rest between two edges leaves one for the other by ever less: these lifts do
// not count.
void SweptResponse::pay_for_lift(EdgeImpact& impact, Vec2 before, double most,
                                 double radius) const {
    const std::uint32_t ball = impact.ball;
    const double after = lift(ball, impact.velocity, impact.now);
    if (!(after > most + lift_by_rounding(ball, before, impact.now))) return;
    const double low = swept_tolerance::uncounted_lift * radius * length(step_.gravity) /
                       paths_.inverse_mass(ball);
    if (after > low) pay(ball, impact.now, impact.velocity);
}

// The weight of the ball that rests on the other one acts for the rest of the substep at once, on
// both: they leave at one speed along the normal, which is no longer that of the lower ball alone.
// A lower ball that rests gives way along its support. By symplectic steps as this one no energy is
// gained: (P^2 - q^2) / (2 (M + m)), with P the momentum before and q the weight's.
void SweptResponse::weigh_on(BallImpact& impact, const BallImpact& before) const {
    const bool is_a_above = -dot(impact.normal, step_.gravity) > 0.0;
    const std::uint32_t upper = is_a_above ? impact.a : impact.b;
    const std::uint32_t lower = is_a_above ? impact.b : impact.a;
    const Vec2 normal = is_a_above ? impact.normal : -impact.normal;
    Vec2& above = is_a_above ? impact.velocity_a : impact.velocity_b;
    Vec2& below = is_a_above ? impact.velocity_b : impact.velocity_a;
    if (!paths_[upper].is_resting || paths_[lower].is_frozen || paths_[upper].is_frozen) return;
    const double rise = dot(below, normal);
    if (!(rise > 0.0)) return;
    Vec2 way = normal;
    if (paths_[lower].is_resting) {
        const Vec2 support = paths_.rest(lower).support;
        if (!(dot(below, support) > swept_tolerance::resting_restitution * step_.rest_speed))
            way = perpendicular(support);
    }
    const double share = dot(way, normal);
    const double heavy = paths_.inverse_mass(lower) * share * share;
    const double light = paths_.inverse_mass(upper);
    const double was_above = dot(is_a_above ? before.velocity_a : before.velocity_b, normal);
    const double was_below = dot(is_a_above ? before.velocity_b : before.velocity_a, normal);
    const double weight = dot(paths_.rest(upper).borne, normal) * (step_.duration - impact.now);
    const double both =
        std::clamp((was_below * light + (was_above - weight) * heavy) / (heavy + light), 0.0, rise);
    Vec2 slower = below + way * ((both - rise) / share);
    if (!(length_squared(slower) <= length_squared(below))) slower = below + normal * (both - rise);
    below = slower;
    above += normal * (both - dot(above, normal));
}

}  // namespace carom

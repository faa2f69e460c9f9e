#include "physics/event/trajectory.h"

#include <array>
#include <bit>

#include "geometry/elementary.h"
#include "physics/broad_phase/capsule_cells.h"

namespace carom {
namespace {

// Of a step of s seconds under drag k: e^-ks, (1 - e^-ks) / ks and what is left of 1 over ks.
template <typename Real>
struct Decay {
    Real all;
    Real mean;
    Real ramp;
};

Decay<double> decay_over(double exponent) {
    return {exponential(-exponent), mean_decay(exponent), mean_decay_ramp(exponent)};
}

Decay<Wide> decay_over(const Wide& exponent) {
    if (exponent < Wide(0.5)) {
        // ramp = sum of (-x)^n / (n + 2)!
        Wide term(0.5);
        Wide ramp(0.5);
        for (int n = 1; n < 30; ++n) {
            term = term * -exponent / Wide(n + 2.0);
            ramp += term;
        }
        const Wide mean = Wide(1.0) - exponent * ramp;
        return {Wide(1.0) - exponent * mean, mean, ramp};
    }
    const Decay<Wide> half = decay_over(exponent * Wide(0.5));
    const Wide all = half.all * half.all;
    const Wide mean = (Wide(1.0) - all) / exponent;
    return {all, mean, (Wide(1.0) - mean) / exponent};
}

template <typename Real>
constexpr int series_length = 15;
template <>
constexpr int series_length<Wide> = 28;

// Sine and cosine of a small angle.
template <typename Real>
Vector<Real> cos_sin(const Real& angle) {
    const Real square = angle * angle;
    Real cosine(1.0);
    Real sine = angle;
    Real even(1.0);
    Real odd = angle;
    for (int n = 2; n < 2 * series_length<Real>; n += 2) {
        even = even * -square / Real(n * (n - 1.0));
        odd = odd * -square / Real(n * (n + 1.0));
        cosine += even;
        sine += odd;
        if (absolute(even) < Real(precision<Real> * 1e-3)) break;
    }
    return {cosine, sine};
}

template <typename Real>
struct AngleAndRate {
    Real angle{};
    Real rate{};
};

// angle' = rate, rate' = along - drag rate, along' = -outward rate, outward' = along rate, where
// along and outward are gravity's parts over the radius.
template <typename Real>
AngleAndRate<Real> swing(Real rate, Real along, Real outward, const Real& drag, const Real& since) {
    constexpr int length = series_length<Real>;
    std::array<Real, length> r{rate};
    std::array<Real, length> a{along};
    std::array<Real, length> o{outward};
    AngleAndRate<Real> result{{}, rate};
    Real power(1.0);
    for (int n = 0; n + 1 < length; ++n) {
        Real a_sum{};
        Real o_sum{};
        for (int i = 0; i <= n; ++i) {
            a_sum += o[i] * r[n - i];
            o_sum += a[i] * r[n - i];
        }
        const Real next(n + 1.0);
        r[n + 1] = (a[n] - drag * r[n]) / next;
        a[n + 1] = -a_sum / next;
        o[n + 1] = o_sum / next;
        power = power * since;
        result.angle += r[n] * power / next;
        result.rate += r[n + 1] * power;
    }
    return result;
}

}  // namespace

EventPath<double> path_from(const BallPath& stored, const PathBend& bend) {
    EventPath<double> path;
    path.time = stored.time;
    path.position = Vector<double>(stored.position);
    path.velocity = Vector<double>(stored.velocity);
    path.acceleration = Vector<double>(bend.acceleration);
    path.center = Vector<double>(bend.center);
    path.motion = stored.motion;
    path.support = bend.support;
    path.second_support = bend.second_support;
    path.quick = stored.quick;
    return path;
}

PathBend stored_bend(const World& world, const EventPath<double>& path) {
    return {.acceleration = Vec2(path.acceleration),
            .center = Vec2(path.center),
            .support = path.support,
            .second_support = path.second_support,
            .carriers = path.motion == Motion::free
                            ? 0
                            : sum_of_carriers(world, path.support, path.second_support)};
}

namespace {

std::uint64_t stirred_edge(std::uint64_t sum, const World& world, std::size_t index) {
    const Capsule& shape = world.capsules.shape[index];
    const Side side = world.model.one_way ? world.capsules.side[index] : Side::both;
    // 0 and -0 are the same place.
    const Vec2 start = shape.start + Vec2{};
    const Vec2 end = shape.end + Vec2{};
    sum = stirred(stirred(stirred(sum, start), end), shape.radius);
    return stirred(sum, static_cast<std::uint64_t>(side));
}

}  // namespace

std::uint32_t sum_of_carriers(const World& world, const PathSupport& support,
                              const PathSupport& second) {
    std::uint64_t sum = 0;
    for (const PathSupport& by : {support, second}) {
        if (by.by != PathSupport::By::edge) continue;
        sum = stirred(sum, std::uint64_t{by.number});
        const auto index = index_of(world, CapsuleId{by.number});
        if (!index || is_held(world, CapsuleId{by.number})) continue;
        sum = stirred_edge(sum, world, *index);
    }
    return static_cast<std::uint32_t>(sum >> 32);
}

std::uint64_t sum_of_obstacles(const World& world) {
    std::uint64_t sum = static_cast<std::uint64_t>(world.model.ball_edge);
    for (std::size_t i = 0; i < world.capsules.size(); ++i) {
        if (is_held(world, world.capsules.id[i])) continue;
        sum = stirred(stirred_edge(sum, world, i), std::uint64_t{world.capsules.material[i]});
    }
    for (const double radius : world.balls.radius)
        sum = stirred(sum, radius);
    if (world.model.filtered)
        for (const std::uint8_t meets : world.meets)
            sum = stirred(sum, std::uint64_t{meets});
    return sum | 1;
}

std::uint64_t sum_of(const BallPath& path, const PathBend& bend) {
    std::uint64_t sum = sum_of(path);
    if (path.motion == Motion::free) return sum;
    sum = stirred(stirred(sum, bend.center), bend.acceleration);
    for (const PathSupport& by : {bend.support, bend.second_support})
        sum = stirred(sum, static_cast<std::uint64_t>(by.by) |
                               std::uint64_t{static_cast<std::uint8_t>(by.across)} << 8 |
                               std::uint64_t{static_cast<std::uint8_t>(by.along)} << 16 |
                               std::uint64_t{by.number} << 32);
    return stirred(sum, std::uint64_t{bend.carriers});
}

template <typename Real>
Turn<Real> turn_at(const EventPath<Real>& path, const Field<Real>& field, const Real& time) {
    const Vector<Real> arm = path.position - path.center;
    const Real radius = length(arm);
    const Vector<Real> normal = arm / radius;
    const Vector<Real> along = perpendicular(normal);
    const auto [angle, rate] =
        swing(dot(along, path.velocity) / radius, dot(along, field.gravity) / radius,
              dot(normal, field.gravity) / radius, field.has_drag ? field.drag : Real{},
              time - path.time);
    const Vector<Real> turned = cos_sin(angle);
    Turn<Real> turn;
    turn.radius = radius;
    turn.normal = normal * turned.x + along * turned.y;
    turn.speed = rate * radius;
    turn.press = -dot(turn.normal, field.gravity) - rate * rate * radius;
    return turn;
}

template <typename Real>
Real piece_end(const EventPath<Real>& path, const Field<Real>& field) {
    // |rate| s + pull s^2 / 2 = 0.05, by the root without cancellation.
    const Real most(0.05);
    const Real radius = length(path.position - path.center);
    const Real rate = length(path.velocity) / radius;
    const Real pull = length(field.gravity) / radius;
    return path.time +
           Real(2.0) * most / (rate + square_root(rate * rate + Real(2.0) * pull * most));
}

template <typename Real>
BallState<Real> state_at(const EventPath<Real>& path, const Field<Real>& field, const Real& time) {
    const Real since = time - path.time;
    if (path.motion == Motion::turning) {
        const Turn<Real> turn = turn_at(path, field, time);
        return {path.center + turn.normal * turn.radius, perpendicular(turn.normal) * turn.speed};
    }
    if (field.has_drag && path.motion != Motion::held) {
        const Decay<Real> decay = decay_over(field.drag * since);
        return {path.position + path.velocity * (since * decay.mean) +
                    path.acceleration * (since * since * decay.ramp),
                path.velocity * decay.all + path.acceleration * (since * decay.mean)};
    }
    return {parabola_at(path, time), path.velocity + path.acceleration * since};
}

template <typename Real>
Real most_acceleration(const EventPath<Real>& path, const Field<Real>& field, const Real& time) {
    if (path.motion == Motion::turning) {
        const Turn<Real> now = turn_at(path, field, time);
        const Real speed =
            absolute(now.speed) + length(field.gravity) * (piece_end(path, field) - time);
        Real most = length(field.gravity) + speed * speed / now.radius;
        if (field.has_drag) most += field.drag * speed;
        return most;
    }
    Real most = length(path.acceleration);
    if (field.has_drag && path.motion != Motion::held) {
        const Real speed = length(state_at(path, field, time).velocity);
        const Real limit = most / field.drag;
        most += field.drag * (speed > limit ? speed : limit);
    }
    return most;
}

template BallState<double> state_at(const EventPath<double>&, const Field<double>&, const double&);
template BallState<Wide> state_at(const EventPath<Wide>&, const Field<Wide>&, const Wide&);
template double most_acceleration(const EventPath<double>&, const Field<double>&, const double&);
template Wide most_acceleration(const EventPath<Wide>&, const Field<Wide>&, const Wide&);
template Turn<double> turn_at(const EventPath<double>&, const Field<double>&, const double&);
template Turn<Wide> turn_at(const EventPath<Wide>&, const Field<Wide>&, const Wide&);
template double piece_end(const EventPath<double>&, const Field<double>&);
template Wide piece_end(const EventPath<Wide>&, const Field<Wide>&);

}  // namespace carom

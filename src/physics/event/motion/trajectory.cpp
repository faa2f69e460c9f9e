#include "physics/event/motion/trajectory.h"

#include <array>

#include "geometry/elementary.h"
#include "physics/event/motion/tolerances.h"

namespace carom {
namespace {

// Under drag k for s seconds: e^-ks, (1 - e^-ks) / ks, and (1 - mean) / ks.
template <typename Real>
struct Decay {
    Real all;
    Real mean;
    Real ramp;
};

Decay<double> decay_over(double exponent) {
    return {exponential(-exponent), mean_decay(exponent), mean_decay_ramp(exponent)};
}

Decay<DoubleDouble> decay_over(const DoubleDouble& exponent) {
    if (exponent < DoubleDouble(0.5)) {
        // ramp = sum of (-x)^n / (n + 2)!
        DoubleDouble term(0.5);
        DoubleDouble ramp(0.5);
        for (int n = 1; n < 30; ++n) {
            term = term * -exponent / DoubleDouble(n + 2.0);
            ramp += term;
        }
        const DoubleDouble mean = DoubleDouble(1.0) - exponent * ramp;
        return {DoubleDouble(1.0) - exponent * mean, mean, ramp};
    }
    const Decay<DoubleDouble> half = decay_over(exponent * DoubleDouble(0.5));
    const DoubleDouble all = half.all * half.all;
    const DoubleDouble mean = (DoubleDouble(1.0) - all) / exponent;
    return {all, mean, (DoubleDouble(1.0) - mean) / exponent};
}

template <typename Real>
constexpr int series_length = 15;
template <>
constexpr int series_length<DoubleDouble> = 28;

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

// The Taylor series of a pendulum: angle' = rate, rate' = along - drag rate, along' = -outward
// rate, outward' = along rate, with along and outward the components of gravity over the radius.
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

template <typename Real>
Field<Real> field_of(const Model& model) {
    Field<Real> field;
    field.gravity = Vector<Real>(model.gravity.value_or(Vec2{}) + Vec2{});  // + 0 clears -0
    field.has_drag = model.drag.has_value();
    field.drag = Real(model.drag.value_or(0.0));
    if (loses_energy(model)) field.pressing = length(field.gravity);
    return field;
}

template <typename Real>
Turn<Real> turn_at(const Trajectory<Real>& trajectory, const Field<Real>& field, const Real& time) {
    const Vector<Real> arm = trajectory.position - trajectory.center;
    const Real radius = length(arm);
    const Vector<Real> normal = arm / radius;
    const Vector<Real> along = perpendicular(normal);
    const auto [angle, rate] =
        swing(dot(along, trajectory.velocity) / radius, dot(along, field.gravity) / radius,
              dot(normal, field.gravity) / radius, field.has_drag ? field.drag : Real{},
              time - trajectory.time);
    const Vector<Real> turned = cos_sin(angle);
    Turn<Real> turn;
    turn.radius = radius;
    turn.normal = normal * turned.x + along * turned.y;
    turn.speed = rate * radius;
    turn.press = -dot(turn.normal, field.gravity) - rate * rate * radius;
    return turn;
}

template <typename Real>
Real piece_end(const Trajectory<Real>& trajectory, const Field<Real>& field) {
    // |rate| s + pull s^2 / 2 = most_piece_angle, by the root without cancellation.
    const Real most(most_piece_angle);
    const Real radius = length(trajectory.position - trajectory.center);
    const Real rate = length(trajectory.velocity) / radius;
    const Real pull = length(field.gravity) / radius;
    const Real piece =
        Real(2.0) * most / (rate + square_root(rate * rate + Real(2.0) * pull * most));
    if (field.has_drag && field.drag * piece > Real(most_piece_decay))
        return trajectory.time + Real(most_piece_decay) / field.drag;
    return trajectory.time + piece;
}

template <typename Real>
BallState<Real> state_at(const Trajectory<Real>& trajectory, const Field<Real>& field,
                         const Real& time) {
    const Real since = time - trajectory.time;
    if (trajectory.motion == Motion::turning) {
        const Turn<Real> turn = turn_at(trajectory, field, time);
        return {trajectory.center + turn.normal * turn.radius,
                perpendicular(turn.normal) * turn.speed};
    }
    if (field.has_drag && trajectory.motion != Motion::held) {
        const Decay<Real> decay = decay_over(field.drag * since);
        return {trajectory.position + trajectory.velocity * (since * decay.mean) +
                    trajectory.acceleration * (since * since * decay.ramp),
                trajectory.velocity * decay.all + trajectory.acceleration * (since * decay.mean)};
    }
    return {parabola_at(trajectory, time), trajectory.velocity + trajectory.acceleration * since};
}

template <typename Real>
Real most_acceleration(const Trajectory<Real>& trajectory, const Field<Real>& field,
                       const Real& time) {
    if (trajectory.motion == Motion::turning) {
        const Turn<Real> now = turn_at(trajectory, field, time);
        const Real speed =
            absolute(now.speed) + length(field.gravity) * (piece_end(trajectory, field) - time);
        Real most = length(field.gravity) + speed * speed / now.radius;
        if (field.has_drag) most += field.drag * speed;
        return most;
    }
    Real most = length(trajectory.acceleration);
    if (field.has_drag && trajectory.motion != Motion::held) {
        const Real speed = length(state_at(trajectory, field, time).velocity);
        const Real limit = most / field.drag;
        most += field.drag * (speed > limit ? speed : limit);
    }
    return most;
}

template Field<double> field_of(const Model&);
template Field<DoubleDouble> field_of(const Model&);
template BallState<double> state_at(const Trajectory<double>&, const Field<double>&, const double&);
template BallState<DoubleDouble> state_at(const Trajectory<DoubleDouble>&,
                                          const Field<DoubleDouble>&, const DoubleDouble&);
template double most_acceleration(const Trajectory<double>&, const Field<double>&, const double&);
template DoubleDouble most_acceleration(const Trajectory<DoubleDouble>&, const Field<DoubleDouble>&,
                                        const DoubleDouble&);
template Turn<double> turn_at(const Trajectory<double>&, const Field<double>&, const double&);
template Turn<DoubleDouble> turn_at(const Trajectory<DoubleDouble>&, const Field<DoubleDouble>&,
                                    const DoubleDouble&);
template double piece_end(const Trajectory<double>&, const Field<double>&);
template DoubleDouble piece_end(const Trajectory<DoubleDouble>&, const Field<DoubleDouble>&);

}  // namespace carom

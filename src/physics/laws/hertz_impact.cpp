#include "physics/laws/hertz_impact.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr double steps_in_shortest = 128.0;
constexpr double most_steps_in_longest = 16384.0;
constexpr double least_steps_in_shortest = 32.0;
// An impact runs through a chain of touching balls in less than half of a contact for each.
constexpr std::size_t longest_at_least = 64;
constexpr std::size_t longest_by_body = 4;

// By Newton's method, from a power of two that is at most twice too large or too small. Pre: x > 0.
template <typename Real>
Real fifth_root(const Real& x) {
    constexpr int iterations = 24;
    int exponent = 0;
    std::frexp(static_cast<double>(x), &exponent);
    Real root(std::ldexp(1.0, exponent / 5));
    for (int i = 0; i < iterations; ++i) {
        const Real square = root * root;
        root = (Real(4.0) * root + x / (square * square)) / Real(5.0);
    }
    return root;
}

template <typename Real>
Real reduced_mass(const ImpactContact<Real>& contact, std::span<const ImpactBody<Real>> bodies) {
    return Real(1.0) / (bodies[contact.a].inverse_mass + bodies[contact.b].inverse_mass);
}

}  // namespace

template <typename Real>
Real hertz_stiffness(const Real& modulus, const Real& radius_a, const Real& radius_b) {
    const Real radius = radius_a * radius_b / (radius_a + radius_b);
    return Real(2.0) / Real(3.0) * modulus * square_root(radius);
}

template <typename Real>
Real hertz_duration(const Real& stiffness, const Real& mass, const Real& speed) {
    // The depth d at which k d^2.5 / 2.5 is the kinetic energy; then 2 d / speed times the integral
    // of 1 / sqrt(1 - x^2.5) from 0 to 1.
    constexpr double shape = 2.94327506142;
    const Real root = fifth_root(Real(1.25) * mass * speed * speed / stiffness);
    return Real(shape) * root * root / speed;
}

template <typename Real>
Real hertz_speed(const Real& stiffness, const Real& mass, const Real& depth) {
    return depth * square_root(square_root(depth) * stiffness / (Real(1.25) * mass));
}

template <typename Real>
const std::vector<HertzTouch<Real>>& HertzImpact<Real>::press(
    std::span<const ImpactBody<Real>> bodies, std::span<const HertzContact<Real>> contacts,
    const Real& speed) {
    touches_.clear();
    lost_ = Real{};
    work_ = 0;
    // The faster a contact, the shorter: one that joins later may close faster than the first.
    Real fastest = speed;
    for (const HertzContact<Real>& each : contacts)
        fastest = std::max(fastest, approach_of<Real>(each.contact, bodies));
    Real shortest{};
    Real longest{};
    for (const HertzContact<Real>& each : contacts) {
        const Real duration =
            hertz_duration(each.stiffness, reduced_mass(each.contact, bodies), fastest);
        if (!(shortest > Real{}) || duration < shortest) shortest = duration;
        if (longest < duration) longest = duration;
    }
    const Real step =
        std::max(shortest / Real(steps_in_shortest), longest / Real(most_steps_in_longest));
    if (shortest < step * Real(least_steps_in_shortest)) return touches_;
    const auto most_steps = static_cast<std::size_t>(static_cast<double>(longest / step)) *
                            (longest_at_least + longest_by_body * bodies.size());
    offset_.assign(bodies.size(), {});
    velocity_.clear();
    for (const ImpactBody<Real>& body : bodies)
        velocity_.push_back(body.velocity);
    states_.assign(contacts.size(), {});
    drift(step / Real(2.0));
    bool presses = true;
    for (std::size_t i = 0; i < most_steps && presses; ++i) {
        presses = kick(bodies, contacts, step);
        if (presses) drift(step);
    }
    if (!presses) lose_rest(contacts);
    const Real scale = scale_of(bodies, contacts);
    for (HertzTouch<Real>& each : touches_)
        each.impulse = states_[each.contact].impulse * scale;
    return touches_;
}

template <typename Real>
void HertzImpact<Real>::drift(const Real& time) {
    for (std::size_t i = 0; i < offset_.size(); ++i)
        offset_[i] += velocity_[i] * time;
}

// One step's impulses: all from the same offsets and velocities, so the order of contacts does not
// show. Whether anything presses.
template <typename Real>
bool HertzImpact<Real>::kick(std::span<const ImpactBody<Real>> bodies,
                             std::span<const HertzContact<Real>> contacts, const Real& step) {
    bool presses = false;
    work_ += contacts.size();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const HertzContact<Real>& each = contacts[i];
        const std::uint32_t a = each.contact.a;
        const std::uint32_t b = each.contact.b;
        const Vector<Real>& normal = each.contact.normal;
        const Real& restitution = each.contact.restitution;
        State& state = states_[i];
        state.kick = Real{};
        const Real depth = -each.gap - dot(offset_[a] - offset_[b], normal);
        if (!(depth > Real{})) {
            lose(state, restitution, Real{});
            continue;
        }
        const Real approach = dot(velocity_[b] - velocity_[a], normal);
        if (!state.has_touched) {
            state.has_touched = true;
            touches_.push_back({static_cast<std::uint32_t>(i), approach, Real{}});
        }
        const Real force = each.stiffness * depth * square_root(depth);
        const Real energy = Real(0.4) * force * depth;
        lose(state, restitution, energy);
        state.energy = energy;
        const bool is_loading = !(approach < Real{});
        state.kick = step * (is_loading ? force : force * restitution * restitution);
        state.impulse += state.kick;
        presses = presses || state.kick > Real{};
    }
    if (!presses) return false;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (!(states_[i].kick > Real{})) continue;
        const ImpactContact<Real>& contact = contacts[i].contact;
        const Vector<Real> momentum = contact.normal * states_[i].kick;
        velocity_[contact.a] += momentum * bodies[contact.a].inverse_mass;
        velocity_[contact.b] -= momentum * bodies[contact.b].inverse_mass;
    }
    return true;
}

// What is still compressed gives nothing back: its restitution is 0.
template <typename Real>
void HertzImpact<Real>::lose_rest(std::span<const HertzContact<Real>> contacts) {
    for (const HertzTouch<Real>& each : touches_)
        lose(states_[each.contact], contacts[each.contact].contact.restitution, Real{});
}

// The contact has unloaded to less energy than it had.
template <typename Real>
void HertzImpact<Real>::lose(State& state, const Real& restitution, const Real& energy) {
    if (!(energy < state.energy)) return;
    lost_ += (Real(1.0) - restitution * restitution) * (state.energy - energy);
    state.energy = energy;
}

// The factor s with which the impulses P lose `lost_`: s P.v + s^2 P.(P/m) / 2 = -lost, with v the
// initial velocities. Takes the root after which the contacts separate; if no factor loses that
// much, the factor that loses most.
template <typename Real>
Real HertzImpact<Real>::scale_of(std::span<const ImpactBody<Real>> bodies,
                                 std::span<const HertzContact<Real>> contacts) {
    Real linear{};
    Real square{};
    offset_.assign(bodies.size(), {});  // now the impulse on each body
    for (const HertzTouch<Real>& each : touches_) {
        const ImpactContact<Real>& contact = contacts[each.contact].contact;
        const Real& impulse = states_[each.contact].impulse;
        linear -= impulse * approach_of<Real>(contact, bodies);
        offset_[contact.a] += contact.normal * impulse;
        offset_[contact.b] -= contact.normal * impulse;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i)
        square += length_squared(offset_[i]) * bodies[i].inverse_mass;
    if (!(square > Real{}) || !(linear < Real{})) return Real{};
    const Real root = linear * linear - Real(2.0) * square * lost_;
    return (root > Real{} ? square_root(root) - linear : -linear) / square;
}

template double hertz_stiffness(const double&, const double&, const double&);
template DoubleDouble hertz_stiffness(const DoubleDouble&, const DoubleDouble&,
                                      const DoubleDouble&);
template double hertz_duration(const double&, const double&, const double&);
template DoubleDouble hertz_duration(const DoubleDouble&, const DoubleDouble&, const DoubleDouble&);
template double hertz_speed(const double&, const double&, const double&);
template DoubleDouble hertz_speed(const DoubleDouble&, const DoubleDouble&, const DoubleDouble&);
template class HertzImpact<double>;
template class HertzImpact<DoubleDouble>;

}  // namespace carom

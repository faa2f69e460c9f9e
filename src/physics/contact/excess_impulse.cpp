#include <algorithm>
#include <cmath>

#include "physics/contact/change_impulse.h"
#include "physics/contact/tolerances.h"

// Excess impulses: see ContactConstraints.
namespace carom {

// Whether the impulses of the last substep change a speed by more than a load can.
bool ContactConstraints::has_excess() const {
    const double bound = contact_tolerance::most_excess * step_.rest_speed;
    double most = 0.0;
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i)
        most = std::max(most, length_squared(bodies_.body[i].velocity - bodies_.start_velocity[i]));
    return most > bound * bound;
}

// The speed at which the upper body leaves the lower one, now or at the start of the substep,
// whichever is less. The more vertical the contact, the more the lower body counts as held.
ContactConstraints::Excess ContactConstraints::excess_of(const ContactPair& constraint,
                                                         Vec2 up) const {
    const double rise = dot(constraint.normal, up);
    const std::uint32_t upper = rise < 0.0 ? constraint.b : constraint.a;
    const std::uint32_t lower = rise < 0.0 ? constraint.a : constraint.b;
    const Vec2 upwards = rise < 0.0 ? -constraint.normal : constraint.normal;
    const double held = std::abs(rise);
    const ContactBody& above = bodies_.body[upper];
    const ContactBody& below = bodies_.body[lower];
    const double start = dot(bodies_.start_velocity[lower], upwards);
    const double end = dot(below.velocity, upwards);
    return {.speed = dot(above.velocity, upwards) - std::max(end, end + (start - end) * held),
            .inverse_mass = above.inverse_mass + below.inverse_mass * (1.0 - held)};
}

// The impulse without its excess; none where there is none.
std::optional<double> ContactConstraints::without_excess(const ContactPair& constraint,
                                                         Vec2 up) const {
    const Excess excess = excess_of(constraint, up);
    if (!(excess.speed > contact_tolerance::most_excess * step_.rest_speed)) return std::nullopt;
    if (!(excess.inverse_mass > 0.0)) return std::nullopt;
    if (had_impacts_ && is_about_to_bounce(constraint)) return std::nullopt;
    return std::max(0.0, constraint.impulse - excess.speed / excess.inverse_mass);
}

// Works from the top down: an impulse that a pair gives back no longer loads the lower body, which
// may then give back more in its turn.
template <bool spin>
void ContactConstraints::take_back_excess() {
    if (step_.gravity == Vec2{}) return;
    const Vec2 up = -step_.gravity / length(step_.gravity);
    const double bound = contact_tolerance::most_excess * step_.rest_speed;
    // Most pairs have none, and are told by this.
    const auto may_have_excess = [&](const ContactPair& constraint) {
        return constraint.impulse > 0.0 && separating_speed(constraint) > bound;
    };
    downwards_by_twos([&](ContactPair& first, ContactPair& second) {
        const bool is_first = may_have_excess(first);
        const bool is_second = may_have_excess(second);
        if (!is_first && !is_second) return;
        const auto of_first = is_first ? without_excess(first, up) : std::nullopt;
        const auto of_second = is_second ? without_excess(second, up) : std::nullopt;
        if (!of_first && !of_second) return;
        first.has_pressed |= first.impulse > 0.0;
        second.has_pressed |= second.impulse > 0.0;
        change_impulses<spin>(
            first, second,
            F64x2{of_first.value_or(first.impulse), of_second.value_or(second.impulse)});
    });
}

template void ContactConstraints::take_back_excess<false>();
template void ContactConstraints::take_back_excess<true>();

}  // namespace carom

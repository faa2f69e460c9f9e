#include <algorithm>
#include <cmath>

#include "physics/contact/exchange.h"
#include "physics/contact/solver.h"

// What stopped an impact is no load: a substep that starts from it throws its bodies up.
namespace carom {

// Whether the impulses of the last substep change a speed by what no load does.
bool ContactSolver::has_throws() const {
    const double bound = most_throw * resting_speed_;
    double most = 0.0;
    for (std::uint32_t i = 0; i < still_; ++i)
        most = std::max(most, length_squared(mover_[i].velocity - before_[i]));
    return most > bound * bound;
}

// How fast the upper of two bodies goes up from the lower one, as that is now and as it was at the
// start of the substep, whichever is less; and what it takes to change that where others hold the
// lower one, the more so the straighter it is below.
ContactSolver::Throw ContactSolver::throw_of(const Press& press, Vec2 up) const {
    const std::uint32_t a = press.a;
    const std::uint32_t b = press.b;
    const Vec2 normal = press.normal;
    const double rise = dot(normal, up);
    const std::uint32_t upper = rise < 0.0 ? b : a;
    const std::uint32_t lower = rise < 0.0 ? a : b;
    const Vec2 upwards = rise < 0.0 ? -normal : normal;
    const double held = std::abs(rise);
    const double start = dot(before_[lower], upwards);
    const double end = dot(mover_[lower].velocity, upwards);
    const double speed = dot(mover_[upper].velocity, upwards);
    return {.speed = speed - std::max(end, end + (start - end) * held),
            .inverse_mass = mover_[upper].inverse_mass + mover_[lower].inverse_mass * (1.0 - held)};
}

// The impulse without what throws; none where nothing does.
std::optional<double> ContactSolver::without_throw(const Press& press, Vec2 up) const {
    const double bound = most_throw * resting_speed_;
    if (!(press.impulse > 0.0) || !(apart(press) > bound)) return std::nullopt;
    const Throw thrown = throw_of(press, up);
    if (!(thrown.speed > bound) || !(thrown.inverse_mass > 0.0)) return std::nullopt;
    if (had_impacts_ && is_about_to_bounce(press)) return std::nullopt;
    return std::max(0.0, press.impulse - thrown.speed / thrown.inverse_mass);
}

// From the top down. Each pair gives back what throws its upper body, as if the lower one were held
// (shock propagation): what is given back throws the lower one in its turn, and is given back
// there. Shared out between the two, half of it would be given back at a time. Where one of two
// neighbours gives something back, both solve their friction again: without that, of deep heaps
// of unequal masses one gains energy (torture_test.cpp).
template <bool spin>
void ContactSolver::take_back_throws() {
    if (gravity_ == Vec2{}) return;
    const Vec2 up = -gravity_ / length(gravity_);
    for (std::size_t end = presses_.size(); end > 0;) {
        const std::size_t begin = end - (end > 1 && presses_[end - 2].with_next ? 2 : 1);
        Press& first = presses_[begin];
        Press& last = presses_[end - 1];
        end = begin;
        const std::optional<double> of_first = without_throw(first, up);
        const std::optional<double> of_last = without_throw(last, up);
        if (!of_first && !of_last) continue;
        exchange<spin>(first, of_first.value_or(first.impulse));
        if (&last != &first) exchange<spin>(last, of_last.value_or(last.impulse));
    }
}

template void ContactSolver::take_back_throws<false>();
template void ContactSolver::take_back_throws<true>();

}  // namespace carom

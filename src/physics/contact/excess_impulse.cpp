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
ContactSolver::Throw ContactSolver::throw_of(const Presses& presses, int which, Vec2 up) const {
    const std::uint32_t a = presses.a[which];
    const std::uint32_t b = presses.b[which];
    const Vec2 normal{presses.normal_x[which], presses.normal_y[which]};
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

// From the top down. Each pair gives back what throws its upper body, as if the lower one were held
// (shock propagation): what is given back throws the lower one in its turn, and is given back
// there. Shared out between the two, half of it would be given back at a time.
template <bool spin>
void ContactSolver::take_back_throws() {
    if (gravity_ == Vec2{}) return;
    const Vec2 up = -gravity_ / length(gravity_);
    const double bound = most_throw * resting_speed_;
    for (std::size_t k = presses_used_; k-- > 0;) {
        Presses& presses = presses_[k];
        const Two parting = apart(presses);
        if (!(std::max(parting[0], parting[1]) > bound)) continue;
        Two impulse = presses.impulse;
        bool changes = false;
        for (const int which : {0, 1}) {
            if (!(impulse[which] > 0.0)) continue;
            const Throw thrown = throw_of(presses, which, up);
            if (!(thrown.speed > bound) || !(thrown.inverse_mass > 0.0)) continue;
            if (had_impacts_ && is_about_to_bounce(presses, which)) continue;
            impulse[which] = std::max(0.0, impulse[which] - thrown.speed / thrown.inverse_mass);
            changes = true;
        }
        if (changes) exchange<spin>(presses, impulse);
    }
}

template void ContactSolver::take_back_throws<false>();
template void ContactSolver::take_back_throws<true>();

}  // namespace carom

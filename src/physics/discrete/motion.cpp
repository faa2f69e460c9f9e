#include "physics/discrete/motion.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "physics/broad_phase/nearest_image.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

// Seldom true. Checking costs less than writing back a velocity that does not change.
bool has_negative_zero(Vec2 v) {
    const auto is_negative_zero = [](double x) {
        return std::bit_cast<std::uint64_t>(x) == std::uint64_t{1} << 63;
    };
    return is_negative_zero(v.x) || is_negative_zero(v.y);
}

ClothState<double> state_on_cloth(const Balls& balls, std::size_t i) {
    return {{}, Vector<double>(balls.velocity[i]), Vector<double>(balls.roll[i]), balls.spin[i]};
}

void take_state(Balls& balls, std::size_t i, const ClothState<double>& state) {
    balls.velocity[i] = Vec2(state.velocity);
    balls.roll[i] = Vec2(state.roll);
    balls.spin[i] = state.spin;
}

bool is_forced(const World& world) {
    return world.model().gravity || world.model().drag;
}

}  // namespace

void OverlapMotion::begin_tick(const World& world) {
    const std::size_t count = world.balls().size();
    const Model& model = world.model();
    if (model.cloth) before_.resize(count);
    keeps_displacements_ =
        step_.has_several && (model.gravity || model.drag || model.speed_limit || model.cloth);
    if (keeps_displacements_) displacement_.resize(count);
    if (step_.has_several) {
        is_active_.resize(count, 0);
        left_.resize(count);
    }
}

double OverlapMotion::move_all(World& world, bool measure) {
    double longest = 0.0;
    with_terms(step_.terms, [&]<Terms terms>() {
        longest = is_forced(world) ? move_all_balls<terms, true>(world, measure)
                                   : move_all_balls<terms, false>(world, measure);
    });
    return longest;
}

void OverlapMotion::move_active(World& world) {
    with_terms(step_.terms, [&]<Terms terms>() {
        is_forced(world) ? move_active_balls<terms, true>(world)
                         : move_active_balls<terms, false>(world);
    });
}

template <Terms terms, bool forced>
double OverlapMotion::move_all_balls(World& world, bool measure) {
    const Flight flight = flight_over(world.model().drag, step_.duration);
    const auto count = static_cast<std::uint32_t>(world.balls().size());
    double longest = 0.0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2 before = world.balls().position[i];
        const Vec2 displacement = move<terms, forced>(world, i, flight);
        if (keeps_displacements_) displacement_[i] = displacement;
        if (!measure) continue;
        Vec2 gone = world.balls().position[i] - before;
        if (terms.wrap()) gone = nearest_image(gone, size(*world.model().wrap));
        longest = std::max(longest, length_squared(gone));
    }
    return std::sqrt(longest);
}

template <Terms terms, bool forced>
void OverlapMotion::move_active_balls(World& world) {
    Flight flight;
    for (const std::uint32_t i : active_) {
        if (flight.duration != left_[i]) flight = flight_over(world.model().drag, left_[i]);
        const Vec2 displacement = move<terms, forced>(world, i, flight);
        if (keeps_displacements_) displacement_[i] = displacement;
    }
}

template <Terms terms, bool forced>
Vec2 OverlapMotion::move(World& world, std::uint32_t i, const Flight& flight) {
    Balls& balls = SolverAccess(world).balls();
    Vec2 displacement;
    if (terms.spin() && world.model().cloth) {
        displacement = move_on_cloth(world, i, flight.duration);
    } else if constexpr (!forced) {
        // Adding 0 turns -0 into 0, as adding a gravity does.
        displacement = balls.velocity[i] * flight.duration + Vec2{};
        if (has_negative_zero(balls.velocity[i])) balls.velocity[i] += Vec2{};
    } else {
        const Vec2 gravity = world.model().gravity.value_or(Vec2{});
        displacement = travel(flight, balls.velocity[i], gravity);
        balls.velocity[i] = velocity_after(flight, balls.velocity[i], gravity);
    }
    if (terms.special() && kinematics_.is_held(i)) {
        displacement = {};
        balls.velocity[i] = {};
        if (terms.spin()) balls.spin[i] = 0.0;
        if (terms.spin() && world.model().cloth) balls.roll[i] = {};
    }
    if (world.model().speed_limit) {
        balls.velocity[i] = limited(balls.velocity[i], *world.model().speed_limit);
        displacement = limited(displacement, *world.model().speed_limit * flight.duration);
    }
    balls.position[i] += displacement;
    if (terms.wrap()) balls.position[i] = wrapped(balls.position[i], *world.model().wrap);
    return displacement;
}

// The displacement on cloth in `duration`. The ball takes on its state at the end.
Vec2 OverlapMotion::move_on_cloth(World& world, std::uint32_t ball, double duration) {
    before_[ball] = state_on_cloth(world.balls(), ball);
    const auto after =
        cloth_state_after(*world.model().cloth, *world.model().spin, before_[ball], duration);
    take_state(SolverAccess(world).balls(), ball, after);
    return Vec2(after.position);
}

Vec2 OverlapMotion::displacement_of(const World& world, std::uint32_t ball) const {
    if (keeps_displacements_) return displacement_[ball];
    return world.balls().velocity[ball] * (step_.is_first ? step_.duration : left_[ball]) + Vec2{};
}

void OverlapMotion::keep_time(World& world, std::span<const PushedBall> pushed_balls) {
    Balls& balls = SolverAccess(world).balls();
    clear_active();
    for (const PushedBall& pushed : pushed_balls) {
        const std::uint32_t i = pushed.ball;
        if (!(pushed.intended > 0.0)) continue;
        const Vec2 displacement = nearest_image(world, balls.position[i] - pushed.origin);
        const double covered = std::min(1.0, length(displacement) / pushed.intended);
        const double had = step_.is_first ? step_.duration : left_[i];
        const double left = had * (1.0 - covered);
        if (world.model().gravity) balls.velocity[i] -= *world.model().gravity * left;
        if (covered < 1e-9 || left < 1e-9 * had) continue;
        if (world.model().cloth)
            take_state(balls, i,
                       cloth_state_after(*world.model().cloth, *world.model().spin, before_[i],
                                         had - left));
        left_[i] = left;
        is_active_[i] = 1;
        active_.push_back(i);
    }
}

void OverlapMotion::clear_active() {
    for (const std::uint32_t i : active_)
        is_active_[i] = 0;
    active_.clear();
}

}  // namespace carom

#include <algorithm>
#include <cmath>

#include "physics/laws/bounce.h"
#include "physics/swept/paths.h"
#include "physics/swept/tolerances.h"
#include "physics/world/solver_access.h"

// How balls turn along their paths in the solver `swept`: spin, roll on cloth, and the friction of
// a weight that rests.
namespace carom {

void SweptPaths::advance_spin(World& world, std::uint32_t ball, double now) const {
    const SweptPath& path = paths_[ball];
    const double since = now - path.chord.time;
    if (world.model().cloth) {
        if (path.is_frozen || is_held(ball)) return;
        const auto there = on_cloth(world, ball, path.start_velocity, since);
        SolverAccess(world).balls().roll[ball] = Vec2(there.roll);
        SolverAccess(world).balls().spin[ball] = there.spin;
        return;
    }
    const double rate = spin_rate_[ball];
    if (rate == 0.0) return;
    double& spin = SolverAccess(world).balls().spin[ball];
    spin += rate * since;
    if (world.model().drag) return;
    // Like velocity_at: the spin where the ball has turned as far as on its chord. So friction
    // takes from one body what it gives to the other, and the rest is lost.
    const double there = std::sqrt(spin * spin + rate * rate * since * (step_.duration - now));
    spin = spin < 0.0 ? -there : there;
}

// The state of the ball, at first at `velocity`, `duration` seconds after the time of its roll.
ClothState<double> SweptPaths::on_cloth(const World& world, std::uint32_t ball, Vec2 velocity,
                                        double duration) const {
    const ClothState<double> state{{},
                                   Vector<double>(velocity),
                                   Vector<double>(world.balls().roll[ball]),
                                   world.balls().spin[ball]};
    return cloth_state_after(*world.model().cloth, *world.model().spin, state, duration);
}

// Spin at the end of the substep, `since` seconds after the ball's last change of path; on cloth
// roll, and the velocity of a ball that is not stopped, too.
void SweptPaths::finish_turning(World& world, std::uint32_t ball, double since) const {
    Balls& balls = SolverAccess(world).balls();
    const SweptPath& path = paths_[ball];
    const bool is_stopped = path.is_frozen || is_held(ball);
    balls.spin[ball] = (path.is_frozen && !path.is_standing) || is_held(ball)
                           ? 0.0
                           : balls.spin[ball] + spin_rate_[ball] * since;
    if (!world.model().cloth) return;
    if (is_stopped) {
        if (!path.is_standing || is_held(ball)) balls.roll[ball] = {};
        return;
    }
    const auto after = on_cloth(world, ball, path.start_velocity, since);
    balls.velocity[ball] = Vec2(after.velocity);
    balls.roll[ball] = Vec2(after.roll);
    balls.spin[ball] = after.spin;
}

void SweptPaths::stop_sliding_if_pressed(World& world, std::uint32_t ball, Vec2& velocity) const {
    if (paths_[ball].resting_impacts != swept_tolerance::most_resting_impacts) return;
    const double inertia = *world.model().spin;
    Vec2& roll = SolverAccess(world).balls().roll[ball];
    roll = velocity = (velocity + roll * inertia) / (1.0 + inertia);
}

void SweptPaths::apply_rest_friction(World& world, std::uint32_t ball, Vec2 surface,
                                     double coefficient, double now, Vec2& velocity) {
    SweptRest& rest = resting_[ball];
    double& spin = SolverAccess(world).balls().spin[ball];
    const double left = step_.duration - now;
    const double radius = world.balls().radius[ball];
    const double inertia = *world.model().spin;
    spin_rate_[ball] = 0.0;
    const Vec2 reaction = rest.gravity - step_.gravity;
    const double press = length(reaction);
    if (!(left > 0.0) || !(press > 0.0)) return;
    const double most = coefficient * press * left;
    if (rest.gravity == Vec2{} && !(rest.other_support == Vec2{})) {
        const double change = std::clamp(-inertia * radius * spin, -most, most);
        spin_rate_[ball] = change / (inertia * radius * left);
        return;
    }
    const Vec2 normal = reaction / press;
    const Vec2 along = perpendicular(normal);
    const double pull = dot(rest.gravity, along) * left;
    double slip = dot(velocity - surface, along) - radius * spin;
    if (slip * (slip + pull) < 0.0) {
        apply_friction_on_surface(velocity, {spin, radius}, 1.0, normal, surface, most,
                                  {1.0, inertia});
        slip = dot(velocity - surface, along) - radius * spin;
    }
    const double change = std::clamp(-(slip + pull) / (1.0 + 1.0 / inertia), -most, most);
    rest.gravity += along * (change / left);
    spin_rate_[ball] = -change / (inertia * radius * left);
}

}  // namespace carom

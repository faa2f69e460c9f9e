#include <algorithm>
#include <cmath>

#include "physics/laws/cloth_contact.h"
#include "physics/laws/contact_material.h"
#include "physics/swept/solver.h"
#include "physics/world/solver_access.h"

// Friction in the solver `swept`, once the velocities along the normal are known.
namespace carom {

void SweptSolver::advance_spin(World& world, std::uint32_t ball, double now) const {
    if (world.model().cloth) {
        if (paths_[ball].is_frozen || is_held_ball(ball)) return;
        const auto there =
            on_cloth(world, ball, paths_[ball].start_velocity, now - paths_[ball].time);
        SolverAccess(world).balls().roll[ball] = Vec2(there.roll);
        SolverAccess(world).balls().spin[ball] = there.spin;
        return;
    }
    const double rate = spin_rate_[ball];
    if (rate == 0.0) return;
    double& spin = SolverAccess(world).balls().spin[ball];
    const double since = now - paths_[ball].time;
    spin += rate * since;
    if (world.model().drag) return;
    // Like velocity_at: the spin where the ball has turned as far as on its chord. So friction
    // takes from one body what it gives to the other, and the rest is lost.
    const double there = std::sqrt(spin * spin + rate * rate * since * (duration_ - now));
    spin = spin < 0.0 ? -there : there;
}

ClothState<double> SweptSolver::on_cloth(const World& world, std::uint32_t ball, Vec2 velocity,
                                         double duration) const {
    const ClothState<double> state{{},
                                   Vector<double>(velocity),
                                   Vector<double>(world.balls().roll[ball]),
                                   world.balls().spin[ball]};
    return cloth_state_after(*world.model().cloth, *world.model().spin, state, duration);
}

void SweptSolver::stop_sliding_if_pressed(World& world, std::uint32_t ball, Vec2& velocity) {
    if (paths_[ball].resting_impacts != most_resting_impacts) return;
    const double inertia = *world.model().spin;
    Vec2& roll = SolverAccess(world).balls().roll[ball];
    roll = velocity = (velocity + roll * inertia) / (1.0 + inertia);
}

void SweptSolver::apply_ball_friction(World& world, const Event& event, Vec2& velocity_a,
                                      double inverse_a, Vec2& velocity_b, double inverse_b,
                                      double impulse, bool resting) {
    Balls& balls = SolverAccess(world).balls();
    const std::uint32_t i = event.ball;
    const std::uint32_t j = event.other;
    double pressed = impulse;
    if (resting && world.model().gravity) {
        // The weight of the upper ball, for the rest of the substep.
        const double up = -dot(*world.model().gravity, event.normal);
        const double inverse = inverse_mass_[up > 0.0 ? i : j];
        if (inverse > 0.0) pressed += std::fabs(up) * (duration_ - event.time) / inverse;
    }
    const Friction friction{friction_of_balls(world, i, j), *world.model().spin};
    if (world.model().cloth) {
        rub_on_cloth(velocity_a, roller(balls, i), inverse_a, velocity_b, roller(balls, j),
                     inverse_b, event.normal, pressed, friction);
        return;
    }
    rub(velocity_a, {balls.spin[i], balls.radius[i]}, inverse_a, velocity_b,
        {balls.spin[j], balls.radius[j]}, inverse_b, event.normal, pressed, friction);
}

void SweptSolver::apply_edge_friction(World& world, std::uint32_t ball, Vec2 normal, Vec2 surface,
                                      double coefficient, double impulse, Vec2& velocity) const {
    Balls& balls = SolverAccess(world).balls();
    if (world.model().cloth) {
        rub_edge_on_cloth(velocity, roller(balls, ball), inverse_mass_[ball], normal, surface,
                          impulse, {coefficient, *world.model().spin});
        return;
    }
    rub_on(velocity, {balls.spin[ball], balls.radius[ball]}, inverse_mass_[ball], normal, surface,
           impulse, {coefficient, *world.model().spin});
}

void SweptSolver::apply_rest_friction(World& world, std::uint32_t ball, Vec2 surface,
                                      double coefficient, double now, Vec2& velocity) {
    RestingContacts& contacts = resting_[ball];
    double& spin = SolverAccess(world).balls().spin[ball];
    const double left = duration_ - now;
    const double radius = world.balls().radius[ball];
    const double inertia = *world.model().spin;
    spin_rate_[ball] = 0.0;
    const Vec2 reaction = contacts.gravity - gravity_;
    const double press = length(reaction);
    if (!(left > 0.0) || !(press > 0.0)) return;
    const double most = coefficient * press * left;
    if (contacts.gravity == Vec2{} && !(contacts.other_support == Vec2{})) {
        const double rim = std::clamp(-inertia * radius * spin, -most, most);
        spin_rate_[ball] = rim / (inertia * radius * left);
        return;
    }
    const Vec2 normal = reaction / press;
    const Vec2 along = perpendicular(normal);
    const double pull = dot(contacts.gravity, along) * left;
    double slip = dot(velocity - surface, along) - radius * spin;
    if (slip * (slip + pull) < 0.0) {
        rub_on(velocity, {spin, radius}, 1.0, normal, surface, most, {1.0, inertia});
        slip = dot(velocity - surface, along) - radius * spin;
    }
    const double change = std::clamp(-(slip + pull) / (1.0 + 1.0 / inertia), -most, most);
    contacts.gravity += along * (change / left);
    spin_rate_[ball] = -change / (inertia * radius * left);
}

}  // namespace carom

#include <algorithm>

#include "geometry/closest.h"
#include "physics/discrete/solver.h"
#include "physics/laws/cloth_contact.h"
#include "physics/laws/contact_material.h"
#include "physics/world/solver_access.h"

// What the solvers `discrete` and `substep` do to the velocities of bodies that overlapped.
namespace carom {

void OverlapSolver::exchange_momentum(World& world, double time, std::vector<Contact>& contacts) {
    with_terms(terms_of(world), [&]<Terms terms>() { bounce_pairs<terms>(world, time, contacts); });
}

// A held edge acts only along its surface (friction), since balls in its way are pushed out; a
// driven edge throws as well.
template <Terms terms>
void OverlapSolver::bounce_pairs(World& world, double time, std::vector<Contact>& contacts) {
    Balls& balls = SolverAccess(world).balls();
    const Vec2 torus = terms.wrap() ? size(*world.model().wrap) : Vec2{};
    for (const Pair& pair : pairs_) {
        const std::uint32_t i = pair.ball;
        if (pair.kind == ContactKind::ball_ball) {
            const std::uint32_t j = pair.other;
            Vec2 offset = balls.position[i] - balls.position[j];
            if (terms.wrap()) offset = nearest_image(offset, torus);
            Vec2 normal = direction(offset, when_coincident);
            if (!(dot(balls.velocity[i] - balls.velocity[j], normal) < 0.0)) continue;
            if (terms.special() && inverse_mass_[i] == 0.0 && inverse_mass_[j] == 0.0) continue;
            const double restitution = restitution_of_balls(world, i, j);
            const Exchange done = bounce(balls.velocity[i], inverse_mass_[i], balls.velocity[j],
                                         inverse_mass_[j], normal, restitution);
            if (terms.spin()) {
                const Friction friction{friction_of_balls(world, i, j), *world.model().spin};
                if (world.model().cloth)
                    rub_on_cloth(balls.velocity[i], roller(balls, i), inverse_mass_[i],
                                 balls.velocity[j], roller(balls, j), inverse_mass_[j], normal,
                                 done.impulse, friction);
                else
                    rub(balls.velocity[i], {balls.spin[i], balls.radius[i]}, inverse_mass_[i],
                        balls.velocity[j], {balls.spin[j], balls.radius[j]}, inverse_mass_[j],
                        normal, done.impulse, friction);
            }
            const Vec2 point = balls.position[j] + normal * balls.radius[j];
            if (i > j) normal = -normal;
            contacts.push_back({time, ContactKind::ball_ball, std::min(i, j), std::max(i, j), point,
                                normal, done.approach, done.impulse});
            continue;
        }
        if (terms.special() && inverse_mass_[i] == 0.0) continue;
        Capsule shape = world.capsules().shape[pair.other];
        shape.start += pair.shift;
        shape.end += pair.shift;
        const Vec2 nearest = closest_point(shape.start, shape.end, balls.position[i]);
        Vec2 normal = direction(balls.position[i] - nearest, when_coincident);
        const HeldEdge* edge = nullptr;
        if (terms.special())
            edge = find_edge(std::span<const HeldEdge>(kinematic_edges_), pair.other);
        const Vec2 surface =
            edge ? surface_velocity(*edge, world.capsules().shape[pair.other], nearest) : Vec2{};
        const bool driven = edge && edge->is_driven;
        const double throwing = driven ? dot(surface, normal) : 0.0;
        const double speed = throwing - dot(balls.velocity[i], normal);
        if (!(speed > 0.0)) continue;
        const double restitution = restitution_of_edge(world, pair.other, speed);
        const Vec2 flat = normal;
        normal = bounce_normal(world, i, normal, balls.velocity[i], restitution);
        const Exchange done =
            bounce_off(balls.velocity[i], inverse_mass_[i], normal, throwing, restitution, driven);
        if (terms.special() && world.model().kicks)
            balls.velocity[i] += normal * kick_of_edge(world, pair.other, shape, nearest, speed);
        if (terms.spin()) {
            const Friction friction{friction_of_edge(world, pair.other), *world.model().spin};
            if (world.model().cloth)
                rub_edge_on_cloth(balls.velocity[i], roller(balls, i), inverse_mass_[i], flat,
                                  surface, done.impulse, friction);
            else
                rub_on(balls.velocity[i], {balls.spin[i], balls.radius[i]}, inverse_mass_[i], flat,
                       surface, done.impulse, friction);
        }
        contacts.push_back({time, ContactKind::ball_edge, i, pair.other,
                            nearest + normal * shape.radius, normal, done.approach, done.impulse});
    }
}

}  // namespace carom

#include "physics/discrete/bounce_overlap.h"

#include <algorithm>

#include "geometry/closest.h"
#include "physics/broad_phase/cell_frame.h"
#include "physics/laws/cloth_contact.h"
#include "physics/laws/contact_material.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

template <Terms terms>
void bounce_balls_apart(World& world, const OverlapKinematics& kinematics, const OverlapPair& pair,
                        double time, std::vector<Contact>& contacts) {
    Balls& balls = SolverAccess(world).balls();
    const std::uint32_t i = pair.ball;
    const std::uint32_t j = pair.other;
    Vec2 offset = balls.position[i] - balls.position[j];
    if (terms.wrap()) offset = nearest_image(offset, size(*world.model().wrap));
    const Vec2 normal = direction(offset, normal_when_coincident);
    if (!(dot(balls.velocity[i] - balls.velocity[j], normal) < 0.0)) return;
    if (terms.special() && kinematics.is_held(i) && kinematics.is_held(j)) return;
    const double inverse_i = kinematics.inverse_mass()[i];
    const double inverse_j = kinematics.inverse_mass()[j];
    const Exchange done = bounce(balls.velocity[i], inverse_i, balls.velocity[j], inverse_j, normal,
                                 restitution_of_balls(world, i, j));
    if (terms.spin()) {
        const Friction friction{friction_of_balls(world, i, j), *world.model().spin};
        if (world.model().cloth)
            apply_cloth_friction(balls.velocity[i], roller(balls, i), inverse_i, balls.velocity[j],
                                 roller(balls, j), inverse_j, normal, done.impulse, friction);
        else
            apply_friction(balls.velocity[i], {balls.spin[i], balls.radius[i]}, inverse_i,
                           balls.velocity[j], {balls.spin[j], balls.radius[j]}, inverse_j, normal,
                           done.impulse, friction);
    }
    const Vec2 point = balls.position[j] + normal * balls.radius[j];
    contacts.push_back({time, ContactKind::ball_ball, std::min(i, j), std::max(i, j), point,
                        i > j ? -normal : normal, done.approach, done.impulse});
}

template <Terms terms>
void bounce_off_overlapped_edge(World& world, const OverlapKinematics& kinematics,
                                const OverlapPair& pair, double time,
                                std::vector<Contact>& contacts) {
    Balls& balls = SolverAccess(world).balls();
    const std::uint32_t i = pair.ball;
    if (terms.special() && kinematics.is_held(i)) return;
    const double inverse_mass = kinematics.inverse_mass()[i];
    Capsule shape = world.capsules().shape[pair.other];
    shape.start += pair.shift;
    shape.end += pair.shift;
    const Vec2 nearest = closest_point(shape.start, shape.end, balls.position[i]);
    const Vec2 normal = direction(balls.position[i] - nearest, normal_when_coincident);
    const HeldEdge* edge = nullptr;
    if (terms.special()) edge = kinematics.find(pair.other);
    const Vec2 surface =
        edge ? surface_velocity(*edge, world.capsules().shape[pair.other], nearest) : Vec2{};
    const bool is_driven = edge && edge->is_driven;
    const double throwing = is_driven ? dot(surface, normal) : 0.0;
    const double approach = throwing - dot(balls.velocity[i], normal);
    if (!(approach > 0.0)) return;
    const double restitution = restitution_of_edge(world, pair.other, approach);
    const Vec2 along = bounce_normal(world, i, normal, balls.velocity[i], restitution);
    const Exchange done =
        bounce_off(balls.velocity[i], inverse_mass, along, throwing, restitution, is_driven);
    if (terms.special() && world.model().kicks)
        balls.velocity[i] += along * kick_of_edge(world, pair.other, shape, nearest, approach);
    if (terms.spin()) {
        const Friction friction{friction_of_edge(world, pair.other), *world.model().spin};
        if (world.model().cloth)
            apply_cloth_friction_on_edge(balls.velocity[i], roller(balls, i), inverse_mass, normal,
                                         surface, done.impulse, friction);
        else
            apply_friction_on_surface(balls.velocity[i], {balls.spin[i], balls.radius[i]},
                                      inverse_mass, normal, surface, done.impulse, friction);
    }
    contacts.push_back({time, ContactKind::ball_edge, i, pair.other, nearest + along * shape.radius,
                        along, done.approach, done.impulse});
}

}  // namespace

void bounce_overlapping(World& world, Terms chosen, const OverlapKinematics& kinematics,
                        std::span<const OverlapPair> pairs, double time,
                        std::vector<Contact>& contacts) {
    with_terms(chosen, [&]<Terms terms>() {
        for (const OverlapPair& pair : pairs)
            if (pair.kind == ContactKind::ball_ball)
                bounce_balls_apart<terms>(world, kinematics, pair, time, contacts);
            else
                bounce_off_overlapped_edge<terms>(world, kinematics, pair, time, contacts);
    });
}

}  // namespace carom

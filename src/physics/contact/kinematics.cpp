#include "physics/contact/kinematics.h"

#include <algorithm>

#include "physics/contact/tolerances.h"
#include "physics/laws/free_motion.h"
#include "physics/world/solver_access.h"

namespace carom {

void ContactKinematics::load(const World& world, ContactBodies& bodies) {
    balls_.clear();
    for (std::uint32_t h = 0; h < world.held_balls().size(); ++h) {
        const auto index = index_of(world, world.held_balls()[h].id);
        if (!index) continue;
        const auto place = std::ranges::find(bodies.ball, static_cast<std::uint32_t>(*index));
        const auto body = static_cast<std::uint32_t>(place - bodies.ball.begin());
        balls_.push_back({.body = body, .held = h});
        bodies.body[body].inverse_mass = 0.0;
    }
    list_kinematic_edges(world, edges_);
}

void ContactKinematics::begin_substep(const World& world, const ContactSubstep& step,
                                      const ContactBodies& bodies, double share_of_displacement) {
    was_held_back_.resize(balls_.size() + edges_.size(), 0);
    const auto per_second = [&](std::size_t index) {
        return was_held_back_[index] ? 1.0 / world.tick_length()
                                     : share_of_displacement / step.duration;
    };
    for (std::size_t i = 0; i < balls_.size(); ++i) {
        ContactHeldBall& ball = balls_[i];
        ball.share = 1.0;
        const Vec2 to_target = displacement_to_target(world, world.held_balls()[ball.held],
                                                      bodies.position[ball.body]);
        ball.velocity = to_target * per_second(i);
    }
    for (std::size_t i = 0; i < edges_.size(); ++i) {
        HeldEdge& edge = edges_[i];
        edge.share = 1.0;
        edge.stopped_at = -1.0;
        edge.version = 0;
        if (edge.is_seesaw) {
            edge.seesaw = world.seesaws()[*seesaw_of(world, edge.seesaw.capsule)];
            edge.since = 0.0;
            if (is_standing(edge.seesaw)) edge.stop(0.0);
        }
        aim(edge, world, per_second(balls_.size() + i));
    }
}

void ContactKinematics::set_velocities(ContactBodies& bodies) const {
    for (const ContactHeldBall& ball : balls_)
        bodies.start_velocity[ball.body] = bodies.body[ball.body].velocity = ball.velocity;
}

void ContactKinematics::set_displacements(ContactBodies& bodies, const ContactSubstep& step) const {
    for (const ContactHeldBall& ball : balls_)
        bodies.displacement[ball.body] = ball.velocity * (ball.share * step.duration);
}

void ContactKinematics::end_substep(World& world, const ContactSubstep& step) {
    for (std::size_t i = 0; i < balls_.size(); ++i)
        if (balls_[i].share < 1.0) was_held_back_[i] = 1;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
        const HeldEdge& edge = edges_[i];
        if (edge.share < 1.0 || edge.is_stopped()) was_held_back_[balls_.size() + i] = 1;
        finish(edge, world, step.duration);
    }
}

void ContactKinematics::stop_held_balls(World& world, const ContactBodies& bodies) const {
    for (const ContactHeldBall& ball : balls_)
        SolverAccess(world).balls().velocity[bodies.ball[ball.body]] = {};
}

// Pre: the pair is kinematic.
std::size_t ContactKinematics::index_of_pair(const ContactPair& pair,
                                             const ContactBodies& bodies) const {
    if (pair.b > bodies.fixed)
        return balls_.size() + static_cast<std::size_t>(&edge_of(pair) - edges_.data());
    const std::uint32_t body = bodies.is_kinematic(pair.a) ? pair.a : pair.b;
    const auto place = std::ranges::find(balls_, body, &ContactHeldBall::body);
    return static_cast<std::size_t>(place - balls_.begin());
}

bool ContactKinematics::hold_back(const ContactPairs& pairs, ContactBodies& bodies,
                                  const ContactSubstep& step) {
    shortened_.assign(balls_.size() + edges_.size(), 1.0);
    bool is_any = false;
    for (const std::uint32_t p : pairs.kinematic()) {
        const ContactPair& pair = pairs[p];
        if (pair.mass == 0.0 || pair.is_hinged) continue;
        // The impact comes in time, and moves the ball away from the edge.
        if (pair.state == ContactState::ccd && pair.b > bodies.fixed) continue;
        const bool by_a = bodies.is_ball(pair.b) && bodies.is_kinematic(pair.a);
        const std::uint32_t ball = by_a ? pair.b : pair.a;
        const Vec2 normal = by_a ? -pair.normal : pair.normal;
        const double surface = dot(bodies.body[by_a ? pair.a : pair.b].velocity, normal);
        const double speed = dot(bodies.body[ball].velocity, normal);
        const double room = std::max(0.0, pair.separation + contact_tolerance::kinematic_overlap *
                                                                bodies.radius[ball]) /
                            step.duration;
        if (!(surface > 0.0) || surface - speed <= room) continue;
        double& shortened = shortened_[index_of_pair(pair, bodies)];
        shortened = std::min(shortened, std::max(0.0, (speed + room) / surface));
        is_any = true;
    }
    for (std::size_t i = 0; i < shortened_.size(); ++i)
        share_of(i) *= shortened_[i];
    for (const std::uint32_t p : pairs.kinematic()) {
        const ContactPair& pair = pairs[p];
        if (pair.b > bodies.fixed && !pair.is_hinged)
            bodies.body[pair.b].velocity *= shortened_[index_of_pair(pair, bodies)];
    }
    return is_any;
}

void ContactKinematics::settle_jams(ContactPairs& pairs, ContactBodies& bodies,
                                    const ContactSubstep& step) {
    jammed_.clear();
    is_jammed_.assign(bodies.fixed, 0);
    const auto jam = [&](const ContactPair& pair, std::uint32_t body) {
        if (pair.separation > contact_tolerance::kinematic_overlap * pair.radius ||
            bodies.is_kinematic(body) || is_jammed_[body])
            return;
        is_jammed_[body] = 1;
        jammed_.push_back(body);
    };
    for (const std::uint32_t p : pairs.kinematic()) {
        const ContactPair& pair = pairs[p];
        if (pair.is_hinged) continue;
        const std::size_t index = index_of_pair(pair, bodies);
        const bool has_stopped =
            index >= balls_.size() && edges_[index - balls_.size()].is_stopped();
        if (share_of(index) == 1.0 && !has_stopped) continue;
        jam(pair, bodies.is_kinematic(pair.a) ? pair.b : pair.a);
    }
    if (jammed_.empty()) return;
    pairs.list_by_body(bodies);
    for (std::size_t next = 0; next < jammed_.size(); ++next) {
        const std::uint32_t body = jammed_[next];
        for (const std::uint32_t p : pairs.of_body(body)) {
            const ContactPair& pair = pairs[p];
            if (bodies.is_ball(pair.b)) jam(pair, pair.a == body ? pair.b : pair.a);
        }
    }
    for (const std::uint32_t body : jammed_)
        bodies.body[body].velocity =
            limited(bodies.body[body].velocity, length(bodies.displacement[body]) / step.duration);
}

void ContactKinematics::note_pressing(const ContactPairs& pairs, const ContactBodies& bodies,
                                      const ContactSubstep& step) {
    for (const std::uint32_t p : pairs.kinematic()) {
        const ContactPair& pair = pairs[p];
        if (pair.state != ContactState::constraint || !(pair.impulse > 0.0) || pair.is_hinged)
            continue;
        pressing_.push_back(contact_of(bodies, pair, step.start_time, pair.impulse));
    }
}

double ContactKinematics::work(const ContactPairs& pairs, const ContactBodies& bodies) const {
    double work = 0.0;
    for (const std::uint32_t p : pairs.kinematic()) {
        const ContactPair& pair = pairs[p];
        if (pair.mass == 0.0 || pair.state != ContactState::constraint || pair.is_hinged) continue;
        const Vec2 push =
            pair.normal * pair.impulse + perpendicular(pair.normal) * pair.tangential_impulse;
        if (bodies.is_ball(pair.b) && bodies.is_kinematic(pair.a))
            work -= dot(push, bodies.body[pair.a].velocity);
        else
            work += dot(push, bodies.body[pair.b].velocity);
    }
    return work;
}

}  // namespace carom

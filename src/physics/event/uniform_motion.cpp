#include "physics/event/uniform_motion.h"

#include <algorithm>

#include "physics/event/motion/edge_impact.h"
#include "physics/event/motion/tolerances.h"
#include "physics/laws/contact_material.h"
#include "physics/memory/branchless.h"

namespace carom {

template <typename Real>
bool UniformMotion<Real>::applies(const KinematicBodies<Real>& kinematic) const {
    const Model& model = scene_.world->model();
    return model.ball_ball && !model.gravity && !scene_.field.has_drag && !model.spin &&
           !model.cloth && !model.modulus && !model.wrap && !model.filtered && !model.one_way &&
           kinematic.edges().empty() && space_.cells().oversized().empty() &&
           std::all_of(balls_.begin(), balls_.end(), [](const BallRecord<Real>& ball) {
               return ball.line.motion == Motion::free;
           });
}

template <typename Real>
bool UniformMotion<Real>::handle(std::uint32_t ball, const BallEvent<Real>& event,
                                 const ImpactRecord& record) {
    if (event.kind == EventKind::cell_transfer && event.other < cell_transfer::sides) {
        predictor_.template transfer<MotionTerms::uniform>(ball, event.other);
    } else if (event.kind == EventKind::ball_ball) {
        if (event.other_version == balls_[event.other].version) return collide(ball, event, record);
        predictor_.template predict<MotionTerms::uniform>(ball);
    } else {
        return false;
    }
    schedule_.update(ball);
    return true;
}

// Finds the balls near a ball that is at `position` now and continues with `velocity`. The
// `partner` of its impact does not count. False if it may touch another already, or if they are too
// many.
template <typename Real>
inline bool UniformMotion<Real>::find_near(std::uint32_t ball, std::uint32_t partner,
                                           const Vector<Real>& position,
                                           const Vector<Real>& velocity,
                                           NearBalls<Real>& near) const {
    const BallRecord<Real>* const balls = balls_.data();
    const Real now = scene_.now;
    const Real size = balls[ball].radius;
    const Real slack = Real(gap_roundings) * rounding_at(position, Real{});
    const Vector<Real> from = position;
    const Vector<Real> own_velocity = velocity;
    std::size_t count = 0;
    std::size_t approached = 0;
    int are_apart = 1;
    auto chains = space_.cells().chains_near(balls_, ball);
    chains.for_each(balls, [&](std::uint32_t other, int, int) {
        const LinearPart<Real>& line = balls[other].line;
        const Vector<Real> offset = from - (line.position + line.velocity * (now - line.time));
        const Real reach = size + balls[other].radius;
        // The rough limit of ImpactCluster, which no ball that may touch exceeds.
        const Real rough = reach * Real(1.0 + 4.0 * contact_slop) + slack;
        const StraightApproach<Real> approach(offset, own_velocity - line.velocity, reach);
        const auto is_other = static_cast<int>(other != partner);
        are_apart &= (is_other ^ 1) | static_cast<int>(length_squared(offset) > rough * rough);
        const std::size_t at = std::min(count, NearBalls<Real>::most - 1);
        near.other[at] = other;
        near.offset[at] = offset;
        near.approach[at] = approach;
        near.approached[approached] = static_cast<std::uint32_t>(at);
        approached = std::min(approached + static_cast<std::size_t>(
                                               static_cast<int>(approach.is_impact()) & is_other),
                              NearBalls<Real>::most - 1);
        ++count;
    });
    near.approached_count = approached;
    return are_apart != 0 && count < NearBalls<Real>::most;
}

// Whether the ball, at `position` now, touches no edge.
template <typename Real>
bool UniformMotion<Real>::is_off_edges(std::uint32_t ball, const Vector<Real>& position) const {
    if (space_.is_off_edges(ball)) return true;  // nearly always, and cheap
    bool is_off = true;
    space_.for_each_edge_near(ball, [&](std::uint32_t capsule, Vec2 shift, int, int) {
        const Edge<Real> edge(scene_.world->capsules().shape[capsule], shift);
        const Real size = balls_.radius(ball);
        is_off = is_off && contact_with(edge, position, size).gap >
                               size * Real(contact_slop) +
                                   Real(gap_roundings) * rounding_at(position, size + edge.radius);
    });
    return is_off;
}

// An impact of two balls that touch nothing else. False: it is not such an impact, and nothing has
// changed.
template <typename Real>
bool UniformMotion<Real>::collide(std::uint32_t ball, const BallEvent<Real>& event,
                                  const ImpactRecord& record) {
    // Seen from the lower ball, whichever has the event.
    Pair pair{{std::min(ball, event.other), std::max(ball, event.other)}, {}, {}, {}, {}};
    for (std::size_t i = 0; i < 2; ++i) {
        const BallRecord<Real>& each = balls_[pair.ball[i]];
        if (each.line.recent_collisions >= most_recent_collisions) return false;
        // + 0 clears -0, as state_at does.
        const Vector<Real> speed = each.line.velocity + Vector<Real>{};
        pair.position[i] = each.line.position + speed * (scene_.now - each.line.time);
        pair.motion[i] = {speed, balls_.plan(pair.ball[i]).inverse_mass};
        const Vector<Real> moved = pair.position[i] - each.line.position;
        const Real near = Real(contact_slop) * each.radius;
        // A rough test first: nearly all have moved further.
        const bool is_in_place =
            length_squared(moved) < Real(2.0) * near * near && length(moved) < near;
        pair.collisions[i] = select(is_in_place, each.line.recent_collisions + 1, 0);
    }
    pair.offset = pair.position[0] - pair.position[1];
    if (!pass_impulse(pair, record)) return false;
    for (std::size_t i = 0; i < 2; ++i) {
        record.touched[pair.ball[i]] = 1;
        trajectories_.start_straight(pair.ball[i], pair.position[i], pair.motion[i].velocity,
                                     pair.collisions[i]);
    }
    // After an impact the two separate, or nearly so.
    const bool is_separating =
        !StraightApproach<Real>(pair.offset, pair.motion[0].velocity - pair.motion[1].velocity,
                                balls_.radius(pair.ball[0]) + balls_.radius(pair.ball[1]))
             .is_impact();
    for (std::size_t i = 0; i < 2; ++i) {
        predictor_.predict_among_near(pair.ball[i], near_[i],
                                      is_separating ? BallRecord<Real>::none : pair.ball[1 - i]);
        schedule_.update(pair.ball[i]);
    }
    return true;
}

// Passes the impulse, records it, and finds the balls near both. False, and nothing but `pair` has
// changed: the approach is rounding, or one of them touches something else.
template <typename Real>
inline bool UniformMotion<Real>::pass_impulse(Pair& pair, const ImpactRecord& record) {
    const Real distance = length(pair.offset);
    ImpactContact<Real> contact;
    contact.a = 0;
    contact.b = 1;
    contact.normal = pair.offset / distance;
    // More than the rounding that the general response uses: it decides the cases in between.
    const auto sum_of_parts = [](const Vector<Real>& v) { return absolute(v.x) + absolute(v.y); };
    const Real rounding =
        Real(2.0 * residual_rounding<Real>) *
        (sum_of_parts(pair.motion[0].velocity) + sum_of_parts(pair.motion[1].velocity));
    const Real approach = approach_of<Real>(contact, pair.motion);
    const bool can_move = pair.motion[0].inverse_mass + pair.motion[1].inverse_mass > Real{};
    if (!(distance > Real{}) || !can_move || !(approach > rounding)) return false;
    contact.restitution = Real(restitution_of_balls(*scene_.world, pair.ball[0], pair.ball[1]));
    const Real impulse = reflect_alone<Real>(pair.motion, contact);
    if (!(impulse > Real{}) || approach_of<Real>(contact, pair.motion) > Real{}) return false;
    if (!is_off_edges(pair.ball[0], pair.position[0]) ||
        !is_off_edges(pair.ball[1], pair.position[1]))
        return false;
    for (std::size_t i = 0; i < 2; ++i)
        if (!find_near(pair.ball[i], pair.ball[1 - i], pair.position[i], pair.motion[i].velocity,
                       near_[i]))
            return false;
    record.contacts.push_back(
        {.time = static_cast<double>(scene_.now),
         .kind = ContactKind::ball_ball,
         .a = pair.ball[0],
         .b = pair.ball[1],
         .point = Vec2(pair.position[0] - contact.normal * balls_.radius(pair.ball[0])),
         .normal = Vec2(contact.normal),
         .approach = static_cast<double>(approach),
         .impulse = static_cast<double>(impulse)});
    return true;
}

template class UniformMotion<double>;
template class UniformMotion<DoubleDouble>;

}  // namespace carom

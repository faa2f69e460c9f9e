#include "physics/event/schedule/predictor.h"

#include <algorithm>
#include <limits>

#include "physics/event/motion/edge_impact.h"
#include "physics/event/motion/tolerances.h"
#include "physics/memory/branchless.h"

namespace carom {
namespace {

template <typename Real>
constexpr BallEvent<Real> unknown_collision{.kind = EventKind::unknown};

}  // namespace

template <typename Real>
template <MotionTerms terms>
void Predictor<Real>::predict(std::uint32_t ball) {
    constexpr bool is_uniform = terms == MotionTerms::uniform;
    FirstCollision<Real> first;
    bool is_known = is_uniform || foreseen_.can_foresee(ball);
    if (is_known && (is_uniform || scene_.world->model().ball_ball))
        foreseen_.template for_each_near<terms>(
            ball, [&](std::uint32_t other, int across, int along) {
                is_known = is_uniform || (is_known && foreseen_.is_flying(other));
                if (is_known)
                    first = foreseen_.template earlier<terms>(ball, other, across, along, first);
            });
    if constexpr (is_uniform) return choose_next_of_uniform(ball, first);
    balls_.plan(ball).set_collision(is_known ? first.event() : unknown_collision<Real>);
    choose_next(ball);
}

template <typename Real>
void Predictor<Real>::predict_among(std::uint32_t ball,
                                    std::span<const Neighbour<Real>> neighbours) {
    if (!foreseen_.can_foresee(ball)) return predict(ball);
    const Vector<Real> velocity = balls_[ball].line.velocity;
    const bool has_gravity = scene_.world->model().gravity.has_value();
    const bool is_filtered = scene_.world->model().filtered;
    const BallRecord<Real>* const balls = balls_.data();
    const Real now = scene_.now;
    const Neighbour<Real>* const near = neighbours.data();
    const auto count = static_cast<std::uint32_t>(neighbours.size());
    const auto approach_to = [&](const Neighbour<Real>& other) {
        const LinearPart<Real>& line = balls[other.other].line;
        Vector<Real> relative = velocity - line.velocity;
        if (has_gravity) relative += scene_.field.gravity * -(now - line.time);
        return StraightApproach<Real>(other.offset, relative, other.reach);
    };
    // First selects, without branches, the neighbours that may be met, and those whose trajectories
    // have started now too: their offsets may have changed.
    selected_.resize(std::max<std::size_t>(selected_.size(), 2 * std::size_t{count}));
    std::uint32_t* const approached = selected_.data();
    std::uint32_t* const started = selected_.data() + count;
    std::size_t approached_count = 0;
    std::size_t started_count = 0;
    int are_free = 1;
    for (std::uint32_t i = 0; i < count; ++i) {
        const LinearPart<Real>& line = balls[near[i].other].line;
        const auto has_started = static_cast<int>(line.time == now);
        are_free &= static_cast<int>(line.motion == Motion::free);
        approached[approached_count] = started[started_count] = i;
        approached_count += static_cast<std::size_t>(
            static_cast<int>(approach_to(near[i]).is_impact()) & ~has_started);
        started_count += static_cast<std::size_t>(has_started);
    }
    const bool is_known = are_free != 0;
    FirstCollision<Real> first;
    if (is_known) {
        for (std::size_t i = 0; i < started_count; ++i) {
            const Neighbour<Real>& other = near[started[i]];
            first = foreseen_.template earlier<MotionTerms::any>(ball, other.other, other.across,
                                                                 other.along, first);
        }
        for (std::size_t i = 0; i < approached_count; ++i) {
            const Neighbour<Real>& other = near[approached[i]];
            if (is_filtered && !scene_.balls_collide(ball, other.other)) continue;
            first = foreseen_.template earlier<MotionTerms::any>(ball, other.other, other.across,
                                                                 other.along, approach_to(other),
                                                                 now, other.offset, first);
        }
    }
    balls_.plan(ball).set_collision(is_known ? first.event() : unknown_collision<Real>);
    choose_next(ball);
}

template <typename Real>
void Predictor<Real>::predict_among_near(std::uint32_t ball, const NearBalls<Real>& near,
                                         std::uint32_t partner) {
    FirstCollision<Real> first;
    if (partner != BallRecord<Real>::none)
        first = foreseen_.template earlier<MotionTerms::uniform>(ball, partner, 0, 0, first);
    for (std::size_t at = 0; at < near.approached_count; ++at) {
        const std::uint32_t which = near.approached[at];
        first = foreseen_.template earlier<MotionTerms::uniform>(ball, near.other[which], 0, 0,
                                                                 near.approach[which], scene_.now,
                                                                 near.offset[which], first);
    }
    choose_next_of_uniform(ball, first);
}

template <typename Real>
template <MotionTerms terms>
void Predictor<Real>::transfer(std::uint32_t ball, std::uint32_t side) {
    constexpr bool is_uniform = terms == MotionTerms::uniform;
    const BallEvent<Real> known = balls_.plan(ball).collision();
    bool is_known = is_uniform || known.kind != EventKind::unknown;
    FirstCollision<Real> first(known);
    if (is_uniform || side < cell_transfer::sides) {
        // Without a branch on the side.
        const int step = 1 - 2 * static_cast<int>(side & 1);
        const int rows = step & -static_cast<int>(side >> 1);
        const int columns = step - rows;
        space_.cells().step(balls_, ball, columns, rows);
        if (is_known && (is_uniform || scene_.world->model().ball_ball))
            foreseen_.template for_each_new<terms>(
                ball, columns, rows, [&](std::uint32_t other, int across, int along) {
                    is_known = is_uniform || (is_known && foreseen_.is_flying(other));
                    if (is_known)
                        first =
                            foreseen_.template earlier<terms>(ball, other, across, along, first);
                });
    }
    if constexpr (is_uniform) return choose_next_of_uniform(ball, first);
    if (!is_known) return predict(ball);
    balls_.plan(ball).set_collision(first.event());
    choose_next(ball);
}

// The first of all that can happen to the ball from now on, its collision being predicted.
template <typename Real>
void Predictor<Real>::choose_next(std::uint32_t ball) {
    const Model& model = scene_.world->model();
    const bool has_kinematic_edges = !kinematic_.edges().empty();
    if (balls_[ball].line.motion == Motion::still && !has_kinematic_edges)
        return choose_next_of_still(ball);
    search_.begin_at(scene_.now);
    const bool is_known = balls_.plan(ball).collision().kind != EventKind::unknown;
    const bool is_uniform = is_known && !model.gravity;
    BallEvent<Real> best;
    best.time = Real(std::numeric_limits<double>::infinity());
    if (!is_uniform || has_kinematic_edges)
        best = {scene_.now + Real(search_horizon_ticks / scene_.world->rate()),
                EventKind::cell_transfer,
                0,
                0,
                cell_transfer::predict_again,
                0};
    if (is_known) keep_earlier(ball, balls_.plan(ball).collision(), best);
    if (is_uniform)
        keep_earlier(ball, transfers_.template uniform_crossing<true>(ball).event(), best);
    else
        transfers_.predict(ball, best);
    if (model.wrap) transfers_.predict_restart(ball, best);
    transitions_.predict(ball, best);
    if (!is_known && model.ball_ball)
        space_.for_each_ball_near(ball, [&](std::uint32_t other, int across, int along) {
            predict_pair(ball, other, across, along, best);
        });
    if (model.ball_edge) {
        if (balls_[ball].line.motion != Motion::resting) predict_edges(ball, best);
        predict_kinematic_edges(ball, best);
    }
    resume_searches(ball, best);
    balls_.plan(ball).set_next_event(best);
}

// Only moving balls can hit a ball that lies still on cloth. Each of those predicts
// again at its own next event, so this looks no further than that.
template <typename Real>
void Predictor<Real>::choose_next_of_still(std::uint32_t ball) {
    BallEvent<Real> best;
    search_.begin_at(scene_.now);
    if (scene_.world->model().ball_ball)
        space_.for_each_ball_near(ball, [&](std::uint32_t other, int across, int along) {
            const BallEvent<Real> theirs = balls_.plan(other).next_event();
            if (theirs.kind == EventKind::none) return;
            BallEvent<Real> impact;
            impact.time = theirs.time;
            predict_pair(ball, other, across, along, impact);
            if (impact.kind != EventKind::none) keep_earlier(ball, impact, best);
        });
    resume_searches(ball, best);
    balls_.plan(ball).set_next_event(best);
}

// Suspended searches are repeated before anything that comes later than they have looked.
template <typename Real>
void Predictor<Real>::resume_searches(std::uint32_t ball, BallEvent<Real>& best) const {
    if (!search_.resume_time) return;
    keep_earlier(
        ball,
        {*search_.resume_time, EventKind::cell_transfer, 0, 0, cell_transfer::predict_again, 0},
        best);
}

// In uniform motion only a collision, an edge or a cell transfer can come next.
template <typename Real>
inline void Predictor<Real>::choose_next_of_uniform(std::uint32_t ball,
                                                    FirstCollision<Real> first) {
    BallPlan<Real>& plan = balls_.plan(ball);
    const BallEvent<Real> collision = first.event();
    plan.set_collision(collision);
    const auto crossing = transfers_.template uniform_crossing<false>(ball);
    // At the same time, collisions come first.
    const bool leaves = crossing.time < first.time;
    BallEvent<Real> next = collision;
    next.time = leaves ? crossing.time : first.time;
    next.kind =
        static_cast<EventKind>(select(leaves, static_cast<std::uint32_t>(EventKind::cell_transfer),
                                      static_cast<std::uint32_t>(collision.kind)));
    next.other = select(leaves, crossing.side, first.other);
    if (!space_.is_off_edges(ball)) {
        search_.begin_at(scene_.now);
        predict_edges(ball, next);
        resume_searches(ball, next);
    }
    plan.set_next_event(next);
}

// Whether the two may have an impact: not if neither moves, or if one rests on the other.
template <typename Real>
bool Predictor<Real>::may_meet(std::uint32_t ball, std::uint32_t other) const {
    if (scene_.world->model().filtered && !scene_.balls_collide(ball, other)) return false;
    const Motion ours = balls_[ball].line.motion;
    const Motion theirs = balls_[other].line.motion;
    const bool may_stay = ours == Motion::held || ours == Motion::resting || ours == Motion::still;
    if (may_stay && theirs == ours) return false;
    const auto rests_on = [this](std::uint32_t upper, std::uint32_t lower) {
        const auto id = number(scene_.world->balls().id[lower]);
        const AccelerationPart<Real>& curve = balls_.curve(upper);
        return (curve.support.kind == SupportId::Kind::ball && curve.support.number == id) ||
               (curve.second_support.kind == SupportId::Kind::ball &&
                curve.second_support.number == id);
    };
    if (!balls_.may_curve()) return true;
    return !(ours != Motion::free && rests_on(ball, other)) &&
           !(theirs != Motion::free && rests_on(other, ball));
}

template <typename Real>
void Predictor<Real>::predict_pair(std::uint32_t ball, std::uint32_t other, int across, int along,
                                   BallEvent<Real>& best) {
    if (!may_meet(ball, other)) return;
    const Trajectory<Real> ours = balls_.trajectory(ball);
    const Trajectory<Real> theirs = balls_.trajectory(other);
    const Real our_radius = balls_.radius(ball);
    const Real their_radius = balls_.radius(other);
    // Computed as seen from the lower ball, so that both balls find the same bits.
    const Real reach = our_radius + their_radius;
    const Real small = our_radius < their_radius ? our_radius : their_radius;
    auto time = ball < other
                    ? ball_time_of_impact(ours, theirs, scene_.image_shift(across, along), reach,
                                          small, scene_.field, best.time, search_)
                    : ball_time_of_impact(theirs, ours, scene_.image_shift(-across, -along), reach,
                                          small, scene_.field, best.time, search_);
    if (!time) return;
    if (*time < scene_.now) time = scene_.now;
    keep_earlier(ball,
                 {*time, EventKind::ball_ball, static_cast<std::int8_t>(across),
                  static_cast<std::int8_t>(along), other, balls_[other].version},
                 best);
}

template <typename Real>
void Predictor<Real>::predict_edges(std::uint32_t ball, BallEvent<Real>& best) {
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    space_.for_each_edge_near(ball, [&](std::uint32_t capsule, Vec2 shift, int across, int along) {
        if (scene_.is_supported_by(trajectory, capsule, across, along)) return;
        const Edge<Real> edge(scene_.world->capsules().shape[capsule], shift);
        auto time = edge_time_of_impact(trajectory, edge, balls_.radius(ball), scene_.field,
                                        best.time, search_);
        if (!time) return;
        if (*time < scene_.now) time = scene_.now;
        if (!scene_.is_solid(capsule, state_at(trajectory, scene_.field, *time).position, shift))
            return;
        keep_earlier(ball,
                     {*time, EventKind::ball_edge, static_cast<std::int8_t>(across),
                      static_cast<std::int8_t>(along), capsule, 0},
                     best);
    });
}

// A ball that rests or lies still can be hit by these, too.
template <typename Real>
void Predictor<Real>::predict_kinematic_edges(std::uint32_t ball, BallEvent<Real>& best) {
    if (kinematic_.edges().empty()) return;
    const Trajectory<Real> trajectory = balls_.trajectory(ball);
    for (std::uint32_t i = 0; i < kinematic_.edges().size(); ++i) {
        const KinematicEdge<Real>& edge = kinematic_.edges()[i];
        if (!scene_.ball_collides_with(ball, edge.capsule)) continue;
        // At the stop of a seesaw every prediction is outdated.
        const Real horizon = lesser(lesser(scene_.end, kinematic_.next_stop()), best.time);
        const Real begin = trajectory.time < scene_.now ? scene_.now : trajectory.time;
        const auto time = moving_edge_time_of_impact(trajectory, edge.edge, balls_.radius(ball),
                                                     scene_.field, begin, horizon, search_);
        if (!time) continue;
        if (!scene_.is_solid(edge.capsule, state_at(trajectory, scene_.field, *time).position, {}))
            continue;
        keep_earlier(ball, {*time, EventKind::kinematic_edge, 0, 0, i, 0}, best);
    }
}

template class Predictor<double>;
template class Predictor<DoubleDouble>;

#define CAROM_FOR(Real)                                                                      \
    template void Predictor<Real>::predict<MotionTerms::any>(std::uint32_t);                 \
    template void Predictor<Real>::predict<MotionTerms::uniform>(std::uint32_t);             \
    template void Predictor<Real>::transfer<MotionTerms::any>(std::uint32_t, std::uint32_t); \
    template void Predictor<Real>::transfer<MotionTerms::uniform>(std::uint32_t, std::uint32_t);
CAROM_FOR(double)
CAROM_FOR(DoubleDouble)
#undef CAROM_FOR

}  // namespace carom

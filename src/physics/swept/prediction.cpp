#include "physics/swept/prediction.h"

#include <algorithm>

#include "physics/ccd/time_of_impact.h"
#include "physics/laws/bounce.h"
#include "physics/swept/tolerances.h"

namespace carom {
namespace {

constexpr std::uint32_t no_ball = 0xffffffffu;

// Whether two bodies that touch approach by no more than rounding. The speed that gravity gives
// counts: where supports take nearly all of it, the rest has the rounding of the whole.
inline bool is_noise(const Impact& impact, Vec2 velocity, Vec2 other, double fall) {
    if (impact.time > 0.0) return false;
    return -dot(velocity - other, impact.normal) <
           swept_tolerance::rounding * (length(velocity) + length(other) + fall);
}

}  // namespace

bool SweptPrediction::is_void(const SweptEvent& event) const {
    if (event.kind == ContactKind::ball_ball)
        return event.other_version != paths_[event.other].version;
    const HeldEdge* const edge = kinematics_.find(event.other);
    return edge && edge->version != event.other_version;
}

void SweptPrediction::predict_at_start(const World& world) {
    with_terms(step_.terms, [&]<Terms terms>() { predict_pairs_at_start<terms>(world); });
    schedule_.sort_initial(step_.duration);
}

void SweptPrediction::predict_all(const World& world, double now) {
    with_terms(step_.terms, [&]<Terms terms>() {
        for (std::uint32_t i = 0; i < paths_.size(); ++i)
            predict_one<terms>(world, i, now, true);
    });
}

void SweptPrediction::predict(const World& world, std::uint32_t ball, double now) {
    with_terms(step_.terms, [&]<Terms terms>() { predict_one<terms>(world, ball, now, false); });
}

template <Terms terms>
void SweptPrediction::predict_pairs_at_start(const World& world) {
    const auto pairs = candidates_.ball_pairs();
    const auto edges = candidates_.edge_pairs();
    auto pair = pairs.begin();
    auto edge = edges.begin();
    const bool has_kinematic =
        terms.special() && world.model().ball_edge && !kinematics_.is_empty();
    for (std::uint32_t i = 0; i < world.balls().size(); ++i) {
        if (!has_kinematic) {  // skip to the next ball that is near anything
            const std::uint32_t next = std::min(pair != pairs.end() ? pair->first : no_ball,
                                                edge != edges.end() ? edge->ball : no_ball);
            if (next == no_ball) break;
            i = next;
        }
        std::optional<SweptEvent> best;
        for (; pair != pairs.end() && pair->first == i; ++pair)
            predict_ball<terms>(world, i, pair->second, 0.0, best);
        Vec2 image;
        if (terms.wrap()) image = candidates_.image_offset(world, i);
        for (; edge != edges.end() && edge->ball == i; ++edge)
            predict_edge<terms>(
                world, i, edge->capsule,
                {(edge->across + image.x) * step_.torus.x, (edge->along + image.y) * step_.torus.y},
                0.0, best);
        if (has_kinematic)
            for (const HeldEdge& kinematic : kinematics_.edges())
                predict_edge<terms>(world, i, kinematic.capsule, {}, 0.0, best);
        if (best && best->time < step_.duration) schedule_.add_initial(*best);
    }
}

// With `only_higher`, which is for predicting all balls, only the lower number of each pair
// predicts its impact.
template <Terms terms>
void SweptPrediction::predict_one(const World& world, std::uint32_t ball, double now,
                                  bool only_higher) {
    std::optional<SweptEvent> best;
    std::uint64_t tests = 0;
    const SweptCandidates::Place place = candidates_.place_of(world, ball, now);
    if (world.model().ball_ball)
        candidates_.for_each_ball(world, ball, now, place, [&](std::uint32_t other) {
            ++tests;
            if (other == ball || (only_higher && other < ball)) return;
            predict_ball<terms>(world, ball, other, now, best);
        });
    if (world.model().ball_edge && !paths_[ball].is_frozen)
        candidates_.for_each_edge(place, [&](std::uint32_t capsule, Vec2 shift) {
            ++tests;
            predict_edge<terms>(world, ball, capsule, shift, now, best);
        });
    if (terms.special() && world.model().ball_edge)
        for (const HeldEdge& edge : kinematics_.edges())
            predict_edge<terms>(world, ball, edge.capsule, {}, now, best);
    tests_ += tests;
    if (best && best->time < step_.duration) schedule_.push(*best);
}

template <Terms terms>
void SweptPrediction::predict_ball(const World& world, std::uint32_t ball, std::uint32_t other,
                                   double now, std::optional<SweptEvent>& best) const {
    const Balls& balls = world.balls();
    if (terms.special() && !kinds_meet(world, balls.kind[ball], balls.kind[other])) return;
    if (terms.special() && paths_.is_held(ball) && paths_.is_held(other)) return;
    const SweptPath& path = paths_[ball];
    const SweptPath& theirs = paths_[other];
    Vec2 offset = path.chord.position_at(now) - theirs.chord.position_at(now);
    if (terms.wrap()) offset = nearest_image(offset, step_.torus);
    const Vec2 relative = path.chord.velocity - theirs.chord.velocity;
    const auto impact = impact_of_balls(offset, relative, balls.radius[ball], balls.radius[other],
                                        step_.duration - now, [] { return 0.0; });
    if (!impact || is_noise(*impact, path.chord.velocity, theirs.chord.velocity, step_.rest_speed))
        return;
    const SweptEvent event{now + impact->time, ContactKind::ball_ball, ball,          other,
                           path.version,       theirs.version,         impact->normal};
    if (!best || is_earlier(event, *best)) best = event;
}

template <Terms terms>
void SweptPrediction::predict_edge(const World& world, std::uint32_t ball, std::uint32_t capsule,
                                   Vec2 shift, double now, std::optional<SweptEvent>& best) const {
    const Balls& balls = world.balls();
    if (terms.special() &&
        !kind_meets_material(world, balls.kind[ball], world.capsules().material[capsule]))
        return;
    const SweptPath& path = paths_[ball];
    const Vec2 velocity = path.chord.velocity;
    const Disc disc{path.chord.position_at(now), balls.radius[ball]};
    Capsule shape = world.capsules().shape[capsule];
    const HeldEdge* edge = nullptr;
    if (terms.special()) edge = kinematics_.find(capsule);
    if (edge) {
        shape = carom::shape_at(*edge, world, now);
    } else if (terms.wrap()) {
        shape.start += shift;
        shape.end += shift;
    }
    const double left = step_.duration - now;
    const bool is_moving = edge && !edge->is_stopped();
    // At the stop of a seesaw every prediction is void.
    const auto horizon = [&] {
        return edge->is_seesaw ? std::min(left, std::max(0.0, edge->time_of_stop() - now)) : left;
    };
    const auto impact = is_moving ? impact_with_moving_edge(disc, velocity, shape, *edge, horizon())
                                  : first_impact(disc, velocity, shape, left);
    if (!impact || (!edge && is_noise(*impact, velocity, {}, step_.rest_speed))) return;
    if (terms.special() && world.model().one_way &&
        !is_on_solid_side(shape, world.capsules().side[capsule],
                          disc.center + velocity * impact->time))
        return;
    const SweptEvent event{now + impact->time, ContactKind::ball_edge,   ball,          capsule,
                           path.version,       edge ? edge->version : 0, impact->normal};
    if (!best || is_earlier(event, *best)) best = event;
}

// First the paths of the bodies that will meet, then the cells around them, then the entries of
// these cells, then the paths of these neighbours.
void SweptPrediction::prefetch_next(const World& world) const {
    const auto place = [&](const SweptEvent& event) {
        return paths_.position_at(event.ball, event.time);
    };
    if (const SweptEvent* const event = schedule_.upcoming(15)) {
        const auto fetch = [&](std::uint32_t ball) {
            prefetch_line(&paths_[ball]);
            prefetch_line(&world.balls().radius[ball]);
        };
        fetch(event->ball);
        if (event->kind == ContactKind::ball_ball) fetch(event->other);
    }
    if (const SweptEvent* const event = schedule_.upcoming(11)) {
        candidates_.prefetch_starts(place(*event));
        const auto fetch = [&](std::uint32_t ball) {
            candidates_.prefetch_cells(ball, place(*event));
            prefetch_line(&paths_.inverse_mass(ball));
        };
        fetch(event->ball);
        if (event->kind == ContactKind::ball_ball) fetch(event->other);
    }
    if (const SweptEvent* const event = schedule_.upcoming(7))
        candidates_.prefetch_entries(place(*event));
    if (const SweptEvent* const event = schedule_.upcoming(3))
        candidates_.prefetch_paths(place(*event));
}

}  // namespace carom

#include "physics/swept_solver.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/closest.h"
#include "physics/bounce.h"

namespace carom {
namespace {

// On a torus a substep must be so short that no ball meets two images of another in it.
int substeps_needed(const World& world, int wanted) {
    if (!world.model.wrap) return wanted;
    const Vec2 torus = size(*world.model.wrap);
    double fastest = 0.0;
    for (const Vec2 velocity : world.balls.velocity)
        fastest = std::max(fastest, length_squared(velocity));
    double speed = std::sqrt(fastest);
    if (world.model.gravity) speed += length(*world.model.gravity) * world.tick_length();
    const double furthest = std::min(torus.x, torus.y) / 8.0;
    const double needed = std::ceil(speed * world.tick_length() / furthest);
    return std::max(wanted, static_cast<int>(std::min(needed, 10'000.0)));
}

// Whether two bodies that touch approach by no more than rounding. What gravity gives counts: where
// supports take nearly all of it, the rest has the rounding of the whole.
bool is_noise(double time, Vec2 normal, Vec2 velocity, Vec2 other, double fall) {
    if (time > 0.0) return false;
    return -dot(velocity - other, normal) <
           SweptSolver::noise * (length(velocity) + length(other) + fall);
}

}  // namespace

void SweptSolver::tick(World& world, int substeps, std::vector<Contact>& contacts,
                       std::vector<std::uint8_t>& touched) {
    const int count = substeps_needed(world, substeps);
    const double duration = world.tick_length() / count;
    const double start = world.time();
    flight_ = flight_over(world.model.drag, duration);
    duration_ = duration;
    resting_speed_ =
        world.model.gravity ? resting_approach * length(*world.model.gravity) * duration : 0.0;
    slides_first_ = world.model.cloth.has_value();
    torus_ = world.model.wrap ? size(*world.model.wrap) : Vec2{};
    inverse_mass_ = world.balls.inverse_mass;
    for (const HeldBall& held : world.held_balls)
        if (const auto index = index_of(world, held.id)) inverse_mass_[*index] = 0.0;
    for (int i = 0; i < count; ++i) {
        begin_paths(world, 1.0 / (count - i));
        with_terms(terms_of(world), [&]<Terms terms>() {
            substep<terms>(world, duration, start + duration * i, contacts, touched);
        });
        finish_paths(world);
    }
}

void SweptSolver::begin_paths(World& world, double share_of_way) {
    const Balls& balls = world.balls;
    const Vec2 gravity = world.model.gravity.value_or(Vec2{});
    paths_.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        Vec2 velocity = balls.velocity[i];
        if (world.model.speed_limit) velocity = limited(velocity, *world.model.speed_limit);
        paths_[i] = Path{};
        paths_[i].position = balls.position[i];
        paths_[i].start_velocity = velocity;
        paths_[i].gravity = gravity;
        paths_[i].velocity =
            world.model.cloth ? chord(world, static_cast<std::uint32_t>(i), velocity, gravity, 0.0)
                              : travel(flight_, velocity, gravity) / duration_;
    }
    for (const HeldBall& held : world.held_balls) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        Vec2 way = held.target - balls.position[*index];
        if (world.model.wrap) way = nearest_image(way, torus_);
        paths_[*index].velocity = way * (share_of_way / duration_);
    }
    spin_rate_.assign(world.model.spin ? balls.size() : 0, 0.0);
    hands_.clear();
    for (const HeldCapsule& held : world.held_capsules) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        const Capsule& shape = world.capsules.shape[*index];
        hands_.push_back({static_cast<std::uint32_t>(*index),
                          (held.start_target - shape.start) * (share_of_way / duration_),
                          (held.end_target - shape.end) * (share_of_way / duration_),
                          held.is_driven});
    }
}

void SweptSolver::finish_paths(World& world) {
    Balls& balls = world.balls;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const auto ball = static_cast<std::uint32_t>(i);
        const Path& path = paths_[i];
        Vec2 position = position_at(ball, duration_);
        if (world.model.wrap) position = wrapped(position, *world.model.wrap);
        balls.position[i] = position;
        if (world.model.spin)
            balls.spin[i] = path.still || is_held_ball(ball)
                                ? 0.0
                                : balls.spin[i] + spin_rate_[i] * (duration_ - path.time);
        if (path.still || is_held_ball(ball)) {
            balls.velocity[i] = {};
            if (world.model.cloth) balls.roll[i] = {};
            continue;
        }
        if (world.model.cloth) {
            const auto after = on_cloth(world, ball, path.start_velocity, duration_ - path.time);
            balls.velocity[i] = Vec2(after.velocity);
            balls.roll[i] = Vec2(after.roll);
            balls.spin[i] = after.spin;
            continue;
        }
        const Flight flight =
            path.time == 0.0 ? flight_ : flight_over(world.model.drag, duration_ - path.time);
        Vec2 velocity = velocity_after(flight, path.start_velocity, path.gravity);
        if (world.model.speed_limit) velocity = limited(velocity, *world.model.speed_limit);
        balls.velocity[i] = velocity;
    }
    for (const Hand& hand : hands_)
        world.capsules.shape[hand.index] = shape_at(world, hand.index, duration_);
}

template <Terms terms>
void SweptSolver::substep(World& world, double duration, double start_time,
                          std::vector<Contact>& contacts, std::vector<std::uint8_t>& touched) {
    const std::size_t count = world.balls.size();
    double extent = 0.0;  // of a typical path; a few very fast balls must not make all cells large
    for (std::size_t i = 0; i < count; ++i)
        extent += 2.0 * world.balls.radius[i] +
                  std::min(length(paths_[i].velocity) * duration, 8.0 * world.balls.radius[i]);
    const CellFrame frame =
        frame_around(world, count == 0 ? 1.0 : extent / static_cast<double>(count));
    cells_.reset(frame, count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2 from = paths_[i].position;
        const Vec2 to = from + paths_[i].velocity * duration;
        cells_.enter(i, grow(join({from, from}, {to, to}), world.balls.radius[i]));
    }
    if (world.model.ball_edge) edges_.update(world, frame, 0.0);

    queue_.clear();
    for (std::uint32_t i = 0; i < count; ++i)
        predict<terms>(world, i, 0.0, true);
    while (!queue_.empty()) {
        std::pop_heap(queue_.begin(), queue_.end(),
                      [](const Event& a, const Event& b) { return is_earlier(b, a); });
        const Event event = queue_.back();
        queue_.pop_back();
        if (event.ball_version != paths_[event.ball].version) continue;
        if (is_void(event)) {
            predict<terms>(world, event.ball, event.time, false);
            continue;
        }
        const bool on_ball = event.kind == ContactKind::ball_ball;
        const auto contact = on_ball ? collide_balls(world, event) : collide_edge(world, event);
        touched[event.ball] = 1;
        if (on_ball) touched[event.other] = 1;
        if (contact) {
            contacts.push_back(*contact);
            contacts.back().time += start_time;
        }
        if (hand_stopped_) {
            hand_stopped_ = false;
            queue_.clear();
            for (std::uint32_t i = 0; i < count; ++i)
                predict<terms>(world, i, event.time, true);
            continue;
        }
        predict<terms>(world, event.ball, event.time, false);
        if (on_ball) predict<terms>(world, event.other, event.time, false);
    }
}

// Whether the other body has changed its path since the prediction.
bool SweptSolver::is_void(const Event& event) const {
    if (event.kind == ContactKind::ball_ball)
        return event.other_version != paths_[event.other].version;
    const Hand* hand = hand_of(event.other);
    return hand && hand->version != event.other_version;
}

bool SweptSolver::is_earlier(const Event& a, const Event& b) {
    const auto key = [](const Event& e) {
        const bool on_ball = e.kind == ContactKind::ball_ball;
        return std::tuple(e.time, e.kind, on_ball ? std::min(e.ball, e.other) : e.ball,
                          on_ball ? std::max(e.ball, e.other) : e.other, e.ball);
    };
    if (a.time != b.time) return a.time < b.time;
    return key(a) < key(b);
}

void SweptSolver::push(const Event& event) {
    queue_.push_back(event);
    std::push_heap(queue_.begin(), queue_.end(),
                   [](const Event& a, const Event& b) { return is_earlier(b, a); });
}

Vec2 SweptSolver::position_at(std::uint32_t ball, double now) const {
    const Path& path = paths_[ball];
    return path.position + path.velocity * (now - path.time);
}

const SweptSolver::Hand* SweptSolver::hand_of(std::uint32_t capsule) const {
    for (const Hand& hand : hands_)
        if (hand.index == capsule) return &hand;
    return nullptr;
}

Capsule SweptSolver::shape_at(const World& world, std::uint32_t capsule, double now) const {
    Capsule shape = world.capsules.shape[capsule];
    if (const Hand* hand = hand_of(capsule)) {
        const double moved = hand->stopped_at >= 0.0 ? std::min(now, hand->stopped_at) : now;
        shape.start += hand->start_velocity * moved;
        shape.end += hand->end_velocity * moved;
    }
    return shape;
}

// The first impact of a ball from now on, among all that share a cell with its path. The pair's
// other ball predicts it too, so at the start only the lower number does.
template <Terms terms>
void SweptSolver::predict(const World& world, std::uint32_t ball, double now, bool only_later) {
    const Path& path = paths_[ball];
    const Balls& balls = world.balls;
    const double left = duration_ - now;
    const Vec2 position = position_at(ball, now);
    std::optional<Event> best;
    const auto consider = [&](const Event& event) {
        if (!best || is_earlier(event, *best)) best = event;
    };
    if (world.model.ball_ball) {
        cells_.for_each_sharing(ball, [&](std::uint32_t other) {
            if (only_later && other < ball) return;
            if (terms.special() && !kinds_meet(world, balls.kind[ball], balls.kind[other])) return;
            const Path& theirs = paths_[other];
            Vec2 offset = position - position_at(other, now);
            if (terms.wrap()) offset = nearest_image(offset, torus_);
            if (terms.special() && is_held_ball(ball) && is_held_ball(other)) return;
            const auto impact =
                first_impact(Disc{offset, balls.radius[ball]}, path.velocity - theirs.velocity,
                             Disc{{}, balls.radius[other]}, left);
            if (impact && !is_noise(impact->time, impact->normal, path.velocity, theirs.velocity,
                                    resting_speed_))
                consider({now + impact->time, ContactKind::ball_ball, ball, other, path.version,
                          theirs.version, impact->normal});
        });
    }
    if (world.model.ball_edge && !path.still) {
        cells_.for_each_cell(ball, [&](std::uint32_t cell, int across, int along) {
            for (const CapsuleEntry entry : edges_.in_cell(cell))
                predict_edge<terms>(
                    world, ball, entry.index,
                    {(entry.across + across) * torus_.x, (entry.along + along) * torus_.y}, now,
                    best);
        });
    }
    if (terms.special() && world.model.ball_edge)
        for (const Hand& hand : hands_)
            predict_edge<terms>(world, ball, hand.index, {}, now, best);
    if (best && best->time < duration_) push(*best);
}

template <Terms terms>
void SweptSolver::predict_edge(const World& world, std::uint32_t ball, std::uint32_t capsule,
                               Vec2 shift, double now, std::optional<Event>& best) const {
    const Balls& balls = world.balls;
    if (terms.special() &&
        !kind_meets_material(world, balls.kind[ball], world.capsules.material[capsule]))
        return;
    const Path& path = paths_[ball];
    const Disc disc{position_at(ball, now), balls.radius[ball]};
    const double left = duration_ - now;
    Capsule shape = world.capsules.shape[capsule];
    const Hand* hand = terms.special() ? hand_of(capsule) : nullptr;
    std::optional<Impact> impact;
    if (hand) {
        shape = shape_at(world, capsule, now);
        const bool stopped = hand->stopped_at >= 0.0;
        impact = stopped ? first_impact(disc, path.velocity, shape, left)
                         : first_impact(disc, path.velocity, shape, hand->start_velocity,
                                        hand->end_velocity, left);
    } else {
        if (terms.wrap()) {
            shape.start += shift;
            shape.end += shift;
        }
        impact = first_impact(disc, path.velocity, shape, left);
    }
    if (!impact ||
        (!hand && is_noise(impact->time, impact->normal, path.velocity, {}, resting_speed_)))
        return;
    if (terms.special() && world.model.one_way) {
        const Vec2 there = disc.center + path.velocity * impact->time;
        if (!is_on_solid_side(shape, world.capsules.side[capsule], there)) return;
    }
    const Event event{now + impact->time, ContactKind::ball_edge,   ball,          capsule,
                      path.version,       hand ? hand->version : 0, impact->normal};
    if (!best || is_earlier(event, *best)) best = event;
}

}  // namespace carom

#include "physics/overlap_solver.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "geometry/closest.h"
#include "physics/bounce.h"
#include "physics/cloth.h"
#include "physics/fetch.h"

namespace carom {
namespace {

// Marks a ball that was pushed further than its neighbours know edges.
constexpr std::uint8_t strayed = 2;

template <Terms terms>
bool overlap(const World& world, const BallPair& pair) {
    const Balls& balls = world.balls;
    Vec2 offset = balls.position[pair.first] - balls.position[pair.second];
    if (terms.wrap()) offset = nearest_image(offset, size(*world.model.wrap));
    const double reach = balls.radius[pair.first] + balls.radius[pair.second];
    return length_squared(offset) < reach * reach;
}

// Seldom; it costs more to write a velocity of which nothing changes than to see that.
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

}  // namespace

void OverlapSolver::tick(World& world, int updates, int steps, std::vector<Contact>& contacts,
                         std::vector<std::uint8_t>& touched, Patience& patience) {
    const double duration = world.tick_length() / updates;
    const double start = world.time();
    const std::size_t count = world.balls.size();
    inverse_mass_ = world.balls.inverse_mass;
    if (!world.held_balls.empty()) {
        with_held_balls_ = world.balls.inverse_mass;
        for (const HeldBall& held : world.held_balls)
            if (const auto index = index_of(world, held.id)) with_held_balls_[*index] = 0.0;
        inverse_mass_ = with_held_balls_;
    }
    keeps_time_ = steps > 1;
    looks_around_ = updates > 1 || steps > 1;
    is_pushed_.resize(count, 0);
    if (world.model.cloth) before_.resize(count);
    keeps_ways_ = keeps_time_ && (world.model.gravity || world.model.drag ||
                                  world.model.speed_limit || world.model.cloth);
    if (keeps_ways_) way_.resize(count);
    if (keeps_time_) {
        is_active_.resize(count, 0);
        left_.resize(count);
    }
    duration_ = duration;
    has_asked_all_ = false;
    const auto first = static_cast<std::ptrdiff_t>(contacts.size());
    for (int i = 0; i < updates && !patience.is_out(); ++i) {
        move_hands(world, 1.0 / (updates - i));
        with_terms(terms_of(world), [&]<Terms terms>() {
            update<terms>(world, updates, steps, start + duration * (i + 1), contacts, patience);
        });
    }
    for (auto contact = contacts.begin() + first; contact != contacts.end(); ++contact) {
        touched[contact->a] = 1;
        if (contact->kind == ContactKind::ball_ball) touched[contact->b] = 1;
    }
}

// Hands go `share` of what is left of their way, whatever is in it; balls are pushed out of it
// afterwards.
void OverlapSolver::move_hands(World& world, double share) {
    hands_way_ = 0.0;
    for (const HeldBall& held : world.held_balls) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        Vec2& position = world.balls.position[*index];
        Vec2 way = held.target - position;
        if (world.model.wrap) way = nearest_image(way, size(*world.model.wrap));
        position += way * share;
        hands_way_ = std::max(hands_way_, length(way * share));
        world.balls.velocity[*index] = {};
    }
    hands_.assign(world.held_capsules.size(), {});
    for (std::size_t i = 0; i < world.held_capsules.size(); ++i) {
        const HeldCapsule& held = world.held_capsules[i];
        const auto index = index_of(world, held.id);
        if (!index) continue;
        Capsule& shape = world.capsules.shape[*index];
        const Vec2 start = (held.start_target - shape.start) * share;
        const Vec2 end = (held.end_target - shape.end) * share;
        hands_[i] = {start / duration_, end / duration_};
        shape.start += start;
        shape.end += end;
    }
}

template <Terms terms>
void OverlapSolver::update(World& world, int updates, int steps, double end_time,
                           std::vector<Contact>& contacts, Patience& patience) {
    const bool is_forced = world.model.gravity || world.model.drag;
    is_first_step_ = true;
    for (int step = 0; step < steps && (is_first_step_ || !active_.empty()); ++step) {
        const std::size_t moving = is_first_step_ ? world.balls.size() : active_.size();
        if (!patience.lasts(moving)) break;
        if (is_first_step_) {
            const double way =
                is_forced ? move_all<terms, true>(world) : move_all<terms, false>(world);
            if (!still_cover(world, way)) look(world, way * updates);
            part_overlapping<terms>(world, neighbours_.pairs());
        } else {
            is_forced ? move_active<terms, true>(world) : move_active<terms, false>(world);
            if (has_strayed_) neighbours_.look(world, margin_);
            part_active<terms>(world);
        }
        has_strayed_ = false;
        push_out_of_edges<terms>(world);
        if (keeps_time_) keep_time(world);
        exchange_momentum(world, end_time, contacts);
        end_step(world);
    }
    for (const std::uint32_t i : active_)
        is_active_[i] = 0;
    active_.clear();
}

template <Terms terms, bool forced>
Vec2 OverlapSolver::move(World& world, std::uint32_t i, const Flight& flight) {
    Balls& balls = world.balls;
    Vec2 way;
    if (terms.spin() && world.model.cloth) {
        way = move_on_cloth(world, i, flight.duration);
    } else if constexpr (!forced) {
        // No -0 is left, as none is where a gravity is added.
        way = balls.velocity[i] * flight.duration + Vec2{};
        if (has_negative_zero(balls.velocity[i])) balls.velocity[i] += Vec2{};
    } else {
        const Vec2 gravity = world.model.gravity.value_or(Vec2{});
        way = travel(flight, balls.velocity[i], gravity);
        balls.velocity[i] = velocity_after(flight, balls.velocity[i], gravity);
    }
    if (terms.special() && inverse_mass_[i] == 0.0) {
        way = {};
        balls.velocity[i] = {};
        if (terms.spin()) balls.spin[i] = 0.0;
        if (terms.spin() && world.model.cloth) balls.roll[i] = {};
    }
    if (world.model.speed_limit) {
        balls.velocity[i] = limited(balls.velocity[i], *world.model.speed_limit);
        way = limited(way, *world.model.speed_limit * flight.duration);
    }
    balls.position[i] += way;
    if (terms.wrap()) balls.position[i] = wrapped(balls.position[i], *world.model.wrap);
    return way;
}

// How far the ball goes on cloth in `duration`; its state becomes that at the end.
Vec2 OverlapSolver::move_on_cloth(World& world, std::uint32_t ball, double duration) {
    before_[ball] = state_on_cloth(world.balls, ball);
    const auto after =
        cloth_state_after(*world.model.cloth, *world.model.spin, before_[ball], duration);
    take_state(world.balls, ball, after);
    return Vec2(after.position);
}

template <Terms terms, bool forced>
double OverlapSolver::move_all(World& world) {
    const Flight flight = flight_over(world.model.drag, duration_);
    const auto count = static_cast<std::uint32_t>(world.balls.size());
    double longest = 0.0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2 before = world.balls.position[i];
        const Vec2 way = move<terms, forced>(world, i, flight);
        if (keeps_ways_) way_[i] = way;
        if (!looks_around_) continue;
        Vec2 gone = world.balls.position[i] - before;
        if (terms.wrap()) gone = nearest_image(gone, size(*world.model.wrap));
        longest = std::max(longest, length_squared(gone));
    }
    return std::sqrt(longest);
}

// How far around itself each ball looks for others at once, so that the steps of a tick can share
// the answer: at least what the fastest goes in the tick (`way`), unless that is a large part of
// the mean ball. One of a few values, so that the cells seldom change.
void OverlapSolver::look(const World& world, double way) {
    margin_ = 0.0;
    widest_ = std::numeric_limits<double>::infinity();
    are_alike_ = false;
    if (looks_around_ && world.balls.size() > 0) {
        double sum = 0.0;
        double smallest = world.balls.radius[0];
        double largest = smallest;
        for (const double radius : world.balls.radius) {
            sum += radius;
            smallest = std::min(smallest, radius);
            largest = std::max(largest, radius);
        }
        widest_ = 2.0 * largest;
        are_alike_ = smallest == largest;
        margin_ = 0.5 * sum / static_cast<double>(world.balls.size());
        for (int halvings = 0; halvings < 6 && way <= margin_ / 2.0; ++halvings)
            margin_ /= 2.0;
    }
    neighbours_.look(world, margin_);
}

// Whether the neighbours are still those that count when all have moved, none further than `way`.
// Once in a tick every ball is asked where it is; then it is enough how far any of them has gone
// since.
bool OverlapSolver::still_cover(const World& world, double way) {
    if (has_asked_all_) return neighbours_.cover_after(way + hands_way_);
    has_asked_all_ = true;
    return neighbours_.cover(world);
}

template <Terms terms, bool forced>
void OverlapSolver::move_active(World& world) {
    Flight flight;
    for (const std::uint32_t i : active_) {
        if (flight.duration != left_[i]) flight = flight_over(world.model.drag, left_[i]);
        const Vec2 way = move<terms, forced>(world, i, flight);
        if (keeps_ways_) way_[i] = way;
        has_strayed_ = !neighbours_.note_place(i, world.balls.position[i]) || has_strayed_;
    }
}

// The way of a ball that has moved in this step and has not been pushed yet.
Vec2 OverlapSolver::way_of(const World& world, std::uint32_t ball) const {
    if (keeps_ways_) return way_[ball];
    return world.balls.velocity[ball] * (is_first_step_ ? duration_ : left_[ball]) + Vec2{};
}

template <Terms terms>
void OverlapSolver::part_active(World& world) {
    neighbours_.list_by_ball();
    near_active_.clear();
    for (const std::uint32_t i : active_)
        for (const std::uint32_t j : neighbours_.of(i))
            if (j > i || !is_active_[j]) near_active_.push_back({i, j});
    part_overlapping<terms>(world, near_active_);
}

// Whether the two would overlap if they were as large as the largest ball.
template <Terms terms>
bool OverlapSolver::are_near(const World& world, const BallPair& pair) const {
    Vec2 offset = world.balls.position[pair.first] - world.balls.position[pair.second];
    if (terms.wrap()) offset = nearest_image(offset, size(*world.model.wrap));
    return length_squared(offset) < widest_ * widest_;
}

// Which of the pairs overlap is settled before any is parted. The balls of a pair lie anywhere in
// the world's arrays: where they are many they are asked for in time, radii only of those that are
// near.
template <Terms terms>
void OverlapSolver::part_overlapping(World& world, std::span<const BallPair> pairs) {
    const Balls& balls = world.balls;
    const bool are_many = balls.size() >= too_many_to_cache;
    overlapping_.clear();
    const std::size_t ahead = are_many ? 24 : pairs.size();
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        if (p + ahead < pairs.size()) {
            fetch_early(&balls.position[pairs[p + ahead].first]);
            fetch_early(&balls.position[pairs[p + ahead].second]);
        }
        if (!are_near<terms>(world, pairs[p])) continue;
        overlapping_.push_back(pairs[p]);
        if (!are_many || are_alike_) continue;
        fetch_early(&balls.radius[pairs[p].first]);
        fetch_early(&balls.radius[pairs[p].second]);
    }
    if (!are_alike_)
        std::erase_if(overlapping_,
                      [&](const BallPair& pair) { return !overlap<terms>(world, pair); });
    order_.sort(overlapping_, balls.size());
    const std::size_t few = are_many ? 8 : overlapping_.size();
    for (std::size_t p = 0; p < overlapping_.size(); ++p) {
        if (p + few < overlapping_.size()) {
            const BallPair& next = overlapping_[p + few];
            for (const std::uint32_t ball : {next.first, next.second}) {
                fetch_early(&balls.position[ball]);
                fetch_early(&balls.velocity[ball]);
                fetch_early(&balls.radius[ball]);
                fetch_early(&inverse_mass_[ball]);
            }
        }
        part<terms>(world, overlapping_[p].first, overlapping_[p].second);
    }
}

// The pair overlapped when all had moved; others may have parted it since.
template <Terms terms>
void OverlapSolver::part(World& world, std::uint32_t i, std::uint32_t j) {
    Balls& balls = world.balls;
    Vec2 offset = balls.position[i] - balls.position[j];
    if (terms.wrap()) offset = nearest_image(offset, size(*world.model.wrap));
    const double reach = balls.radius[i] + balls.radius[j];
    const double squared = length_squared(offset);
    if (squared >= reach * reach) return;
    if (terms.special() && !kinds_meet(world, balls.kind[i], balls.kind[j])) return;
    note_push(world, i);
    note_push(world, j);
    const Vec2 normal = direction(offset, when_coincident);
    double share_i = 0.5;
    double share_j = 0.5;
    if (terms.special()) {
        const bool i_held = inverse_mass_[i] == 0.0;
        const bool j_held = inverse_mass_[j] == 0.0;
        if (i_held != j_held) {
            share_i = i_held ? 0.0 : 1.0;
            share_j = j_held ? 0.0 : 1.0;
        }
    }
    const double depth = reach - std::sqrt(squared);
    balls.position[i] += normal * (depth * share_i);
    balls.position[j] -= normal * (depth * share_j);
    if (terms.wrap()) {
        balls.position[i] = wrapped(balls.position[i], *world.model.wrap);
        balls.position[j] = wrapped(balls.position[j], *world.model.wrap);
    }
    pairs_.push_back({i, j, ContactKind::ball_ball, {}});
}

// Those that moved: in the first step all, then the active ones, and in every step those that were
// pushed. The neighbours know the edges of all that did not stray.
template <Terms terms>
void OverlapSolver::push_out_of_edges(World& world) {
    if (!world.model.ball_edge) return;
    at_edge_.clear();
    const auto note = [&](const EdgePair& pair) {
        const Disc disc{world.balls.position[pair.ball], world.balls.radius[pair.ball]};
        if (overlaps_edge(world, pair, disc)) at_edge_.push_back(pair);
    };
    for (const Pushed& pushed : pushed_) {
        if (knows_edges(world, pushed)) continue;
        is_pushed_[pushed.ball] = strayed;
        neighbours_.for_each_edge_at(pushed.ball, world.balls.position[pushed.ball], note);
    }
    if (is_first_step_) {
        for (const EdgePair& pair : neighbours_.edges())
            if (is_pushed_[pair.ball] != strayed) note(pair);
    } else {
        const auto look = [&](std::uint32_t ball) {
            if (is_pushed_[ball] != strayed)
                for (const EdgePair& pair : neighbours_.edges_of(ball))
                    note(pair);
        };
        for (const std::uint32_t i : active_)
            look(i);
        for (const Pushed& pushed : pushed_)
            if (!is_active_[pushed.ball]) look(pushed.ball);
    }
    if (terms.special())
        for (const HeldCapsule& held : world.held_capsules)
            if (const auto index = index_of(world, held.id))
                for (std::uint32_t i = 0; i < world.balls.size(); ++i)
                    if (is_first_step_ || is_active_[i] || is_pushed_[i])
                        note({i, static_cast<std::uint32_t>(*index)});
    std::sort(at_edge_.begin(), at_edge_.end());
    for (const EdgePair& pair : at_edge_)
        push_out_of_edge<terms>(world, pair);
}

// Whether the neighbours that were noted tell which edges the ball may touch where it is now.
bool OverlapSolver::knows_edges(const World& world, const Pushed& pushed) const {
    const Vec2 position = world.balls.position[pushed.ball];
    if (margin_ > 0.0) return neighbours_.covers(pushed.ball, position);
    Vec2 way = position - pushed.origin;
    if (world.model.wrap) way = nearest_image(way, size(*world.model.wrap));
    const double margin = 0.999 * neighbours_.edge_margin(world.balls.radius[pushed.ball]);
    return length_squared(way) <= margin * margin;
}

template <Terms terms>
void OverlapSolver::push_out_of_edge(World& world, const EdgePair& pair) {
    const std::uint32_t ball = pair.ball;
    const std::uint32_t capsule = pair.capsule;
    Balls& balls = world.balls;
    Capsule shape = world.capsules.shape[capsule];
    Vec2 shift;
    if (terms.wrap()) {
        const Vec2 torus = size(*world.model.wrap);
        shift = {pair.across * torus.x, pair.along * torus.y};
        shape.start += shift;
        shape.end += shift;
    }
    Vec2& position = balls.position[ball];
    const Vec2 offset = position - closest_point(shape.start, shape.end, position);
    const double reach = balls.radius[ball] + shape.radius;
    const double squared = length_squared(offset);
    if (squared >= reach * reach) return;
    if (terms.special() &&
        !kind_meets_material(world, balls.kind[ball], world.capsules.material[capsule]))
        return;
    if (terms.special() && world.model.one_way &&
        (!is_on_solid_side(shape, world.capsules.side[capsule], position) ||
         dot(balls.velocity[ball], offset) > 0.0))
        return;
    note_push(world, ball);
    const Vec2 across = direction(perpendicular(shape.end - shape.start), when_coincident);
    const Vec2 normal =
        direction(offset, dot(across, balls.velocity[ball]) > 0.0 ? -across : across);
    position += normal * (reach - std::sqrt(squared));
    pairs_.push_back({ball, capsule, ContactKind::ball_edge, shift});
}

// The ball is about to be pushed, perhaps not for the first time in this step.
void OverlapSolver::note_push(const World& world, std::uint32_t ball) {
    if (is_pushed_[ball]) return;
    is_pushed_[ball] = 1;
    const Vec2 position = world.balls.position[ball];
    if (keeps_time_ && (is_first_step_ || is_active_[ball])) {
        const Vec2 way = way_of(world, ball);
        pushed_.push_back({ball, length(way), position - way});
    } else {
        pushed_.push_back({ball, 0.0, position});
    }
}

// What each ball that was pushed has left of its time; the others are done.
void OverlapSolver::keep_time(World& world) {
    Balls& balls = world.balls;
    for (const std::uint32_t i : active_)
        is_active_[i] = 0;
    active_.clear();
    for (const Pushed& pushed : pushed_) {
        const std::uint32_t i = pushed.ball;
        if (!(pushed.intended > 0.0)) continue;
        Vec2 way = balls.position[i] - pushed.origin;
        if (world.model.wrap) way = nearest_image(way, size(*world.model.wrap));
        const double covered = std::min(1.0, length(way) / pushed.intended);
        const double had = is_first_step_ ? duration_ : left_[i];
        const double left = had * (1.0 - covered);
        if (world.model.gravity) balls.velocity[i] -= *world.model.gravity * left;
        // A ball that got nowhere gives up the rest of its time.
        if (covered < 1e-9 || left < 1e-9 * had) continue;
        if (world.model.cloth)
            take_state(
                balls, i,
                cloth_state_after(*world.model.cloth, *world.model.spin, before_[i], had - left));
        left_[i] = left;
        is_active_[i] = 1;
        active_.push_back(i);
    }
}

void OverlapSolver::end_step(const World& world) {
    for (const Pushed& pushed : pushed_) {
        is_pushed_[pushed.ball] = 0;
        has_strayed_ =
            !neighbours_.note_place(pushed.ball, world.balls.position[pushed.ball]) || has_strayed_;
    }
    pushed_.clear();
    pairs_.clear();
    is_first_step_ = false;
}

}  // namespace carom

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/closest.h"
#include "physics/laws/bounce.h"
#include "physics/memory/prefetch.h"
#include "physics/swept/solver.h"

// The impacts of a substep of the solver `swept`, found one after the other; what happens at one is
// in swept_collide.cpp.
namespace carom {
namespace {

// Whether two bodies that touch approach by no more than rounding. What gravity gives counts: where
// supports take nearly all of it, the rest has the rounding of the whole.
bool is_noise(double time, Vec2 normal, Vec2 velocity, Vec2 other, double fall) {
    if (time > 0.0) return false;
    return -dot(velocity - other, normal) <
           SweptSolver::noise * (length(velocity) + length(other) + fall);
}

constexpr std::size_t work_of_impact = 8;  // see Patience

constexpr std::uint32_t nobody = 0xffffffffu;

// A little more, of a few binary digits, so that it seldom changes.
double rounded_up(double value) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    return std::ldexp(std::ceil(fraction * 16.0) / 16.0, exponent);
}

// Whether one frame does as well as the other.
bool are_alike(const CellFrame& a, const CellFrame& b) {
    if (a.wraps || b.wraps) return a == b;
    const auto along = [](double low_a, double cell_a, int count_a, double low_b, double cell_b,
                          int count_b) {
        const double extent_a = cell_a * count_a;
        const double extent_b = cell_b * count_b;
        const double most = 0.25 * std::min(extent_a, extent_b);
        return std::fabs(low_a - low_b) <= most && std::fabs(extent_a - extent_b) <= most &&
               4.0 * cell_a >= 3.0 * cell_b && 3.0 * cell_a <= 4.0 * cell_b;
    };
    return along(a.origin.x, a.cell.x, a.columns, b.origin.x, b.cell.x, b.columns) &&
           along(a.origin.y, a.cell.y, a.rows, b.origin.y, b.cell.y, b.rows);
}

}  // namespace

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

// By slices of time, about one event long.
void SweptSolver::sort_first_events() {
    const std::size_t count = unsorted_.size();
    next_first_ = 0;
    first_events_.resize(count);
    slice_start_.assign(count + 1, 0);
    const double slices = static_cast<double>(count) / duration_;
    const auto slice = [&](const Event& event) {
        return std::min(count - 1, static_cast<std::size_t>(event.time * slices));
    };
    for (const Event& event : unsorted_)
        ++slice_start_[slice(event)];
    std::uint32_t end = 0;
    for (std::uint32_t& start : slice_start_)
        start = end += start;
    for (const Event& event : unsorted_)
        first_events_[--slice_start_[slice(event)]] = event;
    for (std::size_t s = 0; s < count; ++s)
        if (slice_start_[s + 1] > slice_start_[s] + 1)
            std::sort(first_events_.begin() + slice_start_[s],
                      first_events_.begin() + slice_start_[s + 1], is_earlier);
}

// The earliest event of all.
std::optional<SweptSolver::Event> SweptSolver::take_event(const World& world) {
    if (next_first_ < first_events_.size() &&
        (queue_.empty() || is_earlier(first_events_[next_first_], queue_.front()))) {
        if (paths_.size() >= too_many_to_cache) look_ahead(world);
        return first_events_[next_first_++];
    }
    if (queue_.empty()) return std::nullopt;
    std::pop_heap(queue_.begin(), queue_.end(),
                  [](const Event& a, const Event& b) { return is_earlier(b, a); });
    const Event event = queue_.back();
    queue_.pop_back();
    return event;
}

// Fetches from memory what events to come are going to need: first the paths, then what tells who
// lies around them, then who that is, then the paths of these.
void SweptSolver::look_ahead(const World& world) const {
    const DiscGrid& grid = neighbours_.grid();
    const auto coming = [&](std::size_t by) {
        return next_first_ + by < first_events_.size() ? &first_events_[next_first_ + by] : nullptr;
    };
    const auto place = [&](const Event& event) { return position_at(event.ball, event.time); };
    if (const Event* const event = coming(16)) {
        fetch_early(&paths_[event->ball]);
        fetch_early(&world.balls.radius[event->ball]);
        if (event->kind == ContactKind::ball_ball) {
            fetch_early(&paths_[event->other]);
            fetch_early(&world.balls.radius[event->other]);
        }
    }
    if (const Event* const event = coming(12)) {
        grid.fetch_starts(place(*event));
        cells_.fetch(event->ball, place(*event));
        if (event->kind == ContactKind::ball_ball) cells_.fetch(event->other, place(*event));
        fetch_early(&inverse_mass_[event->ball]);
        if (event->kind == ContactKind::ball_ball) fetch_early(&inverse_mass_[event->other]);
    }
    if (const Event* const event = coming(8)) grid.fetch_places(place(*event));
    if (const Event* const event = coming(4))
        grid.for_each_around(place(*event),
                             [&](std::uint32_t ball) { fetch_early(&paths_[ball]); });
}

void SweptSolver::look_around_paths(const World& world) {
    const std::size_t count = world.balls.size();
    centers_.resize(count);
    reaches_.resize(count);
    double extent = 0.0;  // of a typical path; a few very fast balls must not make all cells large
    for (std::uint32_t i = 0; i < count; ++i) {
        const Disc disc = around_path(world, i, 0.0);
        centers_[i] = world.model.wrap ? wrapped(disc.center, *world.model.wrap) : disc.center;
        reaches_[i] = disc.radius;
        extent += std::min(2.0 * disc.radius, 10.0 * world.balls.radius[i]);
    }
    neighbours_.look(world, centers_, reaches_);
    neighbours_.sort_pairs();
    const CellFrame frame =
        frame_around(world, count == 0 ? 1.0 : rounded_up(extent / static_cast<double>(count)));
    // Edges stay in their cells while those still fit fairly.
    are_all_in_cells_ = false;
    changed_paths_ = 0;
    cells_.reset(are_alike(frame, cells_.frame()) ? cells_.frame() : frame, count);
    if (world.model.ball_edge && !neighbours_.has_map()) edges_.update(world, cells_.frame(), 0.0);
}

// Where many have changed their paths, as in a heap, looking in one place is cheaper.
void SweptSolver::enter_the_rest(const World& world) {
    for (std::uint32_t i = 0; i < paths_.size(); ++i)
        if (paths_[i].version == 0) cells_.enter(i, box_of_path(world, i, 0.0), true);
    are_all_in_cells_ = true;
}

// Of each pair only the lower number predicts the impact.
template <Terms terms>
void SweptSolver::predict_all_at_start(const World& world) {
    const auto pairs = neighbours_.pairs();
    const auto edges = neighbours_.edges();
    auto pair = pairs.begin();
    auto edge = edges.begin();
    const bool has_hands = terms.special() && world.model.ball_edge && !hands_.empty();
    for (std::uint32_t i = 0; i < world.balls.size(); ++i) {
        if (!has_hands) {  // on to the next that is near anything
            const std::uint32_t next = std::min(pair != pairs.end() ? pair->first : nobody,
                                                edge != edges.end() ? edge->ball : nobody);
            if (next == nobody) break;
            i = next;
        }
        std::optional<Event> best;
        for (; pair != pairs.end() && pair->first == i; ++pair)
            predict_ball<terms>(world, i, pair->second, 0.0, best);
        Vec2 left_behind;  // on a torus: from the image of the disc to the path
        if (terms.wrap()) left_behind = around_path(world, i, 0.0).center - centers_[i];
        for (; edge != edges.end() && edge->ball == i; ++edge) {
            Vec2 shift{edge->across * torus_.x, edge->along * torus_.y};
            if (terms.wrap())
                shift = {(edge->across + std::floor(left_behind.x / torus_.x + 0.5)) * torus_.x,
                         (edge->along + std::floor(left_behind.y / torus_.y + 0.5)) * torus_.y};
            predict_edge<terms>(world, i, edge->capsule, shift, 0.0, best);
        }
        if (has_hands)
            for (const Hand& hand : hands_)
                predict_edge<terms>(world, i, hand.index, {}, 0.0, best);
        if (best && best->time < duration_) unsorted_.push_back(*best);
    }
}

// The first impact of a ball from now on, among all that its path comes near. The pair's other ball
// predicts it too, so where all are predicted only the lower number does.
template <Terms terms>
void SweptSolver::predict(const World& world, std::uint32_t ball, double now, bool only_later) {
    std::optional<Event> best;
    const Box box = box_of_path(world, ball, now);
    const SweptCells::Range cells = cells_.range_of(box);
    if (world.model.ball_ball) {
        const auto meet = [&](std::uint32_t other) {
            if (other == ball || (only_later && other < ball)) return;
            predict_ball<terms>(world, ball, other, now, best);
        };
        if (!are_all_in_cells_) {
            const Disc disc = around_path(world, ball, now);
            neighbours_.grid().for_each_near(disc.center, disc.radius, [&](std::uint32_t other) {
                if (paths_[other].version == 0) meet(other);
            });
        }
        cells_.for_each_in(cells, meet);
    }
    if (world.model.ball_edge && !paths_[ball].still && neighbours_.has_map()) {
        neighbours_.map().for_each_near(box, [&](std::uint32_t capsule) {
            predict_edge<terms>(world, ball, capsule, {}, now, best);
        });
    } else if (world.model.ball_edge && !paths_[ball].still) {
        cells_.for_each_cell(cells, [&](std::uint32_t cell, int across, int along) {
            if (edges_.is_empty(cell)) return;
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
void SweptSolver::predict_ball(const World& world, std::uint32_t ball, std::uint32_t other,
                               double now, std::optional<Event>& best) const {
    const Balls& balls = world.balls;
    if (terms.special() && !kinds_meet(world, balls.kind[ball], balls.kind[other])) return;
    if (terms.special() && is_held_ball(ball) && is_held_ball(other)) return;
    const Path& path = paths_[ball];
    const Path& theirs = paths_[other];
    Vec2 offset = position_at(ball, now) - position_at(other, now);
    if (terms.wrap()) offset = nearest_image(offset, torus_);
    const Vec2 relative = path.velocity - theirs.velocity;
    const double left = duration_ - now;
    if (stays_apart(offset, relative, balls.radius[ball] + balls.radius[other], left)) return;
    const auto impact = first_impact(Disc{offset, balls.radius[ball]}, relative,
                                     Disc{{}, balls.radius[other]}, left);
    if (!impact ||
        is_noise(impact->time, impact->normal, path.velocity, theirs.velocity, resting_speed_))
        return;
    const Event event{now + impact->time, ContactKind::ball_ball, ball,          other,
                      path.version,       theirs.version,         impact->normal};
    if (!best || is_earlier(event, *best)) best = event;
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

template <Terms terms>
void SweptSolver::substep(World& world, double start_time, std::vector<Contact>& contacts,
                          std::vector<std::uint8_t>& touched, Patience& patience) {
    const auto count = static_cast<std::uint32_t>(world.balls.size());
    look_around_paths(world);
    queue_.clear();
    unsorted_.clear();
    predict_all_at_start<terms>(world);
    sort_first_events();
    while (patience.lasts(work_of_impact)) {
        const std::optional<Event> next = take_event(world);
        if (!next) break;
        const Event& event = *next;
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
            next_first_ = first_events_.size();
            for (std::uint32_t i = 0; i < count; ++i)
                predict<terms>(world, i, event.time, true);
            continue;
        }
        if (!are_all_in_cells_ && 4 * changed_paths_ > count) enter_the_rest(world);
        predict<terms>(world, event.ball, event.time, false);
        if (on_ball) predict<terms>(world, event.other, event.time, false);
    }
}

void SweptSolver::move_along_paths(World& world, double start_time, std::vector<Contact>& contacts,
                                   std::vector<std::uint8_t>& touched, Patience& patience) {
    with_terms(terms_of(world), [&]<Terms terms>() {
        substep<terms>(world, start_time, contacts, touched, patience);
    });
}

}  // namespace carom

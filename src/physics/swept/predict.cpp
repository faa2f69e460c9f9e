#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "physics/laws/bounce.h"
#include "physics/memory/prefetch.h"
#include "physics/swept/solver.h"

// How the solver `swept` finds the impacts of a substep in order of time; collide.cpp resolves
// them.
namespace carom {
namespace {

// Whether two bodies that touch approach by no more than rounding. The speed that gravity gives
// counts: where supports take nearly all of it, the rest has the rounding of the whole.
bool is_noise(double time, Vec2 normal, Vec2 velocity, Vec2 other, double fall) {
    if (time > 0.0) return false;
    return -dot(velocity - other, normal) <
           SweptSolver::noise * (length(velocity) + length(other) + fall);
}

constexpr std::size_t work_of_impact = 8;  // see tick/cancellation.h

constexpr std::uint32_t none = 0xffffffffu;

// Rounded up to a few binary digits, so that it seldom changes.
double rounded_to_few_bits(double value) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    return std::ldexp(std::ceil(fraction * 16.0) / 16.0, exponent);
}

// Whether one frame is nearly as good as the other.
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
    const HeldEdge* const edge = kinematic_edge(event.other);
    return edge && edge->version != event.other_version;
}

// Sorts by bins of time that hold about one event each.
void SweptSolver::sort_initial_events() {
    const std::size_t count = unsorted_.size();
    next_initial_ = 0;
    initial_events_.resize(count);
    bin_start_.assign(count + 1, 0);
    const double bins = static_cast<double>(count) / duration_;
    const auto bin = [&](const Event& event) {
        return std::min(count - 1, static_cast<std::size_t>(event.time * bins));
    };
    for (const Event& event : unsorted_)
        ++bin_start_[bin(event)];
    std::uint32_t end = 0;
    for (std::uint32_t& start : bin_start_)
        start = end += start;
    for (const Event& event : unsorted_)
        initial_events_[--bin_start_[bin(event)]] = event;
    for (std::size_t s = 0; s < count; ++s)
        if (bin_start_[s + 1] > bin_start_[s] + 1)
            std::sort(initial_events_.begin() + bin_start_[s],
                      initial_events_.begin() + bin_start_[s + 1], is_earlier<Event>);
}

// The earliest event of all.
std::optional<SweptSolver::Event> SweptSolver::take_event(const World& world) {
    if (next_initial_ < initial_events_.size() &&
        (queue_.is_empty() || is_earlier(initial_events_[next_initial_], queue_.first()))) {
        if (paths_.size() >= too_many_to_cache) prefetch_next(world);
        return initial_events_[next_initial_++];
    }
    if (queue_.is_empty()) return std::nullopt;
    return queue_.pop();
}

// Prefetches what the next initial events need: first their paths, then the cells around them, then
// the entries of these cells, then the paths of these neighbours. In a gas of 100,000 balls this
// saves a quarter of the time.
void SweptSolver::prefetch_next(const World& world) const {
    const DiscGrid& grid = neighbours_.grid();
    const auto coming = [&](std::size_t by) {
        return next_initial_ + by < initial_events_.size() ? &initial_events_[next_initial_ + by]
                                                           : nullptr;
    };
    const auto place = [&](const Event& event) { return position_at(event.ball, event.time); };
    if (const Event* const event = coming(16)) {
        fetch_early(&paths_[event->ball]);
        fetch_early(&world.balls().radius[event->ball]);
        if (event->kind == ContactKind::ball_ball) {
            fetch_early(&paths_[event->other]);
            fetch_early(&world.balls().radius[event->other]);
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

void SweptSolver::find_neighbours(const World& world) {
    const std::size_t count = world.balls().size();
    centers_.resize(count);
    reaches_.resize(count);
    double extent = 0.0;  // of a typical path; a few very fast balls must not make all cells large
    for (std::uint32_t i = 0; i < count; ++i) {
        const Disc disc = bounding_disc(world, i, 0.0);
        centers_[i] = world.model().wrap ? wrapped(disc.center, *world.model().wrap) : disc.center;
        reaches_[i] = disc.radius;
        extent += std::min(2.0 * disc.radius, 10.0 * world.balls().radius[i]);
    }
    neighbours_.look(world, centers_, reaches_);
    neighbours_.sort_pairs();
    const CellFrame frame = frame_around(
        world, count == 0 ? 1.0 : rounded_to_few_bits(extent / static_cast<double>(count)));
    // Edges stay in their cells while those still fit fairly.
    are_all_in_cells_ = false;
    changed_paths_ = 0;
    cells_.reset(are_alike(frame, cells_.frame()) ? cells_.frame() : frame, count);
    if (world.model().ball_edge && !neighbours_.has_map())
        edges_.update(world, cells_.frame(), 0.0);
}

// Once many balls have changed their paths, as in a pile, one search in `cells_` is cheaper than
// two.
void SweptSolver::enter_remaining(const World& world) {
    for (std::uint32_t i = 0; i < paths_.size(); ++i)
        if (paths_[i].version == 0) cells_.enter(i, bounding_box(world, i, 0.0), true);
    are_all_in_cells_ = true;
}

// Of each pair only the ball with the lower number predicts the impact.
template <Terms terms>
void SweptSolver::predict_all_at_start(const World& world) {
    const auto pairs = neighbours_.pairs();
    const auto edges = neighbours_.edges();
    auto pair = pairs.begin();
    auto edge = edges.begin();
    const bool has_kinematic =
        terms.special() && world.model().ball_edge && !kinematic_edges_.empty();
    for (std::uint32_t i = 0; i < world.balls().size(); ++i) {
        if (!has_kinematic) {  // skip to the next ball that is near anything
            const std::uint32_t next = std::min(pair != pairs.end() ? pair->first : none,
                                                edge != edges.end() ? edge->ball : none);
            if (next == none) break;
            i = next;
        }
        std::optional<Event> best;
        for (; pair != pairs.end() && pair->first == i; ++pair)
            predict_ball<terms>(world, i, pair->second, 0.0, best);
        Vec2 left_behind;  // on a torus: from the image of the disc to the path
        if (terms.wrap()) left_behind = bounding_disc(world, i, 0.0).center - centers_[i];
        for (; edge != edges.end() && edge->ball == i; ++edge) {
            Vec2 shift{edge->across * torus_.x, edge->along * torus_.y};
            if (terms.wrap())
                shift = {(edge->across + std::floor(left_behind.x / torus_.x + 0.5)) * torus_.x,
                         (edge->along + std::floor(left_behind.y / torus_.y + 0.5)) * torus_.y};
            predict_edge<terms>(world, i, edge->capsule, shift, 0.0, best);
        }
        if (has_kinematic)
            for (const HeldEdge& kinematic : kinematic_edges_)
                predict_edge<terms>(world, i, kinematic.capsule, {}, 0.0, best);
        if (best && best->time < duration_) unsorted_.push_back(*best);
    }
}

// Predicts the first impact of a ball from now on. With `only_later`, which is for predicting all
// balls, only the lower number of each pair predicts its impact.
template <Terms terms>
void SweptSolver::predict(const World& world, std::uint32_t ball, double now, bool only_later) {
    std::optional<Event> best;
    const Box box = bounding_box(world, ball, now);
    const SweptCells::Range cells = cells_.range_of(box);
    if (world.model().ball_ball) {
        const auto meet = [&](std::uint32_t other) {
            if (other == ball || (only_later && other < ball)) return;
            predict_ball<terms>(world, ball, other, now, best);
        };
        if (!are_all_in_cells_) {
            const Disc disc = bounding_disc(world, ball, now);
            neighbours_.grid().for_each_near(disc.center, disc.radius, [&](std::uint32_t other) {
                if (paths_[other].version == 0) meet(other);
            });
        }
        cells_.for_each_in(cells, meet);
    }
    if (world.model().ball_edge && !paths_[ball].is_frozen && neighbours_.has_map()) {
        neighbours_.map().for_each_near(box, [&](std::uint32_t capsule) {
            predict_edge<terms>(world, ball, capsule, {}, now, best);
        });
    } else if (world.model().ball_edge && !paths_[ball].is_frozen) {
        cells_.for_each_cell(cells, [&](std::uint32_t cell, int across, int along) {
            if (edges_.is_empty(cell)) return;
            for (const CapsuleEntry entry : edges_.in_cell(cell))
                predict_edge<terms>(
                    world, ball, entry.index,
                    {(entry.across + across) * torus_.x, (entry.along + along) * torus_.y}, now,
                    best);
        });
    }
    if (terms.special() && world.model().ball_edge)
        for (const HeldEdge& edge : kinematic_edges_)
            predict_edge<terms>(world, ball, edge.capsule, {}, now, best);
    if (best && best->time < duration_) queue_.push(*best);
}

template <Terms terms>
void SweptSolver::predict_ball(const World& world, std::uint32_t ball, std::uint32_t other,
                               double now, std::optional<Event>& best) const {
    const Balls& balls = world.balls();
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
        is_noise(impact->time, impact->normal, path.velocity, theirs.velocity, rest_speed_))
        return;
    const Event event{now + impact->time, ContactKind::ball_ball, ball,          other,
                      path.version,       theirs.version,         impact->normal};
    if (!best || is_earlier(event, *best)) best = event;
}

template <Terms terms>
void SweptSolver::predict_edge(const World& world, std::uint32_t ball, std::uint32_t capsule,
                               Vec2 shift, double now, std::optional<Event>& best) const {
    const Balls& balls = world.balls();
    if (terms.special() &&
        !kind_meets_material(world, balls.kind[ball], world.capsules().material[capsule]))
        return;
    const Path& path = paths_[ball];
    const Disc disc{position_at(ball, now), balls.radius[ball]};
    const double left = duration_ - now;
    Capsule shape = world.capsules().shape[capsule];
    const HeldEdge* edge = nullptr;
    if (terms.special()) edge = kinematic_edge(capsule);
    std::optional<Impact> impact;
    if (edge) {
        shape = carom::shape_at(*edge, world, now);
        impact = edge->is_stopped() ? first_impact(disc, path.velocity, shape, left)
                                    : first_impact(disc, path.velocity, shape, edge->start_velocity,
                                                   edge->end_velocity, left);
    } else {
        if (terms.wrap()) {
            shape.start += shift;
            shape.end += shift;
        }
        impact = first_impact(disc, path.velocity, shape, left);
    }
    if (!impact ||
        (!edge && is_noise(impact->time, impact->normal, path.velocity, {}, rest_speed_)))
        return;
    if (terms.special() && world.model().one_way) {
        const Vec2 there = disc.center + path.velocity * impact->time;
        if (!is_on_solid_side(shape, world.capsules().side[capsule], there)) return;
    }
    const Event event{now + impact->time, ContactKind::ball_edge,   ball,          capsule,
                      path.version,       edge ? edge->version : 0, impact->normal};
    if (!best || is_earlier(event, *best)) best = event;
}

template <Terms terms>
void SweptSolver::substep(World& world, double start_time, std::vector<Contact>& contacts,
                          std::vector<std::uint8_t>& touched, Patience& patience) {
    const auto count = static_cast<std::uint32_t>(world.balls().size());
    find_neighbours(world);
    queue_.clear();
    unsorted_.clear();
    predict_all_at_start<terms>(world);
    sort_initial_events();
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
        if (edge_stopped_) {
            edge_stopped_ = false;
            queue_.clear();
            next_initial_ = initial_events_.size();
            for (std::uint32_t i = 0; i < count; ++i)
                predict<terms>(world, i, event.time, true);
            continue;
        }
        if (!are_all_in_cells_ && 4 * changed_paths_ > count) enter_remaining(world);
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

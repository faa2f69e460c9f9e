#include "physics/discrete/solver.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "physics/laws/cloth.h"
#include "physics/world/solver_access.h"

// How the solvers `discrete` and `substep` move balls and kinematic bodies, and what time is left
// to balls whose way was cut short.
namespace carom {
namespace {

// Seldom true. Checking costs less than writing back a velocity that does not change.
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
    const std::size_t count = world.balls().size();
    inverse_mass_ = world.balls().inverse_mass;
    if (!world.held_balls().empty()) {
        with_held_balls_ = world.balls().inverse_mass;
        make_held_balls_immovable(world, with_held_balls_);
        inverse_mass_ = with_held_balls_;
    }
    keeps_time_ = steps > 1;
    shares_neighbours_ = updates > 1 || steps > 1;
    is_pushed_.resize(count, 0);
    if (world.model().cloth) before_.resize(count);
    keeps_displacements_ = keeps_time_ && (world.model().gravity || world.model().drag ||
                                           world.model().speed_limit || world.model().cloth);
    if (keeps_displacements_) displacement_.resize(count);
    if (keeps_time_) {
        is_active_.resize(count, 0);
        left_.resize(count);
    }
    duration_ = duration;
    has_checked_all_ = false;
    const auto first = static_cast<std::ptrdiff_t>(contacts.size());
    for (int i = 0; i < updates && !patience.is_out(); ++i) {
        move_kinematic(world, 1.0 / (updates - i));
        with_terms(terms_of(world), [&]<Terms terms>() {
            update<terms>(world, updates, steps, start + duration * (i + 1), contacts, patience);
        });
    }
    for (auto contact = contacts.begin() + first; contact != contacts.end(); ++contact) {
        touched[contact->a] = 1;
        if (contact->kind == ContactKind::ball_ball) touched[contact->b] = 1;
    }
}

// Kinematic bodies go `share` of what is left of their way, whatever is in it. Balls are pushed out
// of it afterwards.
void OverlapSolver::move_kinematic(World& world, double share) {
    kinematic_way_ = 0.0;
    for (const HeldBall& held : world.held_balls()) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        Vec2& position = SolverAccess(world).balls().position[*index];
        const Vec2 way = rest_of_way(world, held, position);
        position += way * share;
        kinematic_way_ = std::max(kinematic_way_, length(way * share));
        SolverAccess(world).balls().velocity[*index] = {};
    }
    list_kinematic_edges(world, kinematic_edges_);
    for (HeldEdge& edge : kinematic_edges_) {
        const HeldCapsule& held = world.held_capsules()[edge.held];
        Capsule& shape = SolverAccess(world).capsules().shape[edge.capsule];
        const Vec2 start = (held.start_target - shape.start) * share;
        const Vec2 end = (held.end_target - shape.end) * share;
        edge.start_velocity = start / duration_;
        edge.end_velocity = end / duration_;
        shape.start += start;
        shape.end += end;
    }
}

template <Terms terms>
void OverlapSolver::update(World& world, int updates, int steps, double end_time,
                           std::vector<Contact>& contacts, Patience& patience) {
    const bool is_forced = world.model().gravity || world.model().drag;
    is_first_step_ = true;
    for (int step = 0; step < steps && (is_first_step_ || !active_.empty()); ++step) {
        const std::size_t moving = is_first_step_ ? world.balls().size() : active_.size();
        if (!patience.lasts(moving)) break;
        if (is_first_step_) {
            const double way =
                is_forced ? move_all<terms, true>(world) : move_all<terms, false>(world);
            if (!neighbours_are_valid(world, way)) find_neighbours(world, way * updates);
        } else {
            is_forced ? move_active<terms, true>(world) : move_active<terms, false>(world);
            if (has_escaped_) neighbours_.look(world, margin_);
        }
        has_escaped_ = false;
        separate_bodies(world);
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
    Balls& balls = SolverAccess(world).balls();
    Vec2 way;
    if (terms.spin() && world.model().cloth) {
        way = move_on_cloth(world, i, flight.duration);
    } else if constexpr (!forced) {
        // Adding 0 turns -0 into 0, as adding a gravity does.
        way = balls.velocity[i] * flight.duration + Vec2{};
        if (has_negative_zero(balls.velocity[i])) balls.velocity[i] += Vec2{};
    } else {
        const Vec2 gravity = world.model().gravity.value_or(Vec2{});
        way = travel(flight, balls.velocity[i], gravity);
        balls.velocity[i] = velocity_after(flight, balls.velocity[i], gravity);
    }
    if (terms.special() && inverse_mass_[i] == 0.0) {
        way = {};
        balls.velocity[i] = {};
        if (terms.spin()) balls.spin[i] = 0.0;
        if (terms.spin() && world.model().cloth) balls.roll[i] = {};
    }
    if (world.model().speed_limit) {
        balls.velocity[i] = limited(balls.velocity[i], *world.model().speed_limit);
        way = limited(way, *world.model().speed_limit * flight.duration);
    }
    balls.position[i] += way;
    if (terms.wrap()) balls.position[i] = wrapped(balls.position[i], *world.model().wrap);
    return way;
}

// The displacement on cloth in `duration`. The ball takes on its state at the end.
Vec2 OverlapSolver::move_on_cloth(World& world, std::uint32_t ball, double duration) {
    before_[ball] = state_on_cloth(world.balls(), ball);
    const auto after =
        cloth_state_after(*world.model().cloth, *world.model().spin, before_[ball], duration);
    take_state(SolverAccess(world).balls(), ball, after);
    return Vec2(after.position);
}

template <Terms terms, bool forced>
double OverlapSolver::move_all(World& world) {
    const Flight flight = flight_over(world.model().drag, duration_);
    const auto count = static_cast<std::uint32_t>(world.balls().size());
    double longest = 0.0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2 before = world.balls().position[i];
        const Vec2 way = move<terms, forced>(world, i, flight);
        if (keeps_displacements_) displacement_[i] = way;
        if (!shares_neighbours_) continue;
        Vec2 gone = world.balls().position[i] - before;
        if (terms.wrap()) gone = nearest_image(gone, size(*world.model().wrap));
        longest = std::max(longest, length_squared(gone));
    }
    return std::sqrt(longest);
}

// Builds the neighbour list with a margin that lets the steps of a tick share it: at least what the
// fastest ball goes in the tick (`way`), unless that is a large part of the mean radius. The margin
// takes one of a few values, so that the cells seldom change.
void OverlapSolver::find_neighbours(const World& world, double way) {
    margin_ = 0.0;
    widest_ = std::numeric_limits<double>::infinity();
    are_alike_ = false;
    if (shares_neighbours_ && world.balls().size() > 0) {
        double sum = 0.0;
        double smallest = world.balls().radius[0];
        double largest = smallest;
        for (const double radius : world.balls().radius) {
            sum += radius;
            smallest = std::min(smallest, radius);
            largest = std::max(largest, radius);
        }
        widest_ = 2.0 * largest;
        are_alike_ = smallest == largest;
        margin_ = 0.5 * sum / static_cast<double>(world.balls().size());
        for (int halvings = 0; halvings < 6 && way <= margin_ / 2.0; ++halvings)
            margin_ /= 2.0;
    }
    neighbours_.look(world, margin_);
}

// Whether the neighbour list still holds now that all balls have moved, none further than `way`.
// Once a tick every ball is checked; after that the longest displacements since add up.
bool OverlapSolver::neighbours_are_valid(const World& world, double way) {
    if (has_checked_all_) return neighbours_.cover_after(way + kinematic_way_);
    has_checked_all_ = true;
    return neighbours_.cover(world);
}

template <Terms terms, bool forced>
void OverlapSolver::move_active(World& world) {
    Flight flight;
    for (const std::uint32_t i : active_) {
        if (flight.duration != left_[i]) flight = flight_over(world.model().drag, left_[i]);
        const Vec2 way = move<terms, forced>(world, i, flight);
        if (keeps_displacements_) displacement_[i] = way;
        has_escaped_ = !neighbours_.note_place(i, world.balls().position[i]) || has_escaped_;
    }
}

// The time that each pushed ball has left; all other balls are done.
void OverlapSolver::keep_time(World& world) {
    Balls& balls = SolverAccess(world).balls();
    for (const std::uint32_t i : active_)
        is_active_[i] = 0;
    active_.clear();
    for (const Pushed& pushed : pushed_) {
        const std::uint32_t i = pushed.ball;
        if (!(pushed.intended > 0.0)) continue;
        Vec2 way = balls.position[i] - pushed.origin;
        if (world.model().wrap) way = nearest_image(way, size(*world.model().wrap));
        const double covered = std::min(1.0, length(way) / pushed.intended);
        const double had = is_first_step_ ? duration_ : left_[i];
        const double left = had * (1.0 - covered);
        if (world.model().gravity) balls.velocity[i] -= *world.model().gravity * left;
        // A ball that got nowhere gives up the rest of its time.
        if (covered < 1e-9 || left < 1e-9 * had) continue;
        if (world.model().cloth)
            take_state(balls, i,
                       cloth_state_after(*world.model().cloth, *world.model().spin, before_[i],
                                         had - left));
        left_[i] = left;
        is_active_[i] = 1;
        active_.push_back(i);
    }
}

void OverlapSolver::end_step(const World& world) {
    for (const Pushed& pushed : pushed_) {
        is_pushed_[pushed.ball] = 0;
        has_escaped_ = !neighbours_.note_place(pushed.ball, world.balls().position[pushed.ball]) ||
                       has_escaped_;
    }
    pushed_.clear();
    pairs_.clear();
    is_first_step_ = false;
}

}  // namespace carom

#include "physics/tick/mover_step.h"

#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "physics/laws/bounce.h"
#include "physics/tick/kinematic.h"
#include "physics/tick/overlap.h"

namespace carom {
namespace {

// The smallest share that is tried before 0, and the one from which a stopped mover starts again.
constexpr double least_part = 1.0 / 64.0;
// A solver's rounding of a displacement, as a share of the whole.
constexpr double way_rounding = 1e-6;
// Of a place, as a share of its distance from the origin.
constexpr double place_rounding = 1e-12;
// Pushes make overlaps deeper by no more than this, in radii.
constexpr double most_squeeze = 0.02;
// An elastic impact with a mover changes a speed by twice that of the mover; two of them in a tick
// are no sign of a jam.
constexpr double most_push = 4.0;
// A ball that stands still after more impacts with movers in the tick is jammed.
constexpr std::uint32_t most_hits = 16;

// Twice the energy of a ball's motion and rotation, divided by its mass.
double square_of(const World& world, std::uint32_t ball) {
    const Balls& balls = world.balls();
    double square = length_squared(balls.velocity[ball]);
    if (world.model().spin) {
        const double turning = balls.radius[ball] * balls.spin[ball];
        square += *world.model().spin * turning * turning;
        if (world.model().cloth) square += *world.model().spin * length_squared(balls.roll[ball]);
    }
    return square;
}

}  // namespace

MoverClock MoverStep::clock_of(const World& world, const Active& active) const {
    return clock_after(world.movers()[active.mover], active.share * world.tick_length());
}

bool MoverStep::begin(World& world) {
    if (world.movers().empty() && active_.empty()) return false;
    active_.clear();
    edges_.clear();
    for (std::uint32_t m = 0; m < world.movers().size(); ++m) {
        const Mover& mover = world.movers()[m];
        if (!mover.runs || mover.edges.empty()) continue;
        Active active{.mover = m};
        const double next = clock_of(world, active).clock;
        for (std::uint32_t e = 0; e < mover.edges.size(); ++e) {
            const auto index = index_of(world, mover.edges[e].capsule);
            if (!index) continue;
            const Capsule from = mover_shape(mover, mover.edges[e], mover.clock);
            const Capsule to = mover_shape(mover, mover.edges[e], next);
            const double way = std::max(distance(from.start, to.start), distance(from.end, to.end));
            active.pace = std::max(active.pace, way * world.rate());
            edges_.push_back({.active = static_cast<std::uint32_t>(active_.size()),
                              .edge = e,
                              .capsule = static_cast<std::uint32_t>(*index)});
        }
        active.share = std::min(1.0, std::max(2.0 * mover.share, least_part));
        active_.push_back(active);
    }
    if (edges_.empty()) return false;
    std::ranges::sort(edges_, {}, &Edge::capsule);
    for (const Edge& edge : edges_)
        hold(world, {.id = world.capsules().id[edge.capsule], .is_driven = true});
    return true;
}

void MoverStep::aim(World& world) const {
    std::vector<HeldCapsule>& held = world.edit_held_capsules();
    auto at = held.begin();
    for (const Edge& edge : edges_) {
        const Active& active = active_[edge.active];
        const Mover& mover = world.movers()[active.mover];
        const Capsule shape = active.share > 0.0 ? mover_shape(mover, mover.edges[edge.edge],
                                                               clock_of(world, active).clock)
                                                 : world.capsules().shape[edge.capsule];
        at = std::ranges::lower_bound(at, held.end(), world.capsules().id[edge.capsule], {},
                                      &HeldCapsule::id);
        at->start_target = shape.start;
        at->end_target = shape.end;
    }
}

const MoverStep::Edge* MoverStep::find(std::uint32_t capsule) const {
    const auto found = std::ranges::lower_bound(edges_, capsule, {}, &Edge::capsule);
    return found != edges_.end() && found->capsule == capsule ? &*found : nullptr;
}

// Unites what has met in this tick. Fixed edges unite nothing.
void MoverStep::find_sets(const Trial& trial) {
    balls_ = static_cast<std::uint32_t>(trial.after.balls().size());
    sets_.reset(balls_ + active_.size());
    most_change_.assign(balls_, 0.0);
    impacts_.assign(balls_, 0);
    const double pull = length(trial.before.model().gravity.value_or(Vec2{}));
    for (const Contact& contact : trial.contacts) {
        if (contact.kind == ContactKind::ball_ball) {
            sets_.unite(contact.a, contact.b);
        } else if (const Edge* const edge = find(contact.b)) {
            Active& active = active_[edge->active];
            active.has_met = true;
            ++impacts_[contact.a];
            sets_.unite(contact.a, balls_ + edge->active);
            const double lift =
                std::sqrt(2.0 * driven_lift_height * pull * trial.before.balls().radius[contact.a]);
            most_change_[contact.a] =
                std::max(most_change_[contact.a], most_push * active.share * active.pace + lift);
        }
    }
}

// The movers that the ball's set has met are at fault.
void MoverStep::blame(std::uint32_t ball) {
    const std::uint32_t root = sets_.root_of(ball);
    for (std::uint32_t i = 0; i < active_.size(); ++i)
        if (sets_.root_of(balls_ + i) == root) active_[i].is_at_fault = true;
}

// Whether the ball leaves what it has met in the contact, at the end of the tick.
bool MoverStep::separates(const Trial& trial, const Contact& contact) {
    const Balls& balls = trial.after.balls();
    Vec2 other;
    if (contact.kind == ContactKind::ball_ball) {
        other = balls.velocity[contact.b];
    } else {
        const Capsule& was = trial.before.capsules().shape[contact.b];
        const Capsule& is = trial.after.capsules().shape[contact.b];
        const double at = closest_parameter(is.start, is.end, balls.position[contact.a]);
        const Vec2 way = (is.start - was.start) * (1.0 - at) + (is.end - was.end) * at;
        other = way * trial.after.rate();
    }
    return dot(balls.velocity[contact.a] - other, contact.normal) > 0.0;
}

// `contact` freezes a ball that an impact has made so fast that it leaves its skin, and stops edges
// that come at it. That is no jam: the ball leaves the edge in the next tick.
bool MoverStep::has_thrown_a_frozen_ball(const Trial& trial) const {
    return std::ranges::any_of(trial.contacts, [&](const Contact& contact) {
        return contact.kind == ContactKind::ball_edge && find(contact.b) &&
               impacts_[contact.a] <= most_hits && separates(trial, contact) &&
               std::ranges::count(trial.standing, contact.a) > 0;
    });
}

// Edges that have not got to their targets, and balls that stand still. A solver that stops one
// edge stops all of them: at fault are movers that have met a ball, else those that yield already.
void MoverStep::check_places(const Trial& trial) {
    const std::vector<HeldCapsule>& held = trial.after.held_capsules();
    auto at = held.begin();
    bool is_stopped = false;
    for (const Edge& edge : edges_) {
        at = std::ranges::lower_bound(at, held.end(), trial.after.capsules().id[edge.capsule], {},
                                      &HeldCapsule::id);
        const Capsule& was = trial.before.capsules().shape[edge.capsule];
        const Capsule& is = trial.after.capsules().shape[edge.capsule];
        const auto has_come = [](Vec2 from, Vec2 to, Vec2 target) {
            return distance(to, target) <=
                   way_rounding * distance(from, target) + place_rounding * length(target);
        };
        is_stopped = is_stopped || !has_come(was.start, is.start, at->start_target) ||
                     !has_come(was.end, is.end, at->end_target);
    }
    if (is_stopped && !has_thrown_a_frozen_ball(trial)) {
        const auto blame_all = [&](auto&& is_suspect) {
            for (Active& active : active_)
                active.is_at_fault = is_suspect(active);
            return std::ranges::any_of(active_, &Active::is_at_fault);
        };
        blame_all([](const Active& active) { return active.has_met; }) ||
            blame_all([](const Active& active) { return active.share < 1.0; }) ||
            blame_all([](const Active&) { return true; });
    }
    for (const std::uint32_t ball : trial.standing)
        if (impacts_[ball] > most_hits) blame(ball);
}

// A new overlap of bodies that separate again is no jam: `discrete` and `substep` notice impacts by
// it, and `contact` freezes what it has thrown.
void MoverStep::check_overlaps(const Trial& trial) {
    const auto is_pressed = [&](const Contact& contact, double before, double after) {
        return after > most_squeeze && after > before + way_rounding &&
               (before > 0.0 || !(trial.overlaps_at_impacts || separates(trial, contact)));
    };
    const Capsules& was = trial.before.capsules();
    const Capsules& is = trial.after.capsules();
    for (const Contact& contact : trial.contacts) {
        const std::uint32_t a = contact.a;
        const std::uint32_t b = contact.b;
        if (contact.kind == ContactKind::ball_ball) {
            if (is_pressed(contact, relative_overlap(trial.before, a, b),
                           relative_overlap(trial.after, a, b)))
                blame(a);
            continue;
        }
        if (!is.side.empty() && is.side[b] != Side::both) continue;
        if (is_pressed(contact, relative_overlap(trial.before, a, was.shape[b]),
                       relative_overlap(trial.after, a, is.shape[b])) ||
            (find(b) && has_crossed(was.shape[b], is.shape[b], trial.before.balls().position[a],
                                    trial.after.balls().position[a])))
            blame(a);
    }
}

void MoverStep::check_energies(const Trial& trial) {
    const World& before = trial.before;
    energy_.assign(sets_.size(), {});
    for (std::uint32_t i = 0; i < active_.size(); ++i)
        energy_[sets_.root_of(balls_ + i)].has_mover = true;
    const double fall =
        2.0 * length(before.model().gravity.value_or(Vec2{})) * before.tick_length();
    for (std::uint32_t i = 0; i < balls_; ++i) {
        Energy& set = energy_[sets_.root_of(i)];
        if (!set.has_mover) continue;
        const double mass = 1.0 / before.balls().inverse_mass[i];
        const double speed = std::sqrt(square_of(before, i)) + fall;
        set.before += 0.5 * mass * speed * speed;
        set.after += 0.5 * mass * square_of(trial.after, i);
    }
    // A ball may have taken all of the energy of its set before it meets the mover.
    for (std::uint32_t i = 0; i < balls_; ++i) {
        if (most_change_[i] == 0.0) continue;
        Energy& set = energy_[sets_.root_of(i)];
        const double mass = 1.0 / before.balls().inverse_mass[i];
        const double speed = std::sqrt(2.0 * set.before / mass);
        set.gain += 0.5 * mass * most_change_[i] * (2.0 * speed + most_change_[i]);
    }
    for (const HeldBall& ball : before.held_balls())
        if (const auto index = index_of(before, ball.id))
            energy_[sets_.root_of(static_cast<std::uint32_t>(*index))].is_thrown = true;
    for (const Contact& contact : trial.contacts) {
        if (contact.kind == ContactKind::ball_ball || find(contact.b)) continue;
        if (is_held(trial.after, before.capsules().id[contact.b]) ||
            before.materials()[before.capsules().material[contact.b]].kick > 0.0)
            energy_[sets_.root_of(contact.a)].is_thrown = true;
    }
    for (std::uint32_t i = 0; i < active_.size(); ++i) {
        const Energy& set = energy_[sets_.root_of(balls_ + i)];
        if (!set.is_thrown && set.after > (set.before + set.gain) * (1.0 + way_rounding))
            active_[i].is_at_fault = true;
    }
}

bool MoverStep::is_sound(const Trial& trial) {
    for (Active& active : active_)
        active.is_at_fault = active.has_met = false;
    find_sets(trial);
    check_places(trial);
    if (std::ranges::any_of(active_, &Active::has_met)) {
        check_overlaps(trial);
        check_energies(trial);
    }
    bool is_sound = true;
    for (Active& active : active_) {
        if (!active.is_at_fault || active.share == 0.0) continue;
        active.share = active.share > least_part ? 0.5 * active.share : 0.0;
        is_sound = false;
    }
    return is_sound;
}

void MoverStep::end(World& world) const {
    for (const Active& active : active_) {
        Mover& mover = world.edit_movers()[active.mover];
        mover.share = active.share;
        if (active.share == 0.0) continue;
        const MoverClock next = clock_of(world, active);
        mover.clock = next.clock;
        mover.runs = next.runs;
    }
    std::vector<Capsule>& shapes = world.edit_capsules().shape;
    for (const Edge& edge : edges_) {
        const Active& active = active_[edge.active];
        const Mover& mover = world.movers()[active.mover];
        if (active.share > 0.0)
            shapes[edge.capsule] = mover_shape(mover, mover.edges[edge.edge], mover.clock);
    }
}

}  // namespace carom

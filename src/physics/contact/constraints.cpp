#include "physics/contact/constraints.h"

#include <algorithm>

#include "physics/contact/change_impulse.h"
#include "physics/contact/energy.h"
#include "physics/contact/tolerances.h"

namespace carom {

// The impulses of the last substep, in one go.
template <bool spin>
inline void ContactConstraints::apply(const ContactPair& constraint) {
    ContactBody& a = bodies_.body[constraint.a];
    ContactBody& b = bodies_.body[constraint.b];
    Vec2 push = constraint.normal * constraint.impulse;
    if constexpr (spin) {
        const double tangential = constraint.tangential_impulse;
        push += perpendicular(constraint.normal) * tangential;
        a.surface_speed -= tangential * a.inverse_mass * step_.spin_ease;
        if (constraint.b != bodies_.fixed)
            b.surface_speed -= tangential * b.inverse_mass * step_.spin_ease;
    }
    a.velocity += push * a.inverse_mass;
    if (constraint.b != bodies_.fixed) b.velocity -= push * b.inverse_mass;
}

// At this target, a pair that does not move keeps its impulse. `given_back`: what is given back of
// it, in shares of the mass.
inline double ContactConstraints::holding_target(const ContactPair& pair, double given_back) const {
    const double ease = bodies_.body[pair.a].inverse_mass + bodies_.body[pair.b].inverse_mass;
    return -given_back * pair.impulse * ease;
}

template <bool spin>
void ContactConstraints::begin_all() {
    nothing_ = ContactPair{.a = bodies_.fixed, .b = bodies_.fixed};
    new_.clear();
    const double per_substep = 1.0 / step_.duration;
    const bool only_holds = !energy_.may_open();
    const double deepest_held = -contact_tolerance::deep_overlap * bodies_.smallest_radius;
    const ContactSoftness softness = step_.softness;
    const double given_back = softness.impulse_share / softness.mass_share;
    double springs = 0.0;
    ContactPair* before = nullptr;  // the constraint before, if it has no neighbour yet
    for (const std::uint32_t p : classification_.constraints()) {
        ContactPair& pair = pairs_[p];
        const double gap = pair.separation;
        double target = gap * per_substep;
        if (gap < 0.0) {
            const double stiffness =
                1.0 + std::min(-gap * (contact_tolerance::overlap_limit *
                                       contact_tolerance::stiffening / overlap_bound(pair)),
                               contact_tolerance::most_stiffening);
            target = gap * (stiffness * softness.push);
            if (only_holds && gap > deepest_held)
                target = std::max(target, holding_target(pair, given_back));
            springs += pair.mass * gap * gap * stiffness;
        }
        pair.target = target;
        if (pair.is_new) new_.push_back(p);
        pair.is_persistent = pair.impulse > 0.0;
        pair.has_pressed = pair.has_neighbour = false;
        const bool is_neighbour = before && !share_body(*before, pair);
        if (is_neighbour) before->has_neighbour = true;
        before = is_neighbour ? nullptr : &pair;
        apply<spin>(pair);
    }
    energy_.begin_substep(0.5 * step_.softness.spring * springs);
}

bool ContactConstraints::share_body(const ContactPair& one, const ContactPair& other) const {
    return one.a == other.a || one.a == other.b || one.b == other.a ||
           (one.b == other.b && one.b != bodies_.fixed);
}

template <bool spin>
inline void ContactConstraints::solve(ContactPair& first, ContactPair& second) {
    using contact_lanes::both;
    const F64x2 target = both(first, second, &ContactPair::target);
    const F64x2 impulse = both(first, second, &ContactPair::impulse);
    const auto is_open = target > F64x2{};
    const F64x2 one{1.0, 1.0};
    const F64x2 mass =
        (is_open ? one : one * step_.softness.mass_share) * both(first, second, &ContactPair::mass);
    const F64x2 given_back = is_open ? F64x2{} : one * step_.softness.impulse_share;
    const F64x2 change = mass * (separating_speeds(first, second) + target) + given_back * impulse;
    change_impulses<spin>(first, second, at_least(F64x2{}, impulse - change));
}

// A pair without an impulse may close its gap within a substep, but no faster. A pair that pressed
// in the last substep is over-relaxed, since its neighbours undo a part of the change.
// `most_more`: how much faster at most.
template <bool spin>
inline void ContactConstraints::relax(ContactPair& first, ContactPair& second, double most_more) {
    using contact_lanes::both;
    const F64x2 impulse = both(first, second, &ContactPair::impulse);
    const F64x2 room =
        impulse == F64x2{} ? at_least(F64x2{}, both(first, second, &ContactPair::target)) : F64x2{};
    const F64x2 speed = separating_speeds(first, second) + room;
    const F64x2 most{first.is_persistent ? most_more : 0.0, second.is_persistent ? most_more : 0.0};
    const F64x2 more = at_least(-most, at_most(most, contact_tolerance::over_relaxation * speed));
    const F64x2 change = both(first, second, &ContactPair::mass) * (speed + more);
    first.has_pressed |= impulse[0] > 0.0;
    second.has_pressed |= impulse[1] > 0.0;
    change_impulses<spin>(first, second, at_least(F64x2{}, impulse - change));
}

// A pair that is about to bounce takes no impulse from a ball that has just bounced.
bool ContactConstraints::is_about_to_bounce(const ContactPair& pair) const {
    return pair.bounces && -separating_speed(pair) > step_.rest_speed;
}

template <bool spin>
void ContactConstraints::solve_all(bool downwards) {
    if (downwards)
        downwards_by_twos([&](auto& first, auto& second) { solve<spin>(first, second); });
    else
        upwards_by_twos([&](auto& first, auto& second) { solve<spin>(first, second); });
}

template <bool spin>
void ContactConstraints::relax_all(double most_more) {
    downwards_by_twos([&, had_impacts = had_impacts_](ContactPair& first, ContactPair& second) {
        const bool skips_first = had_impacts && is_about_to_bounce(first);
        const bool skips_second = had_impacts && is_about_to_bounce(second);
        if (skips_first && skips_second) return;
        relax<spin>(skips_first ? second : first, skips_first || skips_second ? nothing_ : second,
                    most_more);
    });
}

void ContactConstraints::solve(bool downwards) {
    step_.spins ? solve_all<true>(downwards) : solve_all<false>(downwards);
}

void ContactConstraints::begin() {
    had_impacts_ = false;
    step_.spins ? begin_all<true>() : begin_all<false>();
    find_loaded();
    if (has_excess()) step_.spins ? take_back_excess<true>() : take_back_excess<false>();
    solve(false);
    for (int iteration = 1; iteration < contact_tolerance::loaded_iterations; ++iteration)
        for (const std::uint32_t p : loaded_)
            step_.spins ? solve<true>(pairs_[p], nothing_) : solve<false>(pairs_[p], nothing_);
}

void ContactConstraints::relax(double most_push, bool had_impacts) {
    had_impacts_ = had_impacts;
    if (most_push > contact_tolerance::most_excess * step_.rest_speed * step_.duration)
        step_.spins ? take_back_excess<true>() : take_back_excess<false>();
    const double most_more = contact_tolerance::over_relaxation * step_.rest_speed;
    step_.spins ? relax_all<true>(most_more) : relax_all<false>(most_more);
    for (int iteration = 1; iteration < contact_tolerance::loaded_iterations; ++iteration) {
        for (std::size_t k = loaded_.size(); k-- > 0;) {
            ContactPair& pair = pairs_[loaded_[k]];
            if (had_impacts_ && is_about_to_bounce(pair)) continue;
            step_.spins ? relax<true>(pair, nothing_, most_more)
                        : relax<false>(pair, nothing_, most_more);
        }
    }
}

// Works from the top down: a ball that supports a loaded ball is loaded too.
void ContactConstraints::find_loaded() {
    loaded_.clear();
    if (!pairs_.any_high_mass_ratio()) return;
    is_loaded_.assign(bodies_.body.size(), 0);
    const std::span<const std::uint32_t> constraints = classification_.constraints();
    for (std::size_t k = constraints.size(); k-- > 0;) {
        const ContactPair& pair = pairs_[constraints[k]];
        if (!is_loaded_[pair.a] && !is_loaded_[pair.b] && !pair.has_high_mass_ratio) continue;
        if (!bodies_.is_kinematic(pair.a)) is_loaded_[pair.a] = 1;
        if (!bodies_.is_kinematic(pair.b)) is_loaded_[pair.b] = 1;
        loaded_.push_back(constraints[k]);
    }
    std::reverse(loaded_.begin(), loaded_.end());
}

void ContactConstraints::report_new(std::vector<Contact>& contacts, ContactKinematics& kinematics) {
    for (const std::uint32_t p : new_) {
        ContactPair& pair = pairs_[p];
        if (!(pair.impulse > 0.0)) continue;
        pair.is_new = false;
        contacts.push_back(contact_of(bodies_, pair, step_.start_time, pair.impulse));
        kinematics.note_reported(pair, contacts.back());
    }
}

}  // namespace carom

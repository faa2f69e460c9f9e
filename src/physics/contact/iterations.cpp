#include <algorithm>

#include "physics/contact/exchange.h"
#include "physics/contact/solver.h"

// The rounds over the pressed pairs: from the bottom up, which presses them apart, and from the top
// down, which takes back the speed that overlaps gave.
namespace carom {

bool ContactSolver::share_body(const Press& one, const Press& other) const {
    return one.a == other.a || one.a == other.b || one.b == other.a ||
           (one.b == other.b && one.b != still_);
}

// What an impulse changes, and friction's across it.
template <bool spin>
inline void ContactSolver::start_with(const Press& press) {
    Mover& a = mover_[press.a];
    Mover& b = mover_[press.b];
    Vec2 push = press.normal * press.impulse;
    if constexpr (spin) {
        push += perpendicular(press.normal) * press.rub;
        a.rim -= press.rub * a.inverse_mass * spin_ease_;
        if (press.b != still_) b.rim -= press.rub * b.inverse_mass * spin_ease_;
    }
    a.velocity += push * a.inverse_mass;
    if (press.b != still_) b.velocity -= push * b.inverse_mass;
}

template <bool spin>
void ContactSolver::begin_presses() {
    presses_.resize(pressed_.size());
    new_.clear();
    const double per_substep = 1.0 / duration_;
    for (std::uint32_t place = 0; place < pressed_.size(); ++place) {
        const Pair& pair = pairs_[pressed_[place]];
        const double harder = std::min(-pair.gap * (0.5 * hardening / core(pair)), most_hardening);
        if (pair.is_new) new_.push_back(place);
        presses_[place] = {
            .a = pair.a,
            .b = pair.b,
            .pair = pressed_[place],
            .lasts = pair.impulse > 0.0,
            .normal = pair.normal,
            .target = pair.gap * (pair.gap > 0.0 ? per_substep : (1.0 + harder) * softness_.push),
            .mass = pair.mass,
            .impulse = pair.impulse,
            .rub = pair.rub,
            .friction = pair.friction};
        start_with<spin>(presses_[place]);
    }
    for (std::size_t k = 0; k + 1 < presses_.size(); k += presses_[k].with_next ? 2 : 1)
        presses_[k].with_next = !share_body(presses_[k], presses_[k + 1]);
}

template <bool spin>
inline void ContactSolver::press(Press& press) {
    const bool open = press.target > 0.0;
    const double soft_mass = open ? press.mass : softness_.mass * press.mass;
    const double ease = open ? 0.0 : softness_.impulse;
    const double part = soft_mass * (apart(press) + press.target) + ease * press.impulse;
    exchange<spin>(press, std::max(press.impulse - part, 0.0));
}

// A gap that nothing has pressed on may close in the next substep, and no more. What pressed before
// is taken a little too far, since its neighbours take a part back.
template <bool spin>
inline void ContactSolver::relax(Press& press) {
    const double room = press.impulse == 0.0 ? std::max(press.target, 0.0) : 0.0;
    const double parting = apart(press) + room;
    const double most = press.lasts ? overshoot * resting_speed_ : 0.0;
    const double part =
        press.mass * (parting + std::max(std::min(overshoot * parting, most), -most));
    exchange<spin>(press, std::max(press.impulse - part, 0.0));
}

// What has just bounced off something presses no pair that is about to bounce.
bool ContactSolver::is_about_to_bounce(const Press& press) const {
    return pairs_[press.pair].bounces && -apart(press) > resting_speed_;
}

template <bool spin>
void ContactSolver::press_all(bool downwards) {
    if (downwards)
        for (std::size_t k = presses_.size(); k-- > 0;)
            press<spin>(presses_[k]);
    else
        for (Press& each : presses_)
            press<spin>(each);
}

template <bool spin>
void ContactSolver::relax_all() {
    for (std::size_t k = presses_.size(); k-- > 0;)
        if (!had_impacts_ || !is_about_to_bounce(presses_[k])) relax<spin>(presses_[k]);
}

void ContactSolver::press(bool spin, bool downwards) {
    spin ? press_all<true>(downwards) : press_all<false>(downwards);
}

void ContactSolver::press_with_loads(bool spin) {
    spin ? begin_presses<true>() : begin_presses<false>();
    find_loaded();
    if (has_throws()) spin ? take_back_throws<true>() : take_back_throws<false>();
    press(spin, false);
    for (int round = 1; round < loaded_rounds; ++round)
        for (const std::uint32_t place : loaded_)
            spin ? press<true>(presses_[place]) : press<false>(presses_[place]);
}

void ContactSolver::relax_with_loads(bool spin) {
    if (most_push_ > most_throw * resting_speed_ * duration_)
        spin ? take_back_throws<true>() : take_back_throws<false>();
    spin ? relax_all<true>() : relax_all<false>();
    for (int round = 1; round < loaded_rounds; ++round) {
        for (std::size_t k = loaded_.size(); k-- > 0;) {
            Press& press = presses_[loaded_[k]];
            if (had_impacts_ && is_about_to_bounce(press)) continue;
            spin ? relax<true>(press) : relax<false>(press);
        }
    }
    end_presses();
}

// The impulses to start from in the next substep.
void ContactSolver::end_presses() {
    for (const Press& press : presses_) {
        pairs_[press.pair].impulse = press.impulse;
        pairs_[press.pair].rub = press.rub;
    }
}

// From the top down: what presses on what bears a load, bears it too.
void ContactSolver::find_loaded() {
    loaded_.clear();
    if (!any_uneven_) return;
    is_loaded_.assign(mover_.size(), 0);
    for (auto place = static_cast<std::uint32_t>(presses_.size()); place-- > 0;) {
        const Pair& pair = pairs_[presses_[place].pair];
        if (!is_loaded_[pair.a] && !is_loaded_[pair.b] && !is_uneven(pair)) continue;
        if (!is_held_body(pair.a)) is_loaded_[pair.a] = 1;
        if (!is_held_body(pair.b)) is_loaded_[pair.b] = 1;
        loaded_.push_back(place);
    }
    std::reverse(loaded_.begin(), loaded_.end());
}

// Pairs that press for the first time are contacts too.
void ContactSolver::note_new_contacts(std::vector<Contact>& contacts) {
    for (const std::uint32_t place : new_) {
        Pair& pair = pairs_[presses_[place].pair];
        const double impulse = presses_[place].impulse;
        if (!(impulse > 0.0)) continue;
        pair.is_new = false;
        const bool on_ball = pair.edge == NearPair::no_edge;
        const double approach = impulse / pair.mass;
        contacts.push_back({.time = start_time_,
                            .kind = on_ball ? ContactKind::ball_ball : ContactKind::ball_edge,
                            .a = ball_[pair.a],
                            .b = on_ball ? ball_[pair.b] : pair.edge,
                            .point = position_[pair.a] - pair.normal * radius_[pair.a],
                            .normal = pair.normal,
                            .approach = approach,
                            .impulse = impulse});
    }
}

}  // namespace carom

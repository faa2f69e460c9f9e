#include <algorithm>

#include "physics/contact/exchange.h"
#include "physics/contact/solver.h"

// The rounds over the pressed pairs: from the bottom up, which presses them apart, and from the top
// down, which takes back the speed that overlaps gave.
namespace carom {

bool ContactSolver::share_body(const Pair& one, const Pair& other) const {
    return one.a == other.a || one.a == other.b || one.b == other.a ||
           (one.b == other.b && one.b != still_);
}

// What an impulse changes, and friction's across it.
template <bool spin>
inline void ContactSolver::start_with(const Presses& presses) {
    Mover& first_a = mover_[presses.a[0]];
    Mover& second_a = mover_[presses.a[1]];
    Mover& first_b = mover_[presses.b[0]];
    Mover& second_b = mover_[presses.b[1]];
    Two push_x = presses.normal_x * presses.impulse;
    Two push_y = presses.normal_y * presses.impulse;
    const Two inverse_a{first_a.inverse_mass, second_a.inverse_mass};
    const Two inverse_b{first_b.inverse_mass, second_b.inverse_mass};
    if constexpr (spin) {
        push_x -= presses.normal_y * presses.rub;
        push_y += presses.normal_x * presses.rub;
        const Two turn_a = presses.rub * inverse_a * spin_ease_;
        const Two turn_b = presses.rub * inverse_b * spin_ease_;
        first_a.rim -= turn_a[0];
        if (presses.a[1] != still_) second_a.rim -= turn_a[1];
        if (presses.b[0] != still_) first_b.rim -= turn_b[0];
        if (presses.b[1] != still_) second_b.rim -= turn_b[1];
    }
    const Two ax = push_x * inverse_a;
    const Two ay = push_y * inverse_a;
    const Two bx = push_x * inverse_b;
    const Two by = push_y * inverse_b;
    first_a.velocity += Vec2{ax[0], ay[0]};
    if (presses.a[1] != still_) second_a.velocity += Vec2{ax[1], ay[1]};
    if (presses.b[0] != still_) first_b.velocity -= Vec2{bx[0], by[0]};
    if (presses.b[1] != still_) second_b.velocity -= Vec2{bx[1], by[1]};
}

// Two by two, as they come; who shares a body with the one before goes by itself.
template <bool spin>
void ContactSolver::begin_presses() {
    presses_used_ = 0;
    if (presses_.size() < pressed_.size()) presses_.resize(pressed_.size());
    new_.clear();
    const Pair nobody{.a = still_, .b = still_, .is_new = false};
    const double per_substep = 1.0 / duration_;
    for (std::size_t k = 0; k < pressed_.size();) {
        const std::uint32_t p = pressed_[k++];
        std::uint32_t q = none;
        if (k < pressed_.size() && !share_body(pairs_[p], pairs_[pressed_[k]])) q = pressed_[k++];
        const Pair& first = pairs_[p];
        const Pair& second = q == none ? nobody : pairs_[q];
        const Two gap{first.gap, second.gap};
        const Two mass{first.mass, second.mass};
        const auto open = gap > Two{};
        const Two whole = Two{1.0, 1.0};
        const Two most = whole * most_hardening;
        const Two harder = 0.5 * hardening / Two{core(first), q == none ? 1.0 : core(second)};
        const auto place = static_cast<std::uint32_t>(2 * presses_used_);
        if (first.is_new) new_.push_back(place);
        if (second.is_new) new_.push_back(place + 1);
        Presses& both = presses_[presses_used_++];
        for (const int which : {0, 1}) {
            const Pair& pair = which == 0 ? first : second;
            both.a[which] = pair.a;
            both.b[which] = pair.b;
        }
        both.pair[0] = p;
        both.pair[1] = q;
        both.normal_x = Two{first.normal.x, second.normal.x};
        both.normal_y = Two{first.normal.y, second.normal.y};
        both.target = gap * (open ? whole * per_substep
                                  : (whole + at_most(most, -gap * harder)) * softness_.push);
        both.mass = mass;
        both.lasts[0] = first.impulse > 0.0;
        both.lasts[1] = second.impulse > 0.0;
        both.impulse = Two{first.impulse, second.impulse};
        both.rub = Two{first.rub, second.rub};
        both.friction = Two{first.friction, second.friction};
        start_with<spin>(both);
    }
}

template <bool spin>
inline void ContactSolver::press(Presses& presses) {
    const auto open = presses.target > Two{};
    const Two one{1.0, 1.0};
    const Two soft_mass = (open ? one : one * softness_.mass) * presses.mass;
    const Two ease = open ? Two{} : one * softness_.impulse;
    const Two part = soft_mass * (apart(presses) + presses.target) + ease * presses.impulse;
    exchange<spin>(presses, at_least(Two{}, presses.impulse - part));
}

// A gap that nothing has pressed on may close in the next substep, and no more. What pressed before
// is taken a little too far, since its neighbours take a part back.
template <bool spin>
inline void ContactSolver::relax(Presses& presses) {
    const Two room = presses.impulse == Two{} ? at_least(Two{}, presses.target) : Two{};
    const Two parting = apart(presses) + room;
    const double bound = overshoot * resting_speed_;
    const Two most{presses.lasts[0] ? bound : 0.0, presses.lasts[1] ? bound : 0.0};
    const Two part = presses.mass * (parting + at_least(-most, at_most(most, overshoot * parting)));
    exchange<spin>(presses, at_least(Two{}, presses.impulse - part));
}

// What has just bounced off something presses no pair that is about to bounce.
bool ContactSolver::is_about_to_bounce(const Presses& presses, int which) const {
    if (presses.pair[which] == none || !pairs_[presses.pair[which]].bounces) return false;
    const Vec2 relative = mover_[presses.a[which]].velocity - mover_[presses.b[which]].velocity;
    const Vec2 normal{presses.normal_x[which], presses.normal_y[which]};
    return -dot(relative, normal) > resting_speed_;
}

// One of the two, by the same operations.
template <typename Round>
inline void ContactSolver::take_alone(Presses& presses, int which, Round&& round) {
    Presses alone{};
    alone.a[0] = presses.a[which];
    alone.b[0] = presses.b[which];
    alone.a[1] = alone.b[1] = still_;
    alone.normal_x[0] = presses.normal_x[which];
    alone.normal_y[0] = presses.normal_y[which];
    alone.target[0] = presses.target[which];
    alone.mass[0] = presses.mass[which];
    alone.lasts[0] = presses.lasts[which];
    alone.impulse[0] = presses.impulse[which];
    alone.rub[0] = presses.rub[which];
    alone.friction[0] = presses.friction[which];
    round(alone);
    presses.impulse[which] = alone.impulse[0];
    presses.rub[which] = alone.rub[0];
}

template <bool spin>
void ContactSolver::relax_after_impacts(Presses& presses) {
    const bool stays[2]{is_about_to_bounce(presses, 0), is_about_to_bounce(presses, 1)};
    if (!stays[0] && !stays[1]) {
        relax<spin>(presses);
        return;
    }
    for (int which = 0; which < 2; ++which)
        if (!stays[which]) take_alone(presses, which, [&](Presses& alone) { relax<spin>(alone); });
}

template <bool spin>
void ContactSolver::press_all(bool downwards) {
    if (downwards)
        for (std::size_t k = presses_used_; k-- > 0;)
            press<spin>(presses_[k]);
    else
        for (std::size_t k = 0; k < presses_used_; ++k)
            press<spin>(presses_[k]);
}

template <bool spin>
void ContactSolver::relax_all() {
    if (had_impacts_)
        for (std::size_t k = presses_used_; k-- > 0;)
            relax_after_impacts<spin>(presses_[k]);
    else
        for (std::size_t k = presses_used_; k-- > 0;)
            relax<spin>(presses_[k]);
}

void ContactSolver::press(bool spin, bool downwards) {
    spin ? press_all<true>(downwards) : press_all<false>(downwards);
}

void ContactSolver::press_with_loads(bool spin) {
    spin ? begin_presses<true>() : begin_presses<false>();
    find_loaded();
    if (has_throws()) spin ? take_back_throws<true>() : take_back_throws<false>();
    press(spin, false);
    const auto one = [&](Presses& presses) { spin ? press<true>(presses) : press<false>(presses); };
    for (int round = 1; round < loaded_rounds; ++round)
        for (const std::uint32_t place : loaded_)
            take_alone(presses_[place / 2], static_cast<int>(place % 2), one);
}

void ContactSolver::relax_with_loads(bool spin) {
    if (most_push_ > most_throw * resting_speed_ * duration_)
        spin ? take_back_throws<true>() : take_back_throws<false>();
    spin ? relax_all<true>() : relax_all<false>();
    const auto one = [&](Presses& presses) { spin ? relax<true>(presses) : relax<false>(presses); };
    for (int round = 1; round < loaded_rounds; ++round) {
        for (std::size_t k = loaded_.size(); k-- > 0;) {
            Presses& presses = presses_[loaded_[k] / 2];
            const auto which = static_cast<int>(loaded_[k] % 2);
            if (had_impacts_ && is_about_to_bounce(presses, which)) continue;
            take_alone(presses, which, one);
        }
    }
    end_presses();
}

// The impulses to start from in the next substep.
void ContactSolver::end_presses() {
    for (std::size_t k = 0; k < presses_used_; ++k) {
        const Presses& presses = presses_[k];
        for (int which = 0; which < 2; ++which) {
            if (presses.pair[which] == none) continue;
            Pair& pair = pairs_[presses.pair[which]];
            pair.impulse = presses.impulse[which];
            pair.rub = presses.rub[which];
        }
    }
}

// From the top down: what presses on what bears a load, bears it too.
void ContactSolver::find_loaded() {
    loaded_.clear();
    if (!any_uneven_) return;
    is_loaded_.assign(mover_.size(), 0);
    for (auto place = static_cast<std::uint32_t>(2 * presses_used_); place-- > 0;) {
        const std::uint32_t p = presses_[place / 2].pair[place % 2];
        if (p == none) continue;
        const Pair& pair = pairs_[p];
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
        const Presses& presses = presses_[place / 2];
        Pair& pair = pairs_[presses.pair[place % 2]];
        const double impulse = presses.impulse[place % 2];
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

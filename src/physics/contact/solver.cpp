#include "physics/contact/solver.h"

#include <algorithm>
#include <cmath>

#include "physics/tick/emitters_and_sinks.h"

namespace carom {

void ContactSolver::tick(World& world, int substeps, std::vector<Contact>& contacts,
                         std::vector<std::uint8_t>& touched) {
    const int count = substeps_needed(world, substeps);
    duration_ = world.tick_length() / count;
    flight_ = flight_over(world.model.drag, duration_);
    gravity_ = world.model.gravity.value_or(Vec2{});
    fall_ = length(gravity_) * duration_ * duration_;
    resting_speed_ = resting_approach * length(gravity_) * duration_;
    wraps_ = world.model.wrap.has_value();
    torus_ = wraps_ ? size(*world.model.wrap) : Vec2{};
    softness_ = softness_of(world);
    drag_ = world.model.drag;
    if (world.model.spin) {
        spin_ease_ = 1.0 / *world.model.spin;
        spin_mass_ = 1.0 / (1.0 + spin_ease_);
    }
    was_held_back_.clear();
    for (int i = 0; i < count; ++i) {
        is_loaded_anew_ = true;
        if (i == 0) {
            begin(world);
        } else if (!is_at_home()) {
            store(world, touched);
            find_homes(world);
            load(world);
        } else {
            is_loaded_anew_ = false;
        }
        start_time_ = world.time() + duration_ * i;
        substep(world, 1.0 / (count - i), contacts);
    }
    store(world, touched);
}

// Only what loses energy is pushed apart: nothing pays for the lift of elastic balls.
ContactSolver::Softness ContactSolver::softness_of(const World& world) const {
    if (!world.model.lossy) return {.push = 0.0, .mass = 1.0, .impulse = 0.0};
    constexpr double turn = 6.283185307179586 * stiffness;  // rad a substep
    constexpr double first = 2.0 * damping + turn;
    constexpr double second = turn * first;
    return {.push = turn / first / duration_,
            .mass = second / (1.0 + second),
            .impulse = 1.0 / (1.0 + second)};
}

void ContactSolver::substep(World& world, double share_of_way, std::vector<Contact>& contacts) {
    take_hands(world, share_of_way);
    kick(world);
    count_presses();
    had_impacts_ = false;
    prepare(world, terms_of(world));
    press_with_loads(world.model.spin.has_value());
    note_new_contacts(contacts);
    hold_hands_back(world.model.spin.has_value());
    find_ways();
    find_hits();
    had_impacts_ = !hits_.empty() || !strays_.empty();
    if (had_impacts_)
        run_impacts(world, contacts);
    else
        go(world);
    relax_with_loads(world.model.spin.has_value());
    if (!hands_.empty()) settle_jams();
    move_hands(world);
}

void ContactSolver::kick(const World& world) {
    const Vec2 fall = gravity_ * flight_.velocity_per_gravity;
    const std::optional<double> limit = world.model.speed_limit;
    rim_before_.clear();
    if (world.model.spin)
        for (std::uint32_t i = 0; i < still_; ++i)
            rim_before_.push_back(mover_[i].rim);
    for (std::uint32_t i = 0; i < still_; ++i) {
        Vec2 velocity = mover_[i].velocity;
        if (limit) velocity = limited(velocity, *limit);
        before_[i] = velocity;
        mover_[i].velocity = velocity * flight_.decay + fall;
    }
    for (const Hand& hand : hands_)
        if (hand.is_ball) before_[hand.index] = mover_[hand.index].velocity = hand.start_velocity;
}

// A ball that no impulse has changed flies on its exact path; a pressed one goes straight on.
void ContactSolver::find_ways() {
    const Vec2 fall = gravity_ * flight_.velocity_per_gravity;
    const Vec2 drop = gravity_ * flight_.travel_per_gravity;
    strays_.clear();
    most_push_ = 0.0;
    for (std::uint32_t i = 0; i < still_; ++i) {
        const Vec2 velocity = mover_[i].velocity;
        const Vec2 free = before_[i] * flight_.decay + fall;
        const Vec2 change = velocity - free;
        if (change == Vec2{}) {
            way_[i] = before_[i] * flight_.travel_per_velocity + drop;
        } else {
            way_[i] = velocity * duration_;
            most_push_ = std::max(most_push_, length_squared(change));
        }
        if (length_squared(position_[i] + way_[i] - home_[i]) > margin_[i] * margin_[i])
            strays_.push_back(i);
    }
    for (const Hand& hand : hands_)
        if (hand.is_ball) way_[hand.index] = hand.start_velocity * (hand.share * duration_);
    most_push_ = std::sqrt(most_push_) * duration_;
}

void ContactSolver::go(const World& world) {
    const std::optional<double> limit = world.model.speed_limit;
    for (std::uint32_t i = 0; i < still_; ++i) {
        position_[i] += way_[i];
        if (limit) mover_[i].velocity = limited(mover_[i].velocity, *limit);
    }
}

}  // namespace carom

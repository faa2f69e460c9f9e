#include "physics/contact/energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/contact/tolerances.h"

namespace carom {
bool ContactEnergy::may_open() {
    if (!(stored_ < 0.0)) return true;
    if (!energy_) energy_ = energy_of_balls();
    return !(excess() > 0.0);
}

void ContactEnergy::end_substep(std::span<const std::uint32_t> constraints,
                                std::span<const BodyPair> impacts, double given) {
    if (constraints.empty()) return;
    if (!energy_) energy_ = energy_of_balls();
    const double gain = (step_.spins ? gain_of_balls<true>() : gain_of_balls<false>()) - given;
    stored_ = std::min(stored_ - gain, contact_tolerance::most_stored * *energy_);
    if (!(gain > 0.0) || !(excess() > 0.0)) return;
    groups_.find(constraints);
    groups_.join_followers();
    stored_ += take_back(excess());
    if (excess() > 0.0) stored_ += take_from_hit(impacts, excess());
}

// Potential energy is 0 at the lowest point of the lowest ball.
double ContactEnergy::energy_of_balls() const {
    const double weight = length(step_.gravity);
    double energy = 0.0;
    double mass = 0.0;
    double lowest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i) {
        if (bodies_.is_kinematic(i)) continue;
        const double m = 1.0 / bodies_.body[i].inverse_mass;
        const double height = -dot(step_.gravity, bodies_.position[i]);
        energy += kinetic_energy_of(step_, bodies_, i) + m * height;
        mass += m;
        lowest = std::min(lowest, height - weight * bodies_.radius[i]);
    }
    return mass > 0.0 ? std::max(0.0, energy - mass * lowest) : 0.0;
}

// What all balls have gained in the substep. This runs in every substep.
template <bool spin>
double ContactEnergy::gain_of_balls() const {
    double gain = 0.0;
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i) {
        const ContactBody& body = bodies_.body[i];
        if (body.inverse_mass == 0.0) continue;
        double squares = length_squared(body.velocity) - length_squared(bodies_.start_velocity[i]);
        if constexpr (spin) {
            const double before = bodies_.start_surface_speed[i];
            squares +=
                (body.surface_speed * body.surface_speed - before * before) * step_.spin_share;
        }
        gain += (0.5 * squares - dot(step_.gravity, bodies_.displacement[i])) / body.inverse_mass;
    }
    return gain;
}

// Takes energy from all groups that have gained, in proportion. Returns how much.
double ContactEnergy::take_back(double excess) {
    const double gains = groups_.gains();
    if (!(gains > 0.0)) return 0.0;
    reductions_.clear();
    for (const PressGroup& group : groups_.all())
        reductions_.push_back(reduction_of(group, std::min(1.0, excess / gains)));
    double taken = 0.0;
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i) {
        if (bodies_.is_kinematic(i)) continue;
        const Reduction& reduction = reductions_[groups_.index_of(i)];
        if (reduction.part > 0.0) taken += reduce(i, reduction);
    }
    return taken;
}

// Takes energy from the balls that pressed groups have hit, of what they have gained, in
// proportion. Returns how much.
double ContactEnergy::take_from_hit(std::span<const BodyPair> impacts, double excess) {
    hit_.clear();
    for (const auto& [a, b] : impacts) {
        if (groups_.are_together(a, b)) continue;
        if (groups_.is_pressed(b) && !groups_.is_pressed(a)) hit_.push_back(a);
        if (groups_.is_pressed(a) && !groups_.is_pressed(b)) hit_.push_back(b);
    }
    std::ranges::sort(hit_);
    hit_.erase(std::unique(hit_.begin(), hit_.end()), hit_.end());
    double gains = 0.0;
    for (const std::uint32_t i : hit_)
        gains += std::max(0.0, gain_of(step_, bodies_, i));
    if (!(gains > 0.0)) return 0.0;
    double taken = 0.0;
    for (const std::uint32_t i : hit_) {
        const double kinetic = kinetic_energy_of(step_, bodies_, i);
        const double part =
            std::min(1.0, excess / gains) * std::max(0.0, gain_of(step_, bodies_, i));
        const double kept = std::sqrt(std::max(0.0, 1.0 - part / kinetic));
        if (!(part > 0.0)) continue;
        bodies_.body[i].velocity *= kept;
        bodies_.body[i].surface_speed *= kept;
        taken += kinetic - kinetic_energy_of(step_, bodies_, i);
    }
    return taken;
}

// This share of the group's gain comes from its height and its speed, whichever have gained. A
// group that is moved back is slowed too. One that nothing supports keeps its displacements, since
// constraints cannot lift its centre of mass, and its momentum, unless its balls hardly move
// relative to each other.
ContactEnergy::Reduction ContactEnergy::reduction_of(const PressGroup& group, double share) const {
    if (!(group.gain > 0.0)) return {};
    const double lifted = group.may_go_back() ? std::max(0.0, group.lift) : 0.0;
    const double sped = group.is_supported ? std::max(0.0, group.gain - group.lift) : group.gain;
    Reduction reduction{.part = std::min(1.0, share * group.gain / (lifted + sped)),
                        .goes_back = lifted > 0.0,
                        .is_embedded = group.is_embedded};
    const double lost = reduction.part * sped;
    reduction.centre = group.is_supported ? Vec2{} : group.momentum / group.mass;
    double inner = group.kinetic - 0.5 * group.mass * length_squared(reduction.centre);
    reduction.kept = reduction.goes_back ? 1.0 - reduction.part : 1.0;
    if (lost > inner) {
        reduction.centre = {};
        inner = group.kinetic;
        reduction.kept = 1.0;
    }
    if (inner > 0.0) reduction.kept *= std::sqrt(std::max(0.0, 1.0 - lost / inner));
    return reduction;
}

// Returns the energy that the ball has lost.
double ContactEnergy::reduce(std::uint32_t i, const Reduction& reduction) {
    ContactBody& body = bodies_.body[i];
    const double before = kinetic_energy_of(step_, bodies_, i);
    body.velocity = reduction.centre + (body.velocity - reduction.centre) * reduction.kept;
    body.surface_speed *= reduction.kept;
    const double lost = before - kinetic_energy_of(step_, bodies_, i);
    if (!reduction.goes_back) return lost;
    Vec2 back = bodies_.displacement[i] * reduction.part;
    if (reduction.is_embedded)
        back = step_.gravity * (dot(back, step_.gravity) / length_squared(step_.gravity));
    bodies_.position[i] -= back;
    bodies_.displacement[i] -= back;
    return lost - dot(step_.gravity, back) / body.inverse_mass;
}

}  // namespace carom

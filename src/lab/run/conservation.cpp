#include "lab/run/conservation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "game/session/conserved.h"

namespace carom {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double sum_of_magnitudes(const World& world) {
    double sum = 0.0;
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        sum += length(world.balls().velocity[i]) / world.balls().inverse_mass[i];
    return sum;
}

// A sink removes a ball together with its potential energy, which may be below zero.
bool may_gain_energy(const World& world) {
    const bool has_sink = std::ranges::any_of(
        world.zones(), [](const Zone& zone) { return zone.effect == Zone::Effect::sink; });
    return !world.emitters().empty() || !world.held_balls().empty() ||
           !world.held_capsules().empty() || !world.movers().empty() ||
           (world.model().gravity && (world.model().wrap || has_sink));
}

double share(double change, double whole) {
    if (!std::isfinite(change)) return infinity;
    if (change == 0.0) return 0.0;
    return change / whole;
}

}  // namespace

ConservationWatch::ConservationWatch(const World& start)
    : energy_(conserves_energy(start)  ? Energy::conserved
              : may_gain_energy(start) ? Energy::driven
                                       : Energy::dissipated),
      conserves_momentum_(conserves_momentum(start)),
      start_(totals(start)),
      largest_kinetic_(start_.kinetic_energy),
      largest_magnitude_(sum_of_magnitudes(start)) {}

void ConservationWatch::note(const World& world) {
    const Totals now = totals(world);
    const double change = now.energy() - start_.energy();
    const double counted = energy_ == Energy::conserved ? std::fabs(change) : std::max(change, 0.0);
    largest_kinetic_ = std::max(largest_kinetic_, now.kinetic_energy);
    energy_change_ = std::isfinite(change) ? std::max(energy_change_, counted) : infinity;
    if (!conserves_momentum_) return;
    const double moved = length(now.momentum - start_.momentum);
    largest_magnitude_ = std::max(largest_magnitude_, sum_of_magnitudes(world));
    momentum_change_ = std::isfinite(moved) ? std::max(momentum_change_, moved) : infinity;
}

std::optional<double> ConservationWatch::energy_drift() const {
    if (energy_ == Energy::driven) return std::nullopt;
    return share(energy_change_, largest_kinetic_);
}

std::optional<double> ConservationWatch::momentum_drift() const {
    if (!conserves_momentum_) return std::nullopt;
    return share(momentum_change_, largest_magnitude_);
}

}  // namespace carom

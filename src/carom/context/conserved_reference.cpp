#include "carom/context/conserved_reference.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

std::optional<double> relative(double change, double scale) {
    if (!(scale > 0.0)) return std::nullopt;
    return change / scale;
}

}  // namespace

void ConservedReference::set(const World& world) {
    const Totals sums = totals(world);
    tick_ = world.tick();
    energy_ = sums.kinetic_energy + sums.potential_energy;
    momentum_ = sums.momentum;
    momentum_scale_ = 0.0;
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        momentum_scale_ += length(world.balls().velocity[i]) / world.balls().inverse_mass[i];
}

void ConservedReference::watch_commands(const Session& session) {
    const auto commands = session.commands();
    const auto next =
        std::ranges::upper_bound(commands, session.world().tick(), {}, &TimedCommand::tick);
    const auto count = static_cast<std::size_t>(next - commands.begin());
    if (count != commands_watched_) set(session.world());
    commands_watched_ = count;
}

std::optional<double> ConservedReference::energy_drift(const Totals& sums) const {
    return relative(sums.kinetic_energy + sums.potential_energy - energy_, std::fabs(energy_));
}

std::optional<double> ConservedReference::momentum_drift(const Totals& sums) const {
    return relative(length(sums.momentum - momentum_), momentum_scale_);
}

}  // namespace carom

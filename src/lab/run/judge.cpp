#include "lab/run/judge.h"

#include <cmath>
#include <span>
#include <vector>

#include "game/statistics.h"
#include "physics/tick/totals.h"

namespace carom {
namespace {

std::optional<double> chi_square(std::span<const double> counts, std::span<const double> shares) {
    const double total = moments_of(counts).total;
    const double whole = moments_of(shares).total;
    if (!(total > 0.0) || !(whole > 0.0)) return std::nullopt;
    double sum = 0.0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double expected = total * shares[i] / whole;
        const double off = counts[i] - expected;
        // A bin that nothing is expected in, and that is empty, says nothing.
        if (expected > 0.0 || off > 0.0) sum += off * off / expected;
    }
    return sum;
}

std::optional<double> of_bins(const Quantity& quantity, const World& world) {
    const std::vector<std::uint64_t> all = census(world);
    std::vector<double> counts;
    for (const std::uint32_t counter : quantity.counters) {
        counts.push_back(static_cast<double>(all[counter]));
    }
    const Moments counted = moments_of(std::span<const double>(counts));
    if (quantity.kind == QuantityKind::count) return counted.total;
    if (!(counted.total > 0.0)) return std::nullopt;
    if (quantity.kind == QuantityKind::mean) return counted.mean;
    if (quantity.kind == QuantityKind::variance) return counted.variance;
    if (quantity.expected.size() != counts.size()) return std::nullopt;
    if (quantity.kind == QuantityKind::chi_square) return chi_square(counts, quantity.expected);
    const double variance = moments_of(std::span(quantity.expected)).variance;
    if (!(variance > 0.0)) return std::nullopt;
    return counted.variance / variance;
}

std::optional<double> of_ball(const Quantity& quantity, const World& world) {
    const std::optional<std::size_t> index = index_of(world, quantity.ball);
    if (!index) return std::nullopt;
    const Vec2 position = world.balls.position[*index];
    const Vec2 velocity = world.balls.velocity[*index];
    switch (quantity.kind) {
        case QuantityKind::x:
            return position.x;
        case QuantityKind::y:
            return position.y;
        case QuantityKind::vx:
            return velocity.x;
        case QuantityKind::vy:
            return velocity.y;
        case QuantityKind::w:
            return world.model.spin ? world.balls.spin[*index] : 0.0;
        default:
            return length(velocity);
    }
}

}  // namespace

std::optional<double> measure(const Quantity& quantity, const World& world, const RunFacts& facts) {
    using enum QuantityKind;
    const auto counted = [](std::uint64_t count) { return static_cast<double>(count); };
    if (is_of_ball(quantity.kind)) return of_ball(quantity, world);
    if (is_of_bins(quantity.kind)) return of_bins(quantity, world);
    switch (quantity.kind) {
        case collisions:
            return counted(world.ball_ball_collisions + world.ball_edge_collisions);
        case ball_ball:
            return counted(world.ball_ball_collisions);
        case ball_edge:
            return counted(world.ball_edge_collisions);
        case time:
            return world.time();
        case escaped:
            return counted(facts.escaped);
        case overlap:
            return facts.max_overlap;
        case balls:
            return counted(world.balls.size());
        case removed:
            return counted(world.removed.size());
        default:
            break;
    }
    const Totals sums = totals(world);
    switch (quantity.kind) {
        case kinetic_energy:
            return sums.kinetic_energy;
        case potential_energy:
            return sums.potential_energy;
        case energy:
            return sums.kinetic_energy + sums.potential_energy;
        case momentum_x:
            return sums.momentum.x;
        case momentum_y:
            return sums.momentum.y;
        case angular_momentum:
            return sums.angular_momentum;
        default:
            return std::nullopt;
    }
}

std::string_view name(Verdict verdict) {
    switch (verdict) {
        case Verdict::holds:
            return "holds";
        case Verdict::fails:
            return "fails";
        default:
            return "not judged";
    }
}

Judgement judge(const Expect& expect, const World& world, const RunFacts& facts) {
    const std::optional<double> measured = measure(expect.what, world, facts);
    const bool holds = measured && std::abs(*measured - expect.value) <= expect.tolerance;
    return {.verdict = holds ? Verdict::holds : Verdict::fails, .measured = measured, .reason = {}};
}

}  // namespace carom

#include "level/scene/quantities.h"

#include <algorithm>
#include <array>

#include "physics/tick/totals.h"
#include "physics/world/world.h"

namespace carom {
namespace {

using enum QuantityScope;
using W = const World&;

double counted(std::uint64_t count) {
    return static_cast<double>(count);
}

// Energies, momenta and angular momentum are sums over all balls. The potential energy is 0 at the
// origin; the angular momentum is about the origin.
constexpr std::array<QuantityRow, 33> rows{{
    {.name = "collisions",
     .meaning = "of balls with balls and with edges, so far",
     .of_world =
         [](W w) {
             return counted(w.ledger().ball_ball_collisions + w.ledger().ball_edge_collisions);
         }},
    {.name = "ball_ball",
     .meaning = "collisions of balls with balls",
     .of_world = [](W w) { return counted(w.ledger().ball_ball_collisions); }},
    {.name = "ball_edge",
     .meaning = "collisions of balls with edges",
     .of_world = [](W w) { return counted(w.ledger().ball_edge_collisions); }},
    {.name = "kinetic_energy",
     .meaning = "of all balls",
     .dimension = energy_dimension,
     .of_world = [](W w) { return totals(w).kinetic_energy; }},
    {.name = "potential_energy",
     .meaning = "of all balls; height is measured from 0",
     .dimension = energy_dimension,
     .of_world = [](W w) { return totals(w).potential_energy; }},
    {.name = "energy",
     .meaning = "kinetic and potential",
     .dimension = energy_dimension,
     .of_world =
         [](W w) {
             const Totals sums = totals(w);
             return sums.kinetic_energy + sums.potential_energy;
         }},
    {.name = "momentum_x",
     .meaning = "of all balls",
     .dimension = momentum_dimension,
     .of_world = [](W w) { return totals(w).momentum.x; }},
    {.name = "momentum_y",
     .meaning = "of all balls",
     .dimension = momentum_dimension,
     .of_world = [](W w) { return totals(w).momentum.y; }},
    {.name = "angular_momentum",
     .meaning = "of all balls, about 0,0",
     .dimension = angular_momentum_dimension,
     .of_world = [](W w) { return totals(w).angular_momentum; }},
    {.name = "time",
     .meaning = "since the start",
     .dimension = time_dimension,
     .of_world = [](W w) { return w.time(); }},
    {.name = "overlap",
     .meaning = "the deepest so far",
     .scope = run,
     .dimension = length_dimension,
     .at_tick = [](W w) { return deepest_overlap(w); },
     .field = {.key = "max_overlap",
               .head = "overlap",
               .summary = "overlap     {:.3g} at most\n",
               .unit = ReportField::Unit::length,
               .is_in_run = true,
               .is_in_measure = true}},
    {.name = "escaped",
     .meaning = "balls outside of a closed edge or box in which they started",
     .scope = run,
     .field = {.key = "escaped",
               .head = "out",
               .unit = ReportField::Unit::count,
               .is_in_run = true,
               .is_in_measure = true}},
    {.name = "balls",
     .meaning = "in the world",
     .of_world = [](W w) { return counted(w.balls().size()); }},
    {.name = "removed",
     .meaning = "balls that were removed",
     .of_world = [](W w) { return counted(w.ledger().removed.size()); }},
    {.name = "x",
     .meaning = "of a ball",
     .scope = ball,
     .dimension = length_dimension,
     .of_ball = [](W w, std::size_t i) { return w.balls().position[i].x; }},
    {.name = "y",
     .meaning = "of a ball",
     .scope = ball,
     .dimension = length_dimension,
     .of_ball = [](W w, std::size_t i) { return w.balls().position[i].y; }},
    {.name = "vx",
     .meaning = "of a ball",
     .scope = ball,
     .dimension = speed_dimension,
     .of_ball = [](W w, std::size_t i) { return w.balls().velocity[i].x; }},
    {.name = "vy",
     .meaning = "of a ball",
     .scope = ball,
     .dimension = speed_dimension,
     .of_ball = [](W w, std::size_t i) { return w.balls().velocity[i].y; }},
    {.name = "speed",
     .meaning = "of a ball",
     .scope = ball,
     .dimension = speed_dimension,
     .of_ball = [](W w, std::size_t i) { return length(w.balls().velocity[i]); }},
    {.name = "w",
     .meaning = "spin of a ball, counter-clockwise",  // rad/s; 0 in a model without spin
     .scope = ball,
     .dimension = angular_speed_dimension,
     .of_ball = [](W w, std::size_t i) { return w.model().spin ? w.balls().spin[i] : 0.0; }},
    {.name = "count", .meaning = "balls in all bins", .scope = bins},
    {.name = "mean", .meaning = "of the bin number, 0 for the leftmost", .scope = bins},
    {.name = "variance", .meaning = "of the bin number", .scope = bins},
    {.name = "variance_ratio",
     .meaning = "against the curve of the histogram",
     .scope = bins},  // variance over that of the expected shares
    {.name = "chi_square",
     .meaning = "against the curve of the histogram",
     .scope = bins},  // sum of (counted - expected)^2 / expected
    // Observables (lab/observe).
    {.name = "pressure",
     .meaning = "impulses on edges, by time and length",
     .scope = edges,
     .dimension = pressure_dimension,
     .observable = Observable::pressure},
    {.name = "pressure",
     .meaning = "mean, by the virial of all impacts",
     .scope = run,
     .dimension = pressure_dimension,
     .observable = Observable::pressure},
    {.name = "msd",
     .meaning = "mean square displacement",
     .scope = run,
     .dimension = area_dimension,
     .observable = Observable::msd},
    {.name = "vacf",
     .meaning = "velocity autocorrelation",
     .scope = run,
     .observable = Observable::vacf},
    {.name = "speed_distance",
     .meaning = "of the speeds from Maxwell and Boltzmann",
     .scope = run,
     .observable = Observable::speeds},
    {.name = "speed_kurtosis",
     .meaning = "2 in equilibrium",
     .scope = run,
     .observable = Observable::speeds},
    {.name = "contact_value",
     .meaning = "of the pair distribution",
     .scope = run,
     .observable = Observable::pairs},
    {.name = "lyapunov_time",
     .meaning = "in which a small difference grows by a factor of e",
     .scope = run,
     .dimension = time_dimension,
     .observable = Observable::lyapunov},
}};

}  // namespace

bool is_of_ball(QuantityKind kind) {
    return kind->scope == ball;
}

bool is_of_bins(QuantityKind kind) {
    return kind->scope == bins;
}

std::string_view name(QuantityKind kind) {
    return kind->name;
}

std::span<const QuantityRow> quantities() {
    return rows;
}

QuantityKind quantity_named(std::string_view name, bool has_subject) {
    const auto found = std::ranges::find_if(rows, [&](const QuantityRow& row) {
        return row.name == name && (row.scope != edges || has_subject);
    });
    return found == rows.end() ? nullptr : &*found;
}

QuantityKind quantity_in(std::string_view word) {
    if (const std::size_t open = word.find('('); open != std::string_view::npos)
        return quantity_named(word.substr(0, open), true);
    const std::size_t dot = word.rfind('.');
    return quantity_named(dot == std::string_view::npos ? word : word.substr(dot + 1));
}

std::vector<double> binomial_shares(int n, double p) {
    std::vector<double> shares(static_cast<std::size_t>(n) + 1, 0.0);
    if (p <= 0.0 || p >= 1.0) {
        (p <= 0.0 ? shares.front() : shares.back()) = 1.0;
        return shares;
    }
    const auto likeliest = static_cast<std::size_t>(static_cast<double>(n) * p);
    const double odds = p / (1.0 - p);
    shares[likeliest] = 1.0;
    double sum = 1.0;
    const auto tosses = static_cast<std::size_t>(n);
    for (std::size_t k = likeliest; k < tosses; ++k) {
        shares[k + 1] =
            shares[k] * odds * static_cast<double>(tosses - k) / static_cast<double>(k + 1);
        sum += shares[k + 1];
    }
    for (std::size_t k = likeliest; k > 0; --k) {
        shares[k - 1] =
            shares[k] / odds * static_cast<double>(k) / static_cast<double>(tosses - k + 1);
        sum += shares[k - 1];
    }
    for (double& share : shares)
        share /= sum;
    return shares;
}

}  // namespace carom

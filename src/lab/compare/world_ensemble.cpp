#include "lab/compare/world_ensemble.h"

#include <algorithm>
#include <cmath>

#include "lab/measure/difference.h"
#include "lab/measure/nudge.h"
#include "physics/broad_phase/cell_frame.h"

namespace carom {
namespace {

// The cell of a coordinate; none outside, or for NaN.
std::optional<std::size_t> cell_of(double value, double low, double high, std::size_t cells) {
    if (!(value >= low && value < high)) return std::nullopt;
    const double share = (value - low) / (high - low);
    const auto cell = static_cast<std::size_t>(share * static_cast<double>(cells));
    return cell < cells ? cell : cells - 1;
}

}  // namespace

WorldEnsemble::WorldEnsemble(const World& start, const SolverSettings& solver,
                             const EnsembleSettings& settings)
    : solver_(solver), copies_(settings.copies, start) {
    for (std::size_t i = 1; i < copies_.size(); ++i)
        nudge(copies_[i], settings.size, settings.seed, i);
}

bool WorldEnsemble::step(const std::function<bool()>& may_go_on,
                         const std::function<bool()>& keep_going) {
    while (next_ < copies_.size()) {
        if (solver_.tick(copies_[next_], keep_going) == TickOutcome::cancelled) return false;
        ++next_;
        if (next_ < copies_.size() && may_go_on && !may_go_on()) return false;
    }
    next_ = 0;
    return true;
}

void WorldEnsemble::execute(const Command& command) {
    if (const auto* change = std::get_if<command::SetSolver>(&command))
        solver_ = Solver(change->settings);
    for (World& world : copies_)
        if (!refusal(world, command)) carom::execute(world, command);
}

double WorldEnsemble::spread() const {
    const Balls& first = copies_.front().balls();
    const std::optional<Vec2> torus = torus_of(copies_.front());
    std::vector<double> sum(first.size(), 0.0);
    std::vector<double> count(first.size(), 0.0);
    for (std::size_t copy = 1; copy < copies_.size(); ++copy) {
        const Balls& balls = copies_[copy].balls();
        std::size_t j = 0;
        for (std::size_t i = 0; i < first.size(); ++i) {
            while (j < balls.size() && balls.id[j] < first.id[i])
                ++j;
            if (j == balls.size() || balls.id[j] != first.id[i]) continue;
            const Vec2 apart = balls.position[j] - first.position[i];
            sum[i] += length_squared(torus ? nearest_image(apart, *torus) : apart);
            count[i] += 1.0;
        }
    }
    double most = 0.0;
    for (std::size_t i = 0; i < first.size(); ++i)
        if (count[i] > 0.0) most = std::max(most, std::sqrt(sum[i] / count[i]) / first.radius[i]);
    return most;
}

Density density(std::span<const World> copies, const Box& view, std::size_t columns,
                std::size_t rows, std::optional<BallId> only) {
    Density grid{columns, rows, std::vector<std::uint32_t>(columns * rows, 0)};
    const auto count = [&](Vec2 place) {
        const auto column = cell_of(place.x, view.low.x, view.high.x, columns);
        const auto from_below = cell_of(place.y, view.low.y, view.high.y, rows);
        if (column && from_below) ++grid.counts[(rows - 1 - *from_below) * columns + *column];
    };
    for (const World& world : copies) {
        if (only) {
            if (const auto index = index_of(world, *only)) count(world.balls().position[*index]);
            continue;
        }
        for (const Vec2 place : world.balls().position)
            count(place);
    }
    return grid;
}

}  // namespace carom

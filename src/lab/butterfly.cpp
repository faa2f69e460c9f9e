#include "lab/butterfly.h"

#include "lab/nudge.h"

namespace carom {
namespace {

// The cell of a coordinate; none outside, and for what is no number.
std::optional<std::size_t> cell_of(double value, double low, double high, std::size_t cells) {
    if (!(value >= low && value < high)) return std::nullopt;
    const double share = (value - low) / (high - low);
    const auto cell = static_cast<std::size_t>(share * static_cast<double>(cells));
    return cell < cells ? cell : cells - 1;
}

}  // namespace

Butterfly::Butterfly(const World& start, const SolverSettings& solver,
                     const ButterflySettings& settings)
    : solver_(solver), copies_(settings.copies, start) {
    for (std::size_t i = 1; i < copies_.size(); ++i)
        nudge(copies_[i], settings.size, settings.seed, i);
}

void Butterfly::step() {
    for (World& world : copies_)
        solver_.tick(world);
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
            if (const auto index = index_of(world, *only)) count(world.balls.position[*index]);
            continue;
        }
        for (const Vec2 place : world.balls.position)
            count(place);
    }
    return grid;
}

}  // namespace carom

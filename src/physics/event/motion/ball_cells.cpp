#include "physics/event/motion/ball_cells.h"

#include <algorithm>
#include <numeric>

#include "physics/event/motion/tolerances.h"

namespace carom {

template <typename Real>
CellFrame BallCells<Real>::frame_for(const World& world) const {
    const double gap = world.model().modulus ? most_lasting_gap : 0.0;
    double least = (2.02 + gap) * largest_;
    // In a thin gas a ball would cross many cells between two impacts: one ball a cell is enough.
    const double room = area_per_ball(world);
    while (least > 0.0 && 4.0 * least * least < room)
        least *= 2.0;
    constexpr double cells_a_ball = 16.0;
    CellFrame frame = frame_around(world, least, cells_a_ball);
    if (frame.wraps) {
        // On a torus the cells may have come out narrower than a ball.
        const Vec2 extent = size(*world.model().wrap);
        frame.columns = std::clamp(static_cast<int>(extent.x / least), 1, frame.columns);
        frame.rows = std::clamp(static_cast<int>(extent.y / least), 1, frame.rows);
        frame.cell = {extent.x / frame.columns, extent.y / frame.rows};
    }
    return frame;
}

template <typename Real>
void BallCells<Real>::reset(const World& world, Balls& balls) {
    const std::size_t count = world.balls().size();
    const std::vector<double>& radius = world.balls().radius;
    by_size_.resize(count);
    std::iota(by_size_.begin(), by_size_.end(), 0u);
    std::sort(by_size_.begin(), by_size_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return radius[a] != radius[b] ? radius[a] > radius[b] : a < b;
    });
    // Oversized are those before the steepest fall of the radius, if it is more than twofold.
    std::size_t oversized = 0;
    double steepest = 2.0;
    for (std::size_t i = 1; i <= most_oversized && i < count; ++i) {
        const double fall = radius[by_size_[i - 1]] / radius[by_size_[i]];
        if (fall > steepest) {
            steepest = fall;
            oversized = i;
        }
    }
    oversized_.assign(by_size_.begin(), by_size_.begin() + static_cast<std::ptrdiff_t>(oversized));
    std::sort(oversized_.begin(), oversized_.end());
    for (std::size_t i = 0; i < count; ++i)
        balls.plan(i).place = {};
    for (const std::uint32_t ball : oversized_)
        balls.plan(ball).place.cell = none;
    largest_ = oversized < count ? radius[by_size_[oversized]] : 1.0;

    frame_ = frame_for(world);
    const auto columns = static_cast<std::uint32_t>(frame_.columns);
    directions_ = {{{1u, columns}, {0u - 1u, columns}, {columns, 1u}, {0u - columns, 1u}}};
    head_.assign(frame_.count(), none);
    for (std::size_t i = count; i-- > 0;)
        enter(balls, static_cast<std::uint32_t>(i), world.balls().position[i]);
}

template <typename Real>
CellSpot BallCells<Real>::spot_of(Vec2 position) const {
    const int column = frame_.column_unbounded(position.x);
    const int row = frame_.row_unbounded(position.y);
    const int x = frame_.bounded(column, frame_.columns);
    const int y = frame_.bounded(row, frame_.rows);
    if (!frame_.wraps) return {frame_.index(x, y)};
    return {frame_.index(x, y), (column - x) / frame_.columns, (row - y) / frame_.rows};
}

template <typename Real>
void BallCells<Real>::enter(Balls& balls, std::uint32_t ball, Vec2 position) {
    CellPlace& own = balls.plan(ball).place;
    own.column = frame_.column_unbounded(position.x);
    own.row = frame_.row_unbounded(position.y);
    if (!frame_.wraps) {
        own.column = frame_.bounded(own.column, frame_.columns);
        own.row = frame_.bounded(own.row, frame_.rows);
    }
    link(balls, ball);
}

template class BallCells<double>;
template class BallCells<DoubleDouble>;

}  // namespace carom

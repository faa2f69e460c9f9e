#include "physics/event_cells.h"

#include <algorithm>
#include <numeric>

namespace carom {
namespace {

constexpr std::size_t most_giants = 8;

}  // namespace

CellFrame EventCells::frame_for(const World& world) const {
    const double least = 2.02 * largest_;
    CellFrame frame = frame_around(world, least);
    if (frame.wraps) {
        // Cells of a torus may have come out narrower than a ball: then fewer of them.
        const Vec2 extent = size(*world.model.wrap);
        frame.columns = std::clamp(static_cast<int>(extent.x / least), 1, frame.columns);
        frame.rows = std::clamp(static_cast<int>(extent.y / least), 1, frame.rows);
        frame.cell = {extent.x / frame.columns, extent.y / frame.rows};
    }
    return frame;
}

void EventCells::reset(const World& world, const std::vector<Vec2>& positions) {
    const std::size_t count = positions.size();
    const std::vector<double>& radius = world.balls.radius;
    by_size_.resize(count);
    std::iota(by_size_.begin(), by_size_.end(), 0u);
    std::sort(by_size_.begin(), by_size_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return radius[a] != radius[b] ? radius[a] > radius[b] : a < b;
    });
    // Giants end where the radius falls most.
    std::size_t giants = 0;
    double steepest = 2.0;
    for (std::size_t i = 1; i <= most_giants && i < count; ++i) {
        const double fall = radius[by_size_[i - 1]] / radius[by_size_[i]];
        if (fall > steepest) {
            steepest = fall;
            giants = i;
        }
    }
    giants_.assign(by_size_.begin(), by_size_.begin() + static_cast<std::ptrdiff_t>(giants));
    std::sort(giants_.begin(), giants_.end());
    is_giant_.assign(count, 0);
    for (const std::uint32_t giant : giants_)
        is_giant_[giant] = 1;
    largest_ = giants < count ? radius[by_size_[giants]] : 1.0;

    frame_ = frame_for(world);
    head_.assign(frame_.count(), none);
    next_.resize(count);
    before_.resize(count);
    cell_.resize(count);
    column_.resize(count);
    row_.resize(count);
    tori_.resize(frame_.wraps ? count : 0);
    for (std::size_t i = count; i-- > 0;)
        enter(static_cast<std::uint32_t>(i), positions[i]);
}

void EventCells::enter(std::uint32_t ball, Vec2 position) {
    column_[ball] = frame_.column_unbounded(position.x);
    row_[ball] = frame_.row_unbounded(position.y);
    if (!frame_.wraps) {
        column_[ball] = frame_.bounded(column_[ball], frame_.columns);
        row_[ball] = frame_.bounded(row_[ball], frame_.rows);
    }
    link(ball);
}

void EventCells::link(std::uint32_t ball) {
    int column = column_[ball];
    int row = row_[ball];
    if (frame_.wraps) {
        column = frame_.bounded(column, frame_.columns);
        row = frame_.bounded(row, frame_.rows);
        tori_[ball] = {(column_[ball] - column) / frame_.columns, (row_[ball] - row) / frame_.rows};
    }
    cell_[ball] = frame_.index(column, row);
    if (is_giant_[ball]) return;
    before_[ball] = none;
    next_[ball] = head_[cell_[ball]];
    if (next_[ball] != none) before_[next_[ball]] = ball;
    head_[cell_[ball]] = ball;
}

void EventCells::leave(std::uint32_t ball) {
    if (is_giant_[ball]) return;
    if (before_[ball] == none)
        head_[cell_[ball]] = next_[ball];
    else
        next_[before_[ball]] = next_[ball];
    if (next_[ball] != none) before_[next_[ball]] = before_[ball];
}

void EventCells::step(std::uint32_t ball, int columns, int rows) {
    leave(ball);
    column_[ball] += columns;
    row_[ball] += rows;
    link(ball);
}

}  // namespace carom

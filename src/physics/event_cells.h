#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "physics/cell_frame.h"
#include "physics/event_path.h"
#include "physics/fetch.h"
#include "physics/large_pages.h"

/// The broad phase of the solver `event`: each ball in the cell of its centre, moved from cell to
/// cell by events. A few balls much larger than the rest (*giants*) are in no cell: everybody looks
/// at them, so that cells can fit the others.
///
/// What this knows of a ball stands with the ball: what a walk over neighbours reads in EventBall
/// (`next`, and the tori of its path), the rest in its plan (EventPlan::place).
namespace carom {

template <typename Real>
class EventCells {
  public:
    using Balls = EventBalls<Real>;
    static constexpr std::uint32_t none = EventBall<Real>::none;

    /// A frame whose cells are at least as wide as the largest ball that is no giant, and every
    /// ball in it. Pre: `balls` are as many as the world's.
    void reset(const World& world, Balls& balls);

    /// Whether `reset` would choose the same frame now. Pre: the radii are still the same.
    bool suits(const World& world) const { return frame_for(world) == frame_; }

    const CellFrame& frame() const { return frame_; }
    /// Largest radius among those that are in cells.
    double largest() const { return largest_; }
    const std::vector<std::uint32_t>& giants() const { return giants_; }

    void enter(Balls& balls, std::uint32_t ball, Vec2 position);
    void leave(Balls& balls, std::uint32_t ball);
    /// To the next cell; (columns, rows) is one of the four steps.
    void step(Balls& balls, std::uint32_t ball, int columns, int rows);
    /// The path has been moved by whole tori.
    void shift(Balls& balls, std::uint32_t ball, int across, int along) {
        balls.plan(ball).place.column += across * frame_.columns;
        balls.plan(ball).place.row += along * frame_.rows;
        EventPath<Real>& path = balls[ball].path;
        path.across = static_cast<std::int8_t>(path.across + across);
        path.along = static_cast<std::int8_t>(path.along + along);
    }

    /// Into the cache: which balls are in the nine cells around this one; and what a walk over them
    /// reads of the balls, those who stand second in a cell left out.
    void fetch_heads(std::uint32_t cell) const {
        if (!is_inside(cell)) return;
        const std::uint32_t* const middle = head_.data() + cell;
        fetch_early(middle - frame_.columns);
        fetch_early(middle);
        fetch_early(middle + frame_.columns);
    }
    void fetch_near(const Balls& balls, std::uint32_t cell) const {
        if (!is_inside(cell)) return;
        const std::uint32_t* const middle = head_.data() + cell;
        for (const std::uint32_t* row : {middle - frame_.columns, middle, middle + frame_.columns})
            for (int i = -1; i <= 1; ++i)
                // Ball 0 stands for nobody.
                balls.fetch_neighbour(select(row[i] != none, row[i], 0));
    }

    /// Calls visit(other, tori across, tori along) for every ball in the nine cells around the
    /// ball's own, itself left out: the image of the other that is near lies that many tori from
    /// its path.
    template <typename Visit>
    void for_each_near(const Balls& balls, std::uint32_t ball, Visit&& visit) const {
        if (frame_.wraps)
            walk<true>(balls, ball, {-1, -1}, {1, 1}, visit);
        else
            walk<false>(balls, ball, {-1, -1}, {1, 1}, visit);
    }
    /// The same in those three of the nine cells that a step of (columns, rows) has brought near.
    template <typename Visit>
    void for_each_new(const Balls& balls, std::uint32_t ball, int columns, int rows,
                      Visit&& visit) const {
        const EventPlace own = balls.plan(ball).place;
        if (!frame_.wraps && own.column > 0 && own.column < frame_.columns - 1 && own.row > 0 &&
            own.row < frame_.rows - 1) {
            // Which way it goes nobody can foretell.
            const std::ptrdiff_t width = frame_.columns;
            const std::uint32_t* const middle = head_.data() + own.cell + rows * width + columns;
            const std::ptrdiff_t aside = columns * columns * width + rows * rows;
            Firsts firsts(balls[ball].next, ball);
            for (const std::uint32_t* head : {middle - aside, middle, middle + aside})
                firsts.look_at(*head);
            return firsts.for_each(balls.data(), visit);
        }
        const Step low{columns == 0 ? -1 : columns, rows == 0 ? -1 : rows};
        const Step high{columns == 0 ? 1 : columns, rows == 0 ? 1 : rows};
        if (frame_.wraps)
            walk<true>(balls, ball, low, high, visit);
        else
            walk<false>(balls, ball, low, high, visit);
    }

  private:
    /// Whom the cells around a ball begin with, the ball itself passed over. Nobody can foretell
    /// which cells are empty, so no branch is taken on that.
    class Firsts {
      public:
        Firsts(std::uint32_t after_ball, std::uint32_t ball) : after_(after_ball), ball_(ball) {}
        /// At most nine times.
        void look_at(std::uint32_t first) {
            const std::uint32_t other = select(first == ball_, after_, first);
            firsts_[count_] = other;
            count_ += static_cast<std::size_t>(other != none);
        }
        template <typename Visit>
        void for_each(const EventBall<Real>* balls, Visit&& visit) const {
            for (std::size_t i = 0; i < count_; ++i)
                for (std::uint32_t other = firsts_[i]; other != none; other = balls[other].next)
                    if (other != ball_) visit(other, 0, 0);
        }

      private:
        std::array<std::uint32_t, 9> firsts_;
        std::size_t count_ = 0;
        std::uint32_t after_;
        std::uint32_t ball_;
    };
    struct Step {
        int columns = 0;
        int rows = 0;
    };
    /// A cell of the frame on one axis, and how many tori the way to it has crossed. Pre: on a
    /// torus place is in -1..count.
    struct Place {
        int place = 0;
        int tori = 0;
    };
    static Place around(int place, int count) {
        if (place < 0) return {place + count, -1};
        return place < count ? Place{place, 0} : Place{place - count, 1};
    }

    template <bool wraps, typename Visit>
    void walk(const Balls& all, std::uint32_t ball, Step low, Step high, Visit&& visit) const {
        // What a visit writes cannot change these, but no compiler knows that.
        const EventBall<Real>* const balls = all.data();
        const std::uint32_t* const heads = head_.data();
        const EventPlace own = all.plan(ball).place;
        const int columns = frame_.columns;
        const int rows = frame_.rows;
        const auto index = [columns](int column, int row) {
            return static_cast<std::ptrdiff_t>(row) * columns + column;
        };
        if constexpr (wraps) {
            const int across = balls[ball].path.across;
            const int along = balls[ball].path.along;
            const int column = own.column - across * columns;
            const int row = own.row - along * rows;
            for (int j = row + low.rows; j <= row + high.rows; ++j) {
                const Place y = around(j, rows);
                for (int i = column + low.columns; i <= column + high.columns; ++i) {
                    const Place x = around(i, columns);
                    for (std::uint32_t other = heads[index(x.place, y.place)]; other != none;
                         other = balls[other].next)
                        if (other != ball)
                            visit(other, across + x.tori - balls[other].path.across,
                                  along + y.tori - balls[other].path.along);
                }
            }
        } else {
            Firsts firsts(balls[ball].next, ball);
            const int bottom = std::max(own.row + low.rows, 0);
            const int top = std::min(own.row + high.rows, rows - 1);
            const int left = std::max(own.column + low.columns, 0);
            const int right = std::min(own.column + high.columns, columns - 1);
            if (top - bottom == 2 && right - left == 2) {
                const std::uint32_t* const corner = heads + index(left, bottom);
                for (int y = 0; y < 3; ++y)
                    for (int x = 0; x < 3; ++x)
                        firsts.look_at(corner[index(x, y)]);
            } else {
                for (int y = bottom; y <= top; ++y)
                    for (int x = left; x <= right; ++x)
                        firsts.look_at(heads[index(x, y)]);
            }
            firsts.for_each(balls, visit);
        }
    }
    /// Whether there are eight cells around this one, or what stands for them in memory. Any
    /// number.
    bool is_inside(std::uint32_t cell) const {
        const auto columns = static_cast<std::uint32_t>(frame_.columns);
        return cell > columns && cell < head_.size() && cell + columns + 1 < head_.size();
    }
    CellFrame frame_for(const World& world) const;
    void link(Balls& balls, std::uint32_t ball);

    CellFrame frame_;
    double largest_ = 0.0;
    std::vector<std::uint32_t> by_size_;
    std::vector<std::uint32_t> giants_;
    LargeVector<std::uint32_t> head_;  ///< first ball of each cell
};

}  // namespace carom

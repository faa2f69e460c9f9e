#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "physics/broad_phase/cell_frame.h"
#include "physics/event/motion/ball_table.h"
#include "physics/memory/branchless.h"
#include "physics/memory/large_pages.h"
#include "physics/memory/prefetch.h"

/// The broad phase of the solver `event`: a grid that holds each ball in the cell of its centre.
/// Cell transfers, which are events, keep it true.
///
/// A cell is at least as wide as the largest ball in the grid, so a ball can only meet balls of the
/// nine cells around it. A few balls much larger than the rest (*oversized*) are in no cell: every
/// query tests them. On a torus the grid wraps, and queries tell the periodic image of each ball.
///
/// The grid decides only which pairs are tested. Its frame shows in no result: pairs that touch are
/// sorted before use, and events have a total order. README.md has the exceptions: one-way edges,
/// and the rounding of impacts with kinematic edges.
///
/// The grid's data about a ball lies in BallTable: BallRecord::next and the image index of its
/// trajectory, which walks over neighbours read, and BallPlan::place.
///
/// Prefetching: call prefetch_heads(cell) some events ahead, later prefetch_near(cell), then query.
namespace carom {

/// A cell, and the periodic image in which it lies.
struct CellSpot {
    std::uint32_t cell = 0;
    int across = 0;
    int along = 0;
};

template <typename Real>
class BallCells {
  public:
    using Balls = BallTable<Real>;
    static constexpr std::uint32_t none = BallRecord<Real>::none;

    /// Lays the grid out for this world and enters every ball.
    /// Pre: balls.size() == world.balls.size(). Cost: O(n log n).
    void reset(const World& world, Balls& balls);

    /// Whether `reset` would lay out the same grid now. Pre: the radii have not changed.
    bool has_frame_of(const World& world) const { return frame_for(world) == frame_; }

    const CellFrame& frame() const { return frame_; }
    /// The largest radius in the grid; 1 where there is none.
    double largest() const { return largest_; }
    const std::vector<std::uint32_t>& oversized() const { return oversized_; }
    static bool is_oversized(const Balls& balls, std::uint32_t ball) {
        return balls.plan(ball).place.cell == none;
    }

    CellSpot spot_of(Vec2 position) const;
    void enter(Balls& balls, std::uint32_t ball, Vec2 position);
    void leave(Balls& balls, std::uint32_t ball) {
        if (is_oversized(balls, ball)) return;
        const std::uint32_t before = balls.plan(ball).place.before;
        const std::uint32_t next = balls[ball].next;
        if (before == none)
            head_[balls.plan(ball).place.cell] = next;
        else
            balls[before].next = next;
        if (next != none) balls.plan(next).place.before = before;
    }
    /// Moves a ball to an adjacent cell: (columns, rows) is (+-1, 0) or (0, +-1).
    void step(Balls& balls, std::uint32_t ball, int columns, int rows) {
        leave(balls, ball);
        balls.plan(ball).place.column += columns;
        balls.plan(ball).place.row += rows;
        link(balls, ball);
    }
    /// Takes note that the ball's trajectory has been moved by whole periods.
    void shift(Balls& balls, std::uint32_t ball, int across, int along) {
        balls.plan(ball).place.column += across * frame_.columns;
        balls.plan(ball).place.row += along * frame_.rows;
        LinearPart<Real>& line = balls[ball].line;
        line.across = static_cast<std::int8_t>(line.across + across);
        line.along = static_cast<std::int8_t>(line.along + along);
    }

    /// Directions are the sides of cell_transfer, or this.
    static constexpr std::uint32_t no_direction = 4;
    /// The cell on that side of this one, on a plane; for any other direction, the cell itself.
    std::uint32_t next_cell(std::uint32_t cell, std::uint32_t direction) const {
        return cell + directions_[direction % directions_.size()].to_next;
    }

    /// Prefetches the heads of the nine cells around this one; the records of the first ball in
    /// each; those of the three cells that a step in `direction` into this cell brings near. Any
    /// number may be given for a cell.
    void prefetch_heads(std::uint32_t cell) const {
        if (!is_inside(cell)) return;
        const std::uint32_t* const middle = head_.data() + cell;
        prefetch_line(middle - frame_.columns);
        prefetch_line(middle);
        prefetch_line(middle + frame_.columns);
    }
    void prefetch_near(const Balls& balls, std::uint32_t cell) const {
        if (!is_inside(cell)) return;
        const std::uint32_t* const middle = head_.data() + cell;
        for (const std::uint32_t* row : {middle - frame_.columns, middle, middle + frame_.columns})
            prefetch_three(balls, row, 1);
    }
    void prefetch_new(const Balls& balls, std::uint32_t cell, std::uint32_t direction) const {
        if (!is_inside(cell)) return;
        prefetch_three(
            balls, head_.data() + next_cell(cell, direction),
            static_cast<std::ptrdiff_t>(directions_[direction % directions_.size()].aside));
    }

    /// Calls visit(other, across, along) for every other ball in the nine cells around the ball's
    /// own. (across, along) is the periodic image of the other that is near, relative to its
    /// trajectory.
    template <typename Visit>
    void for_each_near(const Balls& balls, std::uint32_t ball, Visit&& visit) const {
        if (!frame_.wraps) {
            Chains chains = chains_near(balls, ball);
            return chains.for_each(balls.data(), visit);
        }
        walk(balls, ball, {-1, -1}, {1, 1}, visit);
    }
    /// Calls visit(other, across, along) for every ball in the three cells that a step of
    /// (columns, rows) has brought near.
    template <typename Visit>
    void for_each_new(const Balls& balls, std::uint32_t ball, int columns, int rows,
                      Visit&& visit) const {
        if (!frame_.wraps) {
            Chains chains = chains_of_new(balls, ball, columns, rows);
            return chains.for_each(balls.data(), visit);
        }
        const auto [low, high] = new_near(columns, rows);
        walk(balls, ball, low, high, visit);
    }

    /// The first balls of some cells around a ball, without the ball itself. Which cells are empty,
    /// and how many balls stand in each, no processor can predict: so no branch is taken on it.
    class Chains {
      public:
        Chains(std::uint32_t after_ball, std::uint32_t ball) : after_(after_ball), ball_(ball) {}
        /// Adds a cell that may begin with the ball itself. At most nine calls.
        void add_passing_over_own(std::uint32_t first) {
            add(select(first == ball_, after_, first));
        }
        /// Adds a cell that does not hold the ball.
        void add(std::uint32_t first) {
            balls_[count_] = first;
            count_ += static_cast<std::size_t>(first != none);
        }
        /// Calls visit(other, 0, 0) for all balls of these cells.
        template <typename Visit>
        void for_each(const BallRecord<Real>* balls, Visit&& visit) {
            std::size_t i = 0;
            for (; i < count_ && count_ < balls_.size(); ++i) {
                const std::uint32_t other = balls_[i];
                add_passing_over_own(balls[other].next);
                visit(other, 0, 0);
            }
            // More than fit here: cell by cell.
            for (; i < count_; ++i)
                for (std::uint32_t other = balls_[i]; other != none; other = balls[other].next)
                    if (other != ball_) visit(other, 0, 0);
        }

      private:
        std::array<std::uint32_t, 48> balls_;
        std::size_t count_ = 0;
        std::uint32_t after_;
        std::uint32_t ball_;
    };
    /// The cells of `for_each_near` and `for_each_new` where nothing wraps.
    Chains chains_near(const Balls& balls, std::uint32_t ball) const {
        const CellPlace& own = balls.plan(ball).place;
        Chains chains(balls[ball].next, ball);
        if (!is_amid(own)) {
            add_chains(own, {-1, -1}, {1, 1}, chains);
            return chains;
        }
        const std::ptrdiff_t width = frame_.columns;
        const std::uint32_t* const middle = head_.data() + own.cell;
        chains.add_passing_over_own(*middle);
        for (const std::ptrdiff_t step : {-width - 1, -width, -width + 1, std::ptrdiff_t{-1},
                                          std::ptrdiff_t{1}, width - 1, width, width + 1})
            chains.add(middle[step]);
        return chains;
    }
    Chains chains_of_new(const Balls& balls, std::uint32_t ball, int columns, int rows) const {
        // By reference: a copy of what was just written in parts would stall.
        const CellPlace& own = balls.plan(ball).place;
        Chains chains(balls[ball].next, ball);
        if (!is_amid(own)) {
            const auto [low, high] = new_near(columns, rows);
            add_chains(own, low, high, chains);
            return chains;
        }
        // Without a branch on the direction.
        const std::ptrdiff_t width = frame_.columns;
        const std::uint32_t* const middle = head_.data() + own.cell + rows * width + columns;
        const std::ptrdiff_t aside = columns * columns * width + rows * rows;
        for (const std::uint32_t* head : {middle - aside, middle, middle + aside})
            chains.add(*head);
        return chains;
    }

  private:
    struct Step {
        int columns = 0;
        int rows = 0;
    };
    /// The corners of the block of cells that a step has brought near.
    static std::array<Step, 2> new_near(int columns, int rows) {
        return {{{columns == 0 ? -1 : columns, rows == 0 ? -1 : rows},
                 {columns == 0 ? 1 : columns, rows == 0 ? 1 : rows}}};
    }
    bool is_amid(const CellPlace& own) const {
        return own.column > 0 && own.column < frame_.columns - 1 && own.row > 0 &&
               own.row < frame_.rows - 1;
    }
    void add_chains(const CellPlace& own, Step low, Step high, Chains& chains) const {
        for (int y = std::max(own.row + low.rows, 0);
             y <= std::min(own.row + high.rows, frame_.rows - 1); ++y)
            for (int x = std::max(own.column + low.columns, 0);
                 x <= std::min(own.column + high.columns, frame_.columns - 1); ++x)
                chains.add_passing_over_own(head_[frame_.index(x, y)]);
    }
    /// A column or row of the frame, and the periodic image. Pre: place is in -1..count.
    struct Place {
        int place = 0;
        int image = 0;
    };
    static Place around(int place, int count) {
        if (place < 0) return {place + count, -1};
        return place < count ? Place{place, 0} : Place{place - count, 1};
    }

    template <typename Visit>
    void walk(const Balls& all, std::uint32_t ball, Step low, Step high, Visit&& visit) const {
        // Copies: a visit cannot change these, but no compiler knows that.
        const BallRecord<Real>* const balls = all.data();
        const std::uint32_t* const heads = head_.data();
        const CellPlace own = all.plan(ball).place;
        const int columns = frame_.columns;
        const int rows = frame_.rows;
        const auto index = [columns](int column, int row) {
            return static_cast<std::ptrdiff_t>(row) * columns + column;
        };
        const int across = balls[ball].line.across;
        const int along = balls[ball].line.along;
        const int column = own.column - across * columns;
        const int row = own.row - along * rows;
        for (int j = row + low.rows; j <= row + high.rows; ++j) {
            const Place y = around(j, rows);
            for (int i = column + low.columns; i <= column + high.columns; ++i) {
                const Place x = around(i, columns);
                for (std::uint32_t other = heads[index(x.place, y.place)]; other != none;
                     other = balls[other].next)
                    if (other != ball)
                        visit(other, across + x.image - balls[other].line.across,
                              along + y.image - balls[other].line.along);
            }
        }
    }
    /// Whether memory holds eight cells around this one. Any number may be given.
    bool is_inside(std::uint32_t cell) const {
        const auto columns = static_cast<std::uint32_t>(frame_.columns);
        return cell > columns && cell < head_.size() && cell + columns + 1 < head_.size();
    }
    // The last ball stands in for `none`.
    static void prefetch_three(const Balls& balls, const std::uint32_t* middle,
                               std::ptrdiff_t apart) {
        const auto last = static_cast<std::uint32_t>(balls.size() - 1);
        for (const std::uint32_t first : {middle[-apart], *middle, middle[apart]})
            balls.prefetch_neighbour(std::min(first, last));
    }
    CellFrame frame_for(const World& world) const;
    void link(Balls& balls, std::uint32_t ball) {
        CellPlace& own = balls.plan(ball).place;
        int column = own.column;
        int row = own.row;
        if (frame_.wraps) {
            column = frame_.bounded(column, frame_.columns);
            row = frame_.bounded(row, frame_.rows);
            LinearPart<Real>& line = balls[ball].line;
            line.across = static_cast<std::int8_t>((own.column - column) / frame_.columns);
            line.along = static_cast<std::int8_t>((own.row - row) / frame_.rows);
        }
        if (is_oversized(balls, ball)) return;
        own.cell = frame_.index(column, row);
        own.before = none;
        const std::uint32_t next = head_[own.cell];
        balls[ball].next = next;
        if (next != none) balls.plan(next).place.before = ball;
        head_[own.cell] = ball;
    }

    /// Steps by direction, so that no branch is taken on it.
    struct Direction {
        std::uint32_t to_next = 0;  ///< to be added to a cell
        std::uint32_t aside = 1;    ///< between cells side by side across the direction
    };

    CellFrame frame_;
    std::array<Direction, 8> directions_;  ///< by direction; those from 4 on lead nowhere
    double largest_ = 0.0;
    std::vector<std::uint32_t> by_size_;
    std::vector<std::uint32_t> oversized_;
    LargeVector<std::uint32_t> head_;  ///< first ball of each cell
};

}  // namespace carom

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "physics/broad_phase/cell_frame.h"
#include "physics/event/trajectory.h"
#include "physics/memory/large_pages.h"
#include "physics/memory/prefetch.h"

/// The broad phase of the solver `event`: each ball in the cell of its centre, moved from cell to
/// cell by events. A few balls much larger than the rest (*giants*) are in no cell: everybody looks
/// at them, so that cells can fit the others.
///
/// What this knows of a ball stands with the ball: what a walk over neighbours reads in EventBall
/// (`next`, and the tori of its path), the rest in its plan (EventPlan::place).
namespace carom {

/// A cell, and how many tori the way to it has crossed.
struct EventSpot {
    std::uint32_t cell = 0;
    int across = 0;
    int along = 0;
};

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
    static bool is_giant(const Balls& balls, std::uint32_t ball) {
        return balls.plan(ball).place.cell == none;
    }

    EventSpot spot_of(Vec2 position) const;
    void enter(Balls& balls, std::uint32_t ball, Vec2 position);
    void leave(Balls& balls, std::uint32_t ball) {
        if (is_giant(balls, ball)) return;
        const std::uint32_t before = balls.plan(ball).place.before;
        const std::uint32_t next = balls[ball].next;
        if (before == none)
            head_[balls.plan(ball).place.cell] = next;
        else
            balls[before].next = next;
        if (next != none) balls.plan(next).place.before = before;
    }
    /// To the next cell; (columns, rows) is one of the four steps.
    void step(Balls& balls, std::uint32_t ball, int columns, int rows) {
        leave(balls, ball);
        balls.plan(ball).place.column += columns;
        balls.plan(ball).place.row += rows;
        link(balls, ball);
    }
    /// The path has been moved by whole tori.
    void shift(Balls& balls, std::uint32_t ball, int across, int along) {
        balls.plan(ball).place.column += across * frame_.columns;
        balls.plan(ball).place.row += along * frame_.rows;
        EventLine<Real>& line = balls[ball].line;
        line.across = static_cast<std::int8_t>(line.across + across);
        line.along = static_cast<std::int8_t>(line.along + along);
    }

    /// A ball leaves a cell in one of the directions 0 to 3, as in events: x, -x, y, -y; or in
    /// none.
    static constexpr std::uint32_t no_direction = 4;
    /// The cell on that side of this one, on a plane; for any other number, the cell itself.
    std::uint32_t next_cell(std::uint32_t cell, std::uint32_t direction) const {
        return cell + ways_[direction % ways_.size()].to_next;
    }

    /// Into the cache: which balls are in the nine cells around this one; what a walk over them
    /// reads of the balls, those who stand second in a cell left out; the same of the three cells
    /// that a step in that direction, which led into this cell, has brought near.
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
            fetch_three(balls, row, 1);
    }
    void fetch_new(const Balls& balls, std::uint32_t cell, std::uint32_t direction) const {
        if (!is_inside(cell)) return;
        fetch_three(balls, head_.data() + next_cell(cell, direction),
                    static_cast<std::ptrdiff_t>(ways_[direction % ways_.size()].aside));
    }

    /// Calls visit(other, tori across, tori along) for every ball in the nine cells around the
    /// ball's own, itself left out: the image of the other that is near lies that many tori from
    /// its path.
    template <typename Visit>
    void for_each_near(const Balls& balls, std::uint32_t ball, Visit&& visit) const {
        if (!frame_.wraps) {
            Firsts firsts = firsts_near(balls, ball);
            return firsts.for_each(balls.data(), visit);
        }
        walk(balls, ball, {-1, -1}, {1, 1}, visit);
    }
    /// The same in those three of the nine cells that a step of (columns, rows) has brought near.
    template <typename Visit>
    void for_each_new(const Balls& balls, std::uint32_t ball, int columns, int rows,
                      Visit&& visit) const {
        if (!frame_.wraps) {
            Firsts firsts = firsts_of_new(balls, ball, columns, rows);
            return firsts.for_each(balls.data(), visit);
        }
        const auto [low, high] = new_near(columns, rows);
        walk(balls, ball, low, high, visit);
    }

    /// Whom the cells around a ball begin with, the ball itself passed over. Nobody can foretell
    /// which cells are empty, nor how many stand in which, so no branch is taken on that.
    class Firsts {
      public:
        Firsts(std::uint32_t after_ball, std::uint32_t ball) : after_(after_ball), ball_(ball) {}
        /// At most nine times.
        void look_at(std::uint32_t first) { add(select(first == ball_, after_, first)); }
        /// The same of a cell in which the ball is not.
        void add(std::uint32_t first) {
            balls_[count_] = first;
            count_ += static_cast<std::size_t>(first != none);
        }
        /// Calls visit(other, 0, 0) for all of them and for those behind them in their cells.
        template <typename Visit>
        void for_each(const EventBall<Real>* balls, Visit&& visit) {
            std::size_t i = 0;
            for (; i < count_ && count_ < balls_.size(); ++i) {
                const std::uint32_t other = balls_[i];
                look_at(balls[other].next);
                visit(other, 0, 0);
            }
            // Too many for the room: cell by cell.
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
    /// For `for_each_near` and `for_each_new` where nothing wraps.
    Firsts firsts_near(const Balls& balls, std::uint32_t ball) const {
        const EventPlace& own = balls.plan(ball).place;
        Firsts firsts(balls[ball].next, ball);
        if (!is_amid(own)) {
            add_firsts(own, {-1, -1}, {1, 1}, firsts);
            return firsts;
        }
        const std::ptrdiff_t width = frame_.columns;
        const std::uint32_t* const middle = head_.data() + own.cell;
        firsts.look_at(*middle);
        for (const std::ptrdiff_t way : {-width - 1, -width, -width + 1, std::ptrdiff_t{-1},
                                         std::ptrdiff_t{1}, width - 1, width, width + 1})
            firsts.add(middle[way]);
        return firsts;
    }
    Firsts firsts_of_new(const Balls& balls, std::uint32_t ball, int columns, int rows) const {
        // Not as a whole: what has just been written in parts takes long to be read so.
        const EventPlace& own = balls.plan(ball).place;
        Firsts firsts(balls[ball].next, ball);
        if (!is_amid(own)) {
            const auto [low, high] = new_near(columns, rows);
            add_firsts(own, low, high, firsts);
            return firsts;
        }
        // Which way it goes nobody can foretell.
        const std::ptrdiff_t width = frame_.columns;
        const std::uint32_t* const middle = head_.data() + own.cell + rows * width + columns;
        const std::ptrdiff_t aside = columns * columns * width + rows * rows;
        for (const std::uint32_t* head : {middle - aside, middle, middle + aside})
            firsts.add(*head);
        return firsts;
    }

  private:
    struct Step {
        int columns = 0;
        int rows = 0;
    };
    /// From where to where those cells are that a step has brought near.
    static std::array<Step, 2> new_near(int columns, int rows) {
        return {{{columns == 0 ? -1 : columns, rows == 0 ? -1 : rows},
                 {columns == 0 ? 1 : columns, rows == 0 ? 1 : rows}}};
    }
    bool is_amid(const EventPlace& own) const {
        return own.column > 0 && own.column < frame_.columns - 1 && own.row > 0 &&
               own.row < frame_.rows - 1;
    }
    void add_firsts(const EventPlace& own, Step low, Step high, Firsts& firsts) const {
        for (int y = std::max(own.row + low.rows, 0);
             y <= std::min(own.row + high.rows, frame_.rows - 1); ++y)
            for (int x = std::max(own.column + low.columns, 0);
                 x <= std::min(own.column + high.columns, frame_.columns - 1); ++x)
                firsts.look_at(head_[frame_.index(x, y)]);
    }
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

    template <typename Visit>
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
                        visit(other, across + x.tori - balls[other].line.across,
                              along + y.tori - balls[other].line.along);
            }
        }
    }
    /// Whether there are eight cells around this one, or what stands for them in memory. Any
    /// number.
    bool is_inside(std::uint32_t cell) const {
        const auto columns = static_cast<std::uint32_t>(frame_.columns);
        return cell > columns && cell < head_.size() && cell + columns + 1 < head_.size();
    }
    // The last ball stands for nobody.
    static void fetch_three(const Balls& balls, const std::uint32_t* middle, std::ptrdiff_t apart) {
        const auto last = static_cast<std::uint32_t>(balls.size() - 1);
        for (const std::uint32_t first : {middle[-apart], *middle, middle[apart]})
            balls.fetch_neighbour(std::min(first, last));
    }
    CellFrame frame_for(const World& world) const;
    void link(Balls& balls, std::uint32_t ball) {
        EventPlace& own = balls.plan(ball).place;
        int column = own.column;
        int row = own.row;
        if (frame_.wraps) {
            column = frame_.bounded(column, frame_.columns);
            row = frame_.bounded(row, frame_.rows);
            EventLine<Real>& line = balls[ball].line;
            line.across = static_cast<std::int8_t>((own.column - column) / frame_.columns);
            line.along = static_cast<std::int8_t>((own.row - row) / frame_.rows);
        }
        if (is_giant(balls, ball)) return;
        own.cell = frame_.index(column, row);
        own.before = none;
        const std::uint32_t next = head_[own.cell];
        balls[ball].next = next;
        if (next != none) balls.plan(next).place.before = ball;
        head_[own.cell] = ball;
    }

    /// In which direction a ball goes nobody can foretell: so no branch is taken on that.
    struct Way {
        std::uint32_t to_next = 0;  ///< to be added to a cell
        std::uint32_t aside = 1;    ///< between cells beside one another as seen by who goes there
    };

    CellFrame frame_;
    std::array<Way, 8> ways_;  ///< by direction; further ones lead nowhere
    double largest_ = 0.0;
    std::vector<std::uint32_t> by_size_;
    std::vector<std::uint32_t> giants_;
    LargeVector<std::uint32_t> head_;  ///< first ball of each cell
};

}  // namespace carom

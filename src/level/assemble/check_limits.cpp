// What the machine cannot do: crowds of balls inside one another, and places and motions too fine
// for its numbers.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "level/assemble/checks.h"

namespace carom {
namespace {

// Discs that are not kept: what a ball needs here is its number. 8 bytes for each of them.
class CrowdCheck {
  public:
    CrowdCheck(const ResolvedNames& names, Context& context)
        : names_(names), context_(context), balls_(context.ir.balls) {}

    void run() {
        find_frame();
        if (!(cell_ > 0.0)) return;
        first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), none);
        next_.assign(balls_.size(), none);
        for (std::uint32_t i = 0; i < balls_.size(); ++i) {
            if (!is_valid(i)) continue;
            const Disc disc = disc_of(i);
            if (is_inside_another(i, disc) || looks_ > most_looks * balls_.size()) return;
            std::uint32_t& first = first_[cell_of(column(disc.center.x), row(disc.center.y))];
            next_[i] = first;
            first = i;
        }
    }

  private:
    static constexpr std::uint32_t none = 0xffffffffu;
    /// Balls of very different sizes, or a million in one place, are for the check that follows.
    static constexpr std::uint64_t most_looks = 16;

    ClassIndex kind_of(std::uint32_t i) const {
        return names_.balls[static_cast<std::size_t>(balls_.shared_part(i).binding)].kind;
    }
    bool is_valid(std::uint32_t i) const {
        return names_.balls[static_cast<std::size_t>(balls_.shared_part(i).binding)].is_valid;
    }
    Disc disc_of(std::uint32_t i) const {
        const BallIr& part = balls_.shared_part(i);
        const double radius = part.radius.value_or(names_.kinds[kind_of(i)].radius);
        return {balls_.position(i) + part.racked * (2.0 * radius + part.gap), radius};
    }

    void find_frame() {
        double largest = 0.0;
        std::optional<Box> all;
        for (std::uint32_t i = 0; i < balls_.size(); ++i) {
            if (!is_valid(i)) continue;
            const Disc disc = disc_of(i);
            const Box at{disc.center, disc.center};
            all = all ? join(*all, at) : at;
            largest = std::max(largest, disc.radius);
        }
        if (!all) return;
        // No more cells than balls.
        low_ = all->low;
        const Vec2 extent = size(*all);
        const double count = static_cast<double>(balls_.size());
        cell_ = std::max({2.0 * largest, std::sqrt(extent.x * extent.y / count), extent.x / count,
                          extent.y / count});
        columns_ = static_cast<int>(extent.x / cell_) + 1;
        rows_ = static_cast<int>(extent.y / cell_) + 1;
    }
    int column(double x) const { return static_cast<int>((x - low_.x) / cell_); }
    int row(double y) const { return static_cast<int>((y - low_.y) / cell_); }
    std::size_t cell_of(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    // Whether the ball starts inside one before it, which is reported.
    bool is_inside_another(std::uint32_t i, const Disc& disc) {
        const int x = column(disc.center.x);
        const int y = row(disc.center.y);
        for (int v = std::max(0, y - 1); v <= std::min(rows_ - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(columns_ - 1, x + 1); ++u)
                for (std::uint32_t k = first_[cell_of(u, v)]; k != none; k = next_[k]) {
                    ++looks_;
                    const Disc other = disc_of(k);
                    const double depth = overlap_at_start(disc, other);
                    if (!(depth > 0.0) || !names_.kinds_collide(kind_of(i), kind_of(k))) continue;
                    report_ball_inside_ball(balls_[i].origin, balls_[k].origin, depth, context_);
                    return true;
                }
        return false;
    }

    const ResolvedNames& names_;
    Context& context_;
    const BallList& balls_;
    Vec2 low_;
    double cell_ = 0.0;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<std::uint32_t> first_;  // by cell: its last ball; `none`
    std::vector<std::uint32_t> next_;   // by ball: the one before it in its cell
    std::uint64_t looks_ = 0;
};

}  // namespace

void check_crowd(const ResolvedNames& names, Context& context) {
    if (context.ir.settings.may_overlap || !names.some_balls_collide()) return;
    CrowdCheck(names, context).run();
}

namespace {

// The distance from a coordinate to the next larger double.
double spacing_at(double coordinate) {
    const double size = std::abs(coordinate);
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) + 1) - size;
}

// Whether rounding loses the motion of a tick along one axis. A velocity that is itself a rounding
// error does not count.
bool is_lost(double coordinate, double velocity, double speed, double tick) {
    constexpr double rounding_error = 1e-6;
    return std::abs(velocity) > rounding_error * speed &&
           coordinate + velocity * tick == coordinate;
}

std::string text_of_length(double value, const Context& context) {
    return fmt::format("{}{}", written(value, Measure::length, context.unit), symbol(context.unit));
}

// Reports an error if doubles are too coarse for a ball of this radius there.
bool reports_coarse(Vec2 at, double radius, const Origin& origin, Context& context) {
    constexpr double least_share = 1.0 / 64.0;
    const double farthest = std::max(std::abs(at.x), std::abs(at.y));
    const double spacing = spacing_at(farthest);
    if (!(spacing > least_share * radius)) return false;
    const auto length_text = [&](double value) { return text_of_length(value, context); };
    context.reporter.error(
        "coordinates-too-coarse", origin.span(),
        fmt::format("numbers near {} are {} apart: too coarse for a ball of radius {}",
                    length_text(farthest), length_text(spacing), length_text(radius)),
        "move the scene closer to 0,0");
    return true;
}

}  // namespace

void check_precision(const std::vector<StartingBall>& balls, const ResolvedNames& names,
                     double rate, Context& context) {
    const double tick = 1.0 / rate;
    for (std::size_t i = 0; i < context.ir.emitters.size(); ++i) {
        const EmitterIr& spec = context.ir.emitters[i];
        if (!names.emitters[i].is_valid) continue;
        const double radius = names.kinds[names.emitters[i].kind].radius;
        if (reports_coarse(spec.emitter.at, radius, spec.origin, context)) return;
    }
    for (const StartingBall& ball : balls) {
        const Vec2 at = ball.position;
        if (reports_coarse(at, ball.radius, ball.origin, context)) return;
        const double speed = length(ball.velocity);
        if (!is_lost(at.x, ball.velocity.x, speed, tick) &&
            !is_lost(at.y, ball.velocity.y, speed, tick))
            continue;
        const double farthest = std::max(std::abs(at.x), std::abs(at.y));
        const auto length_text = [&](double value) { return text_of_length(value, context); };
        context.reporter.warning(
            "motion-lost-in-rounding", ball.origin.span(),
            fmt::format("what the ball travels in a tick, {}, is lost in rounding: numbers near "
                        "{} are {} apart",
                        length_text(speed * tick), length_text(farthest),
                        length_text(spacing_at(farthest))),
            "move the scene closer to 0,0, or take longer ticks: rate");
        return;
    }
}

}  // namespace carom

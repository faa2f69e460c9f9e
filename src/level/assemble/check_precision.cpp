#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "level/assemble/checks.h"

namespace carom {
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

}  // namespace

void check_precision(const std::vector<StartingBall>& balls, double rate, Context& context) {
    constexpr double least_share = 1.0 / 64.0;
    const double tick = 1.0 / rate;
    const auto length_text = [&](double value) {
        return fmt::format("{}{}", written(value, Measure::length, context.unit),
                           symbol(context.unit));
    };
    for (const StartingBall& ball : balls) {
        const Vec2 at = ball.position;
        const double farthest = std::max(std::abs(at.x), std::abs(at.y));
        const double spacing = spacing_at(farthest);
        if (spacing > least_share * ball.radius) {
            context.reporter.error(
                "coordinates-too-coarse", ball.origin.span(),
                fmt::format("numbers near {} are {} apart: too coarse for a ball of radius {}",
                            length_text(farthest), length_text(spacing), length_text(ball.radius)),
                "move the scene closer to 0,0");
            return;
        }
        const double speed = length(ball.velocity);
        if (!is_lost(at.x, ball.velocity.x, speed, tick) &&
            !is_lost(at.y, ball.velocity.y, speed, tick))
            continue;
        context.reporter.warning(
            "motion-lost-in-rounding", ball.origin.span(),
            fmt::format("what the ball travels in a tick, {}, is lost in rounding: numbers near "
                        "{} are {} apart",
                        length_text(speed * tick), length_text(farthest), length_text(spacing)),
            "move the scene closer to 0,0, or take longer ticks: rate");
        return;
    }
}

}  // namespace carom

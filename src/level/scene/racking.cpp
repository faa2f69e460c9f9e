#include "level/scene/racking.h"

#include <algorithm>
#include <numeric>

#include "geometry/elementary.h"
#include "physics/world/random.h"

namespace carom {
namespace {

constexpr double row_height = 0.86602540378443865;  // sqrt(3)/2: equal gaps all around

// The positions of a rack, row by row from the apex, in units of the distance between neighbours: x
// away from the apex, y to the left.
std::vector<Vec2> places_of(const RackLayout& layout) {
    std::vector<Vec2> places;
    for (std::size_t row = 0; row < layout.rows.size(); ++row) {
        const int count = layout.rows[row];
        for (int i = 0; i < count; ++i)
            places.push_back({static_cast<double>(row) * row_height, 0.5 * (count - 1.0) - i});
    }
    return places;
}

// Puts one ball of each group into the rear corners, if both have balls of one group.
void part_groups(const RackLayout& layout, std::vector<int>& numbers) {
    const std::size_t right = numbers.size() - 1;
    const std::size_t left = numbers.size() - static_cast<std::size_t>(layout.rows.back());
    const auto is_low = [&](std::size_t place) { return numbers[place] < layout.group_border; };
    const auto is_placed = [&](std::size_t place) {
        return std::ranges::count(layout.placed, static_cast<int>(place),
                                  &RackLayout::Placed::place) > 0;
    };
    if (is_low(left) != is_low(right)) return;
    const bool wants_low = !is_low(left);
    for (std::size_t i = 0; i < right; ++i) {
        if (i == left || is_placed(i) || is_low(i) != wants_low) continue;
        return std::swap(numbers[i], numbers[right]);
    }
}

// The number of the ball at each position: shuffled by the seed, except where the rules prescribe
// it.
std::vector<int> numbers_of(const RackLayout& layout, std::uint64_t seed) {
    std::vector<int> numbers(static_cast<std::size_t>(layout.balls()));
    std::iota(numbers.begin(), numbers.end(), 1);
    if (!layout.is_shuffled) return numbers;
    for (std::size_t i = numbers.size(); i-- > 1;) {
        const std::uint64_t other = random_bits(seed, RandomStream::rack, 0, i) % (i + 1);
        std::swap(numbers[i], numbers[static_cast<std::size_t>(other)]);
    }
    for (const RackLayout::Placed& placed : layout.placed)
        std::swap(*std::ranges::find(numbers, placed.ball),
                  numbers[static_cast<std::size_t>(placed.place)]);
    if (layout.group_border > 0) part_groups(layout, numbers);
    return numbers;
}

// Of later frames.
constexpr double least_gaps = 0.5;  // of the level's
constexpr double most_gaps = 2.0;
constexpr double most_turn = 0.5;  // degrees
// The draws of a whole rack, apart from those of its balls.
constexpr std::uint64_t of_the_rack = 1000;

Vec2 turned(Vec2 v, const SinCos& by) {
    return {v.x * by.cos - v.y * by.sin, v.x * by.sin + v.y * by.cos};
}

}  // namespace

std::vector<RackedBall> racked(const RackPlan& plan, std::uint32_t frame) {
    const std::vector<Vec2> places = places_of(*plan.layout);
    const bool is_again = frame > 0 && plan.seed && plan.gap > 0.0;
    const std::uint64_t first_seed = plan.seed.value_or(0);
    const std::uint64_t seed = frame > 0 && plan.seed
                                   ? random_bits(first_seed, RandomStream::rack, of_the_rack, frame)
                                   : first_seed;
    const auto of_rack = [&](double from, double to, std::uint64_t draw) {
        return random_between(from, to, seed, RandomStream::rack, of_the_rack, draw);
    };
    const double gap = is_again ? plan.gap * of_rack(least_gaps, most_gaps, 0) : plan.gap;
    const SinCos turn =
        is_again ? sin_cos_degrees(of_rack(-most_turn, most_turn, 1)) : SinCos{0.0, 1.0};
    const std::vector<int> numbers = numbers_of(*plan.layout, seed);
    std::vector<RackedBall> balls;
    for (int number = 1; number <= static_cast<int>(numbers.size()); ++number) {
        const auto place =
            static_cast<std::size_t>(std::ranges::find(numbers, number) - numbers.begin());
        // Random shifts leave at least half of the gap between any two balls.
        const auto shake = [&](std::uint64_t draw) {
            return plan.seed ? random_between(-0.25, 0.25, seed, RandomStream::rack,
                                              static_cast<std::uint64_t>(number), draw) *
                                   gap * 0.70710678118654752
                             : 0.0;
        };
        RackedBall ball;
        ball.grid = plan.toward * places[place].x + perpendicular(plan.toward) * places[place].y;
        if (is_again) ball.grid = turned(ball.grid, turn);
        ball.shift = Vec2{shake(0), shake(1)};
        ball.gap = gap;
        balls.push_back(ball);
    }
    return balls;
}

}  // namespace carom

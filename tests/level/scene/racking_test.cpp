#include "level/scene/racking.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace carom;

namespace {

constexpr double diameter = 0.05715;
constexpr double gap = 0.00005;

std::vector<Vec2> places(const RackPlan& plan, std::uint32_t frame) {
    std::vector<Vec2> result;
    for (const RackedBall& ball : racked(plan, frame))
        result.push_back(ball.shift + ball.grid * (diameter + ball.gap));
    return result;
}

RackPlan plan(const char* statement, double plan_gap = gap) {
    return {rack_layout(statement), {1.0, 0.0}, plan_gap, 9};
}

double least_distance(const std::vector<Vec2>& balls) {
    double least = 1.0;
    for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            least = std::min(least, distance(balls[i], balls[k]));
    return least;
}

}  // namespace

TEST_CASE("each frame has a rack of its own, and the same one every time") {
    for (const char* const statement : {"rack eight", "rack nine", "rack triangle"}) {
        CAPTURE(statement);
        const RackPlan rack = plan(statement);
        std::set<std::pair<double, double>> second_balls;
        for (std::uint32_t frame = 0; frame < 100; ++frame) {
            const auto balls = places(rack, frame);
            CHECK(balls == places(rack, frame));
            CHECK(least_distance(balls) > diameter);
            const Vec2 corner = *std::ranges::max_element(balls, {}, &Vec2::y);
            second_balls.insert({corner.x, corner.y});
        }
        CHECK(second_balls.size() == 100);
    }
}

TEST_CASE("later frames turn the rack by at most half a degree, and keep what the rules place") {
    const RackPlan rack = plan("rack nine");
    double most = 0.0;
    for (std::uint32_t frame = 0; frame < 200; ++frame) {
        const auto balls = places(rack, frame);
        CHECK(length(balls[0]) < gap);  // the 1 at the apex, the 9 in the middle
        const double middle = 2.0 * std::sqrt(0.75) * diameter;
        CHECK(distance(balls[8], Vec2{middle, 0.0}) < 0.02 * diameter);
        most = std::max(most, std::abs(balls[8].y));
    }
    const double half_a_degree = 0.5 * 3.14159265358979 / 180.0;
    CHECK(most < 2.0 * std::sqrt(0.75) * diameter * half_a_degree * 1.02);
    CHECK(most > 0.5 * 2.0 * std::sqrt(0.75) * diameter * half_a_degree);
}

TEST_CASE("without a gap every rack is perfect, and without a seed all are alike") {
    const RackPlan perfect = plan("rack nine", 0.0);
    for (std::uint32_t frame = 0; frame < 20; ++frame) {
        CHECK(std::abs(least_distance(places(perfect, frame)) - diameter) < 1e-15);
        CHECK(places(perfect, frame)[8].y == 0.0);
    }
    RackPlan plain = plan("rack eight");
    plain.seed.reset();
    CHECK(places(plain, 0) == places(plain, 7));
}

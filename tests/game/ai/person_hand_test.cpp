#include "game/ai/person_hand.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace carom;

namespace {

const command::Strike straight{BallId{}, {2.0, 0.0}, 0.0, 0.2};

double degrees_off(const command::Strike& strike) {
    return std::atan2(strike.velocity.y, strike.velocity.x) * 180.0 / 3.14159265358979;
}

}  // namespace

TEST_CASE("a hand errs by its level, and never gets more from the cue than it gives") {
    double before = 100.0;
    for (int level = least_hand; level <= most_hand; ++level) {
        double sum = 0.0;
        for (std::uint64_t shot = 0; shot < 200; ++shot) {
            const auto strike = struck(straight, {2.0, 0.0}, level, 2.1, 7, shot);
            sum += degrees_off(strike) * degrees_off(strike);
            CHECK(length(strike.velocity) < 2.1 + 1e-12);
            CHECK(strike.side == 0.0);
        }
        const double error = std::sqrt(sum / 200.0);
        CHECK(error < 0.7 * before);
        before = error;
    }
    CHECK(before < 0.04);
}

TEST_CASE("a stroke off the line misses to its side, more for a worse hand") {
    for (const double side : {-1.0, 1.0}) {
        double before = 100.0;
        for (int level = least_hand; level <= most_hand; ++level) {
            double mean = 0.0;
            for (std::uint64_t shot = 0; shot < 200; ++shot)
                mean += degrees_off(struck(straight, {2.0, side}, level, 9.0, 7, shot)) / 200.0;
            CHECK(std::abs(mean - side * most_miss(level)) < 0.15);
            CHECK(most_miss(level) < before);
            before = most_miss(level);
        }
    }
}

TEST_CASE("the error belongs to the seed and the shot: the same stroke gives the same shot") {
    const auto once = struck(straight, {3.0, 0.1}, 2, 9.0, 7, 5);
    const auto again = struck(straight, {3.0, 0.1}, 2, 9.0, 7, 5);
    CHECK(once.velocity == again.velocity);
    CHECK(once.follow == again.follow);
    CHECK_FALSE(once.velocity == struck(straight, {3.0, 0.1}, 2, 9.0, 7, 6).velocity);
    CHECK_FALSE(once.velocity == struck(straight, {3.0, 0.1}, 2, 9.0, 8, 5).velocity);
}

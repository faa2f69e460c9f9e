#include "game/ai/shot_noise.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "physics/world/random.h"

namespace carom {
namespace {

/// Approximately normal, mean 0, standard deviation 1: the sum of 12 uniform numbers, minus 6.
double deviate(std::uint64_t seed, std::uint64_t who, std::uint64_t index) {
    double sum = -6.0;
    for (std::uint64_t i = 0; i < 12; ++i)
        sum += random_unit(seed, RandomStream::player, who, 12 * index + i);
    return sum;
}

}  // namespace

ShotNoise operator*(const ShotNoise& error, double factor) {
    return {error.bearing * factor, error.speed * factor, error.tip * factor};
}

command::Strike with_noise(const command::Strike& strike, const ShotNoise& error, double most,
                           std::uint64_t seed, std::uint64_t index) {
    constexpr double least = 0.02;  // of the intended speed
    const double speed = length(strike.velocity);
    if (!(speed > 0.0)) return strike;
    const double off = error.speed * deviate(seed, 1, index);
    const double struck = std::clamp(speed + off, least * speed, std::max(speed, most));
    const SinCos turn = sin_cos_degrees(error.bearing * deviate(seed, 0, index));
    const Vec2 way = strike.velocity / speed;
    command::Strike result = strike;
    result.velocity =
        Vec2{way.x * turn.cos - way.y * turn.sin, way.x * turn.sin + way.y * turn.cos} * struck;
    if (strike.side != 0.0) result.side += error.tip * deviate(seed, 2, index);
    if (strike.follow != 0.0) result.follow += error.tip * deviate(seed, 3, index);
    const double out = std::sqrt(result.side * result.side + result.follow * result.follow);
    if (out > command::Strike::most_offset) {
        // Slightly inside the limit, so that rounding does not make the tip slip.
        const double factor = command::Strike::most_offset * (1.0 - 1e-12) / out;
        result.side *= factor;
        result.follow *= factor;
    }
    return result;
}

}  // namespace carom

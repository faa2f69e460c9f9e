#include "game/ai/person_hand.h"

#include <algorithm>

#include "game/ai/planner.h"
#include "game/ai/shot_noise.h"
#include "geometry/elementary.h"

namespace carom {
namespace {

// The stroke adds errors of its own, so the hand has half of those of a player who aims alike.
constexpr double share = 0.5;
/// Keeps the draws of the person apart from those of the AI player.
constexpr std::uint64_t person = 0x706c61796572u;
/// Keeps the draws of a cue that scatters apart from both.
constexpr std::uint64_t cue = 0x637565u;
/// The share of the speed that a stroke off the line loses.
constexpr double slip = 0.08;

}  // namespace

double most_miss(int level) {
    return 0.4 + 1.2 * shot_noise(level).bearing;
}

command::Strike struck(const command::Strike& intended, const Stroke& stroke, int level,
                       double most, std::uint64_t seed, std::uint64_t shot) {
    const double planned = length(intended.velocity);
    if (!(planned > 0.0)) return intended;
    const double miss = std::clamp(stroke.miss, -1.0, 1.0);
    const double speed = std::min(stroke.speed * (1.0 - slip * miss * miss), most);
    const SinCos turn = sin_cos_degrees(miss * most_miss(level));
    const Vec2 way = intended.velocity / planned;
    command::Strike strike = intended;
    strike.velocity =
        Vec2{way.x * turn.cos - way.y * turn.sin, way.x * turn.sin + way.y * turn.cos} * speed;
    return with_noise(strike, shot_noise(level) * share, most, seed ^ person, shot);
}

command::Strike scattered(const command::Strike& intended, double scatter, double most,
                          std::uint64_t seed, std::uint64_t shot) {
    const ShotNoise error{.bearing = scatter, .speed = 0.0, .tip = 0.0};
    return with_noise(intended, error, most, seed ^ cue, shot);
}

}  // namespace carom

#include "game/ai/pool_value.h"

#include <algorithm>
#include <cmath>

#include "game/referees/referee.h"
#include "geometry/elementary.h"

namespace carom {
namespace {

constexpr double value_of_hand = 0.75;  ///< with ball in hand
constexpr double value_of_choosing = 0.5;
constexpr double value_of_ball = 0.06;
constexpr double value_of_break = 0.1;

// Where each player has a pocket: of a ball in its mouth, and the distance from there at which half
// of that is left, in widths of the cloth.
constexpr double value_of_near_ball = 0.04;
constexpr double near = 0.2;

// What it is worth to the player whose turn it is that balls lie near the own pocket rather than
// near the opponent's. 0 where all pockets serve both.
double nearness(const Scene& scene, const World& world, const PoolPlay& play, const Box& cloth) {
    const PoolState& rules = play.rules;
    const auto own = rules.referee->pocket_of(rules, rules.player);
    const auto other = rules.referee->pocket_of(rules, 1 - rules.player);
    if (!own || !other) return 0.0;
    const double reach = near * std::min(size(cloth).x, size(cloth).y);
    const auto worth = [&](Vec2 place, int pocket) {
        return value_of_near_ball /
               (1.0 + length_squared(place - mouth(scene, cloth, pocket)) / (reach * reach));
    };
    double sum = 0.0;
    for (std::size_t ball = 1; ball < play.balls.size(); ++ball) {
        if (!play.balls[ball]) continue;
        const Vec2 place = world.balls().position[*index_of(world, *play.balls[ball])];
        sum += worth(place, *own) - worth(place, *other);
    }
    return sum;
}

}  // namespace

double pot_chance(const PotLine& line, double bearing_error) {
    const double spread = bearing_error * pi / 180.0;
    const double x = line.tolerance / (1.2 * spread);
    return x / std::sqrt(1.0 + x * x);
}

std::vector<BallId> legal_balls(const PoolPlay& play) {
    std::vector<BallId> balls;
    for (std::size_t ball = 1; ball < play.balls.size(); ++ball)
        if (play.balls[ball] && may_hit_first(play.rules, static_cast<int>(ball)))
            balls.push_back(*play.balls[ball]);
    return balls;
}

std::vector<PotLine> useful_lines(const Scene& scene, const World& world, const PoolPlay& play,
                                  const Box& cloth, Vec2 from, std::span<const BallId> balls) {
    auto lines = pot_lines(scene, world, cloth, *play.balls[cue_ball], from, balls);
    std::erase_if(lines, [&](const PotLine& line) {
        return !play.rules.referee->may_pocket(play.rules, line.pocket);
    });
    return lines;
}

Outlook outlook(const Scene& scene, const World& world, const PoolPlay& play, const Box& cloth,
                double bearing_error) {
    const PoolState& rules = play.rules;
    if (rules.winner) return {*rules.winner == rules.player ? 1.0 : -1.0, std::nullopt, 0.0};
    const double ahead =
        value_of_ball * rules.referee->lead(rules) + nearness(scene, world, play, cloth);
    if (rules.phase == PoolPhase::breaking) {
        const double value = rules.referee->breaks_hard() ? value_of_break : -value_of_break;
        return {std::clamp(value + ahead, -0.95, 0.95), std::nullopt, 0.0};
    }
    const auto cue = play.balls[cue_ball];
    if (!cue || rules.in_hand != CueInHand::no)
        return {std::min(0.95, value_of_hand + ahead), std::nullopt, 0.0};
    const std::vector<BallId> balls = legal_balls(play);
    const Vec2 from = world.balls().position[*index_of(world, *cue)];
    const auto lines = useful_lines(scene, world, play, cloth, from, balls);
    Outlook result;
    if (!lines.empty()) {
        result.chance = pot_chance(lines.front(), bearing_error);
        result.easiest = number_of(play, lines.front().object);
        // A second ball to play next makes the first one worth more.
        double second = 0.0;
        for (const PotLine& line : lines)
            if (line.object != lines.front().object)
                second = std::max(second, pot_chance(line, bearing_error));
        result.value = result.chance * (0.6 + 0.3 * second);
    }
    // If the rules offer a choice, the player may also pass the shot to the opponent.
    if (rules.phase == PoolPhase::choosing)
        result.value = rules.choices.front() == PoolChoice::take_table && rules.choices.size() == 2
                           ? std::abs(result.value)
                           : value_of_choosing;
    result.value = std::clamp(result.value + ahead, -0.95, 0.95);
    return result;
}

double value_to(int player, const Scene& scene, const World& world, const PoolPlay& play,
                const Box& cloth, double bearing_error) {
    const double value = outlook(scene, world, play, cloth, bearing_error).value;
    return play.rules.player == player ? value : -value;
}

}  // namespace carom

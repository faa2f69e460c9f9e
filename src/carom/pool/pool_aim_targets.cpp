#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <tuple>

#include "carom/pool/pool_aim.h"
#include "carom/pool/pool_status.h"
#include "game/ai/pool_shots.h"
#include "game/ai/pool_value.h"
#include "game/commands/aiming.h"
#include "game/referees/referee.h"
#include "geometry/elementary.h"

/// What the cue points at before the player aims, and the balls and pots that keys aim at in turn.
namespace carom {
namespace {

// The opening of straight pool and snooker: this far beside the corner ball of the rack, in radii,
// the cue ball comes back to the head cushion.
constexpr double opening_offset = 1.6;

Vec2 place_at(const World& world, BallId ball) {
    return world.balls().position[*index_of(world, ball)];
}

double bearing_to(Vec2 way) {
    return std::atan2(way.y, way.x) * 180.0 / pi;
}

// What a cue ball that is aimed full at a ball meets first. Better is smaller.
enum class Sight : std::uint8_t { itself, another_target, hidden };

Sight sight(const World& world, BallId cue, BallId at, std::span<const BallId> targets) {
    const auto line = aim_line(world, cue, place_at(world, at) - place_at(world, cue));
    if (!line || !line->object) return Sight::hidden;
    if (*line->object == at) return Sight::itself;
    return std::ranges::count(targets, *line->object) > 0 ? Sight::another_target : Sight::hidden;
}

bool is_cue_ball(const Scene& scene, BallId ball) {
    return std::ranges::any_of(scene.pool.cues, [&](const Cue& cue) {
        return cue.ball == ball || std::ranges::count(cue.balls, ball) > 0;
    });
}

std::string name_of(const Session& session, BallId ball) {
    const PoolPlay* const game = pool_of(session);
    const auto number = game ? number_of(*game, ball) : std::nullopt;
    return number ? game->rules.referee->ball_name(*number) : "the ball";
}

// Which ball a cue ball meets that is aimed full at one behind it: ", behind the 3". Empty: none,
// or one of the same name.
std::string in_the_way(const Session& session, BallId cue, BallId ball) {
    const World& world = session.world();
    const auto line = aim_line(world, cue, place_at(world, ball) - place_at(world, cue));
    if (!line || !line->object) return ", which lies hidden";
    const std::string met = name_of(session, *line->object);
    return met == name_of(session, ball) ? "" : ", behind " + met;
}

}  // namespace

std::vector<BallId> PoolAim::targets(const Session& session) const {
    std::vector<BallId> balls;
    const PoolPlay* game = pool_of(session);
    const auto cue = cue_ball(session);
    for (const BallId id : session.world().balls().id) {
        if (id == cue) continue;
        const auto number = game ? number_of(*game, id) : std::nullopt;
        if (game && (!number || !may_hit_first(game->rules, *number))) continue;
        balls.push_back(id);
    }
    return balls;
}

void PoolAim::aim_first(const Session& session) {
    if (is_safe_opening(session))
        aim_at_corner(session);
    else
        aim_at_nearest(session);
}

// Thin at the ball of the rack that lies farthest to the right.
void PoolAim::aim_at_corner(const Session& session) {
    const auto cue = cue_ball(session);
    if (!cue || session.scene().pool.racks.empty()) return;
    const World& world = session.world();
    const Vec2 from = place_at(world, *cue);
    const Vec2 right = -perpendicular(session.scene().pool.racks[0].toward);
    std::optional<double> most;
    for (const BallId ball : targets(session)) {
        const Vec2 there = place_at(world, ball) - from;
        if (most && dot(there, right) <= *most) continue;
        most = dot(there, right);
        const double radius = world.balls().radius[*index_of(world, ball)];
        setup_.bearing = bearing_to(there + right * (opening_offset * radius));
    }
}

// Aims full at the nearest ball that may legally be hit first. A ball that lies hidden, so that a
// wrong one would be met, comes last: at the break-off of snooker, the red behind the pink. Another
// player's cue ball comes after the others: it lies beside one's own when caroms begin.
void PoolAim::aim_at_nearest(const Session& session) {
    const auto cue = cue_ball(session);
    if (!cue) return;
    const Vec2 from = place_at(session.world(), *cue);
    const std::vector<BallId> balls = targets(session);
    std::optional<std::tuple<bool, bool, double>> best;
    for (const BallId ball : balls) {
        const Vec2 there = place_at(session.world(), ball) - from;
        const std::tuple rank(sight(session.world(), *cue, ball, balls) == Sight::hidden,
                              is_cue_ball(session.scene(), ball), length(there));
        if (best && !(rank < *best)) continue;
        best = rank;
        setup_.bearing = bearing_to(there);
    }
}

std::string PoolAim::next_target(const Session& session, bool backwards) {
    const auto cue = cue_ball(session);
    const std::vector<BallId> any = targets(session);
    if (!cue || any.empty()) return "There is no ball to aim at.";
    const auto sight_of = [&](BallId ball) { return sight(session.world(), *cue, ball, any); };
    std::vector<BallId> balls = any;
    std::ranges::stable_sort(balls, {}, sight_of);
    pot_ = pot_text_.empty() ? (backwards ? balls.size() - 1 : 0)
                             : (pot_ + (backwards ? balls.size() - 1 : 1)) % balls.size();
    const BallId ball = balls[pot_ % balls.size()];
    setup_.bearing = bearing_to(place_at(session.world(), ball) - place_at(session.world(), *cue));
    has_aimed_ = true;
    return pot_text_ = "Full at " + name_of(session, ball) + in_the_way(session, *cue, ball);
}

std::string PoolAim::next_pot(const Session& session, bool backwards) {
    if (is_match_ || session.scene().pool.pockets.empty()) return next_target(session, backwards);
    const auto cloth = cloth_box(session.scene());
    const auto cue = cue_ball(session);
    if (!cloth || !cue) return "There are no pockets here.";
    const World& world = session.world();
    const PoolPlay* const game = pool_of(session);
    const auto lines = game ? useful_lines(session.scene(), world, *game, *cloth,
                                           place_at(world, *cue), targets(session))
                            : pot_lines(session.scene(), world, *cloth, *cue, place_at(world, *cue),
                                        targets(session));
    if (lines.empty()) return "No ball lies free to a pocket.";
    if (pot_text_.empty())
        pot_ = backwards ? lines.size() - 1 : 0;
    else
        pot_ = (pot_ + (backwards ? lines.size() - 1 : 1)) % lines.size();
    const PotLine& line = lines[pot_ % lines.size()];
    setup_.bearing = bearing_to(line.direction);
    has_aimed_ = true;
    setup_.side = setup_.follow = 0.0;
    if (game && may_call(game->rules, PoolCall::Kind::pot) && game->rules.referee->calls_pocket()) {
        setup_.intent = Intent::pocket;
        setup_.pocket = line.pocket;
    }
    const auto number = game ? number_of(*game, line.object) : std::nullopt;
    constexpr std::string_view ways[] = {"", ", by a cushion", ", kicked by a cushion"};
    pot_text_ = fmt::format("{} of {}: {} into the {}{}", pot_ % lines.size() + 1, lines.size(),
                            number ? game->rules.referee->ball_name(*number) : "the ball",
                            pocket_name(session.scene(), line.pocket),
                            ways[static_cast<std::size_t>(line.way)]);
    return pot_text_;
}

}  // namespace carom

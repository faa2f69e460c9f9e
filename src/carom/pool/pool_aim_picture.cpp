#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "carom/pool/pool_aim.h"
#include "carom/pool/pool_status.h"
#include "carom/pool/power_bar.h"
#include "carom/pool/shot_picture.h"
#include "game/ai/pool_shots.h"
#include "game/commands/aiming.h"
#include "game/pool/table_places.h"
#include "game/referees/referee.h"
#include "geometry/elementary.h"
#include "geometry/impact.h"

/// Draws the aim.
namespace carom {
namespace {

std::string tip_text(double side, double follow) {
    std::string text;
    if (follow != 0.0)
        text += fmt::format(" {} {:.2f}", follow > 0.0 ? "follow" : "draw", std::abs(follow));
    if (side != 0.0)
        text += fmt::format(" {} {:.2f}", side > 0.0 ? "right" : "left", std::abs(side));
    return "tip" + (text.empty() ? " centre" : text);
}

std::string cut_text(const AimLine& line, const Look& look) {
    if (!line.object) return "";
    const double degrees = std::acos(std::clamp(line.cut_cosine, -1.0, 1.0)) * 180.0 / pi;
    if (degrees < 0.05) return "full hit";
    const bool is_left = cross(line.to - line.from, line.object_way) > 0.0;
    return fmt::format("cut {:.1f}{} {}", degrees, look.utf8 ? "°" : " deg",
                       is_left ? "left" : "right");
}

// The name of a ball that it is a foul to hit first; none: it may be hit.
std::optional<std::string> wrong_ball(const Session& session, BallId ball) {
    const PoolPlay* const game = pool_of(session);
    const auto number = game ? number_of(*game, ball) : std::nullopt;
    if (!number || may_hit_first(game->rules, *number)) return std::nullopt;
    return game->rules.referee->ball_name(*number);
}

std::optional<Impact> first_edge(const World& world, const Disc& ball, Vec2 way, double most) {
    std::optional<Impact> first;
    for (const Capsule& edge : world.capsules().shape)
        if (const auto impact = first_impact(ball, way, edge, first ? first->time : most))
            first = impact;
    return first;
}

// A ball that lies at a cushion and is sent into it runs along it.
Vec2 along_cushion(const World& world, const Disc& ball, Vec2 way) {
    const auto impact = first_edge(world, ball, way, 0.25 * ball.radius);
    if (!impact) return way;
    return way - impact->normal * (1.000001 * dot(way, impact->normal));
}

// How far a ball gets before it meets another one, at most `most`. The two balls of the aim are
// left out.
double free_way(const World& world, const Disc& ball, Vec2 way, double most,
                const std::array<BallId, 2>& aimed) {
    double reach = most;
    const Balls& balls = world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (std::ranges::count(aimed, balls.id[i]) > 0) continue;
        const Disc other{balls.position[i], balls.radius[i]};
        if (const auto impact = first_impact(ball, way, other, reach)) reach = impact->time;
    }
    return reach;
}

// The end of the straight path of a ball: at the first edge, or where it falls into a pocket.
Vec2 end_of_way(const World& world, const Disc& ball, Vec2 way, double most) {
    const auto impact = first_edge(world, ball, way, most);
    double reach = impact ? impact->time : most;
    for (const Zone& zone : world.zones())
        if (zone.effect == Zone::Effect::sink)
            if (const auto fall = first_impact(Disc{ball.center, 0.0}, way, zone.shape, reach))
                reach = fall->time;
    return ball.center + way * reach;
}

}  // namespace

std::vector<PoolAnnotations::Number> numbers_of(const Session& session) {
    std::vector<PoolAnnotations::Number> numbers;
    if (const auto* play = pool_of(session)) {
        const std::size_t count = play->rules.referee->has_numbers() ? play->balls.size() : 1;
        for (std::size_t ball = 0; ball < count; ++ball)
            if (const auto id = play->balls[ball]) numbers.push_back({*id, static_cast<int>(ball)});
        return numbers;
    }
    const PoolTable& pool = session.scene().pool;
    const auto* const shots = std::get_if<ShotsState>(&session.game());
    const auto add = [&](BallId ball, int number) {
        const auto now = shots ? shots->balls[*index_of(session.scene().world, ball)] : ball;
        if (now) numbers.push_back({*now, number});
    };
    if (pool.cues.size() == 1) add(pool.cue->ball, 0);
    for (const Rack& rack : pool.racks)
        for (std::size_t i = 0; i < rack.balls.size(); ++i)
            add(rack.balls[i], static_cast<int>(i) + 1);
    return numbers;
}

std::vector<PoolAnnotations::Returned> returned_of(const Session& session) {
    const Scene& scene = session.scene();
    std::vector<PoolAnnotations::Returned> returned;
    const auto add = [&](std::optional<BallId> now, BallId before) {
        if (now && *now != before) returned.push_back({*now, before});
    };
    if (const PoolPlay* const pool = pool_of(session))
        for (int ball = 0; ball <= object_balls(scene); ++ball)
            add(pool->balls[static_cast<std::size_t>(ball)], first_ball(scene, ball));
    if (const ShotsState* const shots = shots_of(session))
        for (std::size_t ball = 0; ball < shots->balls.size(); ++ball)
            add(shots->balls[ball], scene.world.balls().id[ball]);
    return returned;
}

// The pocket that is called, or the only one that serves the player.
std::optional<int> PoolAim::marked_pocket(const Session& session) const {
    const PoolPlay* const game = pool_of(session);
    if (game && !game->rules.referee->calls_pocket()) return std::nullopt;
    const PoolCall called = call(session);
    if (setup_.intent == Intent::pocket && called.kind != PoolCall::Kind::pot) return setup_.pocket;
    if (called.kind == PoolCall::Kind::pot) {
        if (shown_aids() == Aids::none && setup_.intent != Intent::pocket) return std::nullopt;
        return called.pocket;
    }
    std::optional<int> only;
    const auto pockets = static_cast<int>(session.scene().pool.pockets.size());
    for (int pocket = 0; game && pocket < pockets; ++pocket) {
        if (!game->rules.referee->may_pocket(game->rules, pocket)) continue;
        if (only) return std::nullopt;
        only = pocket;
    }
    return only;
}

PoolAnnotations::Line PoolAim::stick(const Session& session) const {
    const World& world = session.world();
    const auto ball = *index_of(world, *cue_ball(session));
    return stick_behind({world.balls().position[ball], world.balls().radius[ball]},
                        strike(session).velocity);
}

PoolAnnotations PoolAim::annotations(const Session& session, bool aims) const {
    PoolAnnotations annotations;
    annotations.numbers = numbers_of(session);
    annotations.returned = returned_of(session);
    if (!aims || !may_aim(session) || !is_seen_) return annotations;
    const World& world = session.world();
    const BallId cue = *cue_ball(session);
    const double radius = world.balls().radius[*index_of(world, cue)];
    const command::Strike strike = this->strike(session);
    annotations.stick = stick(session);
    if (const auto pocket = marked_pocket(session)) {
        const std::uint32_t zone = session.scene().pool.pockets[static_cast<std::size_t>(*pocket)];
        annotations.called = session.scene().world.zones()[zone].shape.start;
    }
    if (shown_aids() == Aids::none) return annotations;
    if (const auto line = aim_line(world, cue, strike.velocity)) {
        const auto on_table = [&](Vec2 from, Vec2 way, double most) {
            const double reach =
                free_way(world, {from, radius}, way, most, {cue, line->object.value_or(cue)});
            return PoolAnnotations::Line{from, end_of_way(world, {from, radius}, way, reach)};
        };
        const Vec2 way = strike.velocity / length(strike.velocity);
        annotations.aim = line->object ? PoolAnnotations::Line{line->from, line->to}
                                       : on_table(line->from, way, length(line->to - line->from));
        if (line->object && !is_break(session)) {
            // A fuller hit gives the object ball more of the speed.
            const double reach = 14.0 * radius;
            const Vec2 object = world.balls().position[*index_of(world, *line->object)];
            annotations.ghost = Disc{line->to, radius};
            if (shows_object_line(session))
                annotations.object =
                    on_table(object, along_cushion(world, {object, radius}, line->object_way),
                             reach * line->cut_cosine);
            if (!is_match_ && setup_.aids == Aids::ghost) {
                const double rest = 1.0 - line->cut_cosine * line->cut_cosine;
                annotations.tangent =
                    on_table(line->to, line->tangent, reach * std::sqrt(std::max(0.0, rest)));
            }
        }
    }
    if (!is_match_ && setup_.aids == Aids::full && forecast_ && !is_break(session))
        for (const Forecast::Track& track : forecast_->tracks)
            annotations.tracks.push_back({track.ball, track.way, track.zone.has_value()});
    annotations.spots = cloud_;
    return annotations;
}

// The most important first: see HudInfo::game.
std::string PoolAim::line(const Session& session, const Look& look) const {
    if (!may_aim(session)) return "";
    const command::Strike strike = this->strike(session);
    const double speed = length(strike.velocity);
    std::string text = fmt::format("{} {:.2f} m/s",
                                   power_bar(speed / cue_in_turn(session).most_power, look), speed);
    const std::string called = call_text(session.scene(), call(session));
    const bool tells = shown_aids() != Aids::none || setup_.intent != Intent::automatic;
    if (!called.empty() && tells) text += "  calls: " + called;
    text += "  " + tip_text(setup_.side, setup_.follow);
    const auto line = aim_line(session.world(), strike.ball, strike.velocity);
    if (!line || !line->object || shown_aids() == Aids::none) return text;
    text += "  " + cut_text(*line, look);
    if (const auto wrong = wrong_ball(session, *line->object)) text += " on " + *wrong;
    return text;
}

}  // namespace carom

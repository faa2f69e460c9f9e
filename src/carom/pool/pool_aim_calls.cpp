#include <algorithm>

#include "carom/pool/pool_aim.h"
#include "carom/pool/pool_status.h"
#include "game/ai/pool_shots.h"
#include "game/commands/aiming.h"
#include "game/referees/referee.h"

/// The call of the next shot, and which ball it strikes.
namespace carom {
namespace {

// The pocket whose mouth lies nearest to the straight path of the object ball, by its angle. So
// the call says where the shot points, and not whether it succeeds.
std::optional<int> nearest_pocket(const Session& session, Vec2 object, Vec2 way) {
    const auto cloth = cloth_box(session.scene());
    if (!cloth) return std::nullopt;
    std::optional<int> nearest;
    double best = 0.0;
    for (int pocket = 0; pocket < static_cast<int>(session.scene().pool.pockets.size()); ++pocket) {
        const Vec2 there = mouth(session.scene(), *cloth, pocket) - object;
        const double cosine = dot(there, way) / std::max(length(there), 1e-300);
        if (nearest && cosine <= best) continue;
        nearest = pocket;
        best = cosine;
    }
    return nearest;
}

}  // namespace

bool PoolAim::call_pocket(const Session& session, Vec2 place) {
    const PoolPlay* game = pool_of(session);
    if (!game || !may_call(game->rules, PoolCall::Kind::pot) ||
        !game->rules.referee->calls_pocket())
        return false;
    const auto& pockets = session.scene().pool.pockets;
    for (std::size_t i = 0; i < pockets.size(); ++i) {
        const Capsule& shape = session.scene().world.zones()[pockets[i]].shape;
        if (length(place - shape.start) > shape.radius) continue;
        setup_.intent = Intent::pocket;
        setup_.pocket = static_cast<int>(i);
        return true;
    }
    return false;
}

std::string PoolAim::next_call(const Session& session) {
    const PoolPlay* game = pool_of(session);
    if (!game || game->rules.phase != PoolPhase::playing) return "Nothing is called now.";
    if (game->rules.may_push_out) {
        setup_.intent = setup_.intent == Intent::push_out ? Intent::automatic : Intent::push_out;
        return setup_.intent == Intent::push_out ? "push-out" : "no push-out";
    }
    if (const auto why = game->rules.referee->why_no_call(game->rules, PoolCall::Kind::safety);
        !why.empty())
        return std::string(why);
    setup_.intent = setup_.intent == Intent::safety ? Intent::automatic : Intent::safety;
    return setup_.intent == Intent::safety
               ? "safety: the turn passes"
               : "calls what the aim pockets; click a pocket for another";
}

// The pocket that the player called, or the legal ball and pocket that the forecast shows.
PoolCall PoolAim::call(const Session& session) const {
    const PoolPlay* game = pool_of(session);
    if (!game || game->rules.phase != PoolPhase::playing) return {};
    const PoolState& rules = game->rules;
    if (rules.may_push_out && setup_.intent == Intent::push_out)
        return {PoolCall::Kind::push_out, 0, 0};
    if (!may_call(rules, PoolCall::Kind::pot)) return {};
    if (setup_.intent == Intent::safety) return {PoolCall::Kind::safety, 0, 0};
    if (!rules.referee->calls_pocket()) {
        // The ball that the aim meets is the one that is named.
        const auto line = aim_line(session.world(), *cue_ball(session), strike(session).velocity);
        const auto met = line && line->object ? number_of(*game, *line->object) : std::nullopt;
        if (!met || !may_hit_first(rules, *met)) return {};
        return {PoolCall::Kind::pot, *met, 0};
    }
    const auto* ahead = forecast_ ? std::get_if<PoolPlay>(&forecast_->game) : nullptr;
    if (ahead && !is_match_)
        for (const PoolShot::Pocketed& pocketed : ahead->shot.pocketed)
            if (pocketed.ball != 0 && may_hit_first(rules, pocketed.ball) &&
                (setup_.intent == Intent::automatic || pocketed.pocket == setup_.pocket))
                return {PoolCall::Kind::pot, pocketed.ball, pocketed.pocket};
    if (setup_.intent != Intent::pocket && !is_match_) return {};
    const auto line = aim_line(session.world(), *cue_ball(session), strike(session).velocity);
    const auto met = line && line->object ? number_of(*game, *line->object) : std::nullopt;
    if (!met || !may_hit_first(rules, *met)) return {};
    if (setup_.intent == Intent::pocket) return {PoolCall::Kind::pot, *met, setup_.pocket};
    const Vec2 object = session.world().balls().position[*index_of(session.world(), *line->object)];
    const auto pocket = nearest_pocket(session, object, line->object_way);
    if (!pocket) return {};
    return {PoolCall::Kind::pot, *met, *pocket};
}

std::vector<Command> PoolAim::shot(const Session& session) {
    look(session);
    std::vector<Command> commands;
    const PoolCall what = call(session);
    const PoolPlay* game = pool_of(session);
    if (game && game->rules.phase == PoolPhase::playing && !(what == game->call))
        commands.push_back(command::CallShot{what});
    commands.push_back(strike(session));
    played_ = Played{places_of_balls(session), setup_};
    return commands;
}

bool PoolAim::may_choose(const Session& session) const {
    const ShotsState* shots = shots_of(session);
    return shots && may_aim(session) && cue_balls_of(session.scene(), *shots).size() > 1;
}

bool PoolAim::choose(const Session& session, BallId ball) {
    if (!may_choose(session)) return false;
    const std::vector<BallId> balls = cue_balls_of(session.scene(), *shots_of(session));
    if (std::ranges::count(balls, ball) == 0) return false;
    chosen_ = ball;
    is_seen_ = false;
    return true;
}

void PoolAim::choose_next(const Session& session, bool backwards) {
    const std::vector<BallId> balls = cue_balls_of(session.scene(), *shots_of(session));
    const auto now = std::ranges::find(balls, cue_ball(session).value_or(balls.front()));
    const auto index = static_cast<std::size_t>(now - balls.begin());
    choose(session, balls[(index + (backwards ? balls.size() - 1 : 1)) % balls.size()]);
}

}  // namespace carom

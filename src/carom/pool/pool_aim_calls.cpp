#include <algorithm>

#include "carom/pool/pool_aim.h"
#include "game/commands/aiming.h"
#include "game/referees/referee.h"

/// The call of the next shot.
namespace carom {

bool PoolAim::call_pocket(const Session& session, Vec2 place) {
    const PoolPlay* game = play(session);
    if (!game || !may_call_shots(game->rules)) return false;
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
    const PoolPlay* game = play(session);
    if (!game || game->rules.phase != PoolPhase::playing) return "nothing is called now";
    if (game->rules.may_push_out) {
        setup_.intent = setup_.intent == Intent::push_out ? Intent::automatic : Intent::push_out;
        return setup_.intent == Intent::push_out ? "push-out" : "no push-out";
    }
    if (const auto why = game->rules.referee->why_no_call(game->rules); !why.empty())
        return std::string(why);
    setup_.intent = setup_.intent == Intent::safety ? Intent::automatic : Intent::safety;
    return setup_.intent == Intent::safety
               ? "safety: the turn passes"
               : "calls what the aim pockets; click a pocket for another";
}

// The pocket that the player called, or the legal ball and pocket that the forecast shows.
PoolCall PoolAim::call(const Session& session) const {
    const PoolPlay* game = play(session);
    if (!game || game->rules.phase != PoolPhase::playing) return {};
    const PoolState& rules = game->rules;
    if (rules.may_push_out && setup_.intent == Intent::push_out)
        return {PoolCall::Kind::push_out, 0, 0};
    if (!may_call_shots(rules)) return {};
    if (setup_.intent == Intent::safety) return {PoolCall::Kind::safety, 0, 0};
    const auto* ahead = forecast_ ? std::get_if<PoolPlay>(&forecast_->game) : nullptr;
    if (ahead)
        for (const PoolShot::Pocketed& pocketed : ahead->shot.pocketed)
            if (pocketed.ball != 0 && may_hit_first(rules, pocketed.ball) &&
                (setup_.intent == Intent::automatic || pocketed.pocket == setup_.pocket))
                return {PoolCall::Kind::pot, pocketed.ball, pocketed.pocket};
    if (setup_.intent != Intent::pocket) return {};
    const auto line = aim_line(session.world(), *cue_ball(session), strike(session).velocity);
    const auto met = line && line->object ? number_of(*game, *line->object) : std::nullopt;
    if (!met || !may_hit_first(rules, *met)) return {};
    return {PoolCall::Kind::pot, *met, setup_.pocket};
}

std::vector<Command> PoolAim::shot(const Session& session) {
    look(session);
    std::vector<Command> commands;
    const PoolCall what = call(session);
    const PoolPlay* game = play(session);
    if (game && game->rules.phase == PoolPhase::playing && !(what == game->call))
        commands.push_back(command::CallShot{what});
    commands.push_back(strike(session));
    return commands;
}

}  // namespace carom

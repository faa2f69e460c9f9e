#include "carom/controllers/pool_controller.h"

#include <utility>

namespace carom {
namespace {

/// For each notch of the wheel, m/s.
constexpr double speed_step = 0.1;

}  // namespace

bool PoolController::is_aiming(const PlayContext& play) const {
    return is_striking(play) && !stroke_.meter();
}

bool PoolController::aims_with_keys(const PlayContext& play) const {
    return is_aiming(play) && keeps_cue(play);
}

void PoolController::perform(PlayContext& play, const Action& action) {
    confirmation_.press(action.name);
    if (action.at_pool && action.at_pool(*this, play)) return;
    using AtPool = void (*)(PoolController&, PlayContext&);
    if (const auto* perform = std::get_if<AtPool>(&action.perform)) return (*perform)(*this, play);
    FreeController::perform(play, action);
}

// The wheel changes the speed; 1, 2 and 3 pick one of the choices that the rules offer. The same
// digit pressed again has no other effect, before another key.
bool PoolController::take(PlayContext& play, const InputEvent& event) {
    using enum InputEvent::Action;
    after_ = event.after;
    if (event.kind == InputEvent::Kind::mouse) {
        if ((event.action != wheel_up && event.action != wheel_down) || !is_aiming(play))
            return false;
        aim_.change_speed(event.action == wheel_up ? speed_step : -speed_step);
        play.needs_draw = true;
        return true;
    }
    if (event.kind == InputEvent::Kind::key && takes_key(play, event)) return true;
    return event.kind == InputEvent::Kind::key && event.action != release &&
           takes_choice(play, event);
}

bool PoolController::takes_choice(PlayContext& play, const InputEvent& event) {
    const PoolPlay* const pool = pool_of(play.session);
    const bool repeats_choice = std::exchange(chosen_by_, std::nullopt) == event.key;
    if (!pool || event.modifiers != no_modifier) return false;
    const std::vector<PoolChoice>& choices = pool->rules.choices;
    const bool may_choose =
        pool->rules.phase == PoolPhase::choosing && !players_.is_opponents_turn(play.session);
    if (may_choose && event.key >= U'1' && event.key < U'1' + choices.size()) {
        const PoolChoice choice = choices[event.key - U'1'];
        obey(play, command::Decide{choice}, std::string(choice_text(pool->rules, choice)));
    } else if (!repeats_choice) {
        return false;
    }
    chosen_by_ = event.key;
    return true;
}

void PoolController::after_ticks(PlayContext& play, double) {
    // In the pause in which the balls of a drill lie to be looked at, nobody is in a hurry.
    if (play.clock.is_hurrying() && (!are_rolling(play) || is_at_rest(play.session.world())))
        play.clock.normal();
    const auto outcome = players_.tell_outcome(play.session);
    // While nothing is aimed, the status line says it.
    if (!outcome || *outcome == line(play)) return;
    say(play, *outcome);
    // It stays, so a player who looked away can still read why the cue ball is in hand.
    if (!players_.is_opponents_turn(play.session)) play.messages.keep_message();
}

bool are_rolling(const PlayContext& play) {
    const PoolPlay* const pool = pool_of(play.session);
    const ShotsState* const shots = shots_of(play.session);
    return pool    ? pool->is_shooting
           : shots ? shots->is_shooting
                   : !is_at_rest(play.session.world());
}

bool keeps_cue(const PlayContext& play) {
    return play.pointer.tool.is_empty() && !play.pointer.shows_cursor;
}

void PoolController::continue_from(PlayContext& play, const Controller& before) {
    if (const auto* const pool = dynamic_cast<const PoolController*>(&before))
        players_.continue_from(play.session, pool->players_);
}

}  // namespace carom

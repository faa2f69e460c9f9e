#include <utility>

#include "carom/controllers/pool_controller.h"

/// How a shot comes about: by a key or with the mouse; in a match by a stroke that may fail.
namespace carom {
namespace {

/// Different for each shot of a session: the draws of a stroke that may fail depend on it.
std::uint64_t shot_number(const Session& session) {
    if (const ShotsState* const shots = shots_of(session))
        return std::uint64_t{shots->games} << 32 | shots->shots;
    const PoolPlay* const pool = pool_of(session);
    return pool ? pool->shots : 0;
}

/// Whether the pointer is on the cue as it is drawn. Pre: aim.may_aim().
bool is_on_stick(const PlayContext& play, const PoolAim& aim) {
    const PoolAnnotations::Line stick = aim.stick(play.session);
    const double long_ = length(stick.to - stick.from);
    const Vec2 back = (stick.to - stick.from) / long_;
    const double along = dot(play.pointer.at - stick.from, back);
    return along >= 0.0 && along <= long_ &&
           distance(stick.from + back * along, play.pointer.at) <= slack(play);
}

// The coach proposes one shot at a time, and sets it up.
void hear_coach(PoolController& table, PlayContext& play) {
    PoolCoach& coach = table.coach();
    if (!coach.is_asked()) return;
    if (!table.is_aiming(play)) return coach.dismiss();
    const CandidateShot* const proposal = coach.think(play.session);
    if (!proposal) return;
    const CandidateShot shot = *proposal;
    const std::string text = coach.text(play.session.scene());
    if (shot.place) {
        const BallId ball = *table.aim().cue_ball(play.session);
        if (const auto why_not = play.session.apply(command::PlaceBall{ball, *shot.place}))
            return complain(play, *why_not);
    }
    table.aim().take(play.session, shot);
    say(play, text);
}

}  // namespace

// In a match the past is only looked at: a shot from there would take back what came after.
bool PoolController::is_striking(const PlayContext& play) const {
    const Session& session = play.session;
    return !play.page.is_open() && !players_.is_opponents_turn(session) && aim_.may_aim(session) &&
           !(players_.is_match(session) && session.world().tick() < session.latest());
}

void PoolController::look(PlayContext& play) {
    aim_.set_match(players_.is_match(play.session));
    aim_.look(play.session);
}

void PoolController::pass(PlayContext& play, double seconds) {
    aim_.set_match(players_.is_match(play.session));
    if (play.terminal.key_repeat) stroke_.remember(*play.terminal.key_repeat);
    if (stroke_.meter()) play.needs_draw = true;
    if (stroke_.meter() && !is_striking(play)) stroke_.end();
    if (!stroke_.pass(seconds)) say(play, "No stroke: too late.");
    if (aim_.work(play.session)) play.needs_draw = true;
    players_.pass(play, seconds);
    confirmation_.pass(seconds);
    hear_coach(*this, play);
}

// While the meter runs, a repeat of the key that started it does not strike.
bool PoolController::takes_key(PlayContext& play, const InputEvent& event) {
    using enum InputEvent::Action;
    if (event.action == release) return false;
    const bool repeats = play.terminal.tells_key_release ? event.action == repeat
                                                         : stroke_.repeats(event.key, event.after);
    if (!play.terminal.tells_key_release && stroke_.key_repeat())
        play.terminal.key_repeat = stroke_.key_repeat();
    return repeats && stroke_.meter();
}

void PoolController::point(PlayContext& play) {
    const bool pulls = play.pointer.tool.has_cue();
    if (!aims_by_mouse_ && !pulls) return;
    play.needs_draw = true;
    if (aims_by_mouse_) aim_.aim_at(play.session, play.pointer.at);
    if (!pulls) return;
    if (!players_.is_match(play.session)) {
        if (pull_) aim_.pull(play.session, pulled(*pull_, play.pointer.at), pull_->room);
        return;
    }
    if (!is_striking(play)) return;
    MouseStroke* const push = stroke_.push();
    const auto stroke =
        push ? push->move(play.pointer.at, stroke_.time(after_)) : std::optional<Stroke>{};
    if (!stroke) return;
    play.pointer.tool.forget();
    shoot(play, stroke);
}

bool PoolController::take_press(PlayContext& play, const InputEvent& event) {
    if (event.button == middle_button) return false;
    const bool has_game = has_turns(play.session);
    const auto cue = aim_.cue_ball(play.session);
    const auto at_pointer = ball_at_pointer(play);
    const bool is_left = event.button == left_button && !(event.modifiers & (shift | control));
    Pointer& pointer = play.pointer;
    if (at_pointer && !has_game && is_left) {
        if (!is_aiming(play)) return false;
        // Lifted over the others, so that a shot can be set up.
        pointer.tool.grab_to_place(play.session.world(), *at_pointer, pointer.at);
        pointer.pressed = event.button;
        return true;
    }
    // Without a game any ball is shot.
    if (at_pointer && !has_game && at_pointer != cue) return false;
    if (is_left && at_pointer && is_aiming(play) && at_pointer != cue &&
        aim_.choose(play.session, *at_pointer)) {
        play.needs_draw = true;
        return true;
    }
    if (is_left && at_pointer && at_pointer == cue && is_aiming(play) &&
        aim_.may_place(play.session)) {
        pointer.tool.grab_to_place(play.session.world(), *cue, pointer.at);
        pointer.pressed = event.button;
        return true;
    }
    if (!is_aiming(play)) {
        if (players_.is_opponents_turn(play.session)) say(play, players_.opponent_text());
        const PoolPlay* const pool = pool_of(play.session);
        const ShotsState* const shots = shots_of(play.session);
        const auto why_not = pool && cue ? refusal_to_shoot(*pool, *cue)
                             : shots     ? refusal_to_shoot(play.session.world(), *shots)
                                         : std::nullopt;
        if (why_not) say(play, *why_not);
        return has_game || !is_left;
    }
    pointer.pressed = event.button;
    pull_.reset();
    const bool takes_cue = !is_left || at_pointer == cue;
    if (!takes_cue && aim_.call_pocket(play.session, pointer.at)) return true;
    if (takes_cue || is_on_stick(play, aim_)) {
        pull_ = grip(play.session, aim_, play.view.camera, pointer.at);
        pointer.cue_is_armed = false;
        pointer.tool.take_cue(*cue, pointer.at);
        if (players_.is_match(play.session))
            stroke_.start_push(push_of(*pull_, play.view.camera, stroke_.time(after_)));
    } else {
        aims_by_mouse_ = true;
        aim_.aim_at(play.session, pointer.at);
    }
    return true;
}

bool PoolController::take_release(PlayContext& play) {
    if (std::exchange(aims_by_mouse_, false)) return true;
    const double length_pulled = pull_ ? pulled(*pull_, play.pointer.at) : 0.0;
    const auto pull = std::exchange(pull_, std::nullopt);
    if (!play.pointer.tool.has_cue()) return stroke_.push() != nullptr;
    if (!pull && !has_turns(play.session)) return false;
    play.pointer.tool.forget();
    if (players_.is_match(play.session)) {
        stroke_.end();
        say(play, "Pull the cue back, then push it through where you took it.");
        return true;
    }
    if (!pull || !is_aiming(play)) return true;
    if (length_pulled > pull->least)
        shoot(play);
    else
        aim_.set_up(play.session, pull->before);
    return true;
}

void PoolController::shoot(PlayContext& play, const std::optional<Stroke>& stroke) {
    stroke_.end();
    const Session& session = play.session;
    stroke_.set_last(has_turns(session) ? stroke : std::nullopt, players_.hand());
    const double most = cue_in_turn(session).most_power;
    const double scatter = cue_in_turn(session).scatter;
    const std::uint64_t seed = session.world().seed();
    for (Command command : aim_.shot(session)) {
        auto* const strike = std::get_if<command::Strike>(&command);
        if (strike && stroke && has_turns(session))
            *strike = struck(*strike, *stroke, players_.hand(), most, seed, shot_number(session));
        if (strike && scatter > 0.0)
            *strike = scattered(*strike, scatter, most, seed, shot_number(session));
        if (const auto why_not = play.session.apply(command)) return complain(play, *why_not);
    }
    set_reference(play);
    if (std::exchange(is_near_, false) && !play.view.is_fitted) play.view.fit();
}

bool PoolController::shoot_with_key(PlayContext& play) {
    if (is_striking(play) && stroke_.meter()) {
        shoot(play, stroke_.meter()->strike(after_));
        return true;
    }
    if (aims_with_keys(play)) {
        const double speed = length(aim_.strike(play.session).velocity);
        if (players_.is_match(play.session))
            stroke_.start_meter(speed, cue_in_turn(play.session).most_power);
        else
            shoot(play);
        return true;
    }
    return false;
}

}  // namespace carom

#include "carom/controllers/pool_controller.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "carom/controllers/editing.h"

namespace carom {
namespace {

// For each press of a key.
constexpr double coarse_turn = 1.0;  // degrees
constexpr double fine_turn = 0.05;
constexpr double speed_step = 0.1;   // m/s
constexpr double tip_step = 0.05;    // in radii
constexpr double cursor_step = 0.2;  // columns, with a ball in hand

}  // namespace

PlayerNames PoolController::names() const {
    if (opponent_.skill() > 0) return {"you", "carom"};
    return {"player 1", "player 2"};
}

bool PoolController::is_aiming(const PlayContext& play) const {
    return is_striking(play) && !stroke_.meter();
}

bool PoolController::aims_with_keys(const PlayContext& play) const {
    return is_aiming(play) && play.pointer.tool.is_empty() && !play.pointer.shows_cursor;
}

void PoolController::perform(PlayContext& play, const Action& action) {
    if (action.at_pool && action.at_pool(*this, play)) return;
    using AtPool = void (*)(PoolController&, PlayContext&);
    if (const auto* perform = std::get_if<AtPool>(&action.perform)) return (*perform)(*this, play);
    FreeController::perform(play, action);
}

// The wheel changes the speed; 1, 2 and 3 pick one of the choices that the rules offer.
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
    const PoolPlay* const pool = pool_of(play.session);
    if (!pool || event.kind != InputEvent::Kind::key || event.action == release ||
        event.modifiers != no_modifier)
        return false;
    const std::vector<PoolChoice>& choices = pool->rules.choices;
    if (pool->rules.phase != PoolPhase::choosing || opponent_.is_turn(play.session) ||
        event.key < U'1' || event.key >= U'1' + choices.size())
        return false;
    const PoolChoice choice = choices[event.key - U'1'];
    obey(play, command::Decide{choice}, std::string(choice_text(choice)));
    return true;
}

void PoolController::after_ticks(PlayContext& play, double) {
    if (play.clock.is_hurrying() && !are_rolling(play)) play.clock.normal();
    if (auto outcome = announcer_.tell(play.session, names())) say(play, *std::move(outcome));
}

bool PoolController::are_rolling(const PlayContext& play) const {
    const PoolPlay* const pool = pool_of(play.session);
    const ShotsState* const shots = shots_of(play.session);
    return pool    ? pool->is_shooting
           : shots ? shots->is_shooting
                   : !is_at_rest(play.session.world());
}

// Whether the cue is in the player's hands, so that no key brings out the editor's cursor, even
// while nothing can be aimed.
bool PoolController::keeps_cue(const PlayContext& play) const {
    return play.pointer.tool.is_empty() && !play.pointer.shows_cursor;
}

bool PoolController::edit_nothing(PlayContext& play) const {
    if (!has_turns(play.session)) return false;
    say(play, pool_of(play.session) ? "only the cue moves balls here; pool-table has no rules"
                                    : "only the cue moves balls in this game");
    return true;
}

void PoolController::skip_to_rest(PlayContext& play) {
    if (!are_rolling(play)) return say(play, "The balls are at rest.");
    play.clock.hurry();
}

bool PoolController::turn_coarsely(PlayContext& play, int direction) {
    if (!aims_with_keys(play)) return keeps_cue(play);
    aim_.turn(direction * coarse_turn);
    return true;
}

void PoolController::turn_finely(PlayContext& play, int direction) {
    if (aims_with_keys(play))
        aim_.turn(direction * fine_turn);
    else if (!play.pointer.tool.is_empty())
        move_cursor(play, -direction * cursor_step, 0.0);
}

bool PoolController::change_speed(PlayContext& play, int direction) {
    if (!aims_with_keys(play)) return keeps_cue(play);
    aim_.change_speed(direction * speed_step);
    return true;
}

bool PoolController::move_tip(const PlayContext& play, int side, int follow) {
    if (!is_aiming(play) || play.pointer.shows_cursor) return false;
    aim_.move_tip(side * tip_step, follow * tip_step);
    return true;
}

bool PoolController::explain_cue(PlayContext& play) const {
    if (!aims_with_keys(play) && !has_turns(play.session)) return false;
    say(play, "Arrows aim, enter shoots; or drag with the right button.");
    return true;
}

void PoolController::next_pot(PlayContext& play, bool backwards) {
    if (is_aiming(play)) say(play, aim_.next_pot(play.session, backwards));
}

// The editor's keys for the next ball.
bool PoolController::next_pot_under_rules(PlayContext& play, bool backwards) {
    if (!has_turns(play.session)) return false;
    next_pot(play, backwards);
    return true;
}

void PoolController::next_call(PlayContext& play) {
    if (stroke_.meter()) return;
    say(play, aim_.next_call(play.session));
}

void PoolController::next_aids(PlayContext& play) {
    say(play, aim_.next_aids());
}

void PoolController::place_cue_ball(PlayContext& play) {
    Pointer& pointer = play.pointer;
    if (!pointer.tool.is_empty()) {
        pointer.shows_cursor = false;
        return pointer.tool.cancel(play.session);
    }
    if (!is_aiming(play) || !aim_.may_place(play.session))
        return say(play, "The cue ball is not in hand.");
    const World& world = play.session.world();
    const BallId ball = *aim_.cue_ball(play.session);
    pointer.at = world.balls().position[*index_of(world, ball)];
    pointer.tool.grab_to_place(world, ball, pointer.at);
    pointer.shows_cursor = true;
    say(play, "Move the ball with the arrows; p or enter puts it down.");
}

bool PoolController::set_opponent(const Session& session, int skill) {
    if (!pool_of(session)) return false;
    opponent_.set_skill(skill);
    announcer_.skip(session, names());
    return true;
}

void PoolController::next_opponent(PlayContext& play) {
    const int next = (opponent() + 1) % (most_skill + 1);
    if (!set_opponent(play.session, next)) return say(play, "No game of pool is played here.");
    say(play, next > 0 ? fmt::format("against carom, {} of {}: {}; you have {}", next, most_skill,
                                     skill_text(next), hand_text(hand()))
                       : "two players");
}

void PoolController::ask_coach(PlayContext& play) {
    if (is_match(play.session)) return say(play, "There is no coach in a match.");
    if (!pool_of(play.session) || !is_aiming(play))
        return say(play, "The coach speaks when it is your turn.");
    coach_.ask();
    say(play, "The coach is thinking.");
}

// The coach proposes one shot at a time, and sets it up.
void PoolController::hear_coach(PlayContext& play) {
    if (!coach_.is_asked()) return;
    if (!is_aiming(play)) return coach_.dismiss();
    const CandidateShot* const proposal = coach_.think(play.session);
    if (!proposal) return;
    const CandidateShot shot = *proposal;
    const std::string text = coach_.text(play.session.scene());
    if (shot.place) {
        const BallId ball = *aim_.cue_ball(play.session);
        if (const auto why_not = play.session.apply(command::PlaceBall{ball, *shot.place}))
            return complain(play, *why_not);
    }
    aim_.take(play.session, shot);
    say(play, text);
}

// Goes back to the player's own last turn.
void PoolController::undo_shot(PlayContext& play) {
    if (is_match(play.session)) return say(play, "No shot can be undone in a match.");
    opponent_.hesitate();
    if (!undo(play)) return;
    while (opponent_.is_turn(play.session) && play.session.undo()) {
    }
    set_reference(play);
}

void PoolController::continue_from(PlayContext& play, const Controller& before) {
    const auto* const pool = dynamic_cast<const PoolController*>(&before);
    if (pool) set_hand(pool->hand());
    if (pool) tally_ = pool->tally_;
    if (pool) record_ = pool->record_;
    if (pool && pool->opponent() > 0) set_opponent(play.session, pool->opponent());
}

bool is_in_match(const Session& session) {
    const PoolPlay* const pool = pool_of(session);
    if (!pool || session.is_following() || match_winner(*pool)) return false;
    return pool->shooter || pool->frames != std::array<std::uint32_t, 2>{};
}

}  // namespace carom

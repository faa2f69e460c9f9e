#include "carom/controllers/pool_actions.h"

#include <fmt/format.h>

#include "carom/controllers/editing.h"
#include "game/ai/opponents.h"
#include "game/commands/aiming.h"

namespace carom::pool_actions {
namespace {

// For each press of a key.
constexpr double coarse_turn = 1.0;  // degrees
constexpr double fine_turn = 0.05;
constexpr double speed_step = 0.1;   // m/s
constexpr double tip_step = 0.05;    // in radii
constexpr double cursor_step = 0.2;  // columns, with a ball in hand

constexpr const char* no_game = "No game of pool is played here.";

bool is_past_of_match(const PoolController& table, const PlayContext& play) {
    return table.players().is_match(play.session) &&
           play.session.world().tick() < play.session.latest();
}

std::string only_looked_at(const PlayContext& play) {
    return fmt::format(
        "In a match the past is only looked at{}.",
        play.clock.is_paused() ? fmt::format("; {} resumes", play.keys.hint("pause")) : "");
}

// Whether the action may be carried out; if not, the player is asked.
bool is_confirmed(PoolController& table, PlayContext& play, std::string_view action,
                  std::string_view to_do_what) {
    if (table.confirmation().is_given()) return true;
    table.confirmation().ask();
    say(play, fmt::format("Press {} again to {}.", play.keys.hint(action), to_do_what));
    return false;
}

// Whether an unfinished frame of a match can only be ended by conceding it.
bool is_in_frame_of_match(const PoolController& table, const PlayContext& play) {
    const PoolPlay* const pool = pool_of(play.session);
    return pool && table.players().is_match(play.session) && pool->shooter &&
           pool->rules.phase != PoolPhase::over;
}

void concede(PoolController& table, PlayContext& play) {
    if (is_past_of_match(table, play)) return say(play, only_looked_at(play));
    if (table.players().is_opponents_turn(play.session))
        return say(play, "You can concede when it is your turn.");
    if (are_rolling(play)) return say(play, "You can concede when the balls are at rest.");
    if (!is_confirmed(table, play, "next-frame", "concede the frame")) return;
    table.stroke().end();
    if (const auto why_not = play.session.apply(command::Concede{})) complain(play, *why_not);
    set_reference(play);
}

}  // namespace

bool turn_coarsely(PoolController& table, PlayContext& play, int direction) {
    if (!table.aims_with_keys(play)) return keeps_cue(play);
    table.aim().turn(direction * coarse_turn);
    return true;
}

void turn_finely(PoolController& table, PlayContext& play, int direction) {
    if (table.aims_with_keys(play))
        table.aim().turn(direction * fine_turn);
    else if (!play.pointer.tool.is_empty())
        move_cursor(play, -direction * cursor_step, 0.0);
}

bool change_speed(PoolController& table, PlayContext& play, int direction) {
    if (!table.aims_with_keys(play)) return keeps_cue(play);
    table.aim().change_speed(direction * speed_step);
    return true;
}

bool move_tip(PoolController& table, const PlayContext& play, int side, int follow) {
    // Under rules these keys move nothing else, so that a late press does not shift the table.
    if (!table.is_aiming(play)) return has_turns(play.session) && keeps_cue(play);
    if (play.pointer.shows_cursor) return false;
    table.aim().move_tip(side * tip_step, follow * tip_step);
    return true;
}

bool zoom_on_aim(PoolController& table, PlayContext& play, double factor) {
    if (!table.is_aiming(play)) return false;
    const command::Strike strike = table.aim().strike(play.session);
    const auto line = aim_line(play.session.world(), strike.ball, strike.velocity);
    if (!line || !line->object) return false;
    const CellPoint place = to_cells(play.view.camera, line->to);
    // After a turn of the aim it may lie outside.
    if (!contains(visible_box(play.view.camera), line->to)) {
        const CellPoint middle = play.view.middle();
        play.view.pan(place.column - middle.column, place.row - middle.row);
    }
    play.view.zoom(to_cells(play.view.camera, line->to), factor);
    table.set_near();
    return true;
}

bool shoot(PoolController& table, PlayContext& play) {
    if (table.is_pulling(play) || table.shoot_with_key(play)) return true;
    const PoolPlay* const pool = pool_of(play.session);
    const ShotsState* const shots = shots_of(play.session);
    const bool is_over = pool ? pool->rules.phase == PoolPhase::over : shots && shots->is_over;
    if (is_over && keeps_cue(play)) return rack_again(table, play), true;
    if (keeps_cue(play)) {
        if (are_rolling(play))
            say(play, fmt::format("The balls are still rolling. {} skips to rest.",
                                  play.keys.hint("to-rest")));
        else if (is_past_of_match(table, play))
            say(play, only_looked_at(play));
        return true;
    }
    if (!has_turns(play.session)) return false;
    // Puts down the ball in hand.
    grab(play);
    play.pointer.shows_cursor = !play.pointer.tool.is_empty();
    return true;
}

bool give_up_stroke(PoolController& table, PlayContext& play) {
    if (!table.stroke().meter()) return table.stroke().has_just_run_out();
    table.stroke().end();
    say(play, "No stroke.");
    return true;
}

bool edit_nothing(PlayContext& play) {
    if (!has_turns(play.session)) return false;
    say(play, pool_of(play.session) ? "Only the cue moves balls here. pool-table has no rules."
                                    : "Only the cue moves balls in this game.");
    return true;
}

bool explain_cue(const PoolController& table, PlayContext& play) {
    if (!table.aims_with_keys(play) && !has_turns(play.session)) return false;
    say(play, "Arrows aim, enter shoots; or pull the cue with the mouse.");
    return true;
}

// At rest it tells the outcome once more: it may have faded, or come up during this press.
void skip_to_rest(const PoolController& table, PlayContext& play) {
    const std::string outcome = table.players().outcome(play.session);
    if (!are_rolling(play)) return say(play, outcome.empty() ? "The balls are at rest." : outcome);
    play.clock.hurry();
}

void next_pot(PoolController& table, PlayContext& play, bool backwards) {
    if (table.is_aiming(play)) say(play, table.aim().next_pot(play.session, backwards));
}

bool next_pot_under_rules(PoolController& table, PlayContext& play, bool backwards) {
    if (!has_turns(play.session)) return false;
    if (table.is_aiming(play) && table.aim().may_choose(play.session)) {
        table.aim().choose_next(play.session, backwards);
        play.needs_draw = true;
        return true;
    }
    next_pot(table, play, backwards);
    return true;
}

void next_call(PoolController& table, PlayContext& play) {
    if (table.is_aiming(play)) return say(play, table.aim().next_call(play.session));
    if (table.players().is_opponents_turn(play.session))
        say(play, table.players().opponent_text());
    else if (!table.stroke().meter())
        say(play, "Nothing is called now.");
}

void next_aids(PoolController& table, PlayContext& play) {
    say(play, table.aim().next_aids(play.session));
}

void place_cue_ball(PoolController& table, PlayContext& play) {
    Pointer& pointer = play.pointer;
    if (!pointer.tool.is_empty()) {
        pointer.shows_cursor = false;
        return pointer.tool.cancel(play.session);
    }
    if (!table.is_aiming(play) || !table.aim().may_place(play.session))
        return say(play, "The cue ball is not in hand.");
    const World& world = play.session.world();
    const BallId ball = *table.aim().cue_ball(play.session);
    pointer.at = world.balls().position[*index_of(world, ball)];
    pointer.tool.grab_to_place(world, ball, pointer.at);
    pointer.shows_cursor = true;
    say(play, "Move the ball with the arrows or the mouse; enter puts it down.");
}

void rack_again(PoolController& table, PlayContext& play) {
    if (is_in_frame_of_match(table, play)) return concede(table, play);
    const PoolPlay* const pool = pool_of(play.session);
    obey(play, command::RackAgain{}, pool ? "The balls are racked." : "A new game.");
}

bool keep_frame(PoolController& table, PlayContext& play) {
    if (!is_in_match(play.session)) return false;
    const bool is_race = pool_of(play.session)->race > 0;
    const std::string_view what =
        is_race ? "lose this match and restart" : "lose this frame and restart";
    if (!is_confirmed(table, play, "restart", what)) return true;
    table.players().give_up(play.session);
    return false;
}

bool keep_solver(const PoolController& table, PlayContext& play) {
    if (!table.players().is_match(play.session)) return false;
    say(play, "In a match the solver stays.");
    return true;
}

namespace {

std::string opponent_stays(int opponent) {
    if (opponent == 0) return "The opponent stays until the match is over.";
    if (is_of_ladder(opponent))
        return fmt::format("You play {} until the match is over.", ai_player(opponent).name);
    return fmt::format("You play carom, {} of {}, until the match is over.", opponent, most_skill);
}

// In a game of shots nobody plays against the player: it is practice, or for real.
void toggle_match(PoolPlayers& players, PlayContext& play) {
    const bool is_match = !players.is_match(play.session);
    if (!players.set_match(play.session, is_match))
        return say(play, "That is chosen before the first shot.");
    if (is_match)
        return say(play, fmt::format("for real: you have {}, no lines, no undo",
                                     hand_text(players.hand())));
    say(play, players.keeps_stars(play.session)
                  ? "practice: exact strokes, lines, undo"
                  : "practice: exact strokes, lines, undo; no stars are kept");
}

}  // namespace

void next_opponent(PoolController& table, PlayContext& play) {
    PoolPlayers& players = table.players();
    if (shots_of(play.session)) return toggle_match(players, play);
    if (players.is_match(play.session) && is_in_match(play.session))
        return say(play, opponent_stays(players.opponent()));
    const int next = players.opponent() < most_skill ? players.opponent() + 1 : 0;
    if (!players.set_opponent(play.session, next)) return say(play, no_game);
    say(play, next > 0 ? fmt::format("against carom, {} of {}: {}; you have {}", next, most_skill,
                                     skill_text(next), hand_text(players.hand()))
                       : "two players");
}

void next_hand(PoolController& table, PlayContext& play) {
    PoolPlayers& players = table.players();
    const PoolPlay* const pool = pool_of(play.session);
    const ShotsState* const shots = shots_of(play.session);
    if (!pool && !shots) return say(play, no_game);
    const bool has_begun = pool ? pool->shooter.has_value() : shots->shots > 0 && !shots->is_over;
    if (players.is_match(play.session) && has_begun)
        return say(play, pool ? "Choose your skill before the break."
                              : "Choose your skill before the first shot.");
    players.set_hand(players.hand() % most_hand + least_hand);
    say(play, fmt::format("in a match you have {}, {} of {}", hand_text(players.hand()),
                          players.hand(), most_hand));
}

void open_record(PlayContext& play) {
    play.page.open(CoveringPage::Kind::record);
}

void ask_coach(PoolController& table, PlayContext& play) {
    if (table.players().is_match(play.session))
        return say(play, "There is no coach when it is for real.");
    if (!pool_of(play.session) || !table.is_aiming(play))
        return say(play, "The coach speaks when it is your turn.");
    table.coach().ask();
    say(play, "The coach is thinking.");
}

void undo_shot(PoolController& table, PlayContext& play) {
    PoolPlayers& players = table.players();
    if (players.is_match(play.session))
        return say(play, pool_of(play.session) ? "No shot can be undone in a match."
                                               : "No shot can be undone when it is for real.");
    players.hesitate();
    if (!undo(play)) return;
    say(play, "Undone.");
    while (players.is_opponents_turn(play.session) && play.session.undo()) {
    }
    set_reference(play);
}

}  // namespace carom::pool_actions

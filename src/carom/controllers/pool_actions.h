#pragma once

#include "carom/controllers/pool_controller.h"

/// What keys do at a pool table, for the table of actions (carom/controllers/action_table.cpp).
/// Those that return false do nothing, because the key means something else at present.
namespace carom::pool_actions {

bool turn_coarsely(PoolController& table, PlayContext& play, int direction);
void turn_finely(PoolController& table, PlayContext& play, int direction);
bool change_speed(PoolController& table, PlayContext& play, int direction);
/// Zooms on the place where the aim meets a ball. False: nothing is aimed.
bool zoom_on_aim(PoolController& table, PlayContext& play, double factor);
bool move_tip(PoolController& table, const PlayContext& play, int side, int follow);
bool shoot(PoolController& table, PlayContext& play);
bool give_up_stroke(PoolController& table, PlayContext& play);
/// Says that a game's balls are not edited.
bool edit_nothing(PlayContext& play);
bool explain_cue(const PoolController& table, PlayContext& play);
void skip_to_rest(const PoolController& table, PlayContext& play);

void next_pot(PoolController& table, PlayContext& play, bool backwards);
/// next_pot() in a game, for the keys that select the next ball in free play. False: no game.
bool next_pot_under_rules(PoolController& table, PlayContext& play, bool backwards);
void next_call(PoolController& table, PlayContext& play);
void next_aids(PoolController& table, PlayContext& play);
void place_cue_ball(PoolController& table, PlayContext& play);

/// Racks the next frame; in a match that has a frame in progress, it concedes that one, once the
/// key is pressed again.
void rack_again(PoolController& table, PlayContext& play);
/// Asks before a frame of pool is restarted. False: it may be.
bool keep_frame(PoolController& table, PlayContext& play);
/// Refuses another solver in a match. False: it is none.
bool keep_solver(const PoolController& table, PlayContext& play);
/// Changes the opponent; in a match, before the first break.
void next_opponent(PoolController& table, PlayContext& play);
void next_hand(PoolController& table, PlayContext& play);
void open_record(PlayContext& play);
void ask_coach(PoolController& table, PlayContext& play);
/// Goes back to the player's own last turn.
void undo_shot(PoolController& table, PlayContext& play);

}  // namespace carom::pool_actions

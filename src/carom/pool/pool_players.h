#pragma once

#include <optional>
#include <string>

#include "carom/files/pool_record.h"
#include "carom/pool/pool_opponent.h"
#include "carom/pool/pool_status.h"
#include "carom/pool/shot_clock.h"
#include "carom/pool/shot_tally.h"
#include "game/ai/person_hand.h"

/// Who plays at a pool table, and what is counted of it: the opponent, the person's skill, the shot
/// clock, and the record. At a table without a game it is there, and does nothing.
namespace carom {

/// "you" and the AI player of this number; 0: two people.
PlayerNames names_against(int opponent);

class PoolPlayers {
  public:
    /// The AI player plays the second player from now on (PoolOpponent::set). False without a
    /// game of pool.
    bool set_opponent(const Session& session, int number);
    int opponent() const { return opponent_.number(); }
    bool is_opponents_turn(const Session& session) const { return opponent_.is_turn(session); }
    /// The opponent's announced shot.
    std::string opponent_text() const { return opponent_.text(); }
    /// The shot that the opponent is about to make; null: none.
    const CandidateShot* opponent_shot(const Session& session) const {
        return opponent_.announced(session);
    }
    /// Restarts the opponent's pause, after a rewind.
    void hesitate() { opponent_.hesitate(); }
    PlayerNames names() const;

    /// A game against carom, or with a length (race=), is a match: the stroke may fail, and there
    /// is no undo, no coach and no forecast. All others are practice, where a shot is exactly as
    /// aimed. A game of shots is a match if the level says stroke=hand, or as the player chooses.
    bool is_match(const Session& session) const;
    /// Changes between practice and match. False: not a game of shots, or it has begun.
    bool set_match(const Session& session, bool is_match);
    /// Whether the stars of the level's goal count: not in practice, where the level says
    /// stroke=hand.
    bool keeps_stars(const Session& session) const {
        return is_match(session) || !session.scene().rules.may_miss;
    }

    /// The level of the person's hand in a match, least_hand..most_hand.
    int hand() const { return hand_; }
    void set_hand(int level) { hand_ = level; }

    /// On the shot clock, s; none: no clock runs.
    std::optional<double> time_left(const Session& session) const { return clock_.left(session); }
    void set_time_left(const Session& session, double left) { clock_.resume(session, left); }

    /// What the person had done in matches before this game.
    void set_record(const PoolRecord& record) { record_ = record; }
    const PoolRecord& record_before() const { return record_; }
    /// The record before this game, and what has been counted since.
    PoolRecord record() const;
    /// Counts the frame that is being played, or the match, as lost. Pre: is_in_match().
    void give_up(const Session& session);
    /// What has been counted since the last call. Unless `all`, only once a frame has ended.
    std::optional<PoolRecord> take_record(bool all);

    /// Lets the player's seconds pass: the opponent plays, and clock and record count.
    void pass(PlayContext& play, double seconds);
    /// The outcome of the last shot; empty: there is none, or the balls roll.
    std::string outcome(const Session& session) const {
        return outcome_of(session, names()).value_or("");
    }
    /// The outcome of a shot, once.
    std::optional<std::string> tell_outcome(const Session& session);
    /// Continues with the player's choices in another game.
    void continue_from(const Session& session, const PoolPlayers& before);

  private:
    void count_time(PlayContext& play, double seconds);
    void tally(const PlayContext& play, double seconds);

    PoolOpponent opponent_;
    int hand_ = 2;
    std::optional<bool> is_match_{};  ///< of a game of shots; none: as the level says
    ShotAnnouncer announcer_;
    ShotClock clock_;
    ShotTally tally_;
    PoolRecord record_;
};

/// Whether a match has begun and is not won, so that it is kept when the player leaves.
bool is_in_match(const Session& session);

}  // namespace carom

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "game/rules/goal.h"
#include "game/rules/rule_state.h"
#include "level/scene/pinball_table.h"
#include "physics/world/ids.h"

namespace carom {

/// The state of a game of pinball besides the world. Times are in ticks.
struct PinballState {
    enum class Phase : std::uint8_t {
        playing,
        counting,  ///< the ball has drained, and its bonus is being shown
        over       ///< the plunger starts another game
    };
    Phase phase = Phase::playing;
    std::uint64_t phase_until = 0;  ///< counting

    std::int64_t score = 0;
    std::uint32_t ball = 1;  ///< number of the ball in play
    std::uint32_t extra_balls = 0;
    std::int64_t bonus = 0;
    std::int64_t multiplier = 1;  ///< of the bonus
    std::uint64_t games = 1;

    /// The ball in play has been launched, so the ball saver is running.
    bool is_launched = false;
    std::uint64_t save_until = 0;
    std::uint32_t to_serve = 0;   ///< balls waiting to be served to the plunger
    bool serves_itself = false;   ///< the table launches them automatically
    std::uint64_t launch_at = 0;  ///< of the automatic launch; 0: none
    double pull = 0.0;            ///< of the plunger, 0..1

    std::array<bool, button_count> is_down{};
    std::uint64_t nudge_until = 0;
    Vec2 nudge;  ///< acceleration, length/s^2
    double tilt_meter = 0.0;
    std::uint32_t warnings = 0;
    bool is_tilted = false;

    /// Indexed like PinballTable::devices.
    std::vector<std::uint8_t> is_lit;
    /// End of each kicker's flash; only displayed, and in no fingerprint.
    std::vector<std::uint64_t> flash_until;
    /// How often each device has been hit or entered; only observed, and in no fingerprint.
    std::vector<std::uint32_t> events;
    std::vector<std::uint64_t> lit_until;  ///< 0: until something switches it off
    std::vector<std::uint8_t> is_rising;   ///< drop targets waiting for room to rise
    std::vector<double> turning;           ///< spinners: half turns a second
    std::vector<double> turned;            ///< spinners: fraction of a half turn

    struct Visit {
        std::uint32_t device = 0;
        BallId ball{};
        friend auto operator<=>(const Visit&, const Visit&) = default;
    };
    std::vector<Visit> visits;  ///< which ball is in which zone, ascending

    /// A ball in a hole or a magnet.
    struct Held {
        std::uint32_t device = 0;
        BallId ball{};
        std::uint64_t until = 0;  ///< keeps_until_released: until a rule releases it
    };
    static constexpr std::uint64_t keeps_until_released = ~std::uint64_t{0};
    std::vector<Held> held;

    /// A ball that lies in a lock, has just come into it, or has left it a moment ago: a nudge may
    /// lift it, and it counts once.
    struct Lying {
        std::uint32_t device = 0;
        BallId ball{};
        std::uint64_t since = 0;
        std::uint64_t seen = 0;   ///< the last tick in which it was there
        bool is_counted = false;  ///< rules have been told that it is locked
    };
    std::vector<Lying> lying;
    std::vector<BallId> locked;  ///< balls on the table that are out of play, ascending

    /// Where and when a ball last made progress.
    struct Progress {
        BallId ball{};
        Vec2 place;
        std::uint64_t since = 0;
        std::uint32_t searches = 0;
    };
    std::vector<Progress> progress;  ///< ascending by ball

    std::uint64_t removals_seen = 0;
    std::uint64_t drained = 0;   ///< balls, including saved ones
    std::uint64_t searches = 0;  ///< kicks by the ball search
    std::uint64_t lost = 0;      ///< balls served again because no kick freed them, or because
                                 ///< they had left the table

    RuleState rules;
    std::uint32_t players = 1;  ///< who play; others may join during the first ball
    bool has_replay = false;    ///< the replay award of this player has been given

    /// What a player leaves on the table until its next ball.
    struct Parked {
        std::int64_t score = 0;
        std::uint32_t extra_balls = 0;
        bool has_replay = false;
        std::vector<std::uint8_t> is_lit;  ///< but for drop targets, which rise
    };
    /// By player; that of the player whose turn it is is out of date. Empty: one player.
    std::vector<Parked> parked;

    GoalState goal;  ///< of the level; no shots are counted

    std::string message;
    std::uint64_t message_since = 0;
    std::uint64_t message_until = 0;
    /// The message of an extra ball waits for the one before it, such as that of a multiball.
    bool extra_ball_is_untold = false;
};

}  // namespace carom

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/commands/command.h"
#include "game/referees/pool_state.h"
#include "level/scene/scene.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// A match of pool on a table. It records each shot, asks the referee when the balls are at rest,
/// and carries out the ruling, for example by spotting a ball.
namespace carom {

/// The most balls of a game, with the cue ball: those of snooker.
inline constexpr int most_pool_balls = 22;

/// Plain state: a copy together with a copy of the world continues with the same bits.
struct PoolPlay {
    PoolState rules;
    /// Ball n; none: it is off the table.
    std::array<std::optional<BallId>, most_pool_balls> balls{};
    PoolCall call;  ///< for the next shot
    /// For the last shot. It only serves the words (pool_words.h), and is no part of the digest.
    PoolCall called;
    bool is_shooting = false;
    PoolShot shot;             ///< the record of the present or the last shot
    bool has_crossed = false;  ///< the cue ball has been beyond the head string in that shot
    /// Balls by number that lie frozen to an edge: hits of that edge do not count until the ball
    /// has left it.
    struct Frozen {
        int ball = 0;
        CapsuleId edge{};

        friend bool operator==(const Frozen&, const Frozen&) = default;
    };
    std::vector<Frozen> frozen;
    /// Where balls lay before the shot, in games that may put them back.
    struct Lay {
        int ball = 0;
        Vec2 place;

        friend bool operator==(const Lay&, const Lay&) = default;
    };
    std::vector<Lay> lay;
    std::optional<int> shooter;  ///< of that shot; none: no shot in this frame yet
    /// What a player has decided since that shot. It only serves the words (pool_words.h), follows
    /// from the commands, and is no part of the digest.
    struct Decision {
        std::optional<PoolChoice> choice;  ///< none: the player conceded the frame
        PoolFoul foul = PoolFoul::none;    ///< of the shot
        int penalty = 0;
        bool was_miss = false;  ///< snooker: so the balls could be put back

        friend bool operator==(const Decision&, const Decision&) = default;
    };
    std::optional<Decision> decision;
    PoolFoul last_foul = PoolFoul::none;
    int last_penalty = 0;  ///< points of that foul
    std::uint32_t shots = 0;
    std::uint32_t racks = 0;                ///< since the first: see level/scene/racking.h
    int breaker = 0;                        ///< of this frame
    bool winner_breaks = false;             ///< the next one; else the players take turns
    std::array<std::uint32_t, 2> frames{};  ///< won by each player in this match
    std::uint32_t race = 0;                 ///< frames that win the match; 0: no end

    friend bool operator==(const PoolPlay&, const PoolPlay&) = default;
};

/// None unless the scene's game has a referee (referees/referee.h). `breaker` breaks the first
/// frame, unless the level has a coin tossed for it, which falls by the level's seed.
std::optional<PoolPlay> begin_pool(const Scene& scene, int breaker = 0);

/// Why this ball cannot be struck now, as a sentence; none if it can.
std::optional<std::string> refusal_to_shoot(const PoolPlay& play, BallId ball);
/// Why the cue ball cannot be placed there; none if it can. Overlaps are refused elsewhere.
std::optional<std::string> refusal_to_place(const Scene& scene, const PoolPlay& play, BallId ball,
                                            Vec2 place);
/// Why a command is against the rules, or cannot be executed by the world; none if it can. A player
/// may strike the cue ball, and place it when it is in hand; nothing else.
std::optional<std::string> refusal(const Scene& scene, const World& world, const PoolPlay& play,
                                   const Command& command);

/// Pre: not refused.
void execute(const Scene& scene, World& world, PoolPlay& play, const Command& command);

/// Records the events of a tick. When the balls are at rest the shot is judged: spotted balls and a
/// pocketed cue ball return. Pre: called after every tick of `world`, with its contacts.
void update_pool(const Scene& scene, World& world, PoolPlay& play,
                 std::span<const Contact> contacts);

/// Pre: the choice is one of play.rules.choices.
void make_choice(const Scene& scene, World& world, PoolPlay& play, PoolChoice choice);

/// The player whose turn it is concedes the frame. Pre: is_awaited(play).
void concede_frame(const Scene& scene, World& world, PoolPlay& play);

/// Starts the next frame, which the other player breaks, or restarts an unfinished frame. After the
/// last frame of a match another match starts. Pre: no ball is moving.
void rack_again(const Scene& scene, World& world, PoolPlay& play);

/// Racks the balls as in frame number `frame`; 0 is the level's own rack. The cue ball returns to
/// its start.
void rack_frame(const Scene& scene, World& world, PoolPlay& play, std::uint32_t frame);

/// The winner of the match; none: it is not decided, or has no end.
std::optional<int> match_winner(const PoolPlay& play);

/// Whether the player whose turn it is has a shot or a choice to make.
bool is_awaited(const PoolPlay& play);

/// The number of the ball; none: it is not one of the game's balls.
std::optional<int> number_of(const PoolPlay& play, BallId ball);

/// Whether no ball moves or rolls; balls may still spin in place.
bool is_at_rest(const World& world);

/// The digest of the whole state, combined with `start`.
std::uint64_t digest_of(std::uint64_t start, const PoolPlay& play);
/// The memory that the state owns, without sizeof, in bytes.
std::size_t bytes_of(const PoolPlay& play);

}  // namespace carom

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "game/commands/command.h"
#include "game/referees/pool_state.h"
#include "level/scene/scene.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// Frames of 8-ball or 9-ball on a table: watches the balls, asks the rules when they lie still,
/// and does what the rules say, such as putting a ball back on its spot.
namespace carom {

/// All of it is state: a copy beside a copy of the world goes on with the same bits.
struct PoolPlay {
    PoolState rules;
    /// Ball n; none: it is off the table.
    std::array<std::optional<BallId>, 16> balls{};
    PoolCall call;  ///< for the next shot
    bool is_shooting = false;
    PoolShot shot;  ///< what the present shot has done so far, or what the last one did
    std::optional<int> shooter;  ///< whose shot that is; none: nobody has shot in this frame
    PoolFoul last_foul = PoolFoul::none;
    std::uint32_t shots = 0;
    int breaker = 0;                        ///< who broke, or will, at the start of this frame
    std::array<std::uint32_t, 2> frames{};  ///< won by each, in this match
    std::uint32_t race = 0;                 ///< frames that win the match; 0: it has no end
    std::uint64_t clock = 0;                ///< ticks in which to shoot, or to choose; 0: any time
    std::uint64_t clock_from = 0;           ///< the tick at which that time began

    friend bool operator==(const PoolPlay&, const PoolPlay&) = default;
};

/// None unless the scene's game is 8-ball or 9-ball.
std::optional<PoolPlay> begin_pool(const Scene& scene, int breaker = 0);

/// Why this ball cannot be struck now, as a sentence; none when it can.
std::optional<std::string> refusal_to_shoot(const PoolPlay& play, BallId ball);
/// Why the cue ball cannot be put there; none when it can. What overlaps is refused elsewhere.
std::optional<std::string> refusal_to_place(const Scene& scene, const PoolPlay& play, BallId ball,
                                            Vec2 place);
/// Why a command is against the rules, or cannot be obeyed by the world; none when it can. Only the
/// cue ball is struck, and placed when it is in hand; nothing else is touched.
std::optional<std::string> refusal(const Scene& scene, const World& world, const PoolPlay& play,
                                   const Command& command);

/// Pre: not refused.
void obey(const Scene& scene, World& world, PoolPlay& play, const Command& command);

/// The cue ball has been struck. Pre: not refused.
void begin_shot(PoolPlay& play);

/// Pre: called after every tick of `world`, with its contacts. When the balls lie still the shot is
/// judged: balls come back, and the cue ball too where it fell.
void follow_pool(const Scene& scene, World& world, PoolPlay& play,
                 std::span<const Contact> contacts);

/// Pre: the choice is one of play.rules.choices.
void make_choice(const Scene& scene, World& world, PoolPlay& play, PoolChoice choice);

/// The next frame, which the other player breaks; a frame that is not over is begun again. After
/// the last frame of a match another match begins. Pre: no ball rolls.
void rack_again(const Scene& scene, World& world, PoolPlay& play);

/// Who has won the match; none: it goes on, or has no end.
std::optional<int> match_winner(const PoolPlay& play);

/// Ticks that the player whose turn it is has left; none: no clock runs now.
std::optional<std::uint64_t> time_left(const World& world, const PoolPlay& play);

/// The rack of the scene's game. Pre: the game is 8-ball or 9-ball.
const Rack& rack_of(const Scene& scene);

/// Which ball that is; none: none of the game's.
std::optional<int> number_of(const PoolPlay& play, BallId ball);

/// Whether every ball lies still, though it may still turn on the spot.
bool lies_still(const World& world);

/// Where the cue ball starts: the middle of the head string.
Vec2 head_spot(const Scene& scene);

/// Whether a ball can be there without lying beyond a cushion or over a pocket; other balls do not
/// count. For a convex table.
bool is_on_table(const Scene& scene, const World& world, Vec2 place, double radius);

/// Folds all of it into `start`.
std::uint64_t folded(std::uint64_t start, const PoolPlay& play);
/// Beyond its own size, in bytes.
std::size_t bytes_of(const PoolPlay& play);

}  // namespace carom

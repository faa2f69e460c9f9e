#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "game/pool_rules.h"
#include "level/scene.h"
#include "physics/contact.h"
#include "physics/world.h"

/// A rack of 8-ball or 9-ball on a table: watches the balls, asks the rules when they lie still,
/// and does what the rules say, such as putting a ball back on its spot.
namespace carom {

/// All of it is state: a copy beside a copy of the world goes on with the same bits.
struct PoolPlay {
    PoolState rules;
    /// Ball n; none: it is off the table.
    std::array<std::optional<BallId>, 16> balls{};
    PoolCall call;  ///< for the next shot
    bool is_shooting = false;
    PoolShot shot;  ///< what the present shot has done so far
    PoolFoul last_foul = PoolFoul::none;
    std::uint32_t shots = 0;

    friend bool operator==(const PoolPlay&, const PoolPlay&) = default;
};

/// None unless the scene's game is 8-ball or 9-ball.
std::optional<PoolPlay> begin_pool(const Scene& scene, int breaker = 0);

/// Why this ball cannot be struck now, as a sentence; none when it can.
std::optional<std::string> refusal_to_shoot(const PoolPlay& play, BallId ball);
/// Why the cue ball cannot be put there; none when it can. What overlaps is refused elsewhere.
std::optional<std::string> refusal_to_place(const Scene& scene, const PoolPlay& play, BallId ball,
                                            Vec2 place);

/// The cue ball has been struck. Pre: not refused.
void begin_shot(PoolPlay& play);

/// Pre: called after every tick of `world`, with its contacts. When the balls lie still the shot is
/// judged: balls come back, and the cue ball too where it fell.
void follow_pool(const Scene& scene, World& world, PoolPlay& play,
                 std::span<const Contact> contacts);

/// Pre: the choice is one of play.rules.choices.
void make_choice(const Scene& scene, World& world, PoolPlay& play, PoolChoice choice);

/// Which ball that is; none: none of the game's.
std::optional<int> number_of(const PoolPlay& play, BallId ball);

/// Where the cue ball starts: the middle of the head string.
Vec2 head_spot(const Scene& scene);

}  // namespace carom

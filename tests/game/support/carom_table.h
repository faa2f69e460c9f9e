#pragma once

#include <array>
#include <cmath>
#include <set>
#include <string>

#include <doctest/doctest.h>

#include "game/support/shipped.h"
#include "game/support/shots_game.h"

/// Shots at a three-cushion table, by the order in which the cue ball meets cushions and balls.
namespace carom::test {

inline constexpr double half_length = 1.42;  ///< of the cloth, m
inline constexpr double half_width = 0.71;
inline constexpr double diamond = 0.355;

/// A place in diamonds: 0,0 is the lower left corner of the cloth, 8,4 the upper right one.
inline Vec2 in_diamonds(double x, double y) {
    return {(x - 4.0) * diamond, (y - 2.0) * diamond};
}

/// Three-cushion with the balls at these places: white, yellow, red.
inline Scene placed(std::array<Vec2, 3> places) {
    Scene scene = shipped_level("three-cushion", {"let opening=0"});
    for (std::size_t i = 0; i < places.size(); ++i)
        scene.world.edit_balls().position[i] = places[i];
    return scene;
}

inline command::Strike struck(const ShotsGame& game, Vec2 way, double speed, double side,
                              double follow = 0.0) {
    const Vec2 velocity = way * (speed / std::hypot(way.x, way.y));
    return {*cue_ball_of(game.session.scene(), game.state()), velocity, side, follow};
}

/// Plays a shot. What the cue ball met, in order: `n`, `e`, `s` or `w` a cushion, 1 the first ball,
/// 2 the other one. What comes after the second ball does not matter, nor does the first ball met
/// again.
inline std::string walk_of(ShotsGame& game, const command::Strike& strike) {
    const std::uint32_t cue = number(strike.ball);
    std::string walk;
    std::set<std::uint32_t> balls;
    REQUIRE_FALSE(game.session.apply(strike));
    while (game.state().is_shooting) {
        game.session.step_forward();
        for (const Contact& contact : game.session.contacts()) {
            if (balls.size() == 2) continue;
            if (contact.kind == ContactKind::ball_edge) {
                if (contact.a != cue) continue;
                const Vec2 way = contact.normal;  // from the edge to the ball
                if (std::abs(way.x) > std::abs(way.y))
                    walk += way.x > 0.0 ? 'w' : 'e';
                else
                    walk += way.y > 0.0 ? 's' : 'n';
                continue;
            }
            if (contact.a != cue && contact.b != cue) continue;
            const std::uint32_t other = contact.a == cue ? contact.b : contact.a;
            if (balls.insert(other).second) walk += static_cast<char>('0' + balls.size());
        }
    }
    return walk;
}

/// The walk with `c` for every cushion.
inline std::string story_of(ShotsGame& game, const command::Strike& strike) {
    std::string story = walk_of(game, strike);
    for (char& met : story)
        if (met != '1' && met != '2') met = 'c';
    return story;
}

}  // namespace carom::test

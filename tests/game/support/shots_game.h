#pragma once

#include <cstdint>
#include <string_view>
#include <variant>

#include <doctest/doctest.h>

#include "game/session/forecast.h"
#include "game/session/session.h"
#include "game/shots/shots.h"
#include "physics/solver.h"

namespace carom::test {

/// A game of shots in progress.
struct ShotsGame {
    explicit ShotsGame(const Scene& scene) : session(scene, pick_solver(scene.world).settings) {
        session.step_forward();  // the game and the first turn begin
    }

    const ShotsState& state() const { return std::get<ShotsState>(session.game()); }
    std::int64_t score(std::size_t player) const { return state().players[player].score; }
    /// How many balls of this kind are on the table.
    std::int64_t count_kind(std::string_view kind) const {
        const Scene& scene = session.scene();
        std::int64_t there = 0;
        for (std::size_t ball = 0; ball < state().balls.size(); ++ball)
            there +=
                state().balls[ball] && scene.kind_names[scene.world.balls().kind[ball]] == kind;
        return there;
    }

    void play_until_rest() {
        for (int tick = 0; state().is_shooting && tick < 120 * 120; ++tick)
            session.step_forward();
        REQUIRE_FALSE(state().is_shooting);
    }
    void shoot(const command::Strike& strike) {
        REQUIRE_FALSE(session.apply(strike));
        play_until_rest();
    }
    void shoot(Vec2 velocity) {
        const auto cue = cue_ball_of(session.scene(), state());
        REQUIRE(cue);
        shoot(command::Strike{*cue, velocity});
    }
    void shoot_softly() { shoot({0.0, 0.2}); }

    /// What the rules would say after a shot.
    ShotsState after(const command::Strike& strike) {
        Solver solver(session.solver());
        const Forecast ahead = forecast(session.scene(), session.world(), session.game(), solver,
                                        strike, 120.0, Tracks::none);
        return std::get<ShotsState>(ahead.game);
    }

    Session session;
};

}  // namespace carom::test

#include "game/ai/opponents.h"

#include <doctest/doctest.h>

#include <array>
#include <set>
#include <string_view>

#include "game/ai/planner.h"
#include "game/session/game_state.h"
#include "game/support/shipped.h"

using namespace carom;
using carom::test::shipped_level;

TEST_CASE("the ladder: seven people with names of their own, the better the higher") {
    std::set<std::string_view> names;
    double errors = 100.0;
    for (const LadderRung& rung : ladder()) {
        REQUIRE(is_of_ladder(rung.opponent));
        REQUIRE(rung.opponent <= most_opponent);
        const AiPlayer& player = ai_player(rung.opponent);
        CHECK(names.insert(player.name).second);
        CHECK(player.noise.bearing < errors);
        errors = player.noise.bearing;
        const Scene scene = shipped_level(std::string(rung.level), {std::string(rung.rules)});
        CHECK(scene.pool.race >= 2);
    }
    CHECK(names.size() == 7);
    for (int skill = least_skill; skill <= most_skill; ++skill) {
        CHECK(ai_player(skill).noise == shot_noise(skill));
        CHECK(ai_player(skill).style == PlayStyle{});
        CHECK_FALSE(is_of_ladder(skill));
    }
}

namespace {

struct Choices {
    int safeties = 0;
    int pots = 0;
    double speed = 0.0;  ///< mean of the pots, m/s
};

// What a style chooses in the positions of some frames that skill 2 plays, at each shot after the
// break.
Choices choices_of(const PlayStyle& style, const ShotNoise& noise) {
    Choices all;
    const Scene scene = shipped_level("eight-ball");
    const SolverSettings settings = pick_solver(scene.world).settings;
    for (std::uint32_t frame = 0; frame < 2; ++frame) {
        World world = scene.world;
        world.edit_definition().seed = 100 + frame;
        GameState game = *begin_pool(scene);
        Solver solver(settings);
        auto& play = std::get<PoolPlay>(game);
        for (int shot = 0; shot < 7 && play.rules.phase != PoolPhase::over; ++shot) {
            std::vector<Command> commands;
            if (play.rules.phase == PoolPhase::choosing) {
                commands = {command::Decide{choice_of(scene, world, play, noise)}};
            } else {
                const std::uint64_t seed = decision_seed(world, play);
                const auto best = [&](const PlayStyle& of) {
                    ShotPlanner planner(scene, world, play, settings, noise, seed, of);
                    while (!planner.is_done())
                        planner.work(ShotPlanner::most_tries);
                    return planner.best().front();
                };
                const CandidateShot chosen = best(style);
                using enum CandidateShot::Kind;
                if (chosen.kind == safety) ++all.safeties;
                if (chosen.kind != safety && chosen.kind != break_off && chosen.kind != push_out) {
                    ++all.pots;
                    all.speed += length(chosen.strike.velocity);
                }
                // The position goes on as without a style, so that all styles see the same ones.
                commands = commands_of(scene, play, best({}), noise, seed);
            }
            for (const Command& command : commands) {
                REQUIRE_FALSE(refusal(scene, world, game, command));
                execute(scene, world, game, command);
            }
            while (play.is_shooting) {
                solver.tick(world);
                update_game(scene, world, game, solver.contacts());
            }
        }
    }
    if (all.pots > 0) all.speed /= all.pots;
    return all;
}

}  // namespace

TEST_CASE(
    "styles: in the same positions the safe play more safeties than the bold, the fast hit "
    "harder") {
    const ShotNoise noise = shot_noise(2);
    const Choices even = choices_of({}, noise);
    const Choices safe = choices_of({.safety = 0.25, .risk = -0.2}, noise);
    const Choices bold = choices_of({.safety = -0.5, .risk = 0.35}, noise);
    const Choices fast = choices_of({.pace = 0.06}, noise);
    CHECK(safe.safeties >= even.safeties);
    CHECK(safe.safeties > bold.safeties);
    CHECK(bold.pots >= even.pots);
    CHECK(fast.speed > even.speed);
}

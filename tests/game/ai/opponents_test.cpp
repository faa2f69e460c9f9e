#include "game/ai/opponents.h"

#include <doctest/doctest.h>

#include <array>
#include <set>
#include <string_view>

#include "game/ai/planner.h"
#include "game/session/game_state.h"
#include "game/support/shipped.h"
#include "support/sanitizers.h"

using namespace carom;
using carom::test::has_sanitizers;
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
    void note(const CandidateShot& chosen) {
        using enum CandidateShot::Kind;
        if (chosen.kind == safety) ++safeties;
        if (chosen.kind == safety || chosen.kind == break_off || chosen.kind == push_out) return;
        ++pots;
        speeds += length(chosen.strike.velocity);
    }
    double speed() const { return pots > 0 ? speeds / pots : 0.0; }

    int safeties = 0;
    int pots = 0;
    double speeds = 0.0;  ///< sum over the pots, m/s
};

/// What each style chooses in the positions of some frames that skill 2 plays without a style, at
/// each shot after the break. The first style is that of the frames: none.
template <std::size_t count>
std::array<Choices, count> choices_of(const std::array<PlayStyle, count>& styles,
                                      const ShotNoise& noise) {
    REQUIRE(styles.front() == PlayStyle{});
    std::array<Choices, count> all;
    const Scene scene = shipped_level("eight-ball");
    const SolverSettings settings = pick_solver(scene.world).settings;
    for (std::uint32_t frame = 0; frame < (has_sanitizers ? 1 : 2); ++frame) {
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
                for (std::size_t i = 0; i < count; ++i) {
                    ShotPlanner planner(scene, world, play, settings, noise, seed, styles[i]);
                    while (!planner.is_done())
                        planner.work(ShotPlanner::most_tries);
                    const CandidateShot chosen = planner.best().front();
                    all[i].note(chosen);
                    if (i == 0) commands = commands_of(scene, play, chosen, noise, seed);
                }
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
    return all;
}

}  // namespace

TEST_CASE(
    "styles: in the same positions the safe play more safeties than the bold, the fast hit "
    "harder") {
    const ShotNoise noise = shot_noise(2);
    const auto [even, safe, bold, fast] =
        choices_of(std::array{PlayStyle{}, PlayStyle{.safety = 0.25, .risk = -0.2},
                              PlayStyle{.safety = -0.5, .risk = 0.35}, PlayStyle{.pace = 0.06}},
                   noise);
    CHECK(safe.safeties >= even.safeties);
    CHECK(safe.safeties > bold.safeties);
    CHECK(bold.pots >= even.pots);
    CHECK(fast.speed() > even.speed());
}

// With a hand that misses most pots she played safe every other time: no game for a beginner.
TEST_CASE("the first of the ladder goes for pots that a planner of her hand would leave") {
    const AiPlayer& first = ai_player(ladder().front().opponent);
    const auto [even, hers] = choices_of(std::array{PlayStyle{}, first.style}, first.noise);
    CHECK(hers.pots > even.pots);
    CHECK(hers.safeties < even.safeties);
}

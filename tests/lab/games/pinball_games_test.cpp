#include "lab/games/pinball_games.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "game/ai/demo_player.h"
#include "game/pinball/pinball.h"
#include "game/session/game_state.h"
#include "game/support/shipped.h"
#include "lab/support/first_timer.h"
#include "level/load.h"
#include "support/sanitizers.h"

using namespace carom;

namespace {

const std::vector<std::string> tables = test::pinball_tables();

Scene shipped(std::string_view table, std::string_view folder = "/levels/") {
    std::stringstream text;
    text << std::ifstream(std::string(CAROM_SOURCE_DIR).append(folder).append(table) + ".level")
                .rdbuf();
    LoadResult loaded = load_level(text.str(), table, {});
    REQUIRE(loaded.diagnostics.empty());
    return std::move(*loaded.scene);
}

/// Keeps a reference to the player.
PinballPlayer played_by(DemoPlayer& player) {
    return [&player](const Scene& scene, const World& world, const PinballState& state) {
        return player.play(scene, world, state);
    };
}

PinballGames play(const Scene& scene, std::uint64_t balls, const PinballPlayer& player) {
    return play_pinball(scene, pick_solver(scene.world).settings, balls, player);
}

/// Until `balls` have ended, or for so many seconds.
PinballGames play_demo(const Scene& scene, std::uint64_t balls, double seconds) {
    DemoPlayer player;
    PinballGames games = play_pinball(scene, pick_solver(scene.world).settings, balls,
                                      played_by(player), {}, seconds);
    games.shots_tried = player.shots().tried;
    games.shots_made = player.shots().made;
    return games;
}

/// The figures that no player may spoil.
void check_games(const Scene& scene, std::uint64_t balls, const PinballGames& games) {
    CHECK(scene.world.rate() >= 1000.0);
    CHECK(games.lost == 0);
    CHECK(games.outside == 0);
    CHECK(games.searches <= 1 + balls / 20);
    CHECK(games.seconds > 0.0);
}

PinballGames check_demo(std::string_view table, std::uint64_t balls, double seconds,
                        std::uint64_t seed = 0) {
    CAPTURE(table);
    Scene scene = shipped(table);
    if (seed > 0) scene.world.edit_definition().seed = seed;
    const PinballGames games = play_demo(scene, balls, seconds);
    check_games(scene, balls, games);
    return games;
}

PinballGames check_first_timer(std::string_view table, std::uint64_t balls,
                               std::uint64_t seed = 0) {
    CAPTURE(table);
    Scene scene = shipped(table);
    if (seed > 0) scene.world.edit_definition().seed = seed;
    const PinballGames games = play(scene, balls, test::FirstTimer{});
    CHECK(games.ball_times.size() == balls);
    check_games(scene, balls, games);
    return games;
}

}  // namespace

TEST_CASE("the shipped tables lose no ball: none stuck, none outside, all of them drained") {
#ifdef NDEBUG
    constexpr std::uint64_t balls = 10;
#else
    constexpr std::uint64_t balls = 4;  // with sanitizers, which are ten times slower
#endif
    for (const std::string& table : tables)
        check_first_timer(table, balls);
}

// Coarse bounds of what docs/pinball.md has measured with many balls.
TEST_CASE("a first-timer's ball lasts a while, and the demonstration player keeps it and aims") {
#ifdef NDEBUG
    constexpr std::uint64_t balls = 20;
    std::uint64_t tried = 0;
    std::uint64_t made = 0;
    for (const std::string& table : tables) {
        const PinballGames first = check_first_timer(table, balls);
        CHECK(mean_ball_time(first) > 25.0);
        CHECK(mean_ball_time(first) < 120.0);
        CHECK(share_under(first, 8.0) <= 0.05);
        CHECK(outlane_share(first) < 0.7);
        const PinballGames demo = check_demo(table, balls, 60.0);
        CHECK(demo.ball_times.size() <= 2);
        CHECK(demo.shots_tried >= 2);
        tried += demo.shots_tried;
        made += demo.shots_made;
    }
    // A minute of one table has too few shots to judge by.
    CHECK(2 * made > tried);
    MESSAGE("shots made: " << made << " of " << tried);
#endif
}

// Nobody touches a flipper.
TEST_CASE("no launch that reaches the table drains at once") {
    for (const std::string& table : tables) {
        CAPTURE(table);
        const Scene scene = shipped(table);
        for (int pull = 10; pull <= 20; ++pull) {
            CAPTURE(pull);
            World world = scene.world;
            GameState game = begin_game(scene);
            Solver solver(pick_solver(world).settings);
            const auto run = [&](double seconds) {
                const std::uint64_t until =
                    world.tick() + static_cast<std::uint64_t>(seconds * world.rate());
                while (world.tick() < until && world.ledger().removed.empty()) {
                    solver.tick(world);
                    update_game(scene, world, game, solver.contacts());
                }
            };
            run(0.6);
            pull_plunger(scene, world, std::get<PinballState>(game), 0.05 * pull, true);
            run(3.0);
            CHECK(world.ledger().removed.empty());
        }
    }
}

TEST_CASE("the manual's example table loads without diagnostics, and can be played") {
    const Scene scene = shipped("first-table", "/docs/");
    const std::uint64_t balls = test::has_sanitizers ? 1 : 5;
    CHECK(play(scene, balls, test::FirstTimer{}).ball_times.size() == balls);
    const PinballGames games = play_demo(scene, 5, test::has_sanitizers ? 5.0 : 20.0);
    CHECK(games.lost == 0);
    CHECK(games.outside == 0);
}

TEST_CASE("demo games are reproducible") {
    Scene scene = shipped("three-bumpers");
    const auto presses = [&] {
        std::vector<std::uint64_t> seen;
        DemoPlayer player;
        play_pinball(
            scene, pick_solver(scene.world).settings, 2,
            [&](const Scene& level, const World& world, const PinballState& state) {
                auto made = player.play(level, world, state);
                for (const command::Press& press : made) {
                    seen.push_back(world.tick());
                    seen.push_back(2 * static_cast<std::uint64_t>(press.button) + press.is_down);
                }
                return made;
            },
            {}, test::has_sanitizers ? 10.0 : 15.0);
        return seen;
    };
    const auto first = presses();
    CHECK(first.size() > 10);
    CHECK(presses() == first);
    scene.world.edit_definition().seed = 5;
    CHECK(presses() != first);
}

TEST_CASE("games are summarised in totals and histograms") {
    PinballGames games;
    games.scores = {100, 200, 200, 1300};
    games.ball_times = {1.0, 2.0, 30.0};
    games.drains = {1, 3, 0};
    games.seconds = 3600.0;
    const std::string text = pinball_games_text(games);
    CHECK(text.starts_with("balls 3, games 4, 1.0 hours of play\n"));
    CHECK(text.find("a ball lasts 11.0 s (median 2.0); 66.7 % last less than 8 s") !=
          std::string::npos);
    CHECK(text.find("(outlanes 25 %)") != std::string::npos);
    CHECK(text.find("      200       2 ####") != std::string::npos);
    CHECK(pinball_games_text({}).starts_with("balls 0"));
}

// With CAROM_PINBALL_FIGURES=FILE it writes its results there, and CAROM_BALLS sets the number of
// balls on each table: scripts/update pinball. CAROM_TABLE plays only that table, CAROM_SEED from
// another seed, CAROM_PLAYER=first or demo with that player alone, the latter for CAROM_SECONDS.
TEST_SUITE("long") {
    TEST_CASE("10,000 balls on each table, none stuck, none lost") {
        const char* const wanted = std::getenv("CAROM_BALLS");
        const char* const only = std::getenv("CAROM_TABLE");
        const char* const file = std::getenv("CAROM_PINBALL_FIGURES");
        const char* const wanted_seed = std::getenv("CAROM_SEED");
        const std::uint64_t seed = wanted_seed ? std::strtoull(wanted_seed, nullptr, 10) : 0;
        const std::uint64_t balls = wanted ? std::strtoull(wanted, nullptr, 10) : 10'000;
        // A demonstration player's ball may last for an hour.
        const char* const wanted_seconds = std::getenv("CAROM_SECONDS");
        const double seconds = wanted_seconds ? std::strtod(wanted_seconds, nullptr) : 20'000.0;
        const char* const player = std::getenv("CAROM_PLAYER");
        const auto plays = [&](std::string_view who) { return !player || player == who; };
        for (const std::string& table : tables) {
            if (only && table != only) continue;
            const auto write = [&](std::string_view player, const PinballGames& games) {
                if (file)
                    std::ofstream(file, std::ios::app)
                        << "\n## " << table << ", " << player << "\n\n```\n"
                        << pinball_games_text(games) << "```\n";
            };
            if (plays("first")) write("first-timer", check_first_timer(table, balls, seed));
            if (plays("demo"))
                write("demonstration player", check_demo(table, balls, seconds, seed));
        }
    }
}

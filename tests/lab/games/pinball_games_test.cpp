#include "lab/games/pinball_games.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>

#include "game/ai/demo_player.h"
#include "game/pinball/pinball.h"
#include "game/session/game_state.h"
#include "lab/support/first_timer.h"
#include "level/load.h"

using namespace carom;

namespace {

constexpr std::string_view tables[] = {"three-bumpers", "cable-car", "night-vault"};

Scene shipped(std::string_view table, std::string_view folder = "/levels/") {
    std::stringstream text;
    text << std::ifstream(std::string(CAROM_SOURCE_DIR).append(folder).append(table) + ".level")
                .rdbuf();
    LoadResult loaded = load_level(text.str(), table, {});
    REQUIRE(loaded.diagnostics.empty());
    return std::move(*loaded.scene);
}

PinballPlayer demo_player() {
    return [player = DemoPlayer{}](const Scene& scene, const World& world,
                                   const PinballState& state) mutable {
        return player.play(scene, world, state);
    };
}

PinballGames play(const Scene& scene, std::uint64_t balls, const PinballPlayer& player) {
    return play_pinball(scene, pick_solver(scene.world).settings, balls, player);
}

PinballGames check_table(std::string_view table, std::uint64_t balls, const PinballPlayer& player) {
    CAPTURE(table);
    const Scene scene = shipped(table);
    CHECK(scene.world.rate() >= 1000.0);
    const PinballGames games = play(scene, balls, player);
    CHECK(games.ball_times.size() == balls);
    CHECK(games.lost == 0);
    CHECK(games.outside == 0);
    CHECK(games.searches <= 1 + balls / 20);
    CHECK(games.seconds > 0.0);
    return games;
}

}  // namespace

TEST_CASE("the shipped tables lose no ball: none stuck, none outside, all of them drained") {
#ifdef NDEBUG
    constexpr std::uint64_t balls = 10;
#else
    constexpr std::uint64_t balls = 4;  // with sanitizers, which are ten times slower
#endif
    for (const std::string_view table : tables)
        check_table(table, balls, demo_player());
}

// Coarse bounds of what docs/pinball.md has measured with many balls.
TEST_CASE("a first-timer's ball lasts a while, and the demonstration player's longer") {
#ifdef NDEBUG
    constexpr std::uint64_t balls = 20;
    for (const std::string_view table : tables) {
        const PinballGames first = check_table(table, balls, test::FirstTimer{});
        CHECK(mean_ball_time(first) > 25.0);
        CHECK(mean_ball_time(first) < 120.0);
        CHECK(share_under(first, 8.0) <= 0.05);
        CHECK(outlane_share(first) < 0.7);
        const PinballGames demo = check_table(table, balls, demo_player());
        CHECK(mean_ball_time(demo) > 40.0);
        CHECK(share_under(demo, 8.0) <= 0.05);
    }
#endif
}

// Nobody touches a flipper.
TEST_CASE("no launch that reaches the table drains at once") {
    for (const std::string_view table : tables) {
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
                while (world.tick() < until && world.removed().empty()) {
                    solver.tick(world);
                    update_game(scene, world, game, solver.contacts());
                }
            };
            run(0.6);
            pull_plunger(scene, world, std::get<PinballState>(game), 0.05 * pull, true);
            run(3.0);
            CHECK(world.removed().empty());
        }
    }
}

TEST_CASE("the manual's example table loads without diagnostics, and can be played") {
    const Scene scene = shipped("first-table", "/docs/");
    const PinballGames games = play(scene, 5, demo_player());
    CHECK(games.ball_times.size() == 5);
    CHECK(games.lost == 0);
    CHECK(games.outside == 0);
}

TEST_CASE("demo games are reproducible") {
    const Scene scene = shipped("three-bumpers");
    const PinballGames first = play(scene, 2, demo_player());
    const PinballGames second = play(scene, 2, demo_player());
    CHECK(first.ball_times == second.ball_times);
    Scene other = scene;
    other.world.edit_definition().seed = 5;
    CHECK(play(other, 2, demo_player()).ball_times != first.ball_times);
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
// balls on each table: scripts/update pinball. CAROM_TABLE plays only that table.
TEST_SUITE("long") {
    TEST_CASE("10,000 balls on each table, none stuck, none lost") {
        const char* const wanted = std::getenv("CAROM_BALLS");
        const char* const only = std::getenv("CAROM_TABLE");
        const char* const file = std::getenv("CAROM_PINBALL_FIGURES");
        const std::uint64_t balls = wanted ? std::strtoull(wanted, nullptr, 10) : 10'000;
        for (const std::string_view table : tables) {
            if (only && table != only) continue;
            const auto write = [&](std::string_view player, const PinballGames& games) {
                if (file)
                    std::ofstream(file, std::ios::app)
                        << "\n## " << table << ", " << player << "\n\n```\n"
                        << pinball_games_text(games) << "```\n";
            };
            write("first-timer", check_table(table, balls, test::FirstTimer{}));
            write("demonstration player", check_table(table, balls, demo_player()));
        }
    }
}

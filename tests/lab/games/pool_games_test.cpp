#include "lab/games/pool_games.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>

#include "game/support/shipped.h"

using namespace carom;

namespace {

constexpr std::array<std::string_view, 6> games = {"eight-ball",    "nine-ball",  "ten-ball",
                                                   "straight-pool", "one-pocket", "snooker"};

PoolMatch play_match(std::string_view game, std::array<int, 2> skill, std::uint32_t frames) {
    const Scene scene = test::shipped_level(std::string(game));
    PoolMatch match{skill, {}};
    for (std::uint32_t number = 0; number < frames; ++number) {
        const PoolFrame frame =
            play_pool_frame(scene, pick_solver(scene.world).settings, skill, number);
        CAPTURE(number);
        CHECK_MESSAGE(!frame.refused, *frame.refused);
        match.frames.push_back(frame);
    }
    MESSAGE(pool_match_row(game, match));
    CHECK(frames_unfinished(match) == 0);
    return match;
}

}  // namespace

TEST_CASE("the confidence interval of a share of frames") {
    // Computed by hand from Wilson's formula.
    CHECK(likely_share(50, 100).low == doctest::Approx(0.40383).epsilon(1e-4));
    CHECK(likely_share(50, 100).high == doctest::Approx(0.59617).epsilon(1e-4));
    CHECK(likely_share(10, 10).low == doctest::Approx(0.72247).epsilon(1e-4));
    CHECK(likely_share(10, 10).high == doctest::Approx(1.0));
    CHECK(likely_share(0, 0).low == 0.0);
    CHECK(likely_share(0, 0).high == 1.0);
}

TEST_CASE("a match is reported in one row") {
    PoolMatch match{{4, 3}, {}};
    match.frames = {{0, 12, {1, 0}, 0, true, 60.0, std::nullopt},
                    {1, 20, {0, 2}, 1, false, 80.0, std::nullopt},
                    {0, 10, {0, 0}, 1, false, 50.0, std::nullopt},
                    {std::nullopt, 300, {0, 0}, 0, false, 900.0, std::nullopt}};
    CHECK(frames_won(match, 0) == 2);
    CHECK(frames_won(match, 1) == 1);
    CHECK(frames_unfinished(match) == 1);
    CHECK(pool_match_row("nine-ball", match) ==
          "| nine-ball | 4 against 3 | 4 | 2:1 | 67 % (21 to 94) | 85.5, 300 | 0.2 and 0.5 | "
          "67 % | 1 and 0 | 1 |\n");
    CHECK(pool_match_row("nine-ball", {{2, 1}, {}}).starts_with("| nine-ball | 2 against 1 | 0 |"));
}

TEST_CASE("straight pool is no exchange of fouls, and ends") {
    const Scene scene = test::shipped_level("straight-pool", {"game straightpool points=12"});
    const PoolFrame frame = play_pool_frame(scene, pick_solver(scene.world).settings, {4, 4}, 0);
    CHECK(!frame.refused);
    CHECK(frame.winner.has_value());
    CHECK(frame.shots < 100);
    CHECK(5 * (frame.fouls[0] + frame.fouls[1]) <= frame.shots);
}

// With CAROM_POOL_FIGURES=FILE it writes the results of neighbouring skills there, CAROM_FRAMES
// sets the number of frames of each pair, and CAROM_POOL_GAME=LEVEL plays that game alone:
// scripts/update pool.
TEST_SUITE("long") {
    TEST_CASE("frames end, and the more skilled of two opponents wins more") {
        for (const std::string_view game : games)
            for (const std::array<int, 2> skill : {std::array{4, 2}, std::array{3, 1}}) {
                const PoolMatch match = play_match(game, skill, 12);
                CHECK(frames_won(match, 0) > frames_won(match, 1));
            }
    }

    TEST_CASE("a frame is reproducible, and each number gives another one") {
        const Scene scene = test::shipped_level("nine-ball");
        const SolverSettings solver = pick_solver(scene.world).settings;
        const PoolFrame one = play_pool_frame(scene, solver, {4, 4}, 1);
        const PoolFrame again = play_pool_frame(scene, solver, {4, 4}, 1);
        CHECK(one.seconds == again.seconds);
        CHECK(one.shots == again.shots);
        CHECK(play_pool_frame(scene, solver, {4, 4}, 3).seconds != one.seconds);
    }

    TEST_CASE("neighbouring opponents") {
        const char* const wanted = std::getenv("CAROM_FRAMES");
        const char* const file = std::getenv("CAROM_POOL_FIGURES");
        const char* const only = std::getenv("CAROM_POOL_GAME");
        const auto frames =
            static_cast<std::uint32_t>(wanted ? std::strtoul(wanted, nullptr, 10) : 2);
        std::string table = pool_match_head();
        for (const std::string_view game : games)
            for (const std::array<int, 2> skill :
                 {std::array{2, 1}, std::array{3, 2}, std::array{4, 3}}) {
                if (only && game != only) continue;
                const PoolMatch match = play_match(game, skill, frames);
                table += pool_match_row(game, match);
                constexpr std::uint32_t enough = 100;
                if (frames >= enough) CHECK(frames_won(match, 0) > frames_won(match, 1));
            }
        if (file) std::ofstream(file, std::ios::app) << "\n" << table;
    }
}

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "game/support/shipped.h"
#include "game/support/shots_game.h"
#include "physics/world/random.h"
#include "support/sanitizers.h"

// The games that ship as text: each can be played to its end, and judges as its words say.

using namespace carom;
using carom::test::has_sanitizers;
using carom::test::named;
using carom::test::shipped_level;
using carom::test::ShotsGame;

namespace {

constexpr double pi = 3.14159265358979323846;

// A number of 0 to 1 by game and shot.
double part(std::uint64_t game, std::uint64_t shot, std::uint64_t which) {
    return static_cast<double>(random_bits(game, RandomStream::player, shot, which) >> 11) *
           0x1p-53;
}

command::Strike strike_of(const ShotsGame& game, BallId ball, double degrees, double share) {
    const double speed = share * cue_in_turn(game.session.scene(), game.state()).most_power;
    const double angle = degrees * pi / 180.0;
    return command::Strike{ball, {speed * std::cos(angle), speed * std::sin(angle)}};
}

// A shot in any direction, with any of the balls that the player may strike.
command::Strike wild_shot(const ShotsGame& game, std::uint64_t seed) {
    const std::uint32_t shot = game.state().shots;
    const std::vector<BallId> balls = cue_balls_of(game.session.scene(), game.state());
    REQUIRE_FALSE(balls.empty());
    const auto pick =
        static_cast<std::size_t>(part(seed, shot, 2) * static_cast<double>(balls.size()));
    return strike_of(game, balls[pick], 360.0 * part(seed, shot, 0),
                     0.1 + 0.9 * part(seed, shot, 1));
}

void play_to_end(ShotsGame& game, std::uint64_t seed, int most_shots) {
    for (int shot = 0; shot < most_shots && !game.state().is_over; ++shot)
        game.shoot(wild_shot(game, seed));
    REQUIRE(game.state().is_over);
}

// A strike of `ball` after which `wanted` holds; none in 720 directions.
template <typename Wanted>
std::optional<command::Strike> search(ShotsGame& game, BallId ball, double share, Wanted wanted) {
    for (int half = 0; half < 720; ++half) {
        const command::Strike strike = strike_of(game, ball, half * 0.5, share);
        if (wanted(game.after(strike))) return strike;
    }
    return std::nullopt;
}

bool says(const ShotsState& state, std::string_view text) {
    return state.message.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("each game of shots that ships comes to its end, whatever is shot") {
    struct Case {
        const char* level;
        int most_shots;
        std::vector<std::string> changes{};
    };
    for (const Case& row :
         {Case{"three-cushion", 1000, {"let target=1"}}, Case{"mini-golf", 200},
          Case{"windmill", 1000}, Case{"straight-rail", 200}, Case{"cushion-caroms", 200},
          Case{"bumper-pool", 200}, Case{"skittles", 36}}) {
        CAPTURE(row.level);
        const Scene scene = shipped_level(row.level, row.changes);
        for (std::uint64_t seed = 0; seed < (has_sanitizers ? 1 : 3); ++seed) {
            CAPTURE(seed);
            ShotsGame game(scene);
            play_to_end(game, seed, row.most_shots);
            if (game.state().players.size() > 1) {
                const bool is_tie = game.score(0) == game.score(1);
                CHECK((game.state().winner == std::nullopt) == is_tie);
            }
            // Where there is but one ball, it ends in the hole.
            if (scene.world.balls().size() > 1) CHECK(game.session.world().balls().size() >= 1);
        }
    }
}

TEST_CASE("caroms: nobody scores in the last inning, and the game is a tie") {
    for (const char* level : {"straight-rail", "cushion-caroms"}) {
        CAPTURE(level);
        ShotsGame game(shipped_level(level, {"let last=1"}));
        game.shoot_softly();
        CHECK(game.state().rules.player == 1);
        game.shoot_softly();
        REQUIRE(game.state().is_over);
        CHECK(game.state().winner == std::nullopt);
    }
}

TEST_CASE("caroms: who gets there first leaves the other the last inning") {
    for (const char* level : {"straight-rail", "cushion-caroms"}) {
        CAPTURE(level);
        ShotsGame game(shipped_level(level, {"let target=1"}));
        const auto scores = [](std::size_t player) {
            return [player](const ShotsState& state) { return state.players[player].score == 1; };
        };
        const auto first =
            search(game, *cue_ball_of(game.session.scene(), game.state()), 0.6, scores(0));
        REQUIRE(first);
        game.shoot(*first);
        CHECK(game.state().rules.player == 1);
        REQUIRE_FALSE(game.state().is_over);
        const auto second =
            search(game, *cue_ball_of(game.session.scene(), game.state()), 0.6, scores(1));
        REQUIRE(second);
        game.shoot(*second);
        REQUIRE(game.state().is_over);
        CHECK(game.state().winner == std::nullopt);
    }
}

TEST_CASE("straight rail: the fourth point in a row in one corner is a foul") {
    // Both other balls lie in a corner, frozen to nothing, and the white is beside them.
    ShotsGame game(shipped_level("straight-rail", {"let c=3000"}));  // all of the table is a corner
    int points = 0;
    for (int shot = 0; shot < 4; ++shot) {
        const auto good =
            search(game, *cue_ball_of(game.session.scene(), game.state()), 0.5,
                   [&](const ShotsState& state) {
                       return state.players[0].score > points || says(state, "a fourth point");
                   });
        REQUIRE(good);
        game.shoot(*good);
        if (game.score(0) > points) ++points;
    }
    CHECK(points == 3);
    CHECK(game.state().players[0].fouls == 1);
    CHECK(says(game.state(), "a fourth point in one corner"));
    CHECK(game.state().rules.player == 1);
}

TEST_CASE("bumper pool: the marked ball goes first, and a ball of the other side comes back") {
    ShotsGame game(shipped_level("bumper-pool"));
    const Scene& scene = game.session.scene();
    const BallId ace = named(scene, "redace");
    const std::vector<BallId> mine = cue_balls_of(scene, game.state());
    REQUIRE(mine.size() == 5);
    CHECK(game.session.apply(command::Strike{named(scene, "whiteace"), {1.0, 0.0}}));

    game.shoot(command::Strike{mine[1], {0.1, 0.0}});
    CHECK(game.state().message == "No ball fell.");
    REQUIRE(game.session.undo());

    const auto foul = search(game, mine[1], 0.8, [](const ShotsState& state) {
        return says(state, "the marked ball goes first");
    });
    REQUIRE(foul);
    game.shoot(*foul);
    CHECK(game.count_kind("red") == 5);
    CHECK(game.score(0) == 0);
    CHECK(game.state().players[0].fouls == 1);
    CHECK(game.state().rules.player == 1);
    REQUIRE(game.session.undo());

    const auto good = search(game, ace, 0.6, [](const ShotsState& state) {
        return state.players[0].score == 1 && state.players[0].fouls == 0;
    });
    REQUIRE(good);
    game.shoot(*good);
    CHECK(game.count_kind("red") == 4);
    CHECK(game.state().rules.player == 0);
    CHECK(cue_balls_of(scene, game.state()).size() == 4);
}

TEST_CASE("skittles: fallen pins count and go, and all nine are set up again") {
    ShotsGame game(shipped_level("skittles"));
    CHECK(game.state().is_in_hand);
    game.shoot(Vec2{8.0, 0.0});
    const std::int64_t fell = game.score(0);
    CHECK(fell > 0);
    CHECK(game.count_kind("pin") == 9 - fell);
    CHECK(game.state().is_in_hand);
    game.shoot(Vec2{0.0, 8.0});  // into the gutter
    CHECK(game.score(0) == fell);
    CHECK(game.state().players[0].fouls == 1);
    CHECK(game.state().rules.player == 0);
    game.shoot(Vec2{8.0, 0.3});
    CHECK(game.state().rules.player == 1);
    CHECK(game.count_kind("pin") == 9);
}

TEST_CASE("mini-golf: nine holes, at most seven strokes each, for one player or two") {
    for (const int players : {1, 2}) {
        CAPTURE(players);
        ShotsGame game(shipped_level("mini-golf",
                                     {"game shots wins=least players=" + std::to_string(players)}));
        play_to_end(game, 1, players * 9 * 7);
        for (int player = 0; player < players; ++player) {
            CHECK(game.state().players[static_cast<std::size_t>(player)].innings == 9);
            CHECK(game.score(static_cast<std::size_t>(player)) >= 9);
        }
        CHECK(goal_state(game.session.game())->done);
    }
}

TEST_CASE("mini-golf: a hole in one leads to the next hole") {
    ShotsGame game(shipped_level("mini-golf"));
    game.shoot(Vec2{1.6, 0.0});
    CHECK(game.score(0) == 1);
    CHECK(says(game.state(), "hole 1: in one!"));
    CHECK(task_text(game.session.scene(), game.session.world(), game.session.game()) ==
          "HOLE 2  PAR 2  STROKE 1");
    const auto hole = box_to_look_at(game.session.scene(), game.state());
    REQUIRE(hole);
    CHECK(hole->low.x > 3.0);
    const auto ball = cue_ball_of(game.session.scene(), game.state());
    REQUIRE(ball);
    const World& world = game.session.world();
    CHECK(world.balls().position[*index_of(world, *ball)].x == doctest::Approx(3.8));
}

// With CAROM_GAMES_FIGURES=FILE it writes what became of the games there.
TEST_SUITE("long") {
    TEST_CASE("a hundred games of each game of shots end, with fouls and ties among them") {
        struct Case {
            const char* level;
            int most_shots;
            std::vector<std::string> changes;
        };
        const char* const file = std::getenv("CAROM_GAMES_FIGURES");
        int all_ties = 0;
        for (const Case& row :
             {Case{"three-cushion", 4000, {"let target=3"}}, Case{"straight-rail", 400, {}},
              Case{"cushion-caroms", 400, {}}, Case{"bumper-pool", 400, {}},
              Case{"skittles", 36, {}}, Case{"mini-golf", 200, {}}, Case{"windmill", 1000, {}}}) {
            CAPTURE(row.level);
            const Scene scene = shipped_level(row.level, row.changes);
            int ties = 0;
            std::uint32_t shots = 0;
            std::uint32_t fouls = 0;
            for (std::uint64_t seed = 0; seed < 100; ++seed) {
                CAPTURE(seed);
                ShotsGame game(scene);
                play_to_end(game, seed, row.most_shots);
                const std::vector<ShotsState::Player>& players = game.state().players;
                for (const ShotsState::Player& player : players) {
                    shots += player.shots;
                    fouls += player.fouls;
                }
                if (players.size() > 1 && !game.state().winner) ++ties;
            }
            all_ties += ties;
            const std::string line = std::string(row.level) + ": 100 games, " +
                                     std::to_string(shots) + " shots, " + std::to_string(fouls) +
                                     " fouls, " + std::to_string(ties) + " ties\n";
            MESSAGE(line);
            if (file) std::ofstream(file, std::ios::app) << line;
        }
        CHECK(all_ties > 0);
    }
}

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "game/support/shipped.h"
#include "game/support/shots_game.h"

// The puzzles that ship can be solved: puzzle_solutions.txt has the shots, as lines of a velocity
// (m/s), side and follow (radii) below the name of the level.

using namespace carom;
using carom::test::shipped_level;
using carom::test::ShotsGame;

namespace {

struct Solution {
    std::string level;
    std::vector<command::Strike> shots;  ///< without the ball
};

std::vector<Solution> solutions() {
    std::ifstream file(std::filesystem::path(CAROM_SOURCE_DIR) /
                       "tests/game/shots/puzzle_solutions.txt");
    std::vector<Solution> all;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        if (line.starts_with(' ')) {
            command::Strike strike{};
            char comma = 0;
            words >> strike.velocity.x >> comma >> strike.velocity.y >> strike.side >>
                strike.follow;
            REQUIRE(words);
            all.back().shots.push_back(strike);
        } else {
            all.push_back({line, {}});
        }
    }
    return all;
}

void strike(ShotsGame& game, command::Strike shot) {
    const auto cue = cue_ball_of(game.session.scene(), game.state());
    REQUIRE(cue);
    shot.ball = *cue;
    game.shoot(shot);
}

}  // namespace

TEST_CASE("each puzzle is solved by its recorded shots, for three stars") {
    const std::vector<Solution> all = solutions();
    REQUIRE(all.size() == 20);
    double before = 0.0;
    for (const Solution& solution : all) {
        CAPTURE(solution.level);
        ShotsGame game(shipped_level(solution.level));
        for (const command::Strike& shot : solution.shots)
            strike(game, shot);
        CHECK(game.state().is_over);
        CHECK(stars_of(game.session.game()) == most_stars);
        const double par = game.session.scene().rules.goals.front().limits.front();
        CHECK(static_cast<double>(solution.shots.size()) <= par);
        CHECK(par >= before);
        before = par;
    }
}

TEST_CASE("puzzles: two shots more than par are the last, and a scratch ends the attempt") {
    const Solution first = solutions().front();
    ShotsGame game(shipped_level(first.level));
    const auto wasted = [] { return command::Strike{BallId{}, {0.0, -0.3}}; };
    strike(game, wasted());
    strike(game, wasted());
    CHECK_FALSE(game.state().is_over);
    strike(game, wasted());
    CHECK(game.state().is_over);
    CHECK(stars_of(game.session.game()) == 0);
    REQUIRE(game.session.undo());
    CHECK_FALSE(game.state().is_over);
    REQUIRE(game.session.undo());
    REQUIRE(game.session.undo());
    strike(game, first.shots.front());
    CHECK(game.state().is_over);
    CHECK(stars_of(game.session.game()) == 3);
}

#include "game/ai/planner.h"

#include <doctest/doctest.h>

#include "game/pool/pool_words.h"
#include "game/support/shipped.h"
#include "physics/world/fingerprint.h"

using namespace carom;
using carom::test::shipped_level;

namespace {

// Two AI players at one table.
struct Duel {
    explicit Duel(const std::string& level)
        : scene(shipped_level(level)),
          world(scene.world),
          game(*begin_pool(scene)),
          settings(pick_solver(world).settings),
          solver(settings) {}

    PoolPlay& play() { return std::get<PoolPlay>(game); }

    // Plays one decision of the player whose turn it is, to its outcome.
    void turn(const ShotNoise& error) {
        if (play().rules.phase == PoolPhase::choosing) {
            execute(scene, world, game, command::Decide{choice_of(scene, world, play(), error)});
            return;
        }
        const std::uint64_t seed = decision_seed(world, play());
        ShotPlanner planner(scene, world, play(), settings, error, seed);
        while (!planner.is_done())
            planner.work(1000);
        for (const Command& command :
             commands_of(scene, play(), planner.best().front(), error, seed)) {
            const auto why_not = refusal(scene, world, game, command);
            CAPTURE(candidate_text(scene, planner.best().front()));
            REQUIRE_MESSAGE(!why_not, *why_not);
            execute(scene, world, game, command);
        }
        while (play().is_shooting) {
            solver.tick(world);
            update_game(scene, world, game, solver.contacts());
        }
    }

    Scene scene;
    World world;
    GameState game;
    SolverSettings settings;
    Solver solver;
};

}  // namespace

TEST_CASE("the AI player pockets a straight ball, and announces it") {
    Duel duel("eight-ball");
    PoolPlay& play = duel.play();
    play.rules.phase = PoolPhase::playing;
    play.rules.in_hand = CueInHand::no;
    const auto put = [&](int ball, Vec2 place) {
        duel.world.edit_balls()
            .position[*index_of(duel.world, *play.balls[static_cast<std::size_t>(ball)])] = place;
    };
    put(3, {1.0, 0.4});
    put(0, {0.85, 0.269});
    const ShotNoise error = shot_noise(3);
    ShotPlanner planner(duel.scene, duel.world, play, duel.settings, error, 1);
    while (!planner.is_done())
        planner.work(1000);
    REQUIRE_FALSE(planner.best().empty());
    const CandidateShot& best = planner.best().front();
    CHECK(best.ball == 3);
    CHECK(best.call == PoolCall{PoolCall::Kind::pot, 3, best.pocket});
    CHECK(pocket_name(duel.scene, best.pocket) == "top right");
    CHECK(best.success > 0.7);
    CHECK(candidate_text(duel.scene, best).find("the 3") != std::string::npos);
    duel.turn(error);
    CHECK(is_down(play.rules, 3));
    CHECK(play.rules.player == 0);
}

TEST_CASE("a pot that is not expected to fall is announced as the safety that it is") {
    const Scene scene = shipped_level("snooker");
    CandidateShot shot;
    shot.kind = CandidateShot::Kind::bank;
    shot.ball = 1;
    shot.strike.velocity = {2.0, 0.0};
    shot.success = 0.1;
    CHECK(candidate_text(scene, shot).starts_with("bank a red into"));
    CHECK(candidate_text(scene, shot).find("9 % chance to continue") != std::string::npos);
    // "100 %", and the ball stayed up: one shot in twenty.
    shot.success = 1.0;
    CHECK(candidate_text(scene, shot).find("93 % chance to continue") != std::string::npos);
    shot.success = 0.0;
    CHECK(candidate_text(scene, shot) == "safety on a red, 2.0 m/s");
}

TEST_CASE("the division of the planner's work does not change its decision") {
    Duel duel("nine-ball");
    const ShotNoise error = shot_noise(2);
    duel.turn(error);
    if (duel.play().rules.phase == PoolPhase::choosing) duel.turn(error);
    const auto think = [&](int piece) {
        ShotPlanner planner(duel.scene, duel.world, duel.play(), duel.settings, error, 5);
        int tries = 0;
        while (!planner.is_done()) {
            planner.work(piece);
            tries += piece;
        }
        CHECK(tries <= ShotPlanner::most_tries + piece);
        return planner.best();
    };
    const auto one = think(1);
    const auto many = think(1000);
    REQUIRE(one.size() == many.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        CHECK(one[i].strike.velocity == many[i].strike.velocity);
        CHECK(one[i].value == many[i].value);
    }
}

TEST_CASE("the AI player chooses when the rules ask it to") {
    Duel duel("eight-ball");
    PoolPlay& play = duel.play();
    play.rules.phase = PoolPhase::choosing;
    play.rules.choices = {PoolChoice::spot_eight, PoolChoice::break_again};
    CHECK(choice_of(duel.scene, duel.world, play, {}) == PoolChoice::spot_eight);
}

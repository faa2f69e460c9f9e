#include "lab/run/rule_log.h"

#include <doctest/doctest.h>

#include "game/shots/shots.h"
#include "level/load.h"
#include "physics/solver.h"

using namespace carom;

TEST_CASE("the log of the rules has what changed, when, and what was said") {
    const Scene scene = *load_level(
                             "carom 1 \"Log\"\n"
                             "units mm\n"
                             "use cloth slide=0.2 roll=0.02 spin=10rad/s2\n"
                             "box 0,0 1400,700 r=10\n"
                             "ball white at=300,350 r=30 m=210g\n"
                             "cue ball=white power=0..6m/s\n"
                             "game shots players=2\n"
                             "var rails of shot\n"
                             "var tries of player\n"
                             "on shot begins  tries +1\n"
                             "on cue rail if rails<1  rails +1\n"
                             "on cue rail if rails=1  score 0\n"
                             "on cue rail unless rails  score 0\n"
                             "on shot ends  score rails, message \"{rails rail|rails}\", turn\n"
                             "on shot judged if shots=3  end\n",
                             "log.level", {})
                             .scene;
    World world = scene.world;
    GameState game = begin_game(scene);
    Solver solver({.kind = SolverKind::event});
    RuleLog log;
    CHECK(log.line(scene, world, game).empty());
    std::string text;
    const auto run = [&] {
        do {
            solver.tick(world);
            update_game(scene, world, game, solver.contacts());
            text += log.line(scene, world, game);
        } while (std::get<ShotsState>(game).is_shooting);
    };
    run();
    CHECK(text.empty());
    execute(scene, world, game, command::Strike{BallId{0}, {-1.0, 0.0}});
    run();
    CAPTURE(text);
    CHECK(text.starts_with("tick 2, 0.017 s: tries1 1, shots 1\n"));
    CHECK(text.find(" s: rails 1; line 12 tested rails at 0; line 13 tested rails at 0\n") !=
          std::string::npos);
    CHECK(text.find(" s: player 2, score1 1, \"1 rail\"\n") != std::string::npos);
}

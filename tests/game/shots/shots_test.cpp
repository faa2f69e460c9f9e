#include "game/shots/shots.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "game/session/forecast.h"
#include "game/session/session.h"
#include "game/shots/shots_play.h"
#include "game/support/shipped.h"
#include "game/support/shots_game.h"
#include "level/load.h"

using namespace carom;
using carom::test::shipped_level;
using carom::test::ShotsGame;

namespace {

// A small table: one ball a player strikes, a red ball to its right, a pocket behind that.
constexpr const char* table = R"(carom 1 "Shots"
units mm
use cloth slide=0.2 roll=0.02 spin=10rad/s2
kind ivory r=30 m=210g e=0.95
material rubber e=0.85
box rubber 0,0 1400,700 r=10
pocket hole at=1350,350 r=60
ball white at=300,350 kind=ivory
ball red at=900,350 kind=ivory
cue ball=white power=0..6m/s
)";

Scene scene_of(const std::string& rules) {
    LoadResult loaded = load_level(table + rules, "shots.level", {});
    for (const Diagnostic& diagnostic : loaded.diagnostics)
        INFO(diagnostic.message);
    REQUIRE(loaded.scene);
    return std::move(*loaded.scene);
}

struct Game : ShotsGame {
    using ShotsGame::ShotsGame;
    explicit Game(const std::string& rules) : ShotsGame(scene_of(rules)) {}
};

}  // namespace

TEST_CASE("shots: a score, a turn, a foul and an end") {
    Game game(R"(game shots players=2
var hits of shot
on cue hit red  hits +1
on shot ends if hits  score 2, message "hit {hits}"
on shot ends unless hits  foul "no hit", turn
on shot judged if score>=4  win
)");
    game.shoot({1.5, 0.0});
    CHECK(game.score(0) == 2);
    CHECK(game.state().message == "hit 1");
    CHECK(game.state().rules.player == 0);
    game.shoot_softly();
    CHECK(game.state().message == "foul: no hit");
    CHECK(game.state().players[0].fouls == 1);
    CHECK(game.state().rules.player == 1);
    CHECK(game.state().players[1].innings == 1);
}

TEST_CASE("shots: conditions are tested before any action of the same event") {
    Game game(R"(game shots
var a
on shot ends if a=0  a 1, score 1
on shot ends if a=1  score 100
on shot judged if a=1  score 10
on shot ends if score>1000  end
)");
    game.shoot_softly();
    CHECK(game.score(0) == 11);
}

TEST_CASE("shots: a tick carries out a thousand actions, and counts the rest") {
    std::string rules = "game shots\non shot ends if score>5000  end\n";
    for (int i = 0; i < 1002; ++i)
        rules += "on shot ends  score 1\n";
    Game game(rules);
    game.shoot_softly();
    CHECK(game.score(0) == std::int64_t{most_actions_in_a_tick});
    CHECK(game.state().rules.left_out == 2);
    CHECK(game.state().rules.first_left_out == game.session.world().tick());
}

TEST_CASE("shots: variables of a shot, a turn, a player and a game start again on time") {
    Game game(R"(game shots players=2
var s of shot
var t of turn
var p of player
var g of game start=5
on shot ends  s +1, t +1, p +1, g +1
on shot ends if p=1  turn
on shot judged if g>100  end
on shot judged  message "{s} {t} {p} {g}"
)");
    game.shoot_softly();  // the condition p=1 is tested before p changes
    CHECK(game.state().message == "1 1 1 6");
    game.shoot_softly();
    CHECK(game.state().message == "1 2 2 7");
    CHECK(game.state().rules.player == 1);
    game.shoot_softly();
    CHECK(game.state().message == "1 1 1 8");
}

TEST_CASE("shots: a ball that lies at a cushion has hit it once") {
    Game game(R"(game shots
var rails of shot
on cue rail  rails +1
on shot ends  score rails
on shot judged if score>100  end
)");
    game.shoot({0.0, 1.3});  // up, and back down
    CHECK(game.score(0) >= 1);
    CHECK(game.score(0) <= 3);
}

TEST_CASE("shots: a pocketed cue ball returns, and a respotted ball lies where it began") {
    Game game(R"(game shots
on red pocketed hole  score 5
on shot ends if count(red)=0  respot red
on cue pocketed  foul "in the hole"
on shot judged if score>100  end
)");
    game.shoot({2.5, 0.0});
    CHECK(game.score(0) == 5);
    const World& world = game.session.world();
    CHECK(world.balls().size() == 2);
    CHECK(world.balls().position[*index_of(world, *game.state().balls[1])].x ==
          doctest::Approx(0.9));
    REQUIRE(cue_ball_of(game.session.scene(), game.state()));
}

TEST_CASE("shots: wins=least, a tie, and who wins by win or lose") {
    const auto play = [](const std::string& rules) {
        Game game("game shots players=2 wins=least\n" + rules);
        game.shoot_softly();
        game.shoot_softly();
        REQUIRE(game.state().is_over);
        return game.state().winner;
    };
    const std::string both = "on shot ends  turn\non shot judged if player=2  end\n";
    CHECK(play("on shot ends  score player\n" + both) == std::optional<std::uint32_t>(0));
    CHECK(play("on shot ends  score 3-player\n" + both) == std::optional<std::uint32_t>(1));
    CHECK(play("on shot ends  score 1\n" + both) == std::nullopt);
    const std::string second = "on shot ends  turn\non shot judged if player=2  ";
    CHECK(play(second + "win\n") == std::optional<std::uint32_t>(1));
    CHECK(play(second + "lose\n") == std::optional<std::uint32_t>(0));
}

TEST_CASE("shots: a timer ends a turn, and a goal has stars") {
    Game game(R"(game shots players=2
timer patience 1s
var late
on turn begins if late=0  start patience
on patience ends  late 1, foul "too slow", turn
goal "Be late, then shoot." within 1 2 3 shots if late and shots>=1
)");
    CHECK(seconds_left(game.state().rules,
                       ShotsAnswers(game.session.scene(), game.session.world(), game.state()),
                       0) == 1);
    for (int i = 0; i < 2 * game.session.world().rate(); ++i)
        game.session.step_forward();
    CHECK(game.state().rules.player == 1);
    CHECK(game.state().players[0].fouls == 1);
    CHECK(stars_of(game.session.game()) == 0);
    game.shoot_softly();
    CHECK(stars_of(game.session.game()) == 3);
}

TEST_CASE("shots: only the cue of the player whose turn it is moves anything") {
    Game game("game shots\non shot ends if shots>5  end\n");
    const World& world = game.session.world();
    const BallId red = *game.state().balls[1];
    CHECK(game.session.apply(command::Strike{red, {1.0, 0.0}}));
    CHECK(game.session.apply(command::PlaceBall{red, {0.5, 0.5}}));
    CHECK(game.session.apply(command::RemoveBall{red}));
    CHECK(game.session.apply(command::Strike{*game.state().balls[0], {7.0, 0.0}}));
    CHECK(world.balls().size() == 2);
}

TEST_CASE("shots: undone and played again, a game has the same fingerprint") {
    Game game(shipped_level("three-cushion"));
    const auto mark = [&] { return fingerprint(game.session.world(), game.session.game()); };
    const std::uint64_t before = mark();
    game.shoot({6.0, 0.35});
    const std::uint64_t after = mark();
    const std::string message = game.state().message;
    CHECK_FALSE(message.empty());
    REQUIRE(game.session.undo());
    CHECK(game.state().message.empty());
    CHECK(mark() == before);
    game.shoot({6.0, 0.35});
    CHECK(mark() == after);
    CHECK(game.state().message == message);
}

TEST_CASE("three-cushion: shots score as their contacts say, and say why not") {
    const Scene scene = shipped_level("three-cushion", {"let opening=0"});
    Game game(scene);
    int points = 0;
    int misses = 0;
    for (int degrees = 0; degrees < 360; degrees += 3) {
        const double angle = degrees * 3.14159265358979323846 / 180.0;
        Solver solver(game.session.solver());
        const Forecast ahead = forecast(
            scene, game.session.world(), game.session.game(), solver,
            command::Strike{*game.state().balls[0], {5 * std::cos(angle), 5 * std::sin(angle)}},
            60.0, Tracks::none);
        const auto& state = std::get<ShotsState>(ahead.game);
        CAPTURE(degrees);
        REQUIRE_FALSE(state.is_shooting);
        const bool has_point = state.players[0].score == 1;
        CHECK(state.rules.player == (has_point ? 0u : 1u));
        CHECK((state.message.find("a point") != std::string::npos) == has_point);
        CHECK((state.message.find("No point: ") != std::string::npos) == !has_point);
        points += has_point;
        misses += !has_point;
    }
    CHECK(points > 0);
    CHECK(misses > points);
}

TEST_CASE("shots: rules start and stop motions, and undo takes that back") {
    Game game(R"(edge rubber gate r=5 1200,300 1200,400
edge rubber door r=5 1100,20 1100,60
motion slide gate by=0,200 every=1s stops=2 waits
motion swing door about=1100,20 by=80deg every=1s
game shots
on shot begins  start gate, stop door
on shot ends    start door
on cue pocketed  end
)");
    const auto movers = [&] { return game.session.world().movers(); };
    CHECK_FALSE(movers()[0].runs);
    CHECK(movers()[1].runs);
    const World before = game.session.world();
    game.shoot_softly();
    // The shot takes longer than the half second to the gate's first stop.
    CHECK(movers()[0].clock == 0.5);
    CHECK_FALSE(movers()[0].runs);
    CHECK(movers()[1].runs);
    CHECK(movers()[1].clock < 0.2);
    REQUIRE(game.session.undo());
    while (game.session.world().tick() > before.tick())
        REQUIRE(game.session.step_back());
    CHECK(movers() == before.movers());
}

TEST_CASE("shots: count in a zone, remove inside and outside of it, and it") {
    Game game(R"(game shots
zone right 900,350 900,350 r=100
zone left 300,350 300,350 r=20
var there of shot
on shot begins  there count(red,right)+10*count(ball,left)
on red rail  remove it
on shot ends  message "{there}", remove cue inside left, remove ball outside right
on shot judged if count(ball)=0  end
)");
    game.shoot({0.0, 0.5});
    CHECK(game.state().message == "11");
    // The white lay outside of the right zone, so it returned to its start; the red stays.
    CHECK(game.session.world().balls().size() == 2);
    CHECK(game.count_kind("ivory") == 2);
}

TEST_CASE("shots: a cue over a kind lets the player choose, and cue is the ball that was struck") {
    Game game(R"(game shots players=2
kind team r=25 m=150g e=0.9
ball one kind=team at=300,150
ball two kind=team at=600,150
cue ball=team power=0..6m/s
var rails of shot
on cue rail  rails +1
on one rail  rails +10
on shot ends  message "{rails}", turn
on shot judged if shots>9  end
)");
    game.shoot_softly();
    const std::vector<BallId> team = cue_balls_of(game.session.scene(), game.state());
    REQUIRE(team.size() == 2);
    CHECK(game.session.apply(command::Strike{*game.state().balls[0], {1.0, 0.0}}));
    game.shoot(command::Strike{team[1], {0.0, -0.6}});
    CHECK(game.state().message == "1");
    CHECK(game.state().rules.player == 0);
    game.shoot_softly();
    game.shoot(command::Strike{team[0], {0.0, -0.6}});
    CHECK(game.state().message == "11");
}

TEST_CASE("shots: a shot is judged once the balls have lain still for the time of settle=") {
    const std::string rules = "on shot ends  score 1\non shot judged if shots=9  end\n";
    Game game("game shots settle=0.5s\n" + rules);
    Game quick("game shots\n" + rules);
    const auto ticks_of = [](Game& played) {
        const std::uint64_t before = played.session.world().tick();
        played.shoot_softly();
        return played.session.world().tick() - before;
    };
    const double rate = game.session.world().rate();
    CHECK(static_cast<double>(ticks_of(game) - ticks_of(quick)) ==
          doctest::Approx(0.5 * rate).epsilon(0.02));
    CHECK(game.score(0) == 1);
    // What the balls do meanwhile is part of the state.
    REQUIRE_FALSE(game.session.apply(
        command::Strike{*cue_ball_of(game.session.scene(), game.state()), {0.0, 0.2}}));
    while (game.state().rested == 0)
        game.session.step_forward();
    ShotsState state = game.state();
    ++state.rested;
    CHECK(digest_of(0, state) != digest_of(0, game.state()));
}

TEST_CASE("shots: balls that return together are not in each other's way") {
    Game game(R"(game shots
on shot judged  respot ball
on shot judged if shots=9  end
)");
    // The white, hit full, drives the red away and comes to lie beyond the red's start.
    game.shoot({1.2, 0.0});
    const World& world = game.session.world();
    const auto place = [&](std::size_t ball) {
        return world.balls().position[*index_of(world, *game.state().balls[ball])];
    };
    const Scene& scene = game.session.scene();
    CHECK(place(0) == start_of(scene, 0));
    CHECK(place(1) == start_of(scene, 1));
    // Exchanged places are the worst case.
    World swapped = scene.world;
    std::swap(swapped.edit_balls().position[0], swapped.edit_balls().position[1]);
    ShotsState state = *begin_shots(scene);
    ShotsPlay play(scene, swapped, state);
    RuleAction respot{.what = RuleAction::What::respot};
    respot.index = static_cast<std::uint32_t>(
        std::ranges::find(scene.rules.balls, RuleBalls::Who::any, &RuleBalls::who) -
        scene.rules.balls.begin());
    play.act(respot, 0, 0);
    for (std::uint32_t ball = 0; ball < 2; ++ball)
        CHECK(swapped.balls().position[*index_of(swapped, *state.balls[ball])] ==
              start_of(scene, ball));
}

TEST_CASE("shots: a condition asks whether a motion runs") {
    Game game(R"(edge rubber gate r=10 1200,20 1200,120
motion slide gate by=0,100 every=2s waits
game shots
on shot ends if gate      score 10, stop gate
on shot ends unless gate  score 1, start gate
on shot judged if shots=9  end
)");
    game.shoot_softly();
    CHECK(game.score(0) == 1);
    game.shoot_softly();
    CHECK(game.score(0) == 11);
    game.shoot_softly();
    CHECK(game.score(0) == 12);
}

TEST_CASE("shots: a game that is over has no task") {
    Game game("game shots\non shot judged  end\ntask \"HIT THE RED\"\n");
    const auto task = [&] {
        return task_text(game.session.scene(), game.session.world(), game.state());
    };
    CHECK(task() == "HIT THE RED");
    game.shoot_softly();
    CHECK(task().empty());
}

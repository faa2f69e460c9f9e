#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <variant>

#include "game/replay/replay_text.h"
#include "game/replay/replayer.h"
#include "game/session/session.h"
#include "game/shots/goal_play.h"
#include "level/load.h"

using namespace carom;

namespace {

constexpr const char* table = R"(carom 1 "Goal"
units mm
use cloth slide=0.2 roll=0.02 spin=10rad/s2
kind ivory r=30 m=210g e=0.95
box 0,0 1400,700 r=10
pocket hole at=1350,350 r=60
zone far 1000,100 1000,600 r=100
ball white at=300,350 kind=ivory
ball red at=900,350 kind=ivory
cue ball=white power=0..6m/s
)";

Scene scene_of(const std::string& text) {
    LoadResult loaded = load_level(text, "goal.level", {});
    REQUIRE(loaded.scene);
    return std::move(*loaded.scene);
}

FaultCode fault_of(const std::string& text) {
    const LoadResult loaded = load_level(text, "goal.level", {});
    REQUIRE_FALSE(loaded.diagnostics.empty());
    return loaded.diagnostics.front().code;
}

struct Practice {
    explicit Practice(const std::string& goal)
        : session(scene_of(table + goal), {.kind = SolverKind::event}) {}

    const GoalPlay& play() const { return std::get<GoalPlay>(session.game()); }
    BallId ball(std::size_t index) const { return session.world().balls().id[index]; }
    void run(double seconds) {
        for (int tick = 0; tick < seconds * session.world().rate(); ++tick)
            session.step_forward();
    }
    void shoot(Vec2 velocity) {
        REQUIRE_FALSE(session.apply(command::Strike{ball(0), velocity}));
        run(20.0);
    }

    Session session;
};

}  // namespace

TEST_CASE("a level without a game counts the shots of its goal") {
    Practice practice("goal \"Pocket it.\" within 1 2 3 shots if count(red)=0 and rest\n");
    const auto text = [&] {
        return task_text(practice.session.scene(), practice.session.world(),
                         practice.session.game());
    };
    // The menu promises a puzzle of one shot: so the text says what one shot is worth.
    CHECK(text() == "Pocket it. (0 of 3 shots; 1 for 3 stars)");
    practice.shoot({-0.3, 0.0});
    CHECK(text() == "Pocket it. (1 of 3 shots; 2 for 2 stars)");
    CHECK(stars_of(practice.session.game()) == 0);
    CHECK_FALSE(practice.play().goal.done);
    practice.shoot({2.5, 0.0});
    REQUIRE(practice.play().goal.done);
    CHECK(practice.play().goal.done->shots == 2);
    CHECK(stars_of(practice.session.game()) == 2);
    CHECK(text() == "Done in 2 shots: 2 of 3 stars");
}

TEST_CASE("a goal waits for what it asks, and a shot taken back does not count") {
    Practice practice(
        "goal \"Leave the white there.\" within 1 shots if count(cue,far)=1 and rest\n");
    practice.shoot({0.0, 0.3});
    practice.shoot({0.0, -0.3});
    REQUIRE(practice.session.undo());
    REQUIRE(practice.session.undo());
    CHECK(practice.play().goal.shots == 0);
    practice.shoot({2.0, 0.8});
    CHECK(practice.play().goal.shots == 1);
    const World& world = practice.session.world();
    const Vec2 white = world.balls().position[*index_of(world, practice.ball(0))];
    CHECK(practice.play().goal.done.has_value() == (white.x > 0.9));
}

TEST_CASE("who moves a ball by hand does not reach a goal that counts shots") {
    Practice practice("goal \"Pocket it.\" if count(red)=0 and shots>0\n");
    REQUIRE_FALSE(practice.session.apply(command::PlaceBall{practice.ball(1), {1.2, 0.35}}));
    practice.shoot({2.5, 0.0});
    CHECK(practice.session.world().balls().size() < 2);
    CHECK_FALSE(practice.play().goal.done);
    REQUIRE(practice.session.undo());
    REQUIRE(practice.session.undo());
    practice.shoot({2.5, 0.0});
    CHECK(practice.play().goal.done);
}

TEST_CASE("a goal in seconds counts everything, and balls that come later") {
    Session session(scene_of("carom 1 \"Rain\"\nuse gravity 0,-10\nkind drop r=0.5 e=0.2\n"
                             "spawn drop at=0,20 every=200ms count=30\nbox -3,0 3,40 r=0.1\n"
                             "goal \"Ten drops.\" within 1 20 seconds if count(drop)>=10\n"),
                    {.kind = SolverKind::swept});
    for (int tick = 0; tick < 5 * session.world().rate(); ++tick)
        session.step_forward();
    const GoalState* const goal = goal_state(session.game());
    REQUIRE(goal);
    REQUIRE(goal->done);
    CHECK(goal->done->stars == 2);
}

TEST_CASE("a goal belongs where no referee plays, and rules need a game") {
    const std::string goal = "goal \"Win.\" if count(ball)=0\n";
    CHECK(fault_of(std::string("carom 1 \"x\"\nball a at=0,0\non shot ends  score 1\n")) ==
          FaultCode("rules-without-game"));
    CHECK(fault_of("carom 1 \"x\"\nunits mm\nuse cloth slide=0.2 roll=0.01 spin=10rad/s2\n"
                   "kind pool r=28 m=170g\nball cue kind=pool at=-500,0\nrack nine kind=pool "
                   "at=500,0\npocket a at=900,0 r=60\ncue ball=cue power=0..9m/s\ngame nineball\n" +
                   goal) == FaultCode("goal-of-referee"));
}

TEST_CASE("limits of a goal: three are three, two and one stars") {
    LevelGoal goal;
    CHECK(stars_within(goal, 99.0) == 3);
    goal.limits = {2.0};
    CHECK(stars_within(goal, 2.0) == 3);
    CHECK(stars_within(goal, 3.0) == 0);
    goal.limits = {5.0, 4.0, 3.0};
    goal.counts = LevelGoal::Counts::value;
    CHECK(stars_within(goal, 6.0) == 3);
    CHECK(stars_within(goal, 4.0) == 2);
    CHECK(stars_within(goal, 2.0) == 0);
    goal.counts = LevelGoal::Counts::shots;
    goal.limits = {2.0, 4.0, 6.0};
    CHECK(stars_within(goal, 3.0) == 2);
    CHECK(stars_within(goal, 6.0) == 1);
    CHECK(stars_within(goal, 7.0) == 0);
}

TEST_CASE("a recording of a game by rules is verified, also beyond the limit of actions") {
    std::string rules = "game shots\nvar strokes\non shot ends  strokes +1\n";
    for (int i = 0; i < 1002; ++i)
        rules += "on shot ends  score 1\n";
    rules += "on shot ends if strokes>5  end\ngoal \"Score.\" within 1 shots if score>=500\n";
    const std::string text = table + rules;
    Session session(scene_of(text), {.kind = SolverKind::event});
    session.step_forward();
    for (int shot = 0; shot < 2; ++shot) {
        REQUIRE_FALSE(
            session.apply(command::Strike{session.world().balls().id[0], {0.5, 0.4 - 0.2 * shot}}));
        for (int tick = 0; tick < 10 * session.world().rate(); ++tick)
            session.step_forward();
    }
    REQUIRE(rule_state(session.game())->left_out > 0);
    const std::uint64_t mark = fingerprint(session.world(), session.game());
    const auto read = read_replay(replay_text(record(session, "goal.level", {})));
    REQUIRE(std::holds_alternative<Replay>(read));
    Replayer replayer(std::get<Replay>(read), scene_of(text));
    while (replayer.advance(500)) {
    }
    REQUIRE_FALSE(replayer.failure());
    CHECK(fingerprint(replayer.session().world(), replayer.session().game()) == mark);
    CHECK(*rule_state(replayer.session().game()) == *rule_state(session.game()));
    CHECK(stars_of(replayer.session().game()) == 3);
}

TEST_CASE("a goal is judged at the end of a shot, before the next player's turn begins") {
    const Scene scene = scene_of(std::string(table) +
                                 "game shots players=2\nvar hits of turn\n"
                                 "on cue hit red  hits +1\n"
                                 "on shot ends  turn\n"
                                 "on shot judged if shots=9  end\n"
                                 "goal \"Hit it.\" within 1 2 shots if hits\n");
    Session session(scene, {.kind = SolverKind::event});
    session.step_forward();
    const auto& state = std::get<ShotsState>(session.game());
    REQUIRE_FALSE(session.apply(command::Strike{*cue_ball_of(scene, state), {1.5, 0.0}}));
    while (std::get<ShotsState>(session.game()).is_shooting)
        session.step_forward();
    CHECK(std::get<ShotsState>(session.game()).rules.player == 1);
    CHECK(variables(scene, session.game()).front().second.front() == 0);
    CHECK(stars_of(session.game()) == 3);
}

TEST_CASE("a goal may count a value of the rules: three stars for the most") {
    const std::string rules =
        "game shots\nvar made\nvar tried\non cue hit red once  made +1\n"
        "on shot judged  tried +1, respot ball\n"
        "on shot judged if shots=3  end\n";
    const Scene scene =
        scene_of(table + rules + "goal \"Hit it.\" with 3 2 1 of made if tried=3\n");
    Session session(scene, {.kind = SolverKind::event});
    session.step_forward();
    const auto shoot = [&](Vec2 velocity) {
        const auto& state = std::get<ShotsState>(session.game());
        REQUIRE_FALSE(session.apply(command::Strike{*cue_ball_of(scene, state), velocity}));
        while (std::get<ShotsState>(session.game()).is_shooting)
            session.step_forward();
    };
    shoot({1.5, 0.0});
    shoot({0.0, 0.2});
    CHECK(task_text(scene, session.world(), session.game()) == "Hit it.");
    shoot({1.5, 0.0});
    CHECK(stars_of(session.game()) == 2);
    CHECK(task_text(scene, session.world(), session.game()) == "Done with 2: 2 of 3 stars");
    const auto loaded_with = [&](const std::string& limits) {
        return load_level(table + rules + "goal \"Hit it.\" " + limits + " if tried=3\n", "g", {});
    };
    for (const std::string wrong : {"with 1 2 of made", "with of made", "with 4 3 2 1 of made"}) {
        CAPTURE(wrong);
        const LoadResult loaded = loaded_with(wrong);
        CHECK_FALSE(loaded.scene);
        CHECK(std::ranges::count(loaded.diagnostics, FaultCode("goal-malformed"),
                                 &Diagnostic::code) == 1);
    }
    CHECK_FALSE(loaded_with("with 3 2 1").scene);
    CHECK_FALSE(loaded_with("with 3 2 1 of").scene);
}

TEST_CASE("a goal may allow at most so much of a value: three stars for the least") {
    const std::string rules =
        "game shots\nvar strokes\n"
        "on shot begins  strokes +1\n"
        "on cue pocketed  strokes +2\n"
        "on shot ends if count(red)=0  end\n";
    const Scene scene =
        scene_of(table + rules + "goal \"Pot it.\" within 1 2 4 of strokes if count(red)=0\n");
    const auto after = [&](std::initializer_list<Vec2> shots) {
        Session session(scene, {.kind = SolverKind::event});
        session.step_forward();
        for (const Vec2 velocity : shots) {
            const auto& state = std::get<ShotsState>(session.game());
            REQUIRE_FALSE(session.apply(command::Strike{*cue_ball_of(scene, state), velocity}));
            while (std::get<ShotsState>(session.game()).is_shooting)
                session.step_forward();
        }
        return std::pair(stars_of(session.game()),
                         task_text(scene, session.world(), session.game()));
    };
    const Vec2 soft{-0.2, 0.0};
    const Vec2 pot{2.5, 0.0};
    CHECK(after({}) == std::pair(0, std::string("Pot it.")));
    CHECK(after({pot}) == std::pair(3, std::string("Done with 1: 3 of 3 stars")));
    CHECK(after({soft, pot}) == std::pair(2, std::string("Done with 2: 2 of 3 stars")));
    CHECK(after({soft, soft, pot}) == std::pair(1, std::string("Done with 3: 1 of 3 stars")));
    CHECK(after({soft, soft, soft, soft, pot}) ==
          std::pair(0, std::string("No star with 5: it takes 4")));
}

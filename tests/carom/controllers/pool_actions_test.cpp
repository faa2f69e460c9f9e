#include "carom/controllers/pool_actions.h"

#include <doctest/doctest.h>

#include <string>
#include <variant>

#include "carom/support/person.h"
#include "game/support/shipped.h"

using namespace carom;
using carom::test::always;

namespace {

struct Person : test::PersonAtWindow {
    explicit Person(const std::string& level, int columns = 120, int rows = 36)
        : PersonAtWindow(session_of(level), columns, rows) {}

    static Session session_of(const std::string& level) {
        Scene scene = test::shipped_level(level);
        const SolverSettings solver = pick_solver(scene.world).settings;
        return Session(std::move(scene), solver);
    }
    void key(char32_t code, std::uint8_t modifiers = no_modifier) {
        PersonAtWindow::key(code, modifiers);
        look();
    }
    void wait() {
        for (int i = 0; i < 60 * 60 && play().is_shooting; ++i)
            player.advance(1.0 / 60.0, always);
        REQUIRE_FALSE(play().is_shooting);
        look();
    }
    /// A match against carom that has begun, and in which it is the person's turn. Pre: the level
    /// is a game of pool.
    void begin_match() {
        REQUIRE(player.pool_players()->set_opponent(player.session(), 1));
        for (int shot = 0; shot < 20; ++shot) {
            key(key::enter);
            pass(0.3);
            key(key::enter);
            pass(0.1);
            wait();
            for (int i = 0; i < 1000 && play().rules.player == 1; ++i)
                pass(0.1);
            if (play().rules.player == 0 && play().rules.phase == PoolPhase::playing) return;
        }
        FAIL("no turn");
    }
    const PoolPlay& play() const { return std::get<PoolPlay>(player.session().game()); }
    Vec2 place_of(std::size_t ball) const {
        return world().balls().position[*index_of(world(), *play().balls[ball])];
    }
    std::size_t commands() const { return player.session().commands().size(); }
};

}  // namespace

TEST_CASE("in a match N, pressed twice at once, concedes the frame") {
    Person person("nine-ball");
    person.begin_match();
    const std::size_t commands = person.commands();
    person.key(U'N');
    CHECK(person.sees("Press N again to concede the frame."));
    person.key(key::left);  // no
    person.key(U'N');
    person.pass(6.0);  // too late
    person.key(U'N');
    CHECK(person.commands() == commands);
    person.key(U'N');
    CHECK(person.play().rules.winner == 1);
    person.pass(0.1);
    CHECK(person.sees("You concede. Carom wins the frame."));
    CHECK(person.sees("0:1"));
    person.key(U'N');
    CHECK(person.sees("The balls are racked."));
}

// One key, which the last line offered, wiped out a match.
TEST_CASE("a frame that is being played is restarted only when r is pressed twice") {
    for (const bool is_match : {false, true}) {
        CAPTURE(is_match);
        Person person("nine-ball");
        if (is_match) {
            person.begin_match();
        } else {
            person.key(key::enter);
            person.wait();
        }
        const std::uint64_t tick = person.world().tick();
        person.key(U'r');
        CHECK(person.sees("Press r again to lose this frame and restart."));
        CHECK(person.world().tick() >= tick);
        person.key(U'r');
        CHECK(person.sees("Restarted."));
        CHECK(person.world().tick() == 0);
        const auto lost = [&] { return person.player.pool_players()->record().frames[0].lost; };
        CHECK(lost() == (is_match ? 1 : 0));
        // Nothing is lost now.
        person.key(U'r');
        CHECK(person.sees("Restarted."));
        CHECK(lost() == (is_match ? 1 : 0));
    }
}

TEST_CASE("in a match the solver stays, and in practice it does not") {
    Person person("nine-ball");
    person.key(U's');
    CHECK(person.player.session().solver().kind != SolverKind::event);
    Person in_match("nine-ball");
    in_match.begin_match();
    in_match.key(U's');
    CHECK(in_match.sees("In a match the solver stays."));
    CHECK(in_match.player.session().solver().kind == SolverKind::event);
    CHECK_FALSE(in_match.sees("s solver"));
}

TEST_CASE("in the past of a match enter says why it does not shoot") {
    Person person("nine-ball");
    person.begin_match();
    for (int i = 0; i < 30; ++i)
        person.key(U'<');
    REQUIRE(person.world().tick() < person.player.session().latest());
    const std::size_t commands = person.commands();
    person.key(key::enter);
    CHECK(person.sees("In a match the past is only looked at"));
    CHECK(person.commands() == commands);
}

// The message said "No ball fell. Carom shoots.", since carom chooses at once.
TEST_CASE("after a foul at snooker the message tells it, though carom has chosen already") {
    Person person("snooker");
    REQUIRE(person.player.pool_players()->set_opponent(person.player.session(), 1));
    for (int i = 0; i < 27; ++i)
        person.key(key::down);  // too soft to reach a ball
    person.key(key::enter);
    person.pass(0.3);
    person.key(key::enter);
    person.pass(0.1);
    person.wait();
    REQUIRE(person.play().rules.phase == PoolPhase::choosing);
    for (int i = 0; i < 1000 && person.play().rules.phase == PoolPhase::choosing; ++i)
        person.pass(0.1);
    REQUIRE(person.play().rules.phase != PoolPhase::choosing);
    REQUIRE(person.play().shots == 1);
    person.pass(0.1);
    CHECK(person.sees("Foul and a miss, 4: no ball was hit."));
}

// It pointed full at the apex, softly: a foul. At snooker it passed the pink by 7 mm.
TEST_CASE("the opening that is proposed where a safety opens the frame is fair, and comes back") {
    for (const char* const level : {"straight-pool", "one-pocket", "snooker"}) {
        CAPTURE(level);
        Person person(level);
        const double head = person.place_of(0).x;
        person.key(key::enter);
        person.wait();
        CHECK(person.play().last_foul == PoolFoul::none);
        CHECK(person.play().rules.phase == PoolPhase::playing);
        CHECK(person.place_of(0).x < head);
    }
}

TEST_CASE("every choice after a foul is listed at 80 columns") {
    Person person("eight-ball", 80, 24);
    for (int i = 0; i < 75; ++i)
        person.key(key::down);
    person.key(key::enter);
    person.wait();
    REQUIRE(person.play().rules.choices.size() == 3);
    CHECK(person.sees("1 shoot from here  2 rack again and break  3 rack, the other breaks"));
}

TEST_CASE("a digit that is pressed twice at a choice switches no overlay on") {
    Person person("eight-ball", 80, 24);
    for (int i = 0; i < 75; ++i)
        person.key(key::down);
    person.key(key::enter);
    person.wait();
    REQUIRE(person.play().rules.choices.size() == 3);
    const auto shows = [&] { return person.player.view().overlays != OverlaySet{}; };
    REQUIRE_FALSE(shows());
    person.key(U'1');
    REQUIRE(person.play().rules.choices.empty());
    person.key(U'1');
    person.key(U'1');
    CHECK_FALSE(shows());
    person.key(key::left);
    person.key(U'1');
    CHECK(shows());
}

TEST_CASE("while the stroke meter runs, only the keys of the stroke are offered") {
    Person person("eight-ball");
    REQUIRE(person.player.pool_players()->set_opponent(person.player.session(), 1));
    person.key(key::enter);
    CHECK(person.sees("enter strike  esc no stroke"));
    for (const char* other : {"pause", "restart", "renderer", "quit", "solver", "keys", "about"}) {
        CAPTURE(other);
        CHECK_FALSE(person.sees(other));
    }
}

TEST_CASE("the help of a game of pool lists what is declared there") {
    const auto help = [](const char* level) {
        Person person(level);
        person.key(U'?');
        return person.look();
    };
    const auto says = [](const std::string& text, const char* words) {
        return text.find(words) != std::string::npos;
    };
    for (const char* const level : {"snooker", "one-pocket"}) {
        CAPTURE(level);
        CHECK_FALSE(says(help(level), "safety"));
        CHECK_FALSE(says(help(level), "push-out"));
        CHECK(says(help(level), "aiming aid"));
    }
    for (const char* const level : {"eight-ball", "straight-pool"}) {
        CAPTURE(level);
        CHECK(says(help(level), " safety"));
        CHECK_FALSE(says(help(level), "push-out"));
    }
    CHECK(says(help("nine-ball"), " push-out"));
    CHECK_FALSE(says(help("nine-ball"), "safety"));
    CHECK(says(help("ten-ball"), " safety, or push-out"));
}

TEST_CASE("the whole table comes back with the shot after z") {
    Person person("eight-ball");
    const double scale = person.player.camera().columns_per_length;
    for (int i = 0; i < 5; ++i)
        person.key(U'z');
    REQUIRE(person.player.camera().columns_per_length > 2.0 * scale);
    person.key(key::enter);
    CHECK(person.player.camera().columns_per_length == scale);
}

TEST_CASE("z zooms on the place where the aim meets a ball") {
    Person person("eight-ball");
    const auto ghost = [&] {
        const Vec2 cue = person.place_of(0);
        const Vec2 apex = person.player.session().scene().pool.racks[0].foot;
        return to_cells(person.player.camera(),
                        apex - (apex - cue) * (0.05715 / length(apex - cue)));
    };
    const CellPoint before = ghost();
    const double scale = person.player.camera().columns_per_length;
    for (int i = 0; i < 5; ++i)
        person.key(U'z');
    CHECK(person.player.camera().columns_per_length > 2.0 * scale);
    CHECK(ghost().column == doctest::Approx(before.column).epsilon(0.01));
    CHECK(ghost().row == doctest::Approx(before.row).epsilon(0.01));
}

TEST_CASE("on a table without rules a ball is put over the others, and any ball is shot") {
    Person person("pool-table");
    const auto place_of = [&](std::size_t ball) { return person.world().balls().position[ball]; };
    const std::size_t last = person.world().balls().size() - 1;
    const Vec2 from = place_of(last);
    const Vec2 other = place_of(last - 5);
    const Vec2 to{-0.3, 0.2};
    person.drag(from, to);
    person.pass(1.0);
    CHECK(distance(place_of(last), to) < 0.03);
    CHECK(place_of(last - 5) == other);
    const Vec2 cue = place_of(0);
    person.drag(place_of(last), place_of(last) + Vec2{0.2, 0.1}, right_button);
    person.pass(0.2);
    CHECK(person.world().balls().velocity[last].x < 0.0);
    CHECK(place_of(0) == cue);
}

// j ran through the pause as well, and the balls were back before anybody saw where they had
// stopped.
TEST_CASE("j skips to the rest of a drill's balls, and not the pause in which they lie") {
    test::PersonAtWindow person(Person::session_of("drill-stop"), 120, 36);
    const auto shots = [&]() -> const ShotsState& {
        return std::get<ShotsState>(person.player.session().game());
    };
    REQUIRE(person.player.pool_players()->set_match(person.player.session(), false));
    person.key(key::enter);
    person.pass(0.1);
    REQUIRE(shots().is_shooting);
    person.key(U'j');
    const auto lies = [&] { return shots().is_shooting && shots().rested > 0; };
    double shown = 0.0;
    for (int frame = 0; frame < 600 && shots().is_shooting; ++frame) {
        person.player.advance(1.0 / 60.0, test::always);
        if (lies()) shown += 1.0 / 60.0;
    }
    CHECK_FALSE(shots().is_shooting);
    CHECK(shown > 0.8);
    CHECK(shown < 1.3);
}

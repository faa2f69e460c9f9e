#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "carom/controllers/pinball_bell.h"
#include "carom/controllers/pinball_input.h"
#include "carom/controllers/pinball_panel.h"
#include "carom/play/program.h"
#include "carom/support/at_table.h"
#include "level/load.h"
#include "support/terminal_program.h"

using namespace carom;
using namespace carom::test;
namespace fs = std::filesystem;

TEST_CASE("a table that nobody touches is played by the demo, until any key") {
    const TableHome home;
    AtTable table(home);
    table.pass(19.0);
    CHECK_FALSE(table.sees("DEMONSTRATION"));
    table.pass(4.0);
    CHECK(table.sees("DEMONSTRATION"));
    table.pass(10.0);
    CHECK(table.sees("carom plays: any key starts a game"));
    table.key(U'z');
    CHECK_FALSE(table.sees("DEMONSTRATION"));
    CHECK_FALSE(table.sees("carom plays"));
    CHECK(table.sees("ball 1 of 3"));
    table.pass(5.0);
    CHECK_FALSE(table.sees("DEMONSTRATION"));
    table.key(U'd');
    table.pass(5.0);
    CHECK(table.sees("carom plays: any key of the table takes over"));
}

TEST_CASE("initials that nobody completes are kept, and then the demo plays") {
    const TableHome home;
    home.write("work.level", short_game);
    AtTable table(home);
    table.pass(1.0);
    table.key(key::enter);
    table.pass(10.0);
    REQUIRE(table.sees("YOUR INITIALS: ___"));
    CHECK(table.sees("esc none"));
    CHECK_FALSE(table.sees("renderer"));
    table.key(U'e');
    table.pass(50.0);
    table.key(U'd');
    table.pass(50.0);
    CHECK(table.sees("YOUR INITIALS: ED_"));
    table.pass(11.0);
    CHECK_FALSE(table.sees("YOUR INITIALS"));
    std::stringstream kept;
    kept << std::ifstream(home.path / "data/carom/high-scores").rdbuf();
    CHECK(kept.str().find("work 700 ED-") != std::string::npos);
    CHECK_FALSE(table.sees("DEMONSTRATION"));
    // Its ball drains soon too.
    bool is_played = false;
    for (int i = 0; i < 300 && !is_played; ++i) {
        table.pass(0.1);
        is_played = table.sees("DEMONSTRATION");
    }
    CHECK(is_played);
}

TEST_CASE(
    "a game that is rewound and changed asks for no initials; one that is watched again does") {
    const TableHome home;
    home.write("work.level", short_game);
    for (const bool changes : {false, true}) {
        CAPTURE(changes);
        AtTable table(home);
        table.pass(1.0);
        table.key(key::enter);
        table.pass(2.6);
        REQUIRE(table.sees("NO BONUS"));
        table.key(U'<');
        table.key(U'<');
        table.pass(0.1);
        if (changes) table.key(U'z');
        table.pass(0.1);
        CHECK(table.sees("Rewound: this game is not for the high scores.") == changes);
        table.pass(8.0);
        CHECK(table.sees("YOUR INITIALS") == !changes);
    }
}

TEST_CASE("a game that was rewound and changed asks for no initials after it is resumed either") {
    const TableHome home;
    home.write("work.level", short_game);
    for (const bool changes : {false, true}) {
        CAPTURE(changes);
        {
            AtTable table(home);
            table.pass(1.0);
            table.key(key::enter);
            table.pass(2.6);
            REQUIRE(table.sees("NO BONUS"));
            table.key(U'<');
            table.key(U'<');
            table.pass(0.1);
            if (changes) table.key(U'z');
            table.pass(0.1);
            table.key(U'q');
        }
        AtTable table(home, false, false, "", true);
        table.pass(0.1);
        REQUIRE(table.sees("Resumed."));
        table.key(U' ');
        table.pass(8.0);
        CHECK(table.sees("YOUR INITIALS") == !changes);
        table.key(key::escape);
        table.key(U'q');
    }
}

TEST_CASE("a game with a solver of the player's own asks for no initials after it is resumed") {
    const TableHome home;
    home.write("work.level", short_game);
    for (const bool is_own : {false, true}) {
        CAPTURE(is_own);
        {
            const SolverSettings substep{.kind = SolverKind::substep};
            AtTable table(home, false, false, "", false, {},
                          is_own ? std::optional(substep) : std::nullopt);
            table.pass(1.0);
            table.key(key::enter);
            table.pass(1.0);
            table.key(U'q');
        }
        AtTable table(home, false, false, "", true);
        table.pass(0.1);
        REQUIRE(table.sees("Resumed."));
        table.key(U' ');
        table.pass(10.0);
        CHECK(table.sees("GAME OVER"));
        CHECK(table.sees("YOUR INITIALS") == !is_own);
        table.key(key::escape);
        table.key(U'q');
    }
}

TEST_CASE("a resumed game whose table has changed since asks for no initials") {
    const TableHome home;
    home.write("work.level", short_game);
    {
        AtTable table(home);
        table.pass(1.0);
        table.key(key::enter);
        table.pass(1.0);
        table.key(U'q');
    }
    home.write("work.level", std::string(short_game) + "# changed\n");
    AtTable table(home, false, false, "", true);
    table.pass(0.1);
    REQUIRE(table.sees("Resumed on its earlier level."));
    table.key(U' ');
    table.pass(10.0);
    CHECK(table.sees("GAME OVER"));
    CHECK_FALSE(table.sees("YOUR INITIALS"));
}

TEST_CASE("a game after a restart asks for initials, like the one before it") {
    const TableHome home;
    home.write("work.level", short_game);
    AtTable table(home);
    for (int game = 0; game < 2; ++game) {
        CAPTURE(game);
        table.pass(1.0);
        table.key(key::enter);
        table.pass(8.0);
        REQUIRE(table.sees("YOUR INITIALS"));
        table.key(key::escape);
        CHECK_FALSE(table.sees("YOUR INITIALS"));
        table.key(U'r');
    }
}

TEST_CASE("the panel says what the score reaches next") {
    std::string text = short_game;
    text.replace(text.find("save=0s"), 7, "save=0s replay=500000");
    const Session session = session_of(text.c_str());
    const auto target = [&](std::vector<HighScore> lines) {
        PinballScores scores;
        scores.set({.lines = std::move(lines), .most = 3});
        return score_panel(session, scores, false).lines[2];
    };
    CHECK(target({}) == "extra ball at 500,000");
    CHECK(target({{"TOP", 600000}}) == "extra ball at 500,000");
    CHECK(target({{"TOP", 600000}, {"OLD", 900}}) == "to beat: 900 by OLD");
}

TEST_CASE("the panel lists lights that go out, and no gate or post") {
    std::string text = short_game;
    text += "post bolt 100,300 140,300 r=2\non ball launch open bolt 3s, light lane 3s\n";
    Session session = session_of(text.c_str());
    for (const bool is_down : {true, false}) {
        for (int tick = 0; tick < 500; ++tick)
            session.step_forward();
        REQUIRE_FALSE(session.apply(command::Press{Button::plunger, is_down}).has_value());
    }
    session.step_forward();
    std::string lines;
    for (const std::string& line : score_panel(session, {}, false).lines)
        lines += line + '\n';
    CHECK(lines.find("lane  3 s") != std::string::npos);
    CHECK(lines.find("bolt") == std::string::npos);
}

TEST_CASE("the panel of a high window lists the named lights, and what each ball scored") {
    const TableHome home;
    std::string text = short_game;
    text.replace(text.find("balls=1"), 7, "balls=2");
    text += "insert lock \"LOCK\" at=100,300 at=120,300 r=8\non lane enter light lock.2\n";
    home.write("work.level", text);
    AtTable table(home);
    CHECK(table.sees("LIGHTS"));
    CHECK(table.sees("··  LOCK"));
    CHECK_FALSE(table.sees("THIS GAME"));
    table.pass(1.0);
    table.key(key::enter);
    table.pass(5.0);
    REQUIRE(table.sees("ball 2 of 2"));
    CHECK(table.sees("THIS GAME"));
    CHECK(table.sees("ball 1              700"));
    CHECK_FALSE(table.sees("ball 0"));
}

TEST_CASE("with key releases, the first press already holds the flipper up") {
    const TableHome home;
    for (const bool tells : {true, false}) {
        CAPTURE(tells);
        AtTable table(home, tells);
        const std::size_t at_rest = table.picture();
        CHECK(table.sees(tells ? "Hold to keep up.  k" : "Hold to keep up (a tap lasts 0.75 s)"));
        table.key(U'z');
        table.pass(0.1);
        const std::size_t up = table.picture();
        CHECK(up != at_rest);
        table.pass(0.75);
        CHECK((table.picture() == up) == tells);
        table.key(U'z', InputEvent::Action::release);
        table.pass(0.1);
        CHECK(table.picture() == at_rest);
    }
}

TEST_CASE("a release in the kitty protocol lowers a flipper at once") {
    const TableHome home;
    TerminalProgram game({CAROM_BINARY_DIR "/carom", "play", home.table()},
                         {.columns = 100, .rows = 40, .emulator = {.has_key_protocol = true}});
    REQUIRE(game.wait_for_text("A small table"));
    CHECK(game.screen().key_stack() == 1);
    CHECK(game.wait_for_text("Hold to keep up"));
    const auto picture = [&] {
        std::string rows;
        for (int row = 0; row < table_rows; ++row)
            for (int column = 0; column < 60; ++column)
                rows += described(game.screen().look(column, row)) + '\n';
        return std::hash<std::string>{}(rows);
    };
    const auto never = [] { return false; };
    game.wait_until(never, 0.3);
    const std::size_t at_rest = picture();
    // The bytes of kitty under the flags that carom asks for: z is pressed, repeats, is released.
    game.send("\033[122;;122u");
    REQUIRE(game.wait_until([&] { return picture() != at_rest; }));
    game.wait_until(never, 0.3);
    const std::size_t up = picture();
    CHECK_FALSE(game.wait_until([&] { return picture() != up; }, 0.5));
    game.send("\033[122;1:2;122u");
    CHECK_FALSE(game.wait_until([&] { return picture() != up; }, 0.3));
    game.send("\033[122;1:3u");
    CHECK(game.wait_until([&] { return picture() == at_rest; }, 1.0));
    // Arrow keys too, with Caps Lock or Num Lock on; the other flipper stays down meanwhile.
    game.send("\033[1;65:1D");
    CHECK(game.wait_until([&] { return picture() == up; }, 1.0));
    game.send("\033[1;65:3D");
    CHECK(game.wait_until([&] { return picture() == at_rest; }, 1.0));
    game.send("\033[113;;113u");
    CHECK(game.wait_for_end());
    CHECK(game.screen().key_stack() == 0);
}

TEST_CASE("the mouse pulls the plunger, stronger the further it is dragged") {
    using enum InputEvent::Action;
    constexpr double row = 0.02;
    const Session session = session_of(level);
    const Vec2 grip{0.38, 0.1};
    PinballInput input;
    const auto pressed = input.take_mouse(mouse(press), grip, session);
    REQUIRE(pressed.has_value());
    REQUIRE(pressed->size() == 1);
    CHECK(pressed->front().button == Button::plunger);
    CHECK_FALSE(input.drag_plunger(mouse(move), grip + Vec2{0.05, 0.0}, row).has_value());
    auto pull = input.drag_plunger(mouse(move), grip - Vec2{0.0, 3.0 * row}, row);
    REQUIRE(pull.has_value());
    CHECK(pull->share == doctest::Approx(0.5));
    CHECK_FALSE(pull->lets_go);
    pull = input.drag_plunger(mouse(move), grip - Vec2{0.0, 30.0 * row}, row);
    REQUIRE(pull.has_value());
    CHECK(pull->share == 1.0);
    pull = input.drag_plunger(mouse(release), grip - Vec2{0.0, 1.5 * row}, row);
    REQUIRE(pull.has_value());
    CHECK(pull->share == doctest::Approx(0.25));
    CHECK(pull->lets_go);
    // The tool is empty now.
    CHECK_FALSE(input.drag_plunger(mouse(move), grip, row).has_value());
    CHECK_FALSE(input.take_mouse(mouse(release), grip, session).has_value());
}

TEST_CASE("a press on the plunger without a drag acts like its key") {
    using enum InputEvent::Action;
    const Session session = session_of(level);
    const Vec2 grip{0.38, 0.1};
    PinballInput input;
    REQUIRE(input.take_mouse(mouse(press), grip, session).has_value());
    CHECK_FALSE(input.drag_plunger(mouse(release), grip, 0.02).has_value());
    const auto released = input.take_mouse(mouse(release), grip, session);
    REQUIRE(released.has_value());
    REQUIRE(released->size() == 1);
    CHECK(released->front().button == Button::plunger);
    CHECK_FALSE(released->front().is_down);
    // Elsewhere the button is a flipper's, and no plunger is pulled.
    const auto flipper = input.take_mouse(mouse(press), {0.1, 0.1}, session);
    REQUIRE(flipper.has_value());
    CHECK(flipper->front().button == Button::left_flipper);
    CHECK_FALSE(input.drag_plunger(mouse(move), {0.1, 0.0}, 0.02).has_value());
}

TEST_CASE("the bell rings for kicks and holes, but not too often") {
    // Without a game, the balls may be struck.
    const std::string text = level;
    Session session = session_of(text.substr(0, text.find("game pinball")).c_str());
    PinballBell bell;
    CHECK_FALSE(bell.rings(session, 1.0));
    const auto send = [&](Vec2 velocity) {
        const BallId ball = session.world().balls().id[1];
        REQUIRE_FALSE(session.apply(command::Strike{ball, velocity}).has_value());
        for (int tick = 0; tick < 60; ++tick)
            session.step_forward();
    };
    send({0.0, 1.0});
    CHECK(bell.rings(session, 0.06));
    CHECK_FALSE(bell.rings(session, 1.0));
    send({0.0, 1.5});
    CHECK(bell.rings(session, 0.06));
    send({0.0, 2.5});
    CHECK_FALSE(bell.rings(session, 0.06));  // it has just rung
    const BallId ball = session.world().balls().id[1];
    REQUIRE_FALSE(session.apply(command::PlaceBall{ball, {0.1, 0.3}}).has_value());
    session.step_forward();
    CHECK(bell.rings(session, 1.0));
}

TEST_CASE("the bell is off until a key turns it on, and the setting is kept") {
    const TableHome home;
    {
        AtTable table(home);
        CHECK_FALSE(table.program.take_bell());
        table.key(U'l');
        CHECK(table.sees("bell"));
        CHECK(table.program.take_bell());  // an audible sample for the player
        CHECK_FALSE(table.program.take_bell());
    }
    std::ifstream file(home.path / "config/carom/preferences");
    std::string line;
    std::getline(file, line);
    CHECK(line == "bell = on");
    CHECK(read_preferences(line, "p").preferences.bell);
    CHECK_FALSE(read_preferences("", "p").preferences.bell);
}

TEST_CASE("how the terminal repeats keys is remembered when the game ends") {
    const TableHome home;
    {
        AtTable table(home);
        table.key(U'z');
        for (double wait = 0.5; wait > 0.0; wait = table.now < 101.5 ? 0.04 : 0.0) {
            table.pass(wait);
            table.key(U'z');
        }
        CHECK(table.sees("a tap lasts 0.54 s"));
        table.key(U'q');
    }
    std::ifstream file(home.path / "config/carom/preferences");
    std::string line;
    std::getline(file, line);
    CHECK(line == "key-repeat = 500 40");
    AtTable table(home, false, false, line.c_str());
    CHECK(table.sees("a tap lasts 0.54 s"));
}

TEST_CASE("a gauge shows how far the plunger is pulled") {
    const TableHome home;
    AtTable table(home);
    table.key(key::enter);
    table.pass(0.3);
    CHECK(table.sees("plunger"));
    CHECK(table.sees("30 %"));
}

TEST_CASE("high scores and the flipper mode survive a reload of the level") {
    const TableHome home;
    home.write("data/carom/high-scores", "carom high scores 1\nwork 4321 XYZ\n");
    AtTable table(home, true, true);
    CHECK(table.sees("XYZ"));
    table.key(U'k');
    CHECK(table.sees("a press raises a flipper, the next one lowers it"));
    table.pass(0.1);
    table.pass(4.5);  // the message ends
    CHECK(table.sees("Each press turns one over"));
    std::string changed = level;
    changed.replace(changed.find("A small table"), 13, "Another table");
    home.write("work.level", changed);
    table.pass(0.5);
    REQUIRE(table.sees("Another table"));
    CHECK(table.sees("XYZ"));
    CHECK(table.sees("4,321"));
    table.pass(4.5);
    CHECK(table.sees("Each press turns one over"));
    // The number of lines that the level has now.
    changed.replace(changed.find("highscores=3"), 12, "highscores=0");
    home.write("work.level", changed);
    table.pass(0.5);
    CHECK_FALSE(table.sees("XYZ"));
}

TEST_CASE("a flipper can be bound to another key in the preferences, and hints show it") {
    const TableHome home;
    AtTable table(home, true, false, "p = left-flipper\nz = none\nleft = none\n");
    const std::size_t at_rest = table.picture();
    CHECK(table.sees("Flippers: p and /, or mouse buttons"));
    table.key(U'z');
    table.pass(0.1);
    CHECK(table.picture() == at_rest);
    table.key(U'p');
    table.pass(0.1);
    CHECK(table.picture() != at_rest);
    table.key(U'p', InputEvent::Action::release);
    table.pass(0.2);
    CHECK(table.picture() == at_rest);
}

TEST_CASE("a game that has begun is kept when its player leaves, and can be resumed") {
    const TableHome home;
    {
        AtTable table(home);
        table.pass(1.0);
        table.key(U'q');
        CHECK_FALSE(table.program.is_kept());
    }
    {
        AtTable table(home);
        CHECK_FALSE(table.sees("Unfinished"));
        table.key(U'd');
        table.pass(4.0);
        table.key(U'q');
        CHECK_FALSE(table.program.is_kept());
    }
    for (const char32_t leaving : {U'q', key::escape}) {
        CAPTURE(leaving);
        AtTable table(home);
        table.key(key::enter);
        table.pass(2.0);
        table.key(leaving);
        REQUIRE(table.program.is_kept());
        AtTable later(home);
        CHECK(later.sees("Unfinished game at"));
        later.key(U'R');
        later.pass(0.5);
        CHECK(later.sees("Resumed."));
    }
}

TEST_CASE("a table that nobody has played is no unfinished game, even where the terminal is gone") {
    const TableHome home;
    for (const bool is_played : {false, true}) {
        CAPTURE(is_played);
        {
            AtTable table(home);
            if (is_played) table.key(key::enter);
            table.pass(8.0);
            table.program.interrupt();
        }
        AtTable later(home, false, false, "", true);
        CHECK(later.sees("There is no unfinished game: a new one begins.") == !is_played);
        later.pass(0.5);
        CHECK(later.sees("Resumed.") == is_played);
    }
}

TEST_CASE("one stray key does not end a game, two do") {
    const TableHome home;
    AtTable table(home);
    table.key(U'r');
    CHECK(table.sees("Restarted."));
    table.key(key::enter);
    table.pass(2.0);
    table.key(U'r');
    CHECK(table.sees("Press r again to end this game."));
    table.pass(4.0);
    table.key(U'r');
    CHECK(table.sees("Press r again to end this game."));
    table.key(U'r');
    CHECK(table.sees("Restarted."));
}

TEST_CASE("one stray key does not cost a game its place among the high scores, two do") {
    const TableHome home;
    home.write("work.level", short_game);
    for (const char32_t risk : {U'<', U',', U'-', U'd'}) {
        for (const bool twice : {false, true}) {
            CAPTURE(static_cast<char>(risk));
            CAPTURE(twice);
            AtTable table(home);
            table.pass(1.0);
            table.key(key::enter);
            table.pass(2.6);
            REQUIRE(table.sees("NO BONUS"));
            table.key(risk);
            CHECK(table.sees("no high score then."));
            if (twice) table.key(risk);
            table.pass(0.1);
            table.key(U'z');
            if (twice && risk == U',') table.key(U' ');  // stepping pauses
            table.pass(12.0);
            CHECK(table.sees("YOUR INITIALS") == !twice);
        }
    }
}

TEST_CASE("a table that keeps no high scores, or was changed by --set, asks for no initials") {
    const TableHome home;
    home.write("work.level", short_game);
    const std::vector<std::string> changes[] = {
        {}, {"use gravity 0,-0.7m/s2"}, {"game pinball balls=1 save=0s highscores=0"}};
    for (const std::vector<std::string>& change : changes) {
        AtTable table(home, false, false, "", false, change);
        table.pass(1.0);
        table.key(key::enter);
        table.pass(10.0);
        CHECK(table.sees("GAME OVER"));
        CHECK(table.sees("YOUR INITIALS") == change.empty());
    }
}

TEST_CASE("a game in slow motion asks for no initials") {
    const TableHome home;
    home.write("work.level", short_game);
    AtTable table(home);
    table.key(U'-');
    table.pass(2.0);
    table.key(key::enter);
    bool is_told = false;
    for (int i = 0; i < 80 && !is_told; ++i) {
        table.pass(0.1);
        is_told = table.sees("Slow motion: this game is not for the high scores.");
    }
    CHECK(is_told);
    table.pass(20.0);
    CHECK(table.sees("GAME OVER"));
    CHECK_FALSE(table.sees("YOUR INITIALS"));
    // Nothing is said of the next game while it is as fast as the table.
    table.key(U'*');
    table.key(key::enter);
    table.pass(1.0);
    table.key(key::enter);
    table.pass(12.0);
    CHECK(table.sees("YOUR INITIALS"));
}

TEST_CASE("in a game of pinball no key changes the scene, and the hints name no key of the table") {
    const TableHome home;
    AtTable table(home);
    table.key(key::enter);
    table.pass(2.0);
    const std::size_t before = table.picture();
    table.key(U' ');
    for (const char32_t editing : {U'a', U'g', U'G', U'e', U'E', U's', U'u'}) {
        CAPTURE(static_cast<char>(editing));
        table.key(U'V');
        table.key(editing);
        CHECK(table.sees("Disabled under rules."));
    }
    CHECK(table.picture() == before);
    CHECK(table.sees("space resume"));
    CHECK_FALSE(table.sees(". step"));
}

TEST_CASE("a key of the table that takes over from the demo says so") {
    const TableHome home;
    AtTable table(home);
    table.key(U'd');
    CHECK(table.sees("carom plays"));
    table.key(U'z');
    CHECK_FALSE(table.sees("carom plays"));
    CHECK(table.sees("your game"));
}

TEST_CASE("a plunger that is held as the game ends lets go while initials are typed") {
    const TableHome home;
    home.write("work.level", short_game);
    AtTable table(home, true);
    table.pass(1.0);
    table.key(key::enter);
    table.pass(1.5);
    table.key(key::enter, InputEvent::Action::release);
    table.pass(1.5);
    table.key(key::enter);
    table.pass(1.0);
    REQUIRE(table.sees("100 %"));
    table.pass(10.0);
    REQUIRE(table.sees("YOUR INITIALS"));
    CHECK(table.sees("GAME OVER"));
    CHECK_FALSE(table.sees("100 %"));
    table.key(key::enter, InputEvent::Action::release);
    table.key(U'e');
    table.key(key::enter);
    REQUIRE_FALSE(table.sees("YOUR INITIALS"));
    table.key(key::enter);
    table.pass(0.5);
    table.key(key::enter, InputEvent::Action::release);
    table.pass(0.5);
    CHECK(table.sees("ball 1 of 1"));
    CHECK_FALSE(table.sees("100 %"));
}

TEST_CASE("the ball saver does not hide how many warnings are left") {
    const TableHome home;
    std::string text = short_game;
    text.replace(text.find("save=0s"), 7, "save=10s");
    home.write("work.level", text);
    AtTable table(home, true);
    table.pass(1.0);
    table.key(key::enter);
    table.pass(1.0);
    table.key(key::enter, InputEvent::Action::release);
    table.pass(0.2);
    for (int i = 0; i < 2; ++i) {
        table.key(U'x');
        table.pass(0.12);
        table.key(U'x', InputEvent::Action::release);
    }
    CHECK(table.sees("ball saver 8 s, warning 1 of 3"));
}

TEST_CASE("a tilt ends a celebration") {
    const TableHome home;
    std::string text = short_game;
    text.replace(text.find("score 700"), 9, "score 7000, message \"WELL DONE\"");
    text.replace(text.find("save=0s"), 7, "save=0s tilt=0");
    text.replace(text.find("350,320 399,320"), 15, "10,10 20,10 r=3");
    home.write("work.level", text);
    AtTable table(home, true);
    table.pass(1.0);
    table.key(key::enter);
    table.pass(1.5);
    table.key(key::enter, InputEvent::Action::release);
    for (int i = 0; i < 100 && !table.sees("W E L L"); ++i)
        table.pass(0.05);
    REQUIRE(table.sees("W E L L"));
    for (int i = 0; i < 8; ++i) {
        table.key(U'x');
        table.pass(0.12);
        table.key(U'x', InputEvent::Action::release);
    }
    CHECK(table.sees("TILT"));
    CHECK_FALSE(table.sees("W E L L"));
}

#include "carom/play/program.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "carom/files/high_scores.h"
#include "carom/play/settings_file.h"
#include "carom/support/home.h"
#include "game/replay/replay_text.h"
#include "game/replay/replayer.h"
#include "level/load.h"
#include "physics/version.h"

using namespace carom;
using carom::test::contents;
using carom::test::Running;
namespace fs = std::filesystem;

namespace {

const char* const level = R"(carom 1 "A test"
edge r=1  0,0  40,0  40,30  0,30  close
ball a at=10,10 v=7,3
ball b at=20,15 v=-5,4
)";

struct Home : test::Home {
    Home() { write("test.level", level); }
};

PlayOptions playing(const char* name) {
    PlayOptions options;
    options.level = name;
    return options;
}

}  // namespace

TEST_CASE("a level named on the command line is played") {
    const Home home;
    Running running(playing("test.level"));
    REQUIRE_FALSE(running.program.start());
    CHECK(running.sees("A test"));
    running.pass(0.5);
    CHECK(running.sees("tick 60"));
    running.key(U'q');
    CHECK(running.program.is_over());
}

TEST_CASE("a missing or faulty level is reported") {
    const Home home;
    home.write("bad.level", "carom 1 \"Bad\"\nball at=0,0 r=-1\n");
    auto problems = Running(playing("nowhere.level")).program.start();
    REQUIRE(problems);
    CHECK(problems->front().find("nowhere.level") != std::string::npos);
    problems = Running(playing("bad.level")).program.start();
    REQUIRE(problems);
    CHECK(problems->front().find("bad.level:2:") != std::string::npos);
}

TEST_CASE("a watched level is reloaded when it is saved; errors leave the old one playing") {
    const Home home;
    PlayOptions options = playing("test.level");
    options.watch = true;
    Running running(options);
    REQUIRE_FALSE(running.program.start());
    running.pass(0.5);
    home.write("test.level", "carom 1 \"Worse\"\nball at=0,0 r=-1\n");
    running.pass(0.5);
    CHECK(running.sees("A test"));
    CHECK(running.sees("test.level:2:"));
    running.pass(0.5);
    CHECK(running.sees("A test"));
    home.write("test.level", std::string("carom 1 \"Better\"\nball at=0,0 v=1,0\n"));
    running.pass(0.5);
    CHECK(running.sees("Better"));
    running.pass(5.0);
    CHECK_FALSE(running.sees("error"));
}

TEST_CASE("a watched level that starts with errors is waited for") {
    const Home home;
    home.write("bad.level", "carom 1 \"Bad\"\nball at=0,0 r=-1\n");
    PlayOptions options = playing("bad.level");
    options.watch = true;
    Running running(options);
    REQUIRE_FALSE(running.program.start());
    CHECK(running.sees("bad.level:2:"));
    home.write("bad.level", level);
    running.pass(0.5);
    CHECK(running.sees("A test"));
}

TEST_CASE("an interrupted game is resumed at the point of interruption") {
    const Home home;
    const pid_t child = ::fork();
    if (child == 0) {
        Running running(playing("test.level"));
        running.program.start();
        running.pass(0.5);
        running.key(U'g');
        running.pass(0.5);
        InputEvent hangup;
        hangup.kind = InputEvent::Kind::hangup;
        running.program.handle(hangup, running.now);
        ::_exit(running.program.is_over() ? 0 : 1);
    }
    int status = 1;
    ::waitpid(child, &status, 0);
    REQUIRE(status == 0);

    SUBCASE("by the option") {
        PlayOptions options;
        options.resume = true;
        Running running(options);
        REQUIRE_FALSE(running.program.start());
        running.pass(0.1);
        CHECK(running.sees("tick 120"));
        CHECK(running.sees("gravity"));
        running.key(U' ');
        running.pass(0.5);
        CHECK(running.sees("tick 180"));
    }
    SUBCASE("by the key, when the level is played again") {
        Running running(playing("test.level"));
        REQUIRE_FALSE(running.program.start());
        CHECK(running.sees("Press R to resume"));
        running.pass(0.25);
        running.key(U'R');
        running.pass(0.1);
        CHECK(running.sees("tick 120"));
    }
    SUBCASE("from the menu") {
        Running running({});
        REQUIRE_FALSE(running.program.start());
        CHECK(running.sees("Unfinished"));
        running.key(key::enter);
        running.pass(0.1);
        CHECK(running.sees("tick 120"));
        running.key(U'q');
        Running after({});
        REQUIRE_FALSE(after.program.start());
        CHECK_FALSE(after.sees("Unfinished"));
    }
    SUBCASE("on the level that it began on, also from the menu, when that has changed") {
        const auto menu_sees = [](const std::string& text) {
            Running running({});
            CHECK_FALSE(running.program.start());
            running.pass(0.2);
            return running.sees(text);
        };
        CHECK(menu_sees("Enter resumes it at 0:01."));
        home.write("test.level", std::string(level) + "ball at=30,20\n");
        CHECK(menu_sees("Enter resumes it at 0:01."));
        home.write("test.level", "carom 1 \"Bad\"\nball at=0,0 r=-1\n");
        CHECK(menu_sees("Enter resumes it at 0:01."));
    }
    SUBCASE("from its recording, when the file of its level is gone") {
        fs::remove("test.level");
        Running running({});
        REQUIRE_FALSE(running.program.start());
        running.pass(0.2);
        CHECK(running.sees("Enter resumes it at 0:01."));
        running.key(key::enter);
        running.pass(0.1);
        CHECK(running.sees("tick 120"));
        CHECK(running.sees("gravity"));
        running.key(U'r');
        CHECK(running.sees("tick 0"));
    }
    SUBCASE("on the level that it began on, and says so, when that has changed") {
        home.write("test.level", "# A comment more.\n" + std::string(level) + "ball at=30,20\n");
        PlayOptions options;
        options.resume = true;
        Running running(options);
        REQUIRE_FALSE(running.program.start());
        running.pass(0.1);
        CHECK(running.sees("Resumed on its earlier level."));
        CHECK(running.sees("tick 120"));
    }
}

TEST_CASE("a game of pool that was left while aiming is resumed ready to shoot, not paused") {
    const Home home;
    {
        Running running(playing("eight-ball"));
        REQUIRE_FALSE(running.program.start());
        running.look();
        running.key(key::enter);
        for (int i = 0; i < 1200; ++i)
            running.pass(1.0 / 60.0);
        REQUIRE_FALSE(running.sees("the balls roll"));
        REQUIRE_FALSE(running.sees("breaks"));
        running.key(U'q');
    }
    Running running({});
    REQUIRE_FALSE(running.program.start());
    running.key(key::enter);
    for (int i = 0; i < 20 && !running.sees("Resumed."); ++i)
        running.pass(0.1);
    REQUIRE(running.sees("Resumed."));
    CHECK_FALSE(running.sees("breaks"));
    CHECK_FALSE(running.sees("paused"));
}

TEST_CASE("a game is saved every few seconds, so that even a kill loses little") {
    const Home home;
    Running running(playing("test.level"));
    REQUIRE_FALSE(running.program.start());
    for (int i = 0; i < 70; ++i)
        running.pass(0.1);
    const fs::path folder = home.path / "state/carom/cut-off";
    REQUIRE(fs::exists(folder));
    CHECK_FALSE(fs::is_empty(folder));
    running.key(U'q');
    CHECK(fs::is_empty(folder));
}

TEST_CASE("settings changed by keys are kept, and so are a person's comments") {
    const Home home;
    fs::create_directories(home.preferences().parent_path());
    std::ofstream(home.preferences()) << "# mine\nrenderer = ascii\nz = quit\n";
    Running running(playing("test.level"), contents(home.preferences()));
    REQUIRE_FALSE(running.program.start());
    running.key(U'm');
    CHECK(contents(home.preferences()) == "# mine\nrenderer = ascii\nz = quit\nmouse = off\n");
    running.key(U'z');
    CHECK(running.program.is_over());
}

// Regression: the failure was ignored silently.
TEST_CASE("a key is changed in play: the other key takes its place, and both are kept") {
    const Home home;
    Running running(playing("test.level"));
    REQUIRE_FALSE(running.program.start());
    running.key(key::f1 + 2);
    CHECK(running.sees("Press the key that you want to change"));
    running.key(U'Q');
    CHECK(running.sees("Q does nothing."));
    running.key(U'g');
    CHECK(running.sees("g: gravity on, off. Press its new key."));
    running.key(U'v');
    CHECK(running.sees("v: gravity on, off.  g: next renderer."));
    CHECK(contents(home.preferences()).find("v = gravity") != std::string::npos);
    CHECK(contents(home.preferences()).find("g = renderer") != std::string::npos);
    running.key(U'c');  // ends the message
    CHECK_FALSE(running.sees("gravity"));
    running.key(U'v');
    CHECK(running.sees("gravity"));
    running.key(U'?');
    CHECK(running.sees("f3: change a key"));
    running.key(key::f1 + 2);  // leaves the page
    CHECK(running.sees("Press the key that you want to change"));
    running.key(key::escape);
    CHECK_FALSE(running.sees("Press the key"));
    CHECK_FALSE(running.program.is_over());
}

TEST_CASE("a flipper key is changed at a pinball table, and the hints name the new one") {
    const Home home;
    PlayOptions options;
    options.level = "three-bumpers";
    {
        Running running(options);
        REQUIRE_FALSE(running.program.start());
        CHECK(running.sees("Flippers: z and /"));
        running.key(key::f1 + 2);
        running.key(U'z');
        CHECK(running.sees("z: left flipper. Press its new key."));
        running.key(U'a');
        CHECK(running.sees("a: left flipper."));
        running.pass(0.1);
        running.pass(4.5);  // the message ends
        CHECK(running.sees("Flippers: a and /"));
    }
    CHECK(contents(home.preferences()) == "a = left-flipper\n");
    Running again(options, contents(home.preferences()));
    REQUIRE_FALSE(again.program.start());
    CHECK(again.sees("Flippers: a and /"));
}

TEST_CASE("a light theme brings its own background into a dark terminal") {
    const Home home;
    PlayOptions options = playing("test.level");
    const auto background = [&](const char* theme) {
        options.theme = theme_choice(theme);
        Running running(options);
        running.program.start();
        running.look();
        return running.window.at(0, 10).background;
    };
    CHECK(background("auto") == default_color);
    CHECK(background("dark") == default_color);
    REQUIRE(background("light") != default_color);
    CHECK(luminance(rgb_of(background("light"))) > 0.8);
}

TEST_CASE("the theme changes by a key, in play and in the menu, and is kept") {
    const Home home;
    Running running(playing("test.level"));
    REQUIRE_FALSE(running.program.start());
    running.key(key::f1 + 1);
    CHECK(running.sees("theme: light"));
    running.program.draw(running.window);
    CHECK(luminance(rgb_of(running.window.at(0, 0).background)) > 0.8);
    running.key(key::f1 + 1);
    CHECK(running.sees("theme: contrast"));
    CHECK(contents(home.preferences()) == "theme = contrast\n");
    running.key(key::escape);
    CHECK(running.sees("f2 theme"));
    running.key(key::f1 + 1);
    CHECK(running.sees("theme: color-blind"));
    CHECK(contents(home.preferences()) == "theme = color-blind\n");
    running.key(key::down);
    CHECK_FALSE(running.sees("theme: color-blind"));
    running.key(key::f1 + 1);
    CHECK(running.sees("theme: auto"));
}

TEST_CASE("the key for themes goes to each that looks different on this terminal") {
    const auto after = [](std::string_view now, bool is_terminal_light) {
        return theme_after(*theme_choice(now), is_terminal_light);
    };
    for (const bool is_light : {false, true}) {
        CAPTURE(is_light);
        const std::string_view other = is_light ? "dark" : "light";
        CHECK(after("auto", is_light) == other);
        CHECK(after(other, is_light) == "contrast");
        CHECK(after("contrast", is_light) == "color-blind");
        CHECK(after("color-blind", is_light) == "auto");
    }
    CHECK(after("dark", false) == "light");
    CHECK(after("light", true) == "contrast");
}

TEST_CASE("preferences that cannot be written are reported once, and the game continues") {
    const Home home;
    const auto is_told = [&](const std::string& why) {
        Running running(playing("test.level"));
        REQUIRE_FALSE(running.program.start());
        running.key(U'm');
        const bool told = running.sees("such choices are not kept: " + why);
        // A message's time begins with the first step after it came up.
        running.pass(0.1);
        running.pass(60.0);
        CHECK_FALSE(running.sees("not kept"));
        running.key(U'm');
        CHECK_FALSE(running.sees("not kept"));
        return told;
    };
    std::ofstream(home.path / "config") << "in the way";
    CHECK(is_told("cannot"));
    // A file that cannot be read is not overwritten either.
    fs::remove(home.path / "config");
    fs::create_directories(home.preferences());
    CHECK(is_told("cannot"));
    CHECK(fs::is_directory(home.preferences()));
    // So is one that has no place.
    ::unsetenv("XDG_CONFIG_HOME");
    const char* const place = std::getenv("HOME");
    const std::string before = place ? place : "";
    ::unsetenv("HOME");
    CHECK(is_told("HOME is not set"));
    ::setenv("HOME", "home", 1);
    CHECK(is_told("HOME is 'home', which is no absolute path"));
    if (place) ::setenv("HOME", before.c_str(), 1);
}

TEST_CASE("found 17: what the view of one level shows stays in that level") {
    const Home home;
    home.write("zebra.level", "carom 1 \"Stripes\"\nball a at=0,0\n");
    Running running({});
    REQUIRE_FALSE(running.program.start());
    const auto play = [&](const std::u32string& name) {
        for (const char32_t c : name)
            running.key(c);
        running.key(key::enter);
    };
    const auto leave = [&] {
        running.key(key::escape);
        REQUIRE(running.sees("a r o m"));
    };
    play(U"test");
    running.key(U'4');
    CHECK(running.sees("numbers on"));
    leave();
    play(U"zebra");
    running.key(U'4');
    CHECK(running.sees("numbers on"));
    leave();
    play(U"test");
    running.key(U'4');
    CHECK(running.sees("numbers off"));
    running.key(U'4');
    running.key(U'V');
    running.key(U'4');
    CHECK(running.sees("numbers on"));
    CHECK_FALSE(fs::exists(home.preferences()));
}

TEST_CASE("an error in the preferences is shown, and the game is played") {
    const Home home;
    Running running(playing("test.level"), "renderer = fancy\n");
    REQUIRE_FALSE(running.program.start());
    CHECK(running.sees("preferences:1:12: error"));
}

TEST_CASE("found 34: a level is saved under the name that is typed, in its author's words") {
    const Home home;
    Running running(playing("test.level"));
    REQUIRE_FALSE(running.program.start());
    running.pass(0.3);
    running.key(U'w');
    CHECK(running.sees("Save as: test-1_"));
    for (const char32_t c : std::u32string(U"m/y"))
        running.key(c);
    CHECK(running.sees("Save as: my_"));
    const std::string before = running.look();
    running.pass(1.0);  // the game waits
    CHECK(running.look() == before);
    running.key(key::enter);
    CHECK(running.sees("Saved as my.level. Play it from the menu, in the group Yours."));
    const std::string saved = contents("my.level");
    CHECK(saved.starts_with(level));
    CHECK(saved.find("\nmove a at=") != std::string::npos);
    CHECK_FALSE(Running(playing("my.level")).program.start());

    running.key(U'w');
    for (const char32_t c : std::u32string(U"my"))
        running.key(c);
    running.key(key::enter);
    CHECK(running.sees("my.level exists already"));
    CHECK(contents("my.level") == saved);

    running.key(U'w');
    running.key(key::escape);
    CHECK_FALSE(running.sees("Save as"));
    CHECK_FALSE(fs::exists("test-1.level"));
}

TEST_CASE("a recording that cannot be written promises a game to resume only if there is one") {
    const Home home;
    for (const bool is_kept : {true, false}) {
        CAPTURE(is_kept);
        fs::remove_all(home.path / "state");
        if (!is_kept) std::ofstream(home.path / "state") << "in the way of the folder";
        fs::create_directory("gone");
        PlayOptions options = playing("test.level");
        options.record = "gone/out.replay";
        Running running(options);
        REQUIRE_FALSE(running.program.start());
        running.pass(0.5);
        fs::remove_all("gone");
        running.key(U'q');
        REQUIRE(running.program.lost_recording());
        const std::string& lost = *running.program.lost_recording();
        CHECK((lost.find("carom play --resume --record FILE resumes the game") != lost.npos) ==
              is_kept);
        CHECK((lost.find("the game could not be kept") != lost.npos) == !is_kept);
    }
}

TEST_CASE("a recording is kept from play, and watched from the menu") {
    const Home home;
    {
        Running running(playing("test.level"));
        REQUIRE_FALSE(running.program.start());
        running.pass(0.5);
        running.key(U'g');
        running.pass(0.5);
        running.key(U'W');
        CHECK(running.sees("Keep the recording as: test-1_"));
        running.key(key::tab);
        CHECK(running.sees("Keep the recording as: test-1_"));
        for (const char32_t c : U"xyzzy")
            if (c != 0) running.key(c);
        running.key(key::enter);
        CHECK(running.sees("Kept as xyzzy."));
        CHECK(fs::exists(home.path / "data/carom/recordings/xyzzy.replay"));
        running.pass(0.5);
        running.key(U'W');
        for (const char32_t c : U"xyzzy")
            if (c != 0) running.key(c);
        running.key(key::enter);
        CHECK(running.sees("There is a recording xyzzy."));
        running.key(key::escape);
    }
    Running running({});
    REQUIRE_FALSE(running.program.start());
    for (const char32_t c : U"xyzzy")
        if (c != 0) running.key(c);
    CHECK(running.sees("watch 0:01"));
    running.pass(0.5);
    CHECK(running.sees("A recording of test"));
    running.key(key::enter);
    running.pass(0.25);
    CHECK(running.sees("tick 30"));
    running.key(U'W');  // not of a recording
    CHECK_FALSE(running.sees("Keep the recording"));
    running.pass(2.0);
    CHECK(running.sees("tick 120"));
    CHECK_FALSE(running.sees("not what was recorded"));
    running.key(key::escape);
    CHECK(running.sees("> xyzzy"));
    std::ofstream(home.path / "data/carom/recordings/bad.replay") << "carom replay 3\nnonsense\n";
    running.key(key::enter);
    running.key(key::escape);
    CHECK(running.sees("> xyzzy"));
    CHECK(running.sees("bad"));
    running.key(key::up);
    running.key(key::enter);
    CHECK(running.sees("This recording cannot be played"));
}

TEST_CASE("the start of a level is saved with the edges that the player has drawn") {
    const Home home;
    Running running(playing("test.level"));
    REQUIRE_FALSE(running.program.start());
    running.pass(0.3);
    running.key(U' ');
    running.look();  // places the camera, by which the cursor moves
    for (int i = 0; i < 9; ++i)
        running.key(key::right);
    running.key(U'e');
    for (int i = 0; i < 4; ++i)
        running.key(key::up);
    running.key(U'e');
    REQUIRE(running.sees("Edge added"));
    running.key(U'w');
    running.key(key::tab);
    CHECK(running.sees("(its start)"));
    running.key(key::enter);
    const std::string saved = contents("test-1.level");
    CHECK(saved.starts_with(level));
    CHECK(saved.find("\nedge r=") != std::string::npos);
    CHECK(saved.find("move") == std::string::npos);
}

TEST_CASE("a level that cannot be kept in its author's words is saved flat, and says why") {
    const Home home;
    Running running(playing("test.level"));
    REQUIRE_FALSE(running.program.start());
    running.pass(0.3);
    running.key(U' ');
    running.look();
    running.key(U'e');  // through the place where ball b starts, in the middle of the view
    for (int i = 0; i < 4; ++i)
        running.key(key::up);
    running.key(U'e');
    running.key(U'w');
    running.key(key::tab);
    running.key(key::enter);
    CHECK(running.sees("Saved flat as test-1-flat.level"));
    CHECK_FALSE(fs::exists("test-1.level"));
    CHECK_FALSE(Running(playing("test-1-flat.level")).program.start());
}

TEST_CASE("the mouse is left to the terminal and taken again") {
    const Home home;
    Running running(playing("test.level"));
    REQUIRE_FALSE(running.program.start());
    CHECK(running.program.screen_requests().mouse);
    running.key(U'm');
    CHECK_FALSE(running.program.screen_requests().mouse);
    CHECK(running.sees("mouse"));
    running.key(U'm');
    CHECK(running.program.screen_requests().mouse);
}

TEST_CASE("from the game to the menu and back") {
    const Home home;
    Running running({});
    REQUIRE_FALSE(running.program.start());
    CHECK(running.sees("a r o m"));
    for (const char32_t c : std::u32string(U"a test"))
        running.key(c);
    running.key(key::enter);
    CHECK(running.sees("tick 0"));
    running.key(key::escape);
    CHECK(running.sees("a r o m"));
    running.key(U'q');
    CHECK(running.program.is_over());
}

TEST_CASE(
    "a watched recording of another physics version says so where it differs, and continues") {
    const Home home;
    LoadResult loaded = load_level(level, "test.level");
    REQUIRE(loaded.scene);
    Session session(std::move(*loaded.scene), {.kind = SolverKind::swept});
    while (session.world().tick() < 300)
        session.step_forward();
    Replay replay = record(session, "test.level", {});
    replay.commands = {{30, command::Strike{BallId{0}, {1.0, 1.0}}}};
    for (const int version : {physics_version, physics_version + 1}) {
        CAPTURE(version);
        replay.physics_version = version;
        home.write("a.replay", replay_text(replay));
        PlayOptions options;
        options.replay = "a.replay";
        Running running(options);
        REQUIRE_FALSE(running.program.start());
        running.pass(0.75);
        CHECK_FALSE(running.sees("physics"));
        running.pass(1.0);
        CHECK(running.sees("the fingerprint differs") == (version == physics_version));
        const std::string told =
            fmt::format("recorded under physics {}; this is physics {}", version, physics_version);
        CHECK(running.sees(told.c_str()) == (version != physics_version));
        CHECK(running.sees("tick 210"));
    }
}

TEST_CASE("a goal that is reached gives stars, which the menu shows from then on") {
    const Home home;
    home.write("goal.level", R"(carom 1 "A goal"
use gravity 0,-10
ball falls at=0,0
zone low 0,-20 0,-20 r=5
goal "Fall." within 1 10 20 seconds if count(falls,low)=1
)");
    CHECK(load_stars("goal.level") == 0);
    {
        Running running(playing("goal.level"));
        REQUIRE_FALSE(running.program.start());
        running.pass(0.5);
        CHECK(running.sees("Fall."));
        CHECK(load_stars("goal.level") == 0);
        for (int i = 0; i < 4; ++i)
            running.pass(0.5);
        CHECK(running.sees("Done in 1."));
        CHECK(running.sees("2 of 3 stars"));
        CHECK(load_stars("goal.level") == 2);
    }
    CHECK_FALSE(keep_stars("goal.level", 1));
    CHECK(load_stars("goal.level") == 2);
    Running menu{PlayOptions{}};
    REQUIRE_FALSE(menu.program.start());
    menu.key(U'A');
    for (const char c : std::string(" goal"))
        menu.key(static_cast<char32_t>(c));
    CHECK(menu.sees("**."));
}

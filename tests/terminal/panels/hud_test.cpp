#include "terminal/panels/hud.h"

#include <doctest/doctest.h>

#include <string>

using namespace carom;

namespace {

HudInfo galton() {
    HudInfo info;
    info.title = "Galton board, 12 rows";
    info.solver = "swept";
    info.solver_is_picked = true;
    info.time = 12.345;
    info.tick = info.latest_tick = 1481;
    info.ticks_per_second = 119.7;
    info.rate = 120;
    info.terms = {"gravity 0,-9.81", "restitution", "scatter 20deg"};
    info.balls = 137;
    info.collisions = 4711;
    info.kinetic_energy = 123.456789;
    info.potential_energy = -17.25;
    info.momentum = {0.123, -4.5};
    info.energy_drift = 1.3e-13;
    info.momentum_drift = 0.0;
    info.hints = {{"space", "pause"}, {".", "step"}, {",", "back"}, {"?", "help"}, {"q", "quit"}};
    return info;
}

constexpr Look plain_look{0, false, false};

std::string drawn(const HudInfo& info, int columns, int rows, const Look& look = plain_look) {
    Canvas canvas(columns, rows);
    draw_hud(canvas, info, look);
    const std::string text = canvas.text();
    // The status lines alone.
    return "\n" + text.substr(static_cast<std::size_t>(world_area(columns, rows).rows));
}

}  // namespace

TEST_CASE("the world gets everything but the status lines") {
    for (const auto& [columns, rows] : {std::pair{20, 8}, {40, 12}, {80, 24}, {300, 100}, {1, 1}}) {
        const CellArea area = world_area(columns, rows);
        CHECK(area.rows + hud_rows(columns, rows) == rows);
        CHECK(area.columns == columns);
    }
    CHECK(hud_rows(80, 24) == 3);
    CHECK(hud_rows(20, 8) == 1);
    CHECK(hud_rows(80, 0) == 0);
}

TEST_CASE("the status line shows the number of balls under contact") {
    HudInfo info = galton();
    info.solver = "event";
    CHECK(drawn(info, 160, 24).find("under contact") == std::string::npos);
    info.clustered = 37;
    CHECK(drawn(info, 160, 24).find("37 of 137 under contact") != std::string::npos);
}

TEST_CASE("status lines in a usual window") {
    CHECK(drawn(galton(), 80, 24) == R"(
 Galton board, 12 rows  > x1         12.345 s  swept (auto)    120/120 ticks/s
 KE 123.46      drift +1.3e-13  p +0.123    -4.5       model gravity +2
 space pause  . step  , back  ? help  q quit
)");
}

TEST_CASE("status lines in a wide window show everything") {
    const std::string text = drawn(galton(), 200, 24);
    for (const char* part :
         {"Galton board, 12 rows", "> x1", "12.345 s", "tick 1481", "swept (auto)",
          "120/120 ticks/s", "balls 137", "collisions 4711", "KE 123.46", "PE -17.25",
          "drift +1.3e-13", "p +0.123", "-4.5", "drift 0",
          "model gravity 0,-9.81, restitution, scatter 20deg", "space pause", "q quit"}) {
        CAPTURE(std::string(part));
        CAPTURE(text);
        CHECK(text.find(part) != std::string::npos);
    }
}

TEST_CASE("status lines in small windows keep the most important fields") {
    CHECK(drawn(galton(), 40, 20) == R"(
 > x1         12.345 s  swept (auto)
 KE 123.46      drift +1.3e-13
 space pause  . step  , back  ? help
)");
    CHECK(drawn(galton(), 40, 12) == R"(
 > x1         12.345 s  swept (auto)
 space pause  . step  , back  ? help
)");
    CHECK(drawn(galton(), 20, 8) == R"(
 Galton b  > x1
)");
}

TEST_CASE("expectations come first, and are green once they hold") {
    HudInfo info = galton();
    info.checks = {{.quantity = "collisions", .measured = 2817, .value = 3141, .is_exact = true},
                   {.quantity = "energy", .measured = 1.25, .value = 1.0}};
    const std::string text = drawn(info, 160, 24);
    CHECK(text.find(" collisions 2817 of 3141  energy    1.25, expected 1  KE") !=
          std::string::npos);
    CHECK(text.find("4711") == std::string::npos);  // not repeated
    CHECK(drawn(info, 80, 24).find(" collisions 2817 of 3141  KE") != std::string::npos);

    const Look look{256, true, false};
    const auto color = [&](double measured) {
        info.checks = {{.quantity = "collisions",
                        .measured = measured,
                        .value = 3141,
                        .is_exact = true,
                        .holds = measured == 3141}};
        Canvas canvas(80, 24);
        draw_hud(canvas, info, look);
        return canvas.at(12, 22).foreground;
    };
    CHECK(color(3141) == ink_of(Role::good, look).color);
    CHECK(color(2817) == ink_of(Role::text, look).color);
}

TEST_CASE("a limit that the level expects stands beside the value") {
    HudInfo info = galton();
    info.checks = {{.quantity = "a.x", .relation = "<", .measured = 0.25, .value = 0.5}};
    CHECK(drawn(info, 160, 24).find(" a.x    0.25 < 0.5") != std::string::npos);
}

TEST_CASE("a long title gets half of the line before the least important numbers do") {
    HudInfo info = galton();
    info.title = "A title that is quite a bit longer than others";
    CHECK(drawn(info, 80, 24).find(" A title that is quite a bit long") != std::string::npos);
}

TEST_CASE("a title with the state of a game precedes all but the state of play") {
    HudInfo info = galton();
    info.title = "0:0 to 3, player 2, stripes, 6 left: ball in hand behind the line, 37 s";
    const std::string half = "0:0 to 3, player 2, stripes, 6";
    CHECK(drawn(info, 84, 24).find("37 s") == std::string::npos);
    info.title_comes_first = true;
    CHECK(drawn(info, 84, 24).find("the line, 37 s  > x1") != std::string::npos);
    CHECK(drawn(info, 50, 24).find(half + "...  > x1") != std::string::npos);
    CHECK(drawn(info, 120, 24).find("37 s  > x1         12.345 s  swept") != std::string::npos);
}

TEST_CASE("the name of a level comes before the state of its game, where both fit") {
    HudInfo info = galton();
    info.title_comes_first = true;
    info.title = "Clear the table. (0 of 3 shots)";
    info.is_game = true;
    info.name = "A thin slice";
    CHECK(drawn(info, 80, 24).find(" A thin slice  Clear the table.") != std::string::npos);
    CHECK(drawn(info, 40, 24).find("slice") == std::string::npos);
    CHECK(drawn(info, 40, 24).find(" Clear the table.") != std::string::npos);
}

TEST_CASE("where the name of a level has no room, a short one stands there") {
    HudInfo info = galton();
    info.title_comes_first = true;
    info.title = "player 1 (0:0), on a red, 147 left: ball in hand in the D";
    info.is_game = true;
    info.name = "Snooker on a 12-ft table";
    info.short_name = "Snooker";
    CHECK(drawn(info, 120, 24).find(" Snooker on a 12-ft table  player 1") != std::string::npos);
    CHECK(drawn(info, 80, 24).find(" Snooker  player 1") != std::string::npos);
    CHECK(drawn(info, 60, 24).find("Snooker") == std::string::npos);
}

TEST_CASE("the goal stands beside the state of a game, and before the level's name") {
    HudInfo info = galton();
    info.is_game = true;
    info.title_comes_first = true;
    info.name = "Drill: the stop shot";
    info.title = "TRY 1 OF 5   DONE 0";
    info.game = "2.00 m/s  tip centre";
    info.goal = "Pocket the ball, and stop dead.";
    CHECK(
        drawn(info, 80, 24)
            .find(" Drill: the stop shot  TRY 1 OF 5   DONE 0  Pocket the ball, and stop dead.") !=
        std::string::npos);
    CHECK(drawn(info, 60, 24).find(" TRY 1 OF 5   DONE 0  Pocket the ball, and stop dead.") !=
          std::string::npos);
    CHECK(drawn(info, 40, 24).find("Pocket") == std::string::npos);
}

TEST_CASE("no line is ever longer than the window") {
    HudInfo info = galton();
    info.title = std::string(500, 'x');
    info.solver = std::string(90, 'y');
    info.terms.assign(40, "speed limit 1e+300");
    info.kinetic_energy = -1.23456e-300;
    info.momentum = {-1e300, 1e300};
    info.time = 1e18;
    info.tick = info.latest_tick = ~0ull;
    for (int columns = 1; columns < 320; columns += 3) {
        for (const int rows : {1, 8, 12, 24}) {
            Canvas canvas(columns + 1, rows);
            const Canvas before = canvas;
            Canvas inside(columns, rows);
            draw_hud(inside, info, {});
            CHECK(inside.columns() == columns);
        }
    }
}

TEST_CASE("pausing, going back and running late are shown") {
    HudInfo info = galton();
    info.is_paused = true;
    CHECK(drawn(info, 120, 24).find("|| paused") != std::string::npos);
    info.tick = 1000;
    CHECK(drawn(info, 120, 24).find("tick 1000/1481") != std::string::npos);

    info = galton();
    info.ticks_per_second = 60.0;
    const Look look{256, true, false};
    Canvas canvas(120, 24);
    draw_hud(canvas, info, look);
    bool is_warned = false;
    for (int column = 0; column < 120; ++column) {
        is_warned =
            is_warned || (canvas.at(column, 21).glyph == U'6' &&
                          canvas.at(column, 21).foreground == ink_of(Role::warning, look).color);
    }
    CHECK(is_warned);
}

TEST_CASE("found 4: a message lies over the world, and never over the hints") {
    HudInfo info = galton();
    info.message = "saved galton-2.level";
    Canvas canvas(80, 24);
    draw_hud(canvas, info, plain_look);
    const std::string text = canvas.text();
    CHECK(text.find("\n saved galton-2.level\n Galton board, 12 rows") != std::string::npos);
    CHECK(text.find("space pause") != std::string::npos);
    Canvas small(20, 8);
    draw_hud(small, info, plain_look);
    CHECK(small.text().find("\n saved\n galton-2.level\n Galton b") != std::string::npos);
}

TEST_CASE("every choice that a player must make is shown, in a window of any size") {
    HudInfo info = galton();
    info.is_game = true;
    info.game = "Foul, 6: the wrong ball was hit first. Player 2 chooses.";
    info.hints.push_back({"?", "keys", true});
    info.choices = {{"1", "shoot from here"}, {"2", "let him"}, {"3", "put the balls back"}};
    for (const auto& size :
         {std::pair{20, 8}, {24, 10}, {40, 16}, {60, 14}, {60, 24}, {80, 14}, {80, 24}}) {
        CAPTURE(size.first);
        CAPTURE(size.second);
        Canvas canvas(size.first, size.second);
        draw_hud(canvas, info, plain_look);
        const std::string text = canvas.text();
        CHECK(text.find("1 shoot") != std::string::npos);
        CHECK(text.find("2 let him") != std::string::npos);
        CHECK(text.find("3 put the") != std::string::npos);
    }
    Canvas usual(80, 24);
    draw_hud(usual, info, plain_look);
    CHECK(usual.text().find("\n 1 shoot from here  2 let him  3 put") != std::string::npos);
}

TEST_CASE("a message at a game of pinball takes the line of the game, and covers no ball") {
    HudInfo info = galton();
    info.is_game = true;
    info.game = "Flippers: z and /";
    info.message = "carom plays";
    info.message_in_line = true;
    for (const int rows : {24, 14}) {
        Canvas canvas(80, rows);
        draw_hud(canvas, info, plain_look);
        const std::string text = canvas.text();
        CHECK(text.find("Galton board, 12 rows") < text.find("\n carom plays\n"));
        CHECK(text.find("\n carom plays\n") != std::string::npos);
    }
    // It has no line there, or does not fit.
    Canvas low(80, 9);
    draw_hud(low, info, plain_look);
    CHECK(low.text().find("\n carom plays\n Galton") != std::string::npos);
    info.message = std::string(100, 'x');
    Canvas canvas(80, 24);
    draw_hud(canvas, info, plain_look);
    CHECK(canvas.text().find("xx\n Galton") != std::string::npos);
}

TEST_CASE("issue 22: lines of errors keep their carets, and say where the rest is") {
    HudInfo info = galton();
    for (int i = 0; i < 20; ++i)
        info.message += "a.level:3:1: error: no\n    3 | ball at=1\n      |      ^~~~\n";
    info.message_more = "F1: all of it";
    Canvas canvas(80, 24);
    draw_hud(canvas, info, plain_look);
    const std::string text = canvas.text();
    CHECK(text.find("\n     3 | ball at=1\n       |      ^~~~\n") != std::string::npos);
    CHECK(text.find("\n F1: all of it\n Galton board") != std::string::npos);
}

TEST_CASE("found 12: at a table there are no numbers of the laboratory") {
    HudInfo info = galton();
    info.is_game = true;
    info.reason = "nothing passes through anything";
    info.goal = "Drop all targets: a second ball.";
    CHECK(drawn(info, 120, 24) == R"(
 Galton board, 12 rows
 Drop all targets: a second ball.
 space pause  . step  , back  ? help  q quit
)");
    info.game = "########  8.00 m/s  calls: the 4 into the top left  tip centre  cut 23.4 deg left";
    CHECK(drawn(info, 80, 24) == R"(
 Galton board, 12 rows  Drop all targets: a second ball.
 ########  8.00 m/s  calls: the 4 into the top left  tip centre
 space pause  . step  , back  ? help  q quit
)");
    info.is_paused = true;
    CHECK(drawn(info, 120, 24).find("|| paused") != std::string::npos);
}

TEST_CASE("the goal of a level comes before its numbers") {
    HudInfo info = galton();
    info.goal = "Watch 300 balls pile up to a bell.";
    CHECK(drawn(info, 80, 24).find("\n Watch 300 balls pile up to a bell.  KE") !=
          std::string::npos);
}

TEST_CASE("a level without terms says so, and sums that are not conserved are not shown") {
    HudInfo info = galton();
    info.terms.clear();
    info.energy_drift.reset();
    info.momentum_drift.reset();
    info.potential_energy.reset();
    const std::string text = drawn(info, 120, 24);
    CHECK(text.find("model free discs") != std::string::npos);
    CHECK(text.find("drift") == std::string::npos);
    CHECK(text.find("PE") == std::string::npos);
}

TEST_CASE("changing numbers do not move the fields behind them") {
    HudInfo info = galton();
    const std::string before = drawn(info, 200, 24);
    info.time = 3.5;
    info.kinetic_energy = 7.0;
    info.momentum = {-1.25e-7, 3.0};
    info.energy_drift = 0.0;
    const std::string after = drawn(info, 200, 24);
    for (const char* part : {"swept", "balls", "ticks/s", "drift", "p ", "model"}) {
        CAPTURE(std::string(part));
        CHECK(before.find(part) == after.find(part));
    }
}

TEST_CASE("without UTF-8 only ASCII is drawn") {
    for (const int columns : {20, 80, 200}) {
        for (const char byte : drawn(galton(), columns, 24)) {
            REQUIRE(static_cast<unsigned char>(byte) < 0x80);
        }
    }
}

TEST_CASE("the reason for the solver is shown if there is room") {
    HudInfo info = galton();
    info.reason = "nothing passes through anything";
    CHECK(drawn(info, 140, 24).find("swept (auto)  nothing passes through anything") !=
          std::string::npos);
    CHECK(drawn(info, 80, 24) == drawn(galton(), 80, 24));
    info.solver_is_picked = false;
    CHECK(drawn(info, 140, 24).find("nothing") == std::string::npos);
}

TEST_CASE("the companion's text comes first, in a window of any height") {
    HudInfo info = galton();
    info.beside = "parted at t=1.250, ball 5";
    CHECK(drawn(info, 80, 24).find("\n parted at t=1.250, ball 5  KE 123.46") != std::string::npos);
    CHECK(drawn(info, 40, 12).find("\n parted at t=1.250, ball 5\n") != std::string::npos);
}

TEST_CASE("the key for help has its place among the hints, however many come before it") {
    HudInfo info = galton();
    info.hints = {{"enter", "shoot"},       {"O", "opponent"},
                  {"arrows", "aim, power"}, {"pull the cue", "shoot"},
                  {"shift-arrows", "tip"},  {"?", "keys", true},
                  {"esc", "menu"}};
    for (const int columns : {30, 40, 60, 80, 120}) {
        CAPTURE(columns);
        Canvas canvas(columns, 24);
        draw_hud(canvas, info, {0, false, false});
        CHECK(canvas.text().find("enter shoot") != std::string::npos);
        CHECK(canvas.text().find("? keys") != std::string::npos);
        CHECK((canvas.text().find("esc menu") != std::string::npos) == (columns == 120));
    }
}

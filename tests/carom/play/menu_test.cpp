#include "carom/play/menu.h"

#include <doctest/doctest.h>

#include <string>

#include "carom/support/home.h"
#include "game/support/scenes.h"

using namespace carom;

namespace {

const MayGoOn may_go_on = [] { return true; };

struct Visitor {
    int loads = 0;
    Menu menu;
    Canvas window{100, 30};

    Visitor()
        : menu({{"balls", "Balls", "levels", "/l/balls.level"},
                {"broken", "", "levels", "/l/broken.level"},
                {"gas", "Ideal gas", "levels", "/l/gas.level"}},
               [this](const MenuItem& item) {
                   const std::string& path = item.path;
                   ++loads;
                   LoadedLevel level;
                   level.path = path;
                   if (path != "/l/broken.level") level.result.scene = test::busy_box();
                   if (level.result.scene) level.result.scene->comment = {"Goal: Nine balls."};
                   return level;
               }) {}

    Menu::Choice key(char32_t code) {
        InputEvent event;
        event.key = code;
        return menu.handle(event);
    }
    std::string selected() const { return menu.selected() ? menu.selected()->name : ""; }
    std::string look() {
        ViewOptions view;
        view.look = {0, false, false};
        menu.draw(window, 2.0, view);
        return window.text();
    }
};

}  // namespace

TEST_CASE("arrows select, enter plays") {
    Visitor visitor;
    CHECK(visitor.selected() == "balls");
    visitor.key(key::up);
    CHECK(visitor.selected() == "balls");
    visitor.key(key::end);
    CHECK(visitor.selected() == "gas");
    visitor.key(key::down);
    CHECK(visitor.selected() == "gas");
    const auto choice = visitor.key(key::enter);
    REQUIRE(std::holds_alternative<MenuItem>(choice));
    CHECK(std::get<MenuItem>(choice).path == "/l/gas.level");
}

TEST_CASE("typing searches names and titles") {
    Visitor visitor;
    visitor.key(U'I');
    visitor.key(U'd');
    CHECK(visitor.selected() == "gas");
    CHECK(visitor.menu.shown().size() == 1);
    CHECK(visitor.look().find("search: Id") != std::string::npos);
    visitor.key(U'q');
    CHECK(visitor.selected() == "");
    CHECK(visitor.look().find("Nothing matches") != std::string::npos);
    CHECK(std::holds_alternative<std::monostate>(visitor.key(key::enter)));
    visitor.look();
    visitor.key(key::backspace);
    CHECK(visitor.selected() == "gas");
    CHECK(std::holds_alternative<std::monostate>(visitor.key(key::escape)));
    CHECK(visitor.menu.shown().size() == 3);
    CHECK(visitor.selected() == "gas");
}

TEST_CASE("f1 and ? say where the keys are, but a search may hold a ?") {
    for (const char32_t asks : {char32_t{U'?'}, char32_t{key::f1}}) {
        Visitor visitor;
        visitor.look();
        visitor.key(asks);
        CHECK(visitor.look().find("? lists the keys") != std::string::npos);
        CHECK(visitor.selected() == "balls");
        visitor.key(key::down);
        CHECK(visitor.look().find("? lists the keys") == std::string::npos);
    }
    Visitor visitor;
    visitor.key(U'I');
    visitor.key(U'?');
    CHECK(visitor.look().find("search: I?") != std::string::npos);
}

TEST_CASE("the last line is never cut") {
    for (int columns = 20; columns < 90; ++columns) {
        CAPTURE(columns);
        Visitor visitor;
        visitor.window = Canvas(columns, 12);
        visitor.look();
        const std::string text = visitor.look();
        const std::size_t start = text.rfind('\n', text.size() - 2) + 1;
        const std::string line = text.substr(start, text.size() - start - 1);
        CHECK(line.starts_with(" enter play"));
        CHECK((line.ends_with(" quit") || line == " enter play"));
    }
}

TEST_CASE("typing searches what is said about a level too") {
    std::vector<MenuItem> items{{"plain", "Plain", "Play", "/l/plain.level", "Nothing special"},
                                {"table", "Table", "Play", "/l/table.level", "Two jackpots"}};
    Menu menu(items, [](const MenuItem&) { return LoadedLevel{}; });
    for (const char letter : std::string("jackpot")) {
        InputEvent event;
        event.key = static_cast<char32_t>(letter);
        menu.handle(event);
    }
    REQUIRE(menu.shown().size() == 1);
    CHECK(menu.shown().front()->name == "table");
}

TEST_CASE("a search selects what is called so before what is only said to be") {
    std::vector<MenuItem> items{{"one-pocket", "One-pocket", "Pool", "/l/a.level", "Eight balls"},
                                {"eight-ball", "8-ball", "Pool", "/l/b.level", "The balls"},
                                {"balls", "Balls", "Toys", "/l/c.level", "In a box"}};
    Menu menu(items, [](const MenuItem&) { return LoadedLevel{}; });
    for (const char letter : std::string("ball")) {
        InputEvent event;
        event.key = static_cast<char32_t>(letter);
        menu.handle(event);
    }
    std::vector<std::string> names;
    for (const MenuItem* item : menu.shown())
        names.push_back(item->name);
    CHECK(names == std::vector<std::string>{"balls", "eight-ball", "one-pocket"});
    REQUIRE(menu.selected());
    CHECK(menu.selected()->name == "balls");
}

TEST_CASE("left and right open the groups, and one's own is there even while it is empty") {
    Visitor visitor;
    CHECK(visitor.selected() == "balls");
    visitor.key(key::right);
    CHECK(visitor.selected() == "");
    CHECK(visitor.look().find("No level in this folder") != std::string::npos);
    visitor.key(key::tab);
    CHECK(visitor.selected() == "balls");
    visitor.key(key::left);
    CHECK(visitor.selected() == "");
    // A search finds the levels of all groups, and its end stays in the group of what was found.
    visitor.key(U'I');
    CHECK(visitor.selected() == "gas");
    visitor.key(key::escape);
    CHECK(visitor.selected() == "gas");
    CHECK(visitor.menu.shown().size() == 3);
}

TEST_CASE("q quits; escape asks first, and any other key takes the question back") {
    Visitor visitor;
    CHECK(std::holds_alternative<Menu::Quit>(visitor.key(U'q')));
    CHECK(std::holds_alternative<std::monostate>(visitor.key(key::escape)));
    CHECK(visitor.look().find("Press esc again to quit.") != std::string::npos);
    visitor.key(key::down);
    CHECK(visitor.look().find("Press esc again to quit.") == std::string::npos);
    CHECK(std::holds_alternative<std::monostate>(visitor.key(key::escape)));
    CHECK(std::holds_alternative<Menu::Quit>(visitor.key(key::escape)));
}

TEST_CASE("escape that ends a search does not count towards quitting") {
    Visitor visitor;
    visitor.key(U'I');
    visitor.key(key::escape);
    CHECK(std::holds_alternative<std::monostate>(visitor.key(key::escape)));
    CHECK(std::holds_alternative<Menu::Quit>(visitor.key(key::escape)));
}

TEST_CASE("the selected level is loaded after a moment, and its picture moves") {
    Visitor visitor;
    visitor.menu.advance(0.01, may_go_on);
    CHECK(visitor.loads == 0);
    visitor.menu.advance(0.2, may_go_on);
    CHECK(visitor.loads == 1);
    const std::string before = visitor.look();
    CHECK(before.find("Nine balls.") != std::string::npos);
    visitor.menu.advance(0.5, may_go_on);
    CHECK(visitor.menu.needs_draw());
    CHECK(visitor.look() != before);
    CHECK(visitor.loads == 1);
}

TEST_CASE("a broken level is reported") {
    Visitor visitor;
    visitor.key(key::down);
    visitor.menu.advance(0.2, may_go_on);
    CHECK(visitor.look().find("has errors") != std::string::npos);
}

TEST_CASE("an unfinished match of the ladder is named in full at 80 columns") {
    const test::Home home;
    InterruptedGame game;
    game.file = "/s/eight-ball.resume";
    game.replay.level = "/l/eight-ball.level";
    game.replay.opponent = 9;  // the longest: "Mara: 10-ball to 3"
    game.replay.rate = 120.0;
    game.replay.position = 120 * 60 * 12;
    const std::vector<InterruptedGame> games{game};
    Menu menu(menu_items(games), [](const MenuItem&) { return LoadedLevel{}; });
    Canvas window(80, 24);
    ViewOptions view;
    view.look = {0, false, false};
    menu.draw(window, 2.0, view);
    CHECK(window.text().find("Mara: 10-ball to 3") != std::string::npos);
    CHECK(window.text().find(" 12:00") != std::string::npos);
}

TEST_CASE("the menu lists a level's newest unfinished game alone") {
    const test::Home home;
    const auto game = [](const char* file, const char* level, int opponent, int seconds) {
        InterruptedGame made;
        made.file = file;
        made.replay.level = level;
        made.replay.opponent = opponent;
        made.replay.rate = 120.0;
        made.replay.position = 120 * static_cast<std::uint64_t>(seconds);
        return made;
    };
    // The newest first, as they are found.
    const std::vector<InterruptedGame> games{
        game("/s/a-2.resume", "/l/gas.level", 0, 30), game("/s/a-1.resume", "/l/gas.level", 0, 50),
        game("/s/b-1.resume", "/l/pi.level", 0, 10), game("/s/c-1.resume", "/m/gas.level", 0, 70)};
    std::vector<std::string> files;
    for (const MenuItem& item : menu_items(games))
        if (item.interrupted) files.push_back(item.interrupted->file);
    CHECK(files == std::vector<std::string>{"/s/a-2.resume", "/s/b-1.resume", "/s/c-1.resume"});
}

TEST_CASE("an empty menu can be left") {
    Menu menu({}, [](const MenuItem&) { return LoadedLevel{}; });
    menu.advance(1.0, may_go_on);
    Canvas window(80, 24);
    menu.draw(window, 2.0, {});
    InputEvent enter;
    enter.key = key::enter;
    CHECK(std::holds_alternative<std::monostate>(menu.handle(enter)));
    CHECK(menu.selected() == nullptr);
}

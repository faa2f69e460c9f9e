#include "carom/context/key_map.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace carom;

namespace {

InputEvent press(char32_t code, std::uint8_t modifiers = no_modifier) {
    InputEvent event;
    event.key = code;
    event.modifiers = modifiers;
    return event;
}

}  // namespace

TEST_CASE("key names read back") {
    const Key keys[] = {
        {U'a', no_modifier},       {U'?', no_modifier},       {U'#', no_modifier},
        {U'=', no_modifier},       {U'é', no_modifier},       {key::space, no_modifier},
        {key::enter, no_modifier}, {key::up, shift},          {key::f1 + 11, control},
        {U'x', control | alt},     {key::remove, no_modifier}};
    for (const Key& k : keys) {
        CAPTURE(key_text(k));
        CHECK(key_named(key_text(k)) == k);
    }
}

TEST_CASE("key names are parsed or rejected") {
    CHECK(key_named("ctrl-alt-x") == Key{U'x', control | alt});
    CHECK(key_named("-") == Key{U'-', no_modifier});
    CHECK(key_named("ctrl--") == Key{U'-', control});
    CHECK(key_named("f12") == Key{key::f1 + 11, no_modifier});
    for (const char* bad : {"", "xy", "f0", "f25", "shift-a", "ctrl-", "up down", "\x01", "\xff"}) {
        CAPTURE(bad);
        CHECK(key_named(bad) == std::nullopt);
    }
}

TEST_CASE("shift counts only for keys without a character") {
    CHECK(key_of(press(U'G', shift)) == Key{U'G', no_modifier});
    CHECK(key_of(press(key::up, shift)) == Key{key::up, shift});
    CHECK(key_of(press(U'x', control)) == Key{U'x', control});
}

TEST_CASE("every action has a unique name, and a key") {
    const KeyMap keys;
    std::set<std::string_view> names;
    for (const std::string_view name_text : action_names()) {
        CAPTURE(name_text);
        CHECK(names.insert(name_text).second);
        const Action* const action = action_named(name_text);
        REQUIRE(action);
        CHECK(action->name == name_text);
        REQUIRE_FALSE(keys.keys_of(*action).empty());
        for (const Key& key : keys.keys_of(*action))
            CHECK(keys.action_of(key, layer_of(*action)) == action);
    }
    CHECK(names.size() == actions().size());
    CHECK(action_named("explode") == nullptr);
}

TEST_CASE("the well-known keys keep their actions") {
    const KeyMap keys;
    const auto action = [&](const char* key) { return keys.action_of(*key_named(key)); };
    CHECK(action("space") == action_named("pause"));
    CHECK(action(".") == action_named("step-forward"));
    CHECK(action(",") == action_named("step-back"));
    CHECK(action("q") == action_named("quit"));
}

TEST_CASE("a key has one action, and the last binding counts") {
    KeyMap keys;
    const Key p{U'p', no_modifier};
    keys.bind(p, action_named("pause"));
    CHECK(keys.action_of(p) == action_named("pause"));
    keys.bind(p, action_named("quit"));
    CHECK(keys.action_of(p) == action_named("quit"));
    keys.bind(p, nullptr);
    CHECK(keys.action_of(p) == nullptr);
    CHECK(keys.keys_of(action("pause")) == std::vector<Key>{{key::space, no_modifier}});
}

TEST_CASE("help lists every action that has a key, with its present keys") {
    KeyMap keys;
    keys.bind({U'v', no_modifier}, nullptr);
    keys.bind({U'i', control}, action_named("renderer"));
    keys.bind({key::left, no_modifier}, nullptr);
    std::string all;
    for (const HelpSection& section : keys.help())
        for (const KeyHelp& row : section.keys)
            all += row.keys + ": " + row.what + "\n";
    CHECK(all.find("ctrl-i: the next way to draw\n") != std::string::npos);
    CHECK(all.find("v: ") == std::string::npos);
    CHECK(all.find("space: pause, go on\n") != std::string::npos);
    CHECK(all.find("right drag") == std::string::npos);
    CHECK(all.find("up: move the cursor") != std::string::npos);
}

TEST_CASE("keys of a pinball table are bound like others, and leave other layers alone") {
    KeyMap keys;
    const Key z{U'z', no_modifier};
    const Key p{U'p', no_modifier};
    CHECK(keys.button_of(z) == Button::left_flipper);
    CHECK(keys.action_of(z) == action_named("zoom-in"));
    keys.bind(p, action_named("left-flipper"));
    CHECK(keys.button_of(p) == Button::left_flipper);
    CHECK(keys.action_of(p) == action_named("place-cue-ball"));
    keys.bind(z, action_named("nudge-left"));
    CHECK(keys.button_of(z) == Button::nudge_left);
    CHECK(keys.action_of(z) == action_named("zoom-in"));
    keys.bind(z, action_named("pause"));
    CHECK(keys.button_of(z) == Button::nudge_left);
    CHECK(keys.action_of(z) == action_named("pause"));
    keys.bind(z, nullptr);
    CHECK_FALSE(keys.button_of(z));
    CHECK(keys.action_of(z) == nullptr);
    CHECK(keys.hint("left-flipper") == "left");
}

TEST_CASE("the help page lists the mouse and pinball last, with the bound keys") {
    KeyMap keys;
    const auto lines_of_last = [&] {
        std::string lines;
        const auto all = keys.help();
        for (const KeyHelp& row : all.back().keys)
            lines += row.keys + ": " + row.what + "\n";
        return lines;
    };
    const auto sections = keys.help();
    REQUIRE(sections.size() == 8);
    CHECK(sections[6].title == "Mouse");
    CHECK(sections[6].keys.size() == 5);
    CHECK(sections[7].title == "At pinball");
    CHECK(lines_of_last() ==
          "z / <- ->: flippers; also the mouse's buttons\n"
          "enter: hold and let go: the plunger\n"
          "x up .: nudge the table\n"
          "k: how flippers are held\n"
          "l: the terminal's bell, on, off\n"
          "d: carom plays, you play\n"
          "0: all of the table, or after the ball\n");
    keys.bind({U'p', no_modifier}, action_named("left-flipper"));
    keys.bind({U'9', no_modifier}, action_named("fit"));
    CHECK(lines_of_last().starts_with("z left p: the left flipper\n/ right: the right flipper\n"));
    CHECK(lines_of_last().ends_with("0 9: all of the table, or after the ball\n"));
}

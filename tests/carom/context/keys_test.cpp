#include "carom/context/keys.h"

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

TEST_CASE("keys are written so that they read back") {
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

TEST_CASE("key names are understood or refused") {
    CHECK(key_named("ctrl-alt-x") == Key{U'x', control | alt});
    CHECK(key_named("-") == Key{U'-', no_modifier});
    CHECK(key_named("ctrl--") == Key{U'-', control});
    CHECK(key_named("f12") == Key{key::f1 + 11, no_modifier});
    for (const char* bad : {"", "xy", "f0", "f25", "shift-a", "ctrl-", "up down", "\x01", "\xff"}) {
        CAPTURE(bad);
        CHECK(key_named(bad) == std::nullopt);
    }
}

TEST_CASE("shift belongs to keys without a character only") {
    CHECK(key_of(press(U'G', shift)) == Key{U'G', no_modifier});
    CHECK(key_of(press(key::up, shift)) == Key{key::up, shift});
    CHECK(key_of(press(U'x', control)) == Key{U'x', control});
}

TEST_CASE("every action has a name of its own, and a key") {
    const KeyMap keys;
    std::set<std::string_view> names;
    for (const std::string_view name_text : action_names()) {
        CAPTURE(name_text);
        CHECK(names.insert(name_text).second);
        const auto action = action_named(name_text);
        REQUIRE(action);
        CHECK(name(*action) == name_text);
        REQUIRE_FALSE(keys.keys_of(*action).empty());
        for (const Key& key : keys.keys_of(*action))
            CHECK(keys.action_of(key) == *action);
    }
    CHECK(names.size() == static_cast<std::size_t>(Action::quit) + 1);
    CHECK(action_named("explode") == std::nullopt);
}

TEST_CASE("the keys that the game is known by") {
    const KeyMap keys;
    const auto action = [&](const char* key) { return keys.action_of(*key_named(key)); };
    CHECK(action("space") == Action::pause);
    CHECK(action(".") == Action::step_forward);
    CHECK(action(",") == Action::step_back);
    CHECK(action("q") == Action::quit);
}

TEST_CASE("a key does one thing, and the last word counts") {
    KeyMap keys;
    const Key p{U'p', no_modifier};
    keys.bind(p, Action::pause);
    CHECK(keys.action_of(p) == Action::pause);
    keys.bind(p, Action::quit);
    CHECK(keys.action_of(p) == Action::quit);
    keys.bind(p, std::nullopt);
    CHECK(keys.action_of(p) == std::nullopt);
    CHECK(keys.keys_of(Action::pause) == std::vector<Key>{{key::space, no_modifier}});
}

TEST_CASE("help tells of every action that has a key, as it is now") {
    KeyMap keys;
    keys.bind({U'v', no_modifier}, std::nullopt);
    keys.bind({U'i', control}, Action::renderer);
    keys.bind({key::left, no_modifier}, std::nullopt);
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

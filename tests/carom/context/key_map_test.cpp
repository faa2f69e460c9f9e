#include "carom/context/key_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
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

/// "[SECTION] KEYS: HELP", one line each.
std::string text_of(const std::vector<HelpSection>& sections) {
    std::string text;
    for (const HelpSection& section : sections) {
        text += "[" + section.title + "] ";
        for (const KeyHelp& row : section.keys)
            text += row.keys + ": " + row.what + "\n";
    }
    return text;
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

TEST_CASE("help shows the keys as they are bound, and leaves out lines without a key") {
    KeyMap keys;
    keys.bind({U'v', no_modifier}, nullptr);
    keys.bind({U'i', control}, action_named("renderer"));
    keys.bind({key::left, no_modifier}, nullptr);
    keys.bind({U't', no_modifier}, nullptr);
    const std::string all = text_of(keys.help(PlayKind::free));
    CHECK(all.find("ctrl-i: renderer: next\n") != std::string::npos);
    CHECK(all.find("v: ") == std::string::npos);
    CHECK(all.find("trails") == std::string::npos);
    CHECK(all.find("space: pause, resume\n") != std::string::npos);
    // Not all arrows have their default actions any more.
    CHECK(all.find("arrows: move") == std::string::npos);
    CHECK(all.find("right up down: move the cursor") != std::string::npos);
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
    CHECK(keys.hint("left-flipper") == "p");  // not "left", which is its key by default
}

TEST_CASE("found 2 and 7: the help of a table has the keys of that table alone") {
    KeyMap keys;
    const std::string pool = text_of(keys.help(PlayKind::pool));
    CHECK(pool.find("[Shot] enter: shoot\nleft right: aim\n") != std::string::npos);
    CHECK(pool.find("flipper") == std::string::npos);
    CHECK(pool.find("add, remove a ball") == std::string::npos);
    const std::string pinball = text_of(keys.help(PlayKind::pinball));
    CHECK(pinball.starts_with("[Table] z or left: left flipper\n"));
    CHECK(pinball.find("step forward") == std::string::npos);  // `.` nudges the table
    CHECK(pinball.find("zoom") == std::string::npos);          // `z` is a flipper
    CHECK(pinball.find("cue") == std::string::npos);
    keys.bind({U'p', no_modifier}, action_named("left-flipper"));
    keys.bind({U'9', no_modifier}, action_named("fit"));
    CHECK(text_of(keys.help(PlayKind::pinball)).starts_with("[Table] p: left flipper\n"));
    const std::string watching = text_of(keys.help(PlayKind::watching));
    CHECK(watching.find("solver: next") == std::string::npos);
    CHECK(watching.find("step forward, back") != std::string::npos);
}

TEST_CASE("every action is on a help page where it applies") {
    std::vector<HelpLine> lines(help_lines().begin(), help_lines().end());
    std::ranges::copy(unnamed_lines(actions()), std::back_inserter(lines));
    const auto is_on = [&](const Action& action, PlayKind kind) {
        for (const HelpLine& line : lines)
            if ((line.pages & help_bit(kind)) &&
                (" " + std::string(line.actions) + " ")
                        .find(" " + std::string(action.name) + " ") != std::string::npos)
                return true;
        return false;
    };
    for (const Action& action : actions()) {
        CAPTURE(action.name);
        if (action.name == "help") continue;  // the page itself
        const PlayKind kind = action.where == Where::pool      ? PlayKind::pool
                              : action.where == Where::pinball ? PlayKind::pinball
                                                               : PlayKind::free;
        CHECK(is_on(action, kind));
    }
    for (const HelpLine& line : help_lines()) {
        CHECK_FALSE(line.help.empty());
        CHECK((!line.actions.empty() || !line.keys.empty()));
    }
}

TEST_CASE("help: an action without words on the help pages is there where it applies") {
    const auto nothing = static_cast<void (*)(PlayContext&)>(nullptr);
    const Action added[] = {{"double-gravity", "D", "double gravity", Where::playing, nothing},
                            {"pause", "space", "pause, resume", Where::anywhere, nothing},
                            {"ring", "R", "ring", Where::pinball, nothing},
                            {"help", "?", "help: the keys", Where::anywhere, nothing}};
    const std::vector<HelpLine> lines = unnamed_lines(added);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0].actions == "double-gravity");
    CHECK(lines[0].help == "double gravity");
    CHECK((lines[0].pages & help_bit(PlayKind::free)) != 0);
    CHECK((lines[0].pages & help_bit(PlayKind::cue)) != 0);
    CHECK((lines[0].pages & help_bit(PlayKind::watching)) == 0);
    CHECK(lines[1].pages == help_bit(PlayKind::pinball));
    for (const HelpLine& line : unnamed_lines(actions()))
        CHECK(line.help.size() <= 23);  // the room for it at 80 columns
}

TEST_CASE("found 7: a table's help is seen as a whole at 80x24") {
    const KeyMap keys;
    for (const PlayKind kind : {PlayKind::pool, PlayKind::pinball}) {
        Canvas canvas(80, 24);
        CHECK(draw_help(canvas, keys.help(kind), 0, "", {}).most == 0);
    }
}

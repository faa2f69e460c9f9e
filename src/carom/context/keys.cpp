#include "carom/context/keys.h"

#include <algorithm>
#include <array>

#include "level/text/utf8.h"

namespace carom {
namespace {

struct ActionRow {
    Action action;
    std::string_view name;
    std::string_view keys;  ///< as in the preferences file, blanks between
    std::string_view help;
    std::string_view section;
};

constexpr ActionRow rows[] = {
    {Action::pause, "pause", "space", "pause, go on", "Time"},
    {Action::step_forward, "step-forward", ".", "one tick forward", "Time"},
    {Action::step_back, "step-back", ",", "one tick back", "Time"},
    {Action::next_collision, "next-collision", "n", "to the next collision", "Time"},
    {Action::second_back, "second-back", "<", "a second back", "Time"},
    {Action::second_forward, "second-forward", ">", "a second forward", "Time"},
    {Action::slower, "slower", "- [", "slower", "Time"},
    {Action::faster, "faster", "+ = ]", "faster", "Time"},
    {Action::normal_speed, "normal-speed", "*", "normal speed", "Time"},
    {Action::restart, "restart", "r", "from the start", "Time"},

    {Action::cursor_left, "cursor-left", "left", "move the cursor", "Hands"},
    {Action::cursor_right, "cursor-right", "right", "move the cursor", "Hands"},
    {Action::cursor_up, "cursor-up", "up", "move the cursor", "Hands"},
    {Action::cursor_down, "cursor-down", "down", "move the cursor", "Hands"},
    {Action::next_ball, "next-ball", "tab", "to the next ball", "Hands"},
    {Action::previous_ball, "previous-ball", "backtab", "to the ball before", "Hands"},
    {Action::grab, "grab", "enter", "take or drop what is there", "Hands"},
    {Action::cue, "cue", "k", "pull the cue; enter shoots", "Hands"},
    {Action::add_ball, "add-ball", "a", "add a ball", "Hands"},
    {Action::remove, "remove", "x delete", "remove a ball", "Hands"},
    {Action::draw_edge, "draw-edge", "e", "start, end an edge", "Hands"},
    {Action::remove_edge, "remove-edge", "E", "remove an edge", "Hands"},
    {Action::undo, "undo", "u", "undo the last change", "Hands"},

    {Action::aim_left, "aim-left", "; ctrl-left", "aim a hair to the left", "Pool"},
    {Action::aim_right, "aim-right", "' ctrl-right", "aim a hair to the right", "Pool"},
    {Action::next_pot, "next-pot", "}", "aim at the next pocket, easiest first", "Pool"},
    {Action::previous_pot, "previous-pot", "{", "aim at the one before", "Pool"},
    {Action::call, "call", "d", "declare a safety, or a push-out", "Pool"},
    {Action::place_cue_ball, "place-cue-ball", "p", "take the ball in hand, put it down", "Pool"},
    {Action::aids, "aids", "A", "lines: none, ghost, full, 20 shots", "Pool"},
    {Action::next_frame, "next-frame", "N", "rack the next frame", "Pool"},
    {Action::opponent, "opponent", "O", "play against carom: 1 to 4, nobody", "Pool"},
    {Action::coach, "coach", "C", "what carom would shoot: its three best", "Pool"},

    {Action::solver, "solver", "s", "the next solver", "World"},
    {Action::gravity, "gravity", "g", "gravity on, off", "World"},
    {Action::turn_gravity, "turn-gravity", "G", "turn gravity", "World"},
    {Action::save, "save", "w", "save as a level", "World"},

    {Action::renderer, "renderer", "v", "the next way to draw", "View"},
    {Action::colors, "colors", "c", "colour by kind, speed, mass, ball", "View"},
    {Action::trails, "trails", "t", "trails", "View"},
    {Action::overlay, "overlay", "o", "the next overlay", "View"},
    {Action::velocities, "velocities", "1", "velocities", "View"},
    {Action::contacts, "contacts", "2", "contacts of the last tick", "View"},
    {Action::broad_phase, "broad-phase", "3", "broad-phase cells", "View"},
    {Action::ids, "ids", "4", "numbers of the balls", "View"},
    {Action::grid, "grid", "5", "coordinates", "View"},
    {Action::outlines, "outlines", "6", "balls as outlines", "View"},
    {Action::histogram, "histogram", "h", "the histogram", "View"},
    {Action::energy, "energy", "y", "the energy over time", "View"},
    {Action::zoom_in, "zoom-in", "z", "closer", "View"},
    {Action::zoom_out, "zoom-out", "Z", "farther", "View"},
    {Action::pan_left, "pan-left", "shift-left H", "look left", "View"},
    {Action::pan_right, "pan-right", "shift-right L", "look right", "View"},
    {Action::pan_up, "pan-up", "shift-up K", "look up", "View"},
    {Action::pan_down, "pan-down", "shift-down J", "look down", "View"},
    {Action::fit, "fit", "0", "all of it", "View"},
    {Action::follow, "follow", "f", "follow the ball", "View"},
    {Action::split, "split", "S", "beside it, another solver", "View"},
    {Action::butterfly, "butterfly", "b", "200 copies, a hair apart", "View"},
    {Action::explain, "explain", "i", "which solver, which terms, why", "View"},

    {Action::mouse, "mouse", "m", "give the mouse to the terminal", "Program"},
    {Action::resume, "take-up", "R", "take up the game that was left", "Program"},
    {Action::help, "help", "? f1", "this page", "Program"},
    {Action::menu, "menu", "escape", "let go; the menu", "Program"},
    {Action::quit, "quit", "q", "quit at once", "Program"},
};

struct NamedKey {
    std::string_view name;
    char32_t code;
    std::string_view shown;  ///< in hints and help
};

constexpr NamedKey named_keys[] = {
    {"space", key::space, "space"},
    {"enter", key::enter, "enter"},
    {"tab", key::tab, "tab"},
    {"backtab", key::backtab, "shift-tab"},
    {"escape", key::escape, "esc"},
    {"backspace", key::backspace, "backspace"},
    {"delete", key::remove, "del"},
    {"insert", key::insert, "ins"},
    {"up", key::up, "up"},
    {"down", key::down, "down"},
    {"left", key::left, "left"},
    {"right", key::right, "right"},
    {"home", key::home, "home"},
    {"end", key::end, "end"},
    {"pageup", key::page_up, "pgup"},
    {"pagedown", key::page_down, "pgdn"},
    {"hash", U'#', "#"},  // '#' itself starts a comment
    {"equals", U'=', "="},
};

struct ModifierName {
    std::string_view prefix;
    Modifier modifier;
};

constexpr ModifierName modifier_names[] = {{"ctrl-", control}, {"alt-", alt}, {"shift-", shift}};

bool has_character(char32_t code) {
    return code > U' ' && code != 0x7f && code < 0x110000;
}

std::string prefixes(const Key& key) {
    std::string text;
    for (const ModifierName& row : modifier_names)
        if (key.modifiers & row.modifier) text += row.prefix;
    return text;
}

std::string base_text(char32_t code, std::string_view NamedKey::*which) {
    for (const NamedKey& row : named_keys)
        if (row.code == code) return std::string(row.*which);
    if (code >= key::f1 && code < key::f1 + 24) return "f" + std::to_string(code - key::f1 + 1);
    std::string text;
    append_utf8(text, code);
    return text;
}

/// For people: short.
std::string shown(const Key& key) {
    return prefixes(key) + base_text(key.code, &NamedKey::shown);
}

/// Several rows of help are one line for a person.
struct HelpGroup {
    Action first;
    Action last;
    std::string_view keys;
    std::string_view help;
};

constexpr HelpGroup groups[] = {
    {Action::cursor_left, Action::cursor_down, "arrows", "move the cursor, or what it holds"},
    {Action::pan_left, Action::pan_down, "shift-arrows", "look elsewhere (or H J K L)"},
};

const HelpGroup* group_of(Action action) {
    const auto* found = std::ranges::find_if(groups, [action](const HelpGroup& group) {
        return group.first <= action && action <= group.last;
    });
    return found == std::end(groups) ? nullptr : found;
}

bool has_standard_keys(const KeyMap& keys, const HelpGroup& group) {
    const KeyMap standard;
    return std::ranges::all_of(rows, [&](const ActionRow& row) {
        return row.action < group.first || group.last < row.action ||
               keys.keys_of(row.action) == standard.keys_of(row.action);
    });
}

const HelpSection mouse_help{
    "Mouse",
    {{"left", "drag a ball or an edge; the rest is the view"},
     {"right", "pull the cue and let it go (or shift, ctrl with left)"},
     {"middle", "drag the view"},
     {"wheel", "closer, farther"}},
};

const HelpSection table_help{"At pinball",
                             {{"z / <- ->", "flippers; also the mouse's buttons"},
                              {"enter", "hold and let go: the plunger"},
                              {"x up .", "nudge the table"},
                              {"k", "how flippers are held"},
                              {"l", "the terminal's bell, on, off"},
                              {"d", "carom plays, you play"},
                              {"0", "all of the table, or after the ball"}}};

}  // namespace

std::string_view name(Action action) {
    return std::ranges::find(rows, action, &ActionRow::action)->name;
}

std::optional<Action> action_named(std::string_view name) {
    const auto* row = std::ranges::find(rows, name, &ActionRow::name);
    if (row == std::end(rows)) return std::nullopt;
    return row->action;
}

std::vector<std::string_view> action_names() {
    std::vector<std::string_view> names;
    for (const ActionRow& row : rows)
        names.push_back(row.name);
    return names;
}

Key key_of(const InputEvent& event) {
    const bool keeps_shift = !has_character(event.key);
    const auto mask =
        static_cast<std::uint8_t>(keeps_shift ? shift | alt | control : alt | control);
    return {event.key, static_cast<std::uint8_t>(event.modifiers & mask)};
}

std::optional<Key> key_named(std::string_view text) {
    Key key;
    for (bool found = true; found;) {
        found = false;
        for (const ModifierName& row : modifier_names) {
            if (text.size() <= row.prefix.size() || !text.starts_with(row.prefix)) continue;
            key.modifiers |= row.modifier;
            text.remove_prefix(row.prefix.size());
            found = true;
        }
    }
    for (const NamedKey& row : named_keys)
        if (row.name == text) key.code = row.code;
    for (char32_t n = 1; n <= 24 && key.code == 0; ++n)
        if (text == "f" + std::to_string(n)) key.code = key::f1 + n - 1;
    if (key.code == 0) {
        if (text.empty()) return std::nullopt;
        const auto [character, bytes] = decode_utf8(text);
        if (bytes != text.size() || character == not_a_character || !has_character(character))
            return std::nullopt;
        key.code = character;
    }
    if (has_character(key.code) && (key.modifiers & shift)) return std::nullopt;
    return key;
}

std::string key_text(const Key& key) {
    return prefixes(key) + base_text(key.code, &NamedKey::name);
}

KeyMap::KeyMap() {
    for (const ActionRow& row : rows) {
        std::string_view keys = row.keys;
        while (!keys.empty()) {
            const std::size_t end = std::min(keys.find(' '), keys.size());
            bind(*key_named(keys.substr(0, end)), row.action);
            keys.remove_prefix(std::min(end + 1, keys.size()));
        }
    }
}

void KeyMap::bind(const Key& key, std::optional<Action> action) {
    std::erase_if(bindings_, [&](const Binding& binding) { return binding.key == key; });
    if (action) bindings_.push_back({key, *action});
}

std::optional<Action> KeyMap::action_of(const Key& key) const {
    const auto found = std::ranges::find(bindings_, key, &Binding::key);
    if (found == bindings_.end()) return std::nullopt;
    return found->action;
}

std::vector<Key> KeyMap::keys_of(Action action) const {
    std::vector<Key> keys;
    for (const Binding& binding : bindings_)
        if (binding.action == action) keys.push_back(binding.key);
    return keys;
}

std::string KeyMap::hint(Action action) const {
    const auto found = std::ranges::find(bindings_, action, &Binding::action);
    return found == bindings_.end() ? std::string{} : shown(found->key);
}

std::vector<HelpSection> KeyMap::help() const {
    std::vector<HelpSection> sections;
    for (const ActionRow& row : rows) {
        if (sections.empty() || sections.back().title != row.section)
            sections.push_back({std::string(row.section), {}});
        std::vector<KeyHelp>& lines = sections.back().keys;
        if (const HelpGroup* group = group_of(row.action);
            group && has_standard_keys(*this, *group)) {
            if (row.action == group->first)
                lines.push_back({std::string(group->keys), std::string(group->help)});
            continue;
        }
        std::string keys;
        for (const Key& key : keys_of(row.action))
            keys += (keys.empty() ? "" : " ") + shown(key);
        if (!keys.empty()) lines.push_back({keys, std::string(row.help)});
    }
    sections.push_back(mouse_help);
    sections.push_back(table_help);
    return sections;
}

}  // namespace carom

#include "carom/context/key.h"

#include <algorithm>

#include "level/text/utf8.h"

namespace carom {
namespace {

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

}  // namespace

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

std::string shown_key(const Key& key) {
    return prefixes(key) + base_text(key.code, &NamedKey::shown);
}

}  // namespace carom

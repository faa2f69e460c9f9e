#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "terminal/input/input.h"

/// Keys, and their notation in the preferences file and on the screen.
namespace carom {

/// A key with its modifiers. Shift counts only for keys without a character: a capital letter is a
/// key of its own.
struct Key {
    char32_t code = 0;
    std::uint8_t modifiers = no_modifier;

    friend bool operator==(const Key&, const Key&) = default;
};

/// The key of an event. Pre: the event is of kind `key`.
Key key_of(const InputEvent& event);

/// Parses a key as written in the preferences file: "a", "?", "space", "ctrl-x", "shift-up", "f1",
/// "hash", "equals". None: there is no such key.
std::optional<Key> key_named(std::string_view text);
/// Writes a key so that key_named() parses it.
std::string key_text(const Key& key);
/// A short form of the key for hints and help, such as "esc".
std::string shown_key(const Key& key);

}  // namespace carom

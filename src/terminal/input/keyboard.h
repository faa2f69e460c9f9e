#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "terminal/input/input.h"
#include "terminal/input/input_sequence.h"

/// Decodes keys: the kitty keyboard protocol, xterm's sequences, and the keys that terminfo lists.
///
/// A key that types a character is decoded as that character. Shift is part of the character and
/// not reported as a modifier, since terminals without the protocol cannot report it either. Super,
/// Hyper and Meta count as Alt, so that they never act as the plain key; Caps Lock and Num Lock are
/// ignored.
namespace carom {

/// The sequences that the terminal's keys send, according to its description.
class KeyTable {
  public:
    /// Ignores sequences that do not start with ESC or are shorter than 2 bytes.
    void add(std::string_view sequence, char32_t key, std::uint8_t modifiers = no_modifier);

    struct Entry {
        std::string sequence;
        char32_t key = 0;
        std::uint8_t modifiers = no_modifier;
    };
    /// The key that sends exactly this sequence.
    std::optional<InputEvent> find(std::string_view sequence) const;

  private:
    std::vector<Entry> entries_;  // sorted by sequence, no duplicates
};

/// Turns sequences into keys. It remembers which character each held key typed, since a release
/// does not say.
class Keyboard {
  public:
    /// None: not a key's sequence, or a key that carom does not know.
    std::optional<InputEvent> from_sequence(const ControlSequence& sequence);

  private:
    std::optional<InputEvent> from_code(const ControlSequence& sequence);

    std::vector<std::pair<int, char32_t>> made_;  // key code and character of each held key
};

/// `final`: the byte after ESC O.
std::optional<InputEvent> key_from_ss3(char final);

/// A single character or control byte (0..31 and 127 stand for Ctrl and a letter, Tab, Enter,
/// Escape, Backspace).
InputEvent key_from_character(char32_t character);

}  // namespace carom

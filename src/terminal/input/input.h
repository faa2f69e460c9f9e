#pragma once

#include <cstdint>

/// Input events, decoded from the terminal's bytes and from signals.
namespace carom {

/// Keys without a character. Any other key is the code point of its character, in KeyEvent::key.
namespace key {
inline constexpr char32_t up = 0x110000, down = 0x110001, left = 0x110002, right = 0x110003,
                          home = 0x110004, end = 0x110005, page_up = 0x110006, page_down = 0x110007,
                          insert = 0x110008, remove = 0x110009, backspace = 0x11000a,
                          backtab = 0x11000b, f1 = 0x110010;  // f1 + n - 1
inline constexpr char32_t enter = U'\r', tab = U'\t', escape = 0x1b, space = U' ';
}  // namespace key

enum Modifier : std::uint8_t { no_modifier = 0, shift = 1, alt = 2, control = 4 };

struct InputEvent {
    enum class Kind : std::uint8_t {
        key,
        mouse,
        resize,  ///< the size of the window has changed: query the screen
        hangup,  ///< the terminal is gone
        end      ///< INT, QUIT or TERM: exit cleanly
    };
    enum class Action : std::uint8_t { press, repeat, release, move, wheel_up, wheel_down };

    Kind kind = Kind::key;
    Action action = Action::press;
    char32_t key = 0;            ///< keys: a code point or one of key::
    std::uint8_t modifiers = 0;  ///< a set of Modifier
    std::uint8_t button = 0;     ///< mouse: 1 left, 2 middle, 3 right; 0 none
    double column = 0.0;  ///< mouse: in cells from the left edge; the centre of cell 0 is 0.5
    double row = 0.0;     ///< mouse: in cells from the top edge
    double after = 0.0;   ///< s since the program's time was last advanced
};

}  // namespace carom

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "terminal/canvas/color.h"
#include "terminal/input/input_sequence.h"

/// The terminal's answers to carom's queries. An answer is never mistaken for a key, however late
/// it arrives.
namespace carom {

struct Answer {
    enum class Kind : std::uint8_t {
        attributes,  ///< DA, to CSI c: queried last, so its answer comes after all others
        status,      ///< to CSI 5 n: the terminal has drawn everything sent before it
        mode,        ///< DECRPM, to CSI ? number $ p
        cell_size,   ///< to CSI 16 t
        key_flags,   ///< to CSI ? u: the terminal supports the kitty keyboard protocol
        background,  ///< to OSC 11 ; ?
        version,     ///< XTVERSION, to CSI > q, or DA2, to CSI > c: which terminal it is
        colors       ///< by DECRQSS of a style that was just set, or by XTGETTCAP of RGB and Tc
    };
    Kind kind = Kind::attributes;
    int number = 0;           ///< mode: its number
    bool is_offered = false;  ///< mode: whether it can be set and reset
    int pixels_wide = 0;      ///< cell_size
    int pixels_high = 0;      ///< cell_size
    Rgb color;                ///< background
    int colors = 0;           ///< colors: 256 or direct_colors; 0: the answer does not tell
    std::string text;         ///< version: such as "kitty(0.40.1)" or "tmux 3.4"

    friend bool operator==(const Answer&, const Answer&) = default;
};

/// None: the sequence does not answer any of carom's queries.
std::optional<Answer> answer_in(const ControlSequence& sequence);

/// The answer in an operating system command. `body`: the bytes between `ESC ]` and the terminator.
std::optional<Answer> answer_in_command(std::string_view body);
/// The answer in a device control string. `body`: the bytes between `ESC P` and the terminator.
std::optional<Answer> answer_in_device_control(std::string_view body);

/// All queries sent at the start. The last is for device attributes, which every terminal answers,
/// so its answer marks the end. `passes_strings_on`: the terminal is a multiplexer that sends
/// control strings which it does not know to the terminal outside, as GNU screen does; the question
/// about colours is left out, since the answer would be about the wrong terminal.
std::string capability_questions(bool passes_strings_on = false);

}  // namespace carom

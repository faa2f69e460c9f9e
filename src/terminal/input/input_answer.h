#pragma once

#include <optional>
#include <string_view>

#include "terminal/canvas/color.h"
#include "terminal/input/input_sequence.h"

/// What the terminal says when carom asks it something. Never a key, however late it comes.
namespace carom {

struct Answer {
    enum class Kind : std::uint8_t {
        attributes,  ///< DA, to CSI c: sent last, so that all else has been answered before it
        status,      ///< to CSI 5 n: everything sent before it has been drawn
        mode,        ///< DECRPM, to CSI ? number $ p
        cell_size,   ///< to CSI 16 t
        key_flags,   ///< to CSI ? u: the terminal has the kitty keyboard protocol
        background   ///< to OSC 11 ; ?
    };
    Kind kind = Kind::attributes;
    int number = 0;           ///< mode: which
    bool is_offered = false;  ///< mode: it can be set and reset
    int pixels_wide = 0;      ///< cell_size
    int pixels_high = 0;      ///< cell_size
    Rgb color;                ///< background

    friend bool operator==(const Answer&, const Answer&) = default;
};

/// None: the sequence is no answer to anything that carom asks.
std::optional<Answer> answer_in(const ControlSequence& sequence);

/// `body`: what stands between `ESC ]` and its terminator.
std::optional<Answer> answer_in_command(std::string_view body);

/// All that carom asks at the start, the sentinel last.
std::string_view capability_questions();

}  // namespace carom

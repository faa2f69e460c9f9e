#pragma once

#include <optional>
#include <string_view>

#include "terminal/canvas/color.h"
#include "terminal/input/input_sequence.h"

/// The terminal's answers to carom's queries. An answer is never taken for a key, however late it
/// comes.
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

/// None: the sequence does not answer any of carom's queries.
std::optional<Answer> answer_in(const ControlSequence& sequence);

/// The answer in an operating system command. `body`: the bytes between `ESC ]` and the terminator.
std::optional<Answer> answer_in_command(std::string_view body);

/// All queries of the start; device attributes, which every terminal answers, are the last, as a
/// sentinel.
std::string_view capability_questions();

}  // namespace carom

#pragma once

#include <optional>
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
        background   ///< to OSC 11 ; ?
    };
    Kind kind = Kind::attributes;
    int number = 0;           ///< mode: its number
    bool is_offered = false;  ///< mode: whether it can be set and reset
    int pixels_wide = 0;      ///< cell_size
    int pixels_high = 0;      ///< cell_size
    Rgb color;                ///< background

    friend bool operator==(const Answer&, const Answer&) = default;
};

/// None: the sequence does not answer any of carom's queries.
std::optional<Answer> answer_in(const ControlSequence& sequence);

/// The answer in an operating system command. `body`: the bytes between `ESC ]` and the terminator.
std::optional<Answer> answer_in_command(std::string_view body);

/// All queries sent at the start. The last is for device attributes, which every terminal answers,
/// so its answer marks the end.
std::string_view capability_questions();

}  // namespace carom

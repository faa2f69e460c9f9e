#pragma once

#include <string>
#include <string_view>

/// Control sequences as ECMA-48 spells them: CSI, parameters, intermediates, a final byte.
namespace carom {

/// What stands between `ESC [` and the final byte, and that byte. Parameters are separated by ';',
/// sub-parameters by ':'; both count from 0.
struct ControlSequence {
    char prefix = 0;            ///< one of < = > ? in front of the parameters, or 0
    std::string parameters;     ///< digits, ';' and ':'
    std::string intermediates;  ///< bytes 0x20..0x2f, mostly none
    char final = 0;

    /// Missing, empty or out of 0..999999: `otherwise`.
    int number(int index, int otherwise = 0) const { return number(index, 0, otherwise); }
    int number(int index, int part, int otherwise) const;

    friend bool operator==(const ControlSequence&, const ControlSequence&) = default;
};

/// `body`: what follows `ESC [`, the final byte included.
ControlSequence parse_control_sequence(std::string_view body);

}  // namespace carom

#pragma once

#include <string>
#include <string_view>

/// Control sequences in the syntax of ECMA-48: CSI, parameters, intermediates, a final byte.
namespace carom {

/// A parsed control sequence: the bytes between `ESC [` and the final byte, and that byte.
/// Parameters are separated by ';', sub-parameters by ':'; both count from 0.
struct ControlSequence {
    char prefix = 0;            ///< one of < = > ? before the parameters, or 0
    std::string parameters;     ///< digits, ';' and ':'
    std::string intermediates;  ///< bytes 0x20..0x2f, usually none
    char final = 0;

    /// The parameter; `otherwise` if it is missing, empty or out of 0..999999.
    int number(int index, int otherwise = 0) const { return number(index, 0, otherwise); }
    int number(int index, int part, int otherwise) const;

    friend bool operator==(const ControlSequence&, const ControlSequence&) = default;
};

/// `body`: the bytes after `ESC [`, including the final byte.
ControlSequence parse_control_sequence(std::string_view body);

}  // namespace carom

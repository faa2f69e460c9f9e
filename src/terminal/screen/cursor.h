#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "terminal/screen/dialect.h"

/// The shortest bytes that move a terminal's cursor.
namespace carom {

/// The position of the cursor, from 0. One column past the last means: the last column has been
/// written and the cursor waits at the margin, so only movements that do not depend on its column
/// are safe.
struct CursorPlace {
    int row = 0;
    int column = 0;

    friend bool operator==(const CursorPlace&, const CursorPlace&) = default;
};

/// The length of ESC [ number final, where the number 1 is left out.
std::size_t sequence_size(int number);
void append_sequence(std::string& bytes, int number, char final);

/// The number of bytes to move within a row, in a window of so many columns.
std::size_t sideways_size(const TerminalDialect& dialect, int columns, int from, int to);

/// Appends the movement. `from` is empty where the position is not known.
void append_movement(std::string& bytes, const TerminalDialect& dialect, int columns,
                     const std::optional<CursorPlace>& from, const CursorPlace& to);

}  // namespace carom

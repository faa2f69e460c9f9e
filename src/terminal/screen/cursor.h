#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "terminal/screen/dialect.h"

/// The shortest bytes that move a terminal's cursor.
namespace carom {

/// Of the cursor, from 0. The column behind the last one: the last has been written and the cursor
/// waits at the margin, so that only movements that do not depend on its column are certain.
struct CursorPlace {
    int row = 0;
    int column = 0;

    friend bool operator==(const CursorPlace&, const CursorPlace&) = default;
};

/// Bytes of ESC [ number final, where 1 goes without saying.
std::size_t sequence_size(int number);
void append_sequence(std::string& bytes, int number, char final);

/// Bytes that moving within a row takes, in a window of so many columns.
std::size_t sideways_size(const TerminalDialect& dialect, int columns, int from, int to);

/// Appends the movement. `from`: none where it is not known.
void append_movement(std::string& bytes, const TerminalDialect& dialect, int columns,
                     const std::optional<CursorPlace>& from, const CursorPlace& to);

}  // namespace carom

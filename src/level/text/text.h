#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "level/text/diagnostic.h"
#include "level/text/lookalikes.h"

/// The text of a level, and positions in it. Columns count characters (code points), not bytes.
namespace carom {

/// A file, an include, or a statement of --set. Words and spans point into it, so it must not move
/// or change while they are in use.
struct SourceText {
    std::string name;
    std::string text;
    std::vector<std::string_view> lines;       ///< without their ends (LF or CR LF)
    std::map<std::size_t, MendedLine> mended;  ///< by index, the lines with lookalikes
    std::vector<IncludedFrom> included_from;   ///< innermost first
    int order = 0;                             ///< diagnostics are sorted by it first
};

/// A position in a source. Line and column from 1.
struct Span {
    const SourceText* source = nullptr;
    int line = 1;
    int column = 1;
    int length = 1;
};

/// Splits `text` into lines. A byte order mark at the start belongs to no line.
std::vector<std::string_view> split_lines(std::string_view text);

/// The reason why a text cannot be read at all.
struct TextFault {
    FaultCode code;
    int line = 1;
    int column = 1;
    std::string message;
    std::string remedy;
};

inline constexpr std::size_t max_file_bytes = 4u << 20;
inline constexpr std::size_t max_line_bytes = 4096;

/// The first fault of a text: more than 4 MiB, a line of more than 4,096 bytes, a NUL byte, or
/// bytes that are not UTF-8. None: the text can be read.
std::optional<TextFault> find_fault(std::string_view text);

/// The text with each byte that is not part of a valid UTF-8 character replaced by '?'.
std::string legible(std::string_view text);

}  // namespace carom

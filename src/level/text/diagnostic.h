#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What is wrong with a level, for the person who wrote it.
namespace carom {

enum class Severity { error, warning };

/// Where an `include` stands that led to a file.
struct IncludedFrom {
    std::string file;
    int line = 0;
};

struct Diagnostic {
    Severity severity = Severity::error;
    std::string file;  ///< as given to load_level, or as resolved for an include
    int line = 1;      ///< from 1
    int column = 1;    ///< from 1, in characters (not bytes)
    int length = 1;    ///< of the span that the caret underlines, in characters, >= 1
    std::string message;
    std::string remedy;                       ///< what to do; may be empty
    std::string source;                       ///< the line itself, without its end
    std::vector<IncludedFrom> included_from;  ///< innermost first
};

/// The text, fit for a terminal: '?' for control characters and for bytes that are not UTF-8, a
/// space for a tab.
std::string printable(std::string_view text);

/// As people read it:
///
///     levels/canyon.level:12:22: error: r must not be negative, but is -0.2
///        12 | edge wood 1,2 4,2  r=-0.2
///           |                      ^~~~
///           = write a length, such as r=0.2
///
/// with a line `included from ...` for each file of the chain. All of it is `printable`, and long
/// lines are cut around the span. Ends with a newline.
std::string render(const Diagnostic& diagnostic);

}  // namespace carom

#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Errors and warnings about a level, for the person who wrote it.
namespace carom {

enum class Severity { error, warning };

/// A stable name for a kind of fault, such as "unknown-kind": words of lower-case letters and
/// digits joined by '-'. Tests and tools match it, since the message may change; players do not see
/// it. Two places that report the same fault share a code.
class FaultCode {
  public:
    constexpr FaultCode() = default;
    /// Does not compile if the text is not of that form.
    consteval FaultCode(const char* text) : text_(text) {
        for (const char c : text_)
            if (!(c >= 'a' && c <= 'z') && !(c >= '0' && c <= '9') && c != '-') throw "not a code";
    }
    constexpr std::string_view text() const { return text_; }
    friend constexpr bool operator==(FaultCode, FaultCode) = default;

  private:
    std::string_view text_;
};

/// The place of an `include` that led to a file.
struct IncludedFrom {
    std::string file;
    int line = 0;
};

struct Diagnostic {
    Severity severity = Severity::error;
    FaultCode code;
    std::string file;  ///< as given to load_level, or as resolved for an include
    int line = 1;      ///< from 1
    int column = 1;    ///< from 1, in characters (not bytes)
    int length = 1;    ///< characters that the caret underlines, >= 1
    std::string message;
    std::string remedy;                       ///< a suggested fix; may be empty
    std::string source;                       ///< the source line, without its end
    std::vector<IncludedFrom> included_from;  ///< innermost first
};

/// `text` made safe for a terminal: '?' replaces control characters, invisible ones
/// (lookalikes.h) and bytes that are not UTF-8, a space replaces a tab.
std::string printable(std::string_view text);
/// Makes each line of `text` printable, and keeps the line breaks.
std::string printable_lines(std::string_view text);

/// The diagnostic as text for a terminal:
///
///     levels/canyon.level:12:22: error: r must not be negative, but is -0.2
///        12 | edge wood 1,2 4,2  r=-0.2
///           |                      ^~~~
///           = write a length, such as r=0.2
///
/// A line `included from ...` follows for each include of the chain. All of the text is
/// `printable`, long source lines are cut around the span, and the last line ends with a newline.
std::string render(const Diagnostic& diagnostic);

}  // namespace carom

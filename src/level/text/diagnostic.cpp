#include "level/text/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

#include "level/text/joined.h"
#include "level/text/lookalikes.h"
#include "level/text/utf8.h"

namespace carom {
namespace {

constexpr int widest = 100;  // most characters of a source line that are shown

// The C0 and C1 control characters. U+0080 to U+009F have two bytes: 0xc2, and one below 0xa0.
bool is_control(std::string_view character) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
    if (character.size() == 1) return byte(0) < 0x20 || byte(0) == 0x7f;
    return character.size() == 2 && byte(0) == 0xc2 && byte(1) < 0xa0;
}

// One printable string for each character, so that a caret in column n stands below character n.
std::vector<std::string> printable_characters(std::string_view text) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = character_length(text, i);
        const std::string_view character = text.substr(i, std::max(length, std::size_t{1}));
        if (character == "\t") {
            result.emplace_back(" ");
        } else {
            const bool is_hidden = length == 0 || is_control(character) ||
                                   is_invisible(decode_utf8(character).character);
            result.emplace_back(is_hidden ? "?" : character);
        }
        i += character.size();
    }
    return result;
}

}  // namespace

std::string printable(std::string_view text) {
    return joined(printable_characters(text), "");
}

std::string printable_lines(std::string_view text) {
    std::string lines;
    for (std::size_t end = 0; (end = text.find('\n')) != std::string_view::npos;) {
        lines += printable(text.substr(0, end)) + '\n';
        text.remove_prefix(end + 1);
    }
    return lines + printable(text);
}

std::string render(const Diagnostic& d) {
    const std::vector<std::string> line = printable_characters(d.source);
    const int size = static_cast<int>(line.size());
    const int caret = std::clamp(d.column - 1, 0, size);
    const int span = std::clamp(d.length, 1, std::max(1, size - caret));

    // A long line is cut to a window that begins some characters before the span.
    const int first = size <= widest ? 0 : std::clamp(caret - widest / 3, 0, size - widest);
    const int last = std::min(size, first + widest);
    std::string text = first > 0 ? "..." : "";
    std::string marks(text.size(), ' ');
    for (int i = first; i < last; ++i)
        text += line[static_cast<std::size_t>(i)];
    if (last < size) text += "...";
    while (!text.empty() && text.back() == ' ')
        text.pop_back();
    marks += std::string(static_cast<std::size_t>(caret - first), ' ') + '^' +
             std::string(static_cast<std::size_t>(std::clamp(span, 1, widest) - 1), '~');

    const std::string number = fmt::format("{:>5}", d.line);
    const std::string gutter(number.size() + 1, ' ');
    std::string result =
        fmt::format("{}:{}:{}: {}: {}\n", printable(d.file), d.line, d.column,
                    d.severity == Severity::error ? "error" : "warning", printable(d.message));
    result += fmt::format("{} |{}{}\n", number, text.empty() ? "" : " ", text);
    result += fmt::format("{}| {}\n", gutter, marks);
    if (!d.remedy.empty()) result += fmt::format("{}= {}\n", gutter, printable(d.remedy));
    for (const IncludedFrom& from : d.included_from) {
        result += fmt::format("{}included from {}:{}\n", gutter, printable(from.file), from.line);
    }
    return result;
}

}  // namespace carom

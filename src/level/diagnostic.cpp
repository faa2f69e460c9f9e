#include "level/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

constexpr int widest = 100;  // characters of a source line that are shown

// One string a character, fit for a terminal: a caret below the nth stands under the nth.
std::vector<std::string> printable_characters(std::string_view line) {
    std::vector<std::string> result;
    for (const char c : line) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xc0u) == 0x80u && !result.empty()) {
            result.back() += c;
        } else if (c == '\t') {
            result.emplace_back(" ");
        } else if (byte < 0x20 || byte == 0x7f) {
            result.emplace_back("?");
        } else {
            result.emplace_back(1, c);
        }
    }
    return result;
}

// U+0080 to U+009F are control characters too: two bytes, the first 0xc2, the second below 0xa0.
std::string shown(const std::string& character) {
    const bool is_control = character.size() == 2 && character[0] == '\xc2' &&
                            static_cast<unsigned char>(character[1]) < 0xa0;
    return is_control ? "?" : character;
}

}  // namespace

std::string render(const Diagnostic& d) {
    const std::vector<std::string> line = printable_characters(d.source);
    const int size = static_cast<int>(line.size());
    const int caret = std::clamp(d.column - 1, 0, size);
    const int span = std::clamp(d.length, 1, std::max(1, size - caret));

    // The window of a long line: the span with some of what stands before it.
    const int first = size <= widest ? 0 : std::clamp(caret - widest / 3, 0, size - widest);
    const int last = std::min(size, first + widest);
    std::string text = first > 0 ? "..." : "";
    std::string marks(text.size(), ' ');
    for (int i = first; i < last; ++i)
        text += shown(line[static_cast<std::size_t>(i)]);
    if (last < size) text += "...";
    while (!text.empty() && text.back() == ' ')
        text.pop_back();
    marks += std::string(static_cast<std::size_t>(caret - first), ' ') + '^' +
             std::string(static_cast<std::size_t>(std::clamp(span, 1, widest) - 1), '~');

    const std::string number = fmt::format("{:>5}", d.line);
    const std::string gutter(number.size() + 1, ' ');
    std::string result =
        fmt::format("{}:{}:{}: {}: {}\n", d.file, d.line, d.column,
                    d.severity == Severity::error ? "error" : "warning", d.message);
    result += fmt::format("{} |{}{}\n", number, text.empty() ? "" : " ", text);
    result += fmt::format("{}| {}\n", gutter, marks);
    if (!d.remedy.empty()) result += fmt::format("{}= {}\n", gutter, d.remedy);
    for (const IncludedFrom& from : d.included_from) {
        result += fmt::format("{}included from {}:{}\n", gutter, from.file, from.line);
    }
    return result;
}

}  // namespace carom

#include "level/statements/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "level/text/lookalikes.h"
#include "level/text/utf8.h"

namespace carom {
namespace {

void report_letter(std::string_view c, const Span& at, Reporter& reporter) {
    if (c == "\t")
        return reporter.error("map-tab", at, "a tab stands in the drawing", "write blanks");
    if (const Lookalike* like = lookalike(decode_utf8(c).character))
        return reporter.error("lookalike", at, fmt::format("{} stands here", like->name),
                              std::string(like->remedy));
    reporter.error("map-letter-unknown", at, fmt::format("'{}' means nothing in a drawing", c),
                   fmt::format("explain it above: legend ball {} kind=NAME", c));
}

}  // namespace

Drawing::Drawing(const std::vector<Word>& lines) : lines_(lines) {
    for (const Word& line : lines) {
        std::vector<std::string_view> row;
        for (std::size_t i = 0; i < line.text.size();) {
            std::size_t end = i + 1;
            while (end < line.text.size() && continues_sequence(line.text[end]))
                ++end;
            row.push_back(line.text.substr(i, end - i));
            i = end;
        }
        columns_ = std::max(columns_, static_cast<int>(row.size()));
        cells_.push_back(std::move(row));
    }
}

const LegendIr* DrawingLetters::legend_of(std::string_view letter) const {
    static const LegendIr solid{.what = LegendIr::What::solid};
    static const LegendIr ball{.what = LegendIr::What::ball};
    static const LegendIr peg{.what = LegendIr::What::peg};
    if (letter == " ") return nullptr;
    const auto found = ir_.legends.find(letter);
    if (found != ir_.legends.end()) return &found->second;
    return letter == "#" ? &solid : letter == "o" ? &ball : letter == "*" ? &peg : nullptr;
}

// A character with a meaning in drawings.
bool DrawingLetters::is_known(std::string_view c) const {
    return c == " " || c == "." || is_line(c) || is_joint(c) || legend_of(c);
}

// The column at which a comment begins: a mark of comments, and behind it a word of three
// letters or more, one of them unknown.
std::optional<int> DrawingLetters::comment_in(const Drawing& drawing, int row) const {
    const auto is_mark = [&](int column) {
        const std::string_view c = drawing.at(row, column);
        return c == "#" || c == ";" || ((c == "/" || c == "-") && drawing.at(row, column + 1) == c);
    };
    std::optional<int> mark;
    int letters = 0;
    bool has_unknown = false;
    for (int column = 0; column < drawing.length(row); ++column) {
        const std::string_view c = drawing.at(row, column);
        if (!mark && is_mark(column)) mark = column;
        const bool is_letter = is_identifier(c);
        letters = is_letter ? letters + 1 : 0;
        has_unknown = is_letter && ((letters > 1 && has_unknown) || !is_known(c));
        if (mark && has_unknown && letters >= 3) return mark;
    }
    return std::nullopt;
}

bool DrawingLetters::check(const Drawing& drawing, Reporter& reporter) const {
    std::set<std::string_view> reported;
    bool is_valid = true;
    for (int row = 0; row < drawing.rows(); ++row) {
        int last = drawing.length(row);
        if (const std::optional<int> comment = comment_in(drawing, row)) {
            reporter.error("comment-in-map", drawing.span(row, *comment),
                           "a drawing cannot have comments",
                           "write it above the map, or below its end");
            is_valid = false;
            last = *comment;
        }
        for (int column = 0; column < last; ++column) {
            const std::string_view c = drawing.at(row, column);
            if (is_known(c)) continue;
            is_valid = false;
            if (reported.insert(c).second) report_letter(c, drawing.span(row, column), reporter);
        }
    }
    return is_valid;
}

}  // namespace carom

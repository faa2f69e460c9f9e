#include "level/text/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

bool is_blank_or_comment(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string_view::npos || text[first] == '#';
}

// Whether the '#' at `place` belongs to a colour, as in color=#d92b2b, and begins no comment. A
// value cannot be left out, so no level has a comment there.
bool is_color_mark(std::string_view line, std::size_t place) {
    return place > 0 && line[place - 1] == '=' && place + 1 < line.size() &&
           !is_blank(line[place + 1]);
}

// The length of the mark if the word begins a comment as in C, Lua, SQL or INI files; 0 otherwise.
// `before`: the words of the statement so far. `legend ball ;` explains the letter.
std::size_t foreign_comment_mark(std::string_view word, const std::vector<Word>& before) {
    if (word.starts_with("//") || word.starts_with("/*")) return 2;
    const bool is_letter =
        word.size() == 1 && before.size() == 2 && before.front().text == "legend";
    if (word.starts_with(";") && !is_letter) return 1;
    return word == "--" || (word.starts_with("--") && before.empty()) ? 2 : 0;
}

}  // namespace

Word Word::part(std::size_t offset, std::size_t count) const {
    return {text.substr(offset, count), source, line, column + characters(text.substr(0, offset))};
}

std::vector<Word> LineReader::next() {
    std::vector<Word> words;
    while (line_ < source_->lines.size()) {
        const bool goes_on = split(clean_line(line_), static_cast<int>(line_) + 1, words);
        ++line_;
        if (!goes_on && !words.empty()) return words;
    }
    return words;
}

std::string_view LineReader::clean_line(std::size_t index) {
    const auto found = source_->mended.find(index);
    if (found == source_->mended.end()) return source_->lines[index];
    const MendedLine::Mend& first = found->second.mends.front();
    reporter_->error("lookalike", {source_, static_cast<int>(index) + 1, first.column, 1},
                     fmt::format("{} stands here", first.lookalike->name),
                     std::string(first.lookalike->remedy));
    return found->second.text;
}

std::optional<Word> LineReader::next_verbatim() {
    if (line_ >= source_->lines.size()) return std::nullopt;
    const Word word{source_->lines[line_], source_, static_cast<int>(line_) + 1, 1};
    ++line_;
    return word;
}

bool LineReader::split(std::string_view line, int number, std::vector<Word>& words) {
    const auto word_at = [&](std::size_t from, std::size_t to) {
        return Word{line.substr(from, to - from), source_, number,
                    characters(line.substr(0, from)) + 1};
    };
    std::size_t i = 0;
    while (i < line.size()) {
        if (is_blank(line[i])) {
            ++i;
            continue;
        }
        if (line[i] == '#') return false;
        if (line[i] == '\\') {
            if (is_blank_or_comment(line.substr(i + 1))) return true;
            reporter_->error("backslash-inside-line", word_at(i, i + 1).span(),
                             "a '\\' stands in the middle of the line",
                             "a '\\' continues a line, and only at its end");
            ++i;
            continue;
        }
        std::size_t end = i;
        if (line[i] == '"') {
            end = line.find('"', i + 1);
            if (end == std::string_view::npos) {
                reporter_->error("quote-not-closed", word_at(i, line.size()).span(),
                                 "the closing '\"' is missing",
                                 "end the text with '\"' on the same line");
                words.push_back(word_at(i, line.size()));
                return false;
            }
            ++end;
        } else {
            while (end < line.size() && !is_blank(line[end]) && line[end] != '"' &&
                   line[end] != '\\' && (line[end] != '#' || is_color_mark(line, end))) {
                ++end;
            }
        }
        const Word word = word_at(i, end);
        if (const std::size_t mark = foreign_comment_mark(word.text, words); mark > 0) {
            reporter_->error(
                "foreign-comment", word.part(0, mark).span(),
                fmt::format("'{}' does not begin a comment", word.text.substr(0, mark)),
                "a comment begins with #");
            return false;
        }
        words.push_back(word);
        i = end;
    }
    return false;
}

bool starts_identifier(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

bool continues_identifier(char c) {
    return starts_identifier(c) || (c >= '0' && c <= '9');
}

bool is_identifier(std::string_view text) {
    return !text.empty() && starts_identifier(text[0]) &&
           std::ranges::all_of(text, continues_identifier);
}

}  // namespace carom

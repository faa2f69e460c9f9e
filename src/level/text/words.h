#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "level/text/reporter.h"
#include "level/text/text.h"
#include "level/text/utf8.h"

/// Splits a source into lines of words. Comments are dropped, and a line that ends in a backslash
/// continues on the next.
namespace carom {

/// Characters between blanks, or a text in quotes, including the quotes. A word is never empty and
/// lies within one line.
struct Word {
    std::string_view text;
    const SourceText* source = nullptr;
    int line = 1;
    int column = 1;

    Span span() const { return {source, line, column, characters(text)}; }
    /// The part of `count` bytes that begins at byte `offset`. Pre: offset <= text.size().
    Word part(std::size_t offset, std::size_t count = std::string_view::npos) const;
};

/// Reads a source from top to bottom.
class LineReader {
  public:
    LineReader(const SourceText& source, Reporter& reporter)
        : source_(&source), reporter_(&reporter) {}

    /// The words of the next line that has words; empty at the end of the source. Lookalikes, and
    /// comments as other languages write them, are reported and read as the author meant them.
    std::vector<Word> next();
    /// The next line, verbatim (for drawings); none at the end of the source.
    std::optional<Word> next_verbatim();

  private:
    /// A line without lookalikes; reports the first of them.
    std::string_view clean_line(std::size_t index);
    /// Adds the words of one line; true when a backslash continues it.
    bool split(std::string_view line, int number, std::vector<Word>& words);

    const SourceText* source_;
    Reporter* reporter_;
    std::size_t line_ = 0;
};

/// Whether the text is a name: a letter or '_', then letters, digits and '_'. Every character
/// beyond ASCII counts as a letter.
bool is_identifier(std::string_view text);
bool starts_identifier(char c);
bool continues_identifier(char c);

}  // namespace carom

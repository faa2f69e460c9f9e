#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "level/text/reporter.h"
#include "level/text/text.h"
#include "level/text/utf8.h"

/// Lines of words: comments dropped, lines that end in a backslash joined to the next.
namespace carom {

/// What stands between blanks; a text in quotes is one word, quotes included. Never empty, never
/// runs over the end of a line.
struct Word {
    std::string_view text;
    const SourceText* source = nullptr;
    int line = 1;
    int column = 1;

    Span span() const { return {source, line, column, characters(text)}; }
    /// The piece of `count` bytes from byte `offset` on. Pre: offset <= text.size().
    Word part(std::size_t offset, std::size_t count = std::string_view::npos) const;
};

/// Reads a source from top to bottom.
class LineReader {
  public:
    LineReader(const SourceText& source, Reporter& reporter)
        : source_(&source), reporter_(&reporter) {}

    /// The words of the next line that has any; empty at the end of the source.
    std::vector<Word> next();
    /// The next line as it stands (for drawings); none at the end of the source.
    std::optional<Word> next_verbatim();

  private:
    /// Adds the words of one line; true when the line goes on.
    bool split(std::string_view line, int number, std::vector<Word>& words);

    const SourceText* source_;
    Reporter* reporter_;
    std::size_t line_ = 0;
};

/// A letter or '_', then letters, digits and '_'. Letters beyond ASCII count as letters.
bool is_identifier(std::string_view text);
bool starts_identifier(char c);
bool continues_identifier(char c);

}  // namespace carom

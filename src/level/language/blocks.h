#pragma once

#include <vector>

#include "level/language/statement_table.h"
#include "level/text/words.h"

/// Parses lines of words into a tree: the statements between mirror, repeat, part or map and its
/// `end` are the body of that statement.
namespace carom {

/// One statement of a source. It has at least one word.
struct Node {
    std::vector<Word> words;
    /// Null: an unknown keyword, which has been reported.
    const Statement* statement = nullptr;
    std::vector<Node> body;
    std::vector<Word> drawing;  ///< the verbatim lines of a map; a word may be empty

    const Word& keyword() const { return words.front(); }
    /// The words after the statement's name ("use gravity" has two words of name).
    std::vector<Word> rest() const;
};

/// The deepest nesting of blocks.
inline constexpr int max_block_depth = 32;

/// The statements of a source, looked up in `table`, which must outlive them. Reports unknown
/// keywords, missing and stray `end`s; stops (Reporter::stop) at blocks nested deeper than
/// max_block_depth. An unknown keyword that resembles a block's opens a block, so that its `end` is
/// not reported as well.
std::vector<Node> read_blocks(const SourceText& source, const StatementTable& table,
                              Reporter& reporter);

}  // namespace carom

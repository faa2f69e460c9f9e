#pragma once

#include <vector>

#include "level/language/statements.h"
#include "level/text/words.h"

/// Lines to a tree: what stands between mirror, repeat, part or map and its `end` is its body.
namespace carom {

/// One statement of a source. Never empty.
struct Node {
    std::vector<Word> words;
    /// None: an unknown keyword, told already.
    const Statement* statement = nullptr;
    std::vector<Node> body;
    std::vector<Word> drawing;  ///< a map's lines as they stand; may be empty words

    const Word& keyword() const { return words.front(); }
    /// The words behind the statement's name ("use gravity" has two of them).
    std::vector<Word> rest() const;
};

/// Deepest blocks.
inline constexpr int max_block_depth = 32;

/// The statements of a source. Reports unknown keywords, missing and stray `end`s, and blocks
/// nested deeper than max_block_depth, behind which nothing more is read.
std::vector<Node> read_blocks(const SourceText& source, Reporter& reporter);

}  // namespace carom

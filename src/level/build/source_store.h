#pragma once

#include <deque>
#include <string>
#include <vector>

#include "level/language/blocks.h"

namespace carom {

/// Owns every source text and every tree of a load. Words, spans and nodes point into it, so it
/// must outlive the interpreter's results; its elements never move.
struct SourceStore {
    std::deque<SourceText> sources;  ///< in the order in which they were opened
    std::deque<std::vector<Node>> trees;

    const SourceText& add(std::string name, std::string text, std::vector<IncludedFrom> from = {});
};

}  // namespace carom

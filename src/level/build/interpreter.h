#pragma once

#include <deque>
#include <string>

#include "level/statements/builders.h"

/// Carries out the statements of a level, its blocks and its includes, into a draft.
namespace carom {

/// Owns every text and every tree that words point into.
struct SourceStore {
    std::deque<SourceText> sources;
    std::deque<std::vector<Node>> trees;

    const SourceText& add(std::string name, std::string text, std::vector<IncludedFrom> from = {});
};

/// Pre: `main` is in `texts` and has no fault. Overrides replace the statement of the file that
/// says the same thing, in its place; one that the file does not say comes last.
void unroll(const SourceText& main, const LoadOptions& options, SourceStore& texts, Scene& scene,
            Context& context);

}  // namespace carom

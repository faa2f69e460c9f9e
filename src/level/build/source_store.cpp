#include "level/build/source_store.h"

namespace carom {

const SourceText& SourceStore::add(std::string name, std::string text,
                                   std::vector<IncludedFrom> from) {
    SourceText& source = sources.emplace_back();
    source.name = std::move(name);
    source.text = std::move(text);
    source.lines = split_lines(source.text);
    for (std::size_t i = 0; i < source.lines.size(); ++i) {
        MendedLine line = mended(source.lines[i]);
        if (!line.mends.empty()) source.mended.emplace(i, std::move(line));
    }
    source.included_from = std::move(from);
    source.order = static_cast<int>(sources.size()) - 1;
    return source;
}

}  // namespace carom

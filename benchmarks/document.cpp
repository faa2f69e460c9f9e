#include "document.h"

#include <sstream>
#include <string_view>

namespace carom::bench {
namespace {

constexpr std::string_view mark_start = "<!-- bench ";
constexpr std::string_view mark_end = " -->";

// The NAME of a mark; empty where the line is not a mark.
std::string mark_name(const std::string& line) {
    if (!line.starts_with(mark_start) || !line.ends_with(mark_end)) return {};
    return line.substr(mark_start.size(), line.size() - mark_start.size() - mark_end.size());
}

}  // namespace

std::string with_blocks(const std::string& text, const std::map<std::string, std::string>& blocks) {
    std::istringstream in(text);
    std::string out;
    for (std::string line; std::getline(in, line);) {
        out += line + '\n';
        const auto block = blocks.find(mark_name(line));
        if (block == blocks.end()) continue;
        // Skip the old block, from its opening fence to the closing one.
        for (int fences = 0; fences < 2 && std::getline(in, line);)
            fences += line.starts_with("```") ? 1 : 0;
        out += "```text\n" + block->second + "```\n";
    }
    return out;
}

}  // namespace carom::bench

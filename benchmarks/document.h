#pragma once

#include <map>
#include <string>

/// Measurements inside a document.
namespace carom::bench {

/// `text` with the fenced block after each line `<!-- bench NAME -->` replaced by blocks[NAME].
/// Marks whose name is not in `blocks` keep their block.
std::string with_blocks(const std::string& text, const std::map<std::string, std::string>& blocks);

}  // namespace carom::bench

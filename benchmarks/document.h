#pragma once

#include <map>
#include <string>

/// Measurements that stand in a text for people.
namespace carom::bench {

/// `text` with the fenced block after each line `<!-- bench NAME -->` replaced by blocks[NAME].
/// Names without a block keep what they have.
std::string with_blocks(const std::string& text, const std::map<std::string, std::string>& blocks);

}  // namespace carom::bench

#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The order of the menu: a text file beside the levels that ship.
///
///     [Play]
///     eight-ball   Solids and stripes, alone or in a match
///
/// A group in brackets, then its levels, each with a line about it. `#` begins a comment.
namespace carom {

struct ListedLevel {
    std::string group;
    std::string name;  ///< the file name without folder and `.level`
    std::string line;  ///< about the level; may be empty
};

std::vector<ListedLevel> menu_list(std::string_view text);
/// The list in the folder; empty where there is none.
std::vector<ListedLevel> menu_list_in(const std::string& folder);

}  // namespace carom

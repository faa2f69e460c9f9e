#include "carom/files/menu_list.h"

#include <algorithm>
#include <filesystem>

#include "carom/files/files.h"

namespace carom {
namespace {

constexpr std::string_view file_name = "menu.list";

std::string_view without_blanks(std::string_view text) {
    const std::size_t from = std::min(text.find_first_not_of(" \t\r"), text.size());
    const std::size_t last = text.find_last_not_of(" \t\r");
    return last == text.npos ? std::string_view{} : text.substr(from, last + 1 - from);
}

}  // namespace

std::vector<ListedLevel> menu_list(std::string_view text) {
    std::vector<ListedLevel> levels;
    std::string group;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = without_blanks(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.front() == '#') continue;
        if (line.front() == '[') {
            group = line.substr(1, line.find(']') - 1);
            continue;
        }
        const std::size_t name = std::min(line.find_first_of(" \t"), line.size());
        levels.push_back({group, std::string(line.substr(0, name)),
                          std::string(without_blanks(line.substr(name)))});
    }
    return levels;
}

std::vector<ListedLevel> menu_list_in(const std::string& folder) {
    const FileText file = read_file((std::filesystem::path(folder) / file_name).string());
    return file.text ? menu_list(*file.text) : std::vector<ListedLevel>{};
}

}  // namespace carom

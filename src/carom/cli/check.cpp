#include "carom/cli/check.h"

#include <fmt/format.h>

#include <algorithm>

#include "carom/files/level_files.h"
#include "carom/files/print.h"

namespace carom {

int check(const CheckOptions& options) {
    bool all_load = true;
    for (const std::string& argument : options.levels) {
        const LoadedLevel level = load_level_file(argument, {.overrides = options.overrides});
        if (!level.error.empty()) print_error(level.error);
        print_diagnostics(level.result.diagnostics);
        if (!level.result.scene) {
            all_load = false;
        } else if (!print_out(fmt::format("{}: ok\n", level.path))) {
            return 2;
        }
    }
    return all_load ? 0 : 2;
}

int list(const ListOptions&) {
    const std::optional<std::string> folder = shipped_levels_folder();
    if (!folder) {
        print_error(
            "the levels that ship with carom are not where they should be; set CAROM_LEVELS to "
            "their folder");
        return 2;
    }
    const std::vector<LevelEntry> levels = levels_in(*folder);
    std::size_t width = 0;
    for (const LevelEntry& level : levels)
        width = std::max(width, level.name.size());
    std::string text;
    for (const LevelEntry& level : levels) {
        text += fmt::format("{:<{}}  {}\n", level.name, width, level.title);
    }
    return print_out(text) ? 0 : 2;
}

}  // namespace carom

#include "carom/cli/open_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "carom/files/print.h"

namespace carom {

std::optional<OpenedReplay> open_recording(const std::string& path,
                                           std::initializer_list<FixedOption> fixed) {
    const auto given = std::ranges::find_if(fixed, &FixedOption::is_given);
    if (given != fixed.end()) {
        print_error(
            fmt::format("'{}' is a recording, which leaves no choice of {}", path, given->name));
        return std::nullopt;
    }
    auto opened = open_replay(path);
    if (const auto* error = std::get_if<std::string>(&opened)) {
        print_note(*error);
        return std::nullopt;
    }
    return std::get<OpenedReplay>(std::move(opened));
}

}  // namespace carom

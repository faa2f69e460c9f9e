#include "carom/files/output_clash.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace carom {
namespace {

namespace fs = std::filesystem;

bool is_same_file(const std::string& a, const std::string& b) {
    if (a == b) return true;
    if (a == "-" || b == "-") return false;
    std::error_code error;
    if (fs::equivalent(a, b, error)) return true;
    // Files that do not exist yet are compared by where they would be.
    const fs::path place = fs::weakly_canonical(fs::absolute(a, error), error);
    if (error) return false;
    return place == fs::weakly_canonical(fs::absolute(b, error), error) && !error;
}

}  // namespace

std::optional<std::string> clash_of_outputs(std::span<const std::string> outputs,
                                            std::span<const std::string> inputs) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const std::string& output = outputs[i];
        if (output.empty()) continue;
        const auto is_it = [&](const std::string& other) {
            return !other.empty() && is_same_file(output, other);
        };
        if (std::ranges::any_of(outputs.first(i), is_it))
            return fmt::format("two outputs cannot both go to {}",
                               output == "-" ? "standard output" : "'" + output + "'");
        if (output != "-" && std::ranges::any_of(inputs, is_it))
            return fmt::format("'{}' is read, and the output would replace it: name another file",
                               output);
    }
    return std::nullopt;
}

}  // namespace carom

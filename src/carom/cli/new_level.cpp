#include "carom/cli/new_level.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "carom/files/files.h"
#include "carom/files/level_files.h"
#include "carom/files/print.h"

namespace carom {
namespace {

constexpr std::string_view first_level =
    "carom 1 \"My level\"\n"
    "# Goal: Say here what to do.\n"
    "use gravity 0,-9.81\n"
    "material wood e=0.8\n"
    "edge wood r=1  0,0  100,0  100,80  0,80  close\n"
    "edge wood r=0.5  20,40  60,25\n"
    "ball a at=30,60 v=2,0 r=2 m=1\n";

}  // namespace

int new_level(const NewOptions& options) {
    std::error_code missing;
    if (std::filesystem::exists(options.file, missing)) {
        print_error(fmt::format("'{}' exists already: name another file", options.file));
        return 2;
    }
    std::string text(first_level);
    if (!options.source.empty()) {
        const FoundLevel found = find_level(options.source);
        FileText content = found.path ? read_file(*found.path) : FileText{{}, found.error};
        if (!content.text) {
            print_error(content.error);
            return 2;
        }
        text = std::move(*content.text);
    }
    if (const auto error =
            write_file_atomically(options.file, text, Access::everybody, Existing::kept)) {
        print_error(*error);
        return 2;
    }
    const std::string name = printable(options.file);
    const std::string told =
        fmt::format("{}: try `carom play {} --watch`, and edit it\n", name, name);
    return print_out(told) ? 0 : 2;
}

}  // namespace carom

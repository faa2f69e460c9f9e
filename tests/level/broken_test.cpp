#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

#include <doctest/doctest.h>

#include "level/support/files.h"

using namespace carom;
using namespace carom::test;

namespace {

// What the loader must find, one line a diagnostic: severity, code, file:line:column.
std::string finding(const Diagnostic& diagnostic) {
    return fmt::format("{} {} {}:{}:{}\n",
                       diagnostic.severity == Severity::error ? "error" : "warning",
                       diagnostic.code.text(), diagnostic.file, diagnostic.line, diagnostic.column);
}

std::string findings(const LoadResult& result) {
    std::string lines;
    for (const Diagnostic& diagnostic : result.diagnostics)
        lines += finding(diagnostic);
    return lines;
}

// A NAME.expected has each finding, and below it, indented, the message as players see it. Only the
// findings are compared, so a message may be reworded.
std::string expected_file(const LoadResult& result) {
    std::string text;
    for (const Diagnostic& diagnostic : result.diagnostics) {
        text += finding(diagnostic);
        const std::string message = render(diagnostic);
        for (std::size_t from = 0; from < message.size();) {
            const std::size_t end = message.find('\n', from);
            text += "    " + message.substr(from, end - from) + "\n";
            from = end + 1;
        }
    }
    return text;
}

std::string expected_findings(const std::string& file) {
    std::string lines;
    for (std::size_t from = 0; from < file.size();) {
        const std::size_t end = std::min(file.find('\n', from), file.size() - 1);
        if (file[from] != ' ') lines += file.substr(from, end + 1 - from);
        from = end + 1;
    }
    return lines;
}

}  // namespace

// Each broken/NAME.level has a fault of its own, and the loader reports that fault alone. With
// CAROM_UPDATE_BROKEN=1 in the environment, this test writes NAME.expected instead of reading it.
TEST_CASE("each broken level gets exactly its own diagnostics") {
    const std::filesystem::path folder =
        std::filesystem::path(CAROM_SOURCE_DIR) / "tests/level/broken";
    const auto files = level_files(folder);
    const char* update = std::getenv("CAROM_UPDATE_BROKEN");
    CHECK(files.size() > 150);
    for (const auto& file : files) {
        const std::string name = file.filename().string();
        CAPTURE(name);
        const LoadResult result = load_level(read_file(file), name, options_for(folder));
        std::filesystem::path expected = file;
        expected.replace_extension(".expected");
        if (update && std::string_view(update) == "1") {
            std::ofstream(expected, std::ios::binary) << expected_file(result);
        }
        CHECK(findings(result) == expected_findings(read_file(expected)));
        CHECK_FALSE(result.diagnostics.empty());
        CHECK(result.diagnostics.size() <= 20);
        bool has_error = false;
        for (const Diagnostic& d : result.diagnostics) {
            CHECK_FALSE(d.code.text().empty());
            has_error = has_error || d.severity == Severity::error;
        }
        CHECK(result.scene.has_value() == !has_error);
    }
}

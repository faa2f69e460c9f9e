#include <doctest/doctest.h>

#include "level/support/files.h"

using namespace carom;
using namespace carom::test;

// Each broken/NAME.level is wrong in its own way; NAME.expected holds what carom says to it, to the
// letter, and nothing more: one message for one mistake.
TEST_CASE("broken levels get exactly their messages") {
    const std::filesystem::path folder =
        std::filesystem::path(CAROM_SOURCE_DIR) / "tests/level/broken";
    const auto files = level_files(folder);
    CHECK(files.size() > 150);
    for (const auto& file : files) {
        const std::string name = file.filename().string();
        CAPTURE(name);
        const LoadResult result = load_level(read_file(file), name, options_for(folder));
        std::filesystem::path expected = file;
        expected.replace_extension(".expected");
        CHECK(rendered(result) == read_file(expected));
        CHECK_FALSE(result.diagnostics.empty());
        CHECK(result.diagnostics.size() <= 20);
        bool has_error = false;
        for (const Diagnostic& d : result.diagnostics)
            has_error = has_error || d.severity == Severity::error;
        CHECK(result.scene.has_value() == !has_error);
    }
}

#include "carom/cli/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

#include "carom/files/level_files.h"
#include "carom/files/print.h"
#include "lab/json.h"

namespace carom {

namespace {

void write_diagnostic(JsonWriter& json, const Diagnostic& diagnostic) {
    json.begin_object(JsonWriter::Layout::one_line);
    json.field("file", diagnostic.file);
    json.field("line", std::int64_t{diagnostic.line});
    json.field("column", std::int64_t{diagnostic.column});
    json.field("length", std::int64_t{diagnostic.length});
    json.field("severity", diagnostic.severity == Severity::error ? "error" : "warning");
    json.field("code", diagnostic.code.text());
    json.field("message", diagnostic.message);
    json.field("remedy", diagnostic.remedy);
    json.end_object();
}

// As load_level_file(), where "-" is the text on standard input.
LoadedLevel load(const std::string& argument, LoadOptions options) {
    if (argument != "-") return load_level_file(argument, std::move(options));
    constexpr std::size_t most = std::size_t{4} << 20;  // as read_file
    std::string text;
    std::array<char, 65536> part{};
    while (text.size() <= most) {
        const std::size_t read = std::fread(part.data(), 1, part.size(), stdin);
        if (read == 0) break;
        text.append(part.data(), read);
    }
    LoadedLevel loaded;
    loaded.path = "standard input";
    options.resolve_include = include_resolver();
    loaded.result = load_level(text, loaded.path, options);
    return loaded;
}

// A list of all diagnostics of all levels. A level that cannot be read has one without a line.
int check_for_tools(const CheckOptions& options) {
    bool all_load = true;
    JsonWriter json;
    json.begin_list(JsonWriter::Layout::lines);
    for (const std::string& argument : options.levels) {
        const LoadedLevel level = load(argument, {.overrides = options.overrides});
        all_load = all_load && level.result.scene;
        if (!level.error.empty()) {
            json.begin_object(JsonWriter::Layout::one_line);
            json.field("file", argument);
            json.field("severity", "error");
            json.field("message", level.error);
            json.end_object();
        }
        for (const Diagnostic& diagnostic : level.result.diagnostics)
            write_diagnostic(json, diagnostic);
    }
    json.end_list();
    if (!print_out(std::move(json).text())) return 2;
    return all_load ? 0 : 2;
}

}  // namespace

int check(const CheckOptions& options) {
    if (options.format == CheckFormat::json) return check_for_tools(options);
    bool all_load = true;
    for (const std::string& argument : options.levels) {
        const LoadedLevel level = load(argument, {.overrides = options.overrides});
        if (!level.error.empty()) print_error(level.error);
        print_diagnostics(level.result.diagnostics);
        if (!level.result.scene) {
            all_load = false;
        } else if (!print_out(fmt::format("{}: ok\n", printable(level.path)))) {
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

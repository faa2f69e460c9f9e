#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string>

#include "guard.h"
#include "term_table.h"

// Counts instructions. scripts/instructions runs this program under callgrind.
namespace {

using namespace carom::bench;

constexpr double tolerance = 0.03;

std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

int check(const std::vector<GuardLine>& counted, const std::string& figures) {
    const auto differences = guard_differences(parse_guard(content(figures)), counted, tolerance);
    for (const std::string& difference : differences)
        fmt::print("{}\n", difference);
    fmt::print("{} counts, {} differ from {} by more than {} %\n", counted.size(),
               differences.size(), figures, 100.0 * tolerance);
    if (differences.empty()) return 0;
    fmt::print("If that is meant: scripts/instructions --update, and say why in the commit.\n");
    return 1;
}

}  // namespace

int main(int count, char** arguments) {
    std::string dumps;
    std::string scenes;
    std::string figures;
    bool update = false;
    bool terms = false;
    CLI::App app("Counts instructions; runs under callgrind");
    app.add_option("--dumps", dumps, "As --callgrind-out-file")->required();
    app.add_option("--scenes", scenes, "Folder of the levels")->required();
    app.add_option("--figures", figures, "The file to compare with")->required();
    app.add_flag("--update", update, "Write that file anew");
    app.add_flag("--terms", terms, "Instead: print what each term of the model costs");
    CLI11_PARSE(app, count, arguments);

    InstructionCounter counter(dumps);
    if (terms) {
        fmt::print("{}", term_table(counter, content(scenes + "/gas.level")));
        return 0;
    }
    const std::vector<GuardLine> counted = guard_lines(counter, scenes);
    if (!update) return check(counted, figures);
    std::ofstream(figures) << guard_text(counted);
    return 0;
}

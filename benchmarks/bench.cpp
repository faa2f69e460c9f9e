#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "document.h"
#include "goals.h"
#include "own.h"
#include "runs.h"
#include "tables.h"

// Runs carom and other engines in the same scenes, by turns. scripts/bench builds all of them and
// calls this program.
namespace {

using namespace carom::bench;

struct Options {
    Places places;
    bool quick = false;
    int rounds = 5;
    std::string only;  // only scenes whose names contain this
    bool with_own = true;
    std::string csv_path;
    std::string document_path;
    std::string terms_path;  // a table of instructions that is copied into the document
};

// The machine: processor and compiler.
std::string machine() {
    std::ifstream file("/proc/cpuinfo");
    std::string processor = "unknown";
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("model name")) continue;
        processor = line.substr(line.find(':') + 2);
        break;
    }
#ifdef __clang__
    const std::string compiler = "clang++ " __clang_version__;
#else
    const std::string compiler = "g++ " __VERSION__;
#endif
    return fmt::format("processor  {}, one thread\ncompiler   {}, -O3\n", processor, compiler);
}

std::string engines_text(const std::vector<SceneResults>& scenes) {
    std::map<std::string, std::string> engines;
    for (const SceneResults& scene : scenes) {
        for (const Result& result : scene.results)
            if (!result.engine.starts_with("carom"))
                engines.emplace(result.contestant.name, result.engine);
    }
    std::string text;
    for (const auto& [name, engine] : engines)
        text += fmt::format("{:<17}  {}\n", name, engine);
    return text;
}

std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

int run(const Options& options) {
    const auto say = [](const std::string& what) { fmt::print(stderr, "{}\n", what); };
    std::vector<SceneResults> scenes;
    std::map<std::string, std::string> blocks;
    for (const BenchScene& scene : bench_scenes(options.quick)) {
        if (scene.name.find(options.only) == std::string::npos) continue;
        scenes.push_back(run_scene(options.places, scene, options.rounds, say));
        blocks[scene.name] = scene_table(scenes.back());
        fmt::print("\n{}\n{}", scene.name, blocks[scene.name]);
        std::fflush(stdout);
    }
    OwnFigures own;
    if (options.with_own) {
        own = measure_own(options.places, options.quick, std::min(options.rounds, 3), say);
        blocks["cost"] = cost_table(own);
        blocks["events"] = events_table(own);
        fmt::print("\ncarom in the gas\n{}\n{}", blocks["cost"], blocks["events"]);
    }
    blocks["machine"] = machine() + engines_text(scenes);
    blocks["goals"] = goals_table(goal_lines(scenes, own));
    fmt::print("\nWhat carom must reach\n{}\n{}", blocks["goals"], blocks["machine"]);
    if (!options.terms_path.empty()) blocks["terms"] = content(options.terms_path);

    if (!options.csv_path.empty()) std::ofstream(options.csv_path) << csv(scenes, own);
    if (!options.document_path.empty()) {
        const std::string text = with_blocks(content(options.document_path), blocks);
        std::ofstream(options.document_path) << text;
    }
    return 0;
}

}  // namespace

int main(int count, char** arguments) {
    Options options;
    options.places.programs = std::filesystem::canonical(arguments[0]).parent_path();
    CLI::App app("carom beside its peers, in the same scenes");
    app.add_option("--scenes", options.places.scenes, "Folder of the levels")->required();
    app.add_option("--scratch", options.places.scratch, "Folder for what is in between")
        ->required();
    app.add_option("--scripts", options.places.scripts, "Folder of the engines in JavaScript");
    app.add_flag("--quick", options.quick, "Short runs, small scenes");
    app.add_option("--rounds", options.rounds, "Runs of each engine")->check(CLI::Range(1, 99));
    app.add_option("--only", options.only, "Scenes with this in their names");
    app.add_flag("!--no-own", options.with_own, "Without what has no peer");
    app.add_option("--csv", options.csv_path, "Write all figures to this file");
    app.add_option("--document", options.document_path, "Renew the figures in this file");
    app.add_option("--terms", options.terms_path, "The table of terms for it");
    CLI11_PARSE(app, count, arguments);
    return run(options);
}

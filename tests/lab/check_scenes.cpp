// Runs fuzzed scenes under every solver, or those that are named, and checks after every tick what
// it must keep. See scripts/check-scenes.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "lab/support/fuzzed_scene.h"
#include "physics/solver.h"

namespace {

void write(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace carom;
    const std::vector<std::string_view> words(argv + 1, argv + argc);
    const std::uint64_t stride = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 0;
    if (argc < 5 || stride == 0) {
        std::cerr << "usage: check_scenes FIRST COUNT STRIDE KEPT [grains] [SOLVER...]\n"
                     "grains: with balls of radii down to 1e-17 of the usual\n";
        return 2;
    }
    const bool has_grains = std::find(words.begin() + 4, words.end(), "grains") != words.end();
    const bool names_solvers = words.size() > (has_grains ? 5u : 4u);
    const std::uint64_t first = std::strtoull(argv[1], nullptr, 10);
    const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
    std::uint64_t runs = 0;
    std::uint64_t stood_still = 0;
    std::uint64_t unloadable = 0;
    std::uint64_t broken = 0;
    for (std::uint64_t number = first; number < first + count; number += stride) {
        const test::FuzzedScene fuzzed =
            test::fuzzed_scene(number, has_grains ? bits::grain_decade : bits::usual_least_decade);
        if (!fuzzed.scene) {
            ++unloadable;
            continue;
        }
        for (const SolverKind kind : solvers_available()) {
            const bool is_named = !names_solvers || std::find(words.begin() + 4, words.end(),
                                                              name(kind)) != words.end();
            if (!is_named || !supports(kind, fuzzed.scene->world.model())) continue;
            const test::CheckedRun run = test::check_run(fuzzed, kind);
            ++runs;
            if (run.stood_still) ++stood_still;
            if (!run.breach) continue;
            ++broken;
            const std::string solver(name(kind));
            const std::string path =
                std::string(argv[4]) + "/" + std::to_string(number) + "-" + solver;
            write(path + ".level", fuzzed.text);
            write(path + ".commands", run.commands);
            // With the settings of the level's solver, which --solver would not keep.
            SolverSettings settings = fuzzed.scene->solver.value_or(SolverSettings{});
            settings.kind = kind;
            std::cout << "carom run " << path << ".level --commands " << path
                      << ".commands --set 'solver "
                      << settings_text(settings, SettingsText::unusual) << "' --check --ticks "
                      << run.ticks << "\n    " << text(*run.breach, fuzzed.scene->world.rate())
                      << '\n'
                      << std::flush;
        }
    }
    std::cout << runs << " runs, " << unloadable << " scenes that do not load; time stood still in "
              << stood_still << "; " << broken << " broken\n";
    return broken == 0 ? 0 : 1;
}

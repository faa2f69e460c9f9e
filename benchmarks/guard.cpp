#include "guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace carom::bench {
namespace {

struct Guarded {
    CountedScene scene;
    std::vector<SolverKind> solvers;
};

std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<Guarded> guarded(const std::string& folder) {
    using enum SolverKind;
    const std::string gas = content(folder + "/gas.level");
    const std::string pile = content(folder + "/pile.level");
    const std::string galton = content(folder + "/galton.level");
    const std::string mixture =
        "carom 1 \"Benchmark: a mixture\"\nrate 60\nseed 1\nbox 0,0 100,100 r=1\n"
        "fill count=100 box=1,1,99,99 r=1..5 speed=10\n"
        "fill count=400 box=1,1,99,99 r=0.01..0.1 speed=10\n";
    const std::vector<std::string> small_pile{"let columns=20 rows=20 width=25 height=40"};
    return {
        {{.name = "gas", .text = gas}, {discrete, substep, swept, contact, event}},
        {{.name = "mixture", .text = mixture}, {discrete, substep, swept, contact, event}},
        {{.name = "pile-falls", .text = pile, .overrides = small_pile, .warm_ticks = 60},
         {discrete, substep, swept, contact}},
        {{.name = "pile-rests", .text = pile, .overrides = small_pile, .warm_ticks = 600},
         {contact}},
        {{.name = "galton", .text = galton, .overrides = {"let n=500"}, .warm_ticks = 120},
         {discrete, substep, swept, contact, event}},
    };
}

}  // namespace

std::vector<GuardLine> guard_lines(InstructionCounter& counter, const std::string& scenes) {
    std::vector<GuardLine> lines;
    for (const Guarded& guarded_scene : guarded(scenes)) {
        for (const SolverKind solver : solvers_available()) {
            if (std::ranges::find(guarded_scene.solvers, solver) == guarded_scene.solvers.end())
                continue;
            const auto count = count_scene(counter, guarded_scene.scene, solver);
            if (!count) {
                fmt::print(stderr, "error: the level of '{}' does not load\n",
                           guarded_scene.scene.name);
                std::exit(2);
            }
            lines.push_back({.scene = guarded_scene.scene.name,
                             .solver = std::string(name(solver)),
                             .instructions = std::round(count->instructions_a_tick)});
        }
    }
    return lines;
}

}  // namespace carom::bench

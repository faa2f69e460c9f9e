#include "guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

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

const GuardLine* find(const std::vector<GuardLine>& lines, const GuardLine& like) {
    const auto found = std::ranges::find_if(lines, [&like](const GuardLine& line) {
        return line.scene == like.scene && line.solver == like.solver;
    });
    return found == lines.end() ? nullptr : &*found;
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

std::string guard_text(const std::vector<GuardLine>& lines) {
    std::string text =
        "# Instructions a tick, counted by callgrind: g++ 12, -O3, x86-64. scripts/instructions\n"
        "# compares; scripts/instructions --update writes this file anew.\n";
    for (const GuardLine& line : lines)
        text += fmt::format("{} {} {:.0f}\n", line.scene, line.solver, line.instructions);
    return text;
}

std::vector<GuardLine> parse_guard(const std::string& text) {
    std::vector<GuardLine> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        GuardLine parsed;
        if (!line.starts_with('#') && words >> parsed.scene >> parsed.solver >> parsed.instructions)
            lines.push_back(parsed);
    }
    return lines;
}

std::vector<std::string> guard_differences(const std::vector<GuardLine>& written,
                                           const std::vector<GuardLine>& counted,
                                           double tolerance) {
    std::vector<std::string> differences;
    for (const GuardLine& line : counted) {
        const GuardLine* before = find(written, line);
        if (!before) {
            differences.push_back(
                fmt::format("{} under {}: not written down", line.scene, line.solver));
            continue;
        }
        const double change = line.instructions / before->instructions - 1.0;
        if (std::abs(change) > tolerance) {
            differences.push_back(fmt::format("{} under {}: {:.0f} instructions a tick, {:+.1f} %",
                                              line.scene, line.solver, line.instructions,
                                              100.0 * change));
        }
    }
    for (const GuardLine& line : written) {
        if (!find(counted, line))
            differences.push_back(fmt::format("{} under {}: not there", line.scene, line.solver));
    }
    return differences;
}

}  // namespace carom::bench

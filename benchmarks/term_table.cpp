#include "term_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/table.h"
#include "term_scenes.h"

namespace carom::bench {
namespace {

// One count for each of solvers_available().
std::vector<std::optional<Count>> counts(InstructionCounter& counter, const CountedScene& scene) {
    std::vector<std::optional<Count>> all;
    for (const SolverKind solver : solvers_available())
        all.push_back(count_scene(counter, scene, solver));
    return all;
}

// `with`: none where the solver does not support the term.
std::string added(const std::optional<Count>& with, const Count& bare) {
    if (!with) return "-";
    const double more = with->instructions_a_ball_tick - bare.instructions_a_ball_tick;
    return fmt::format("{:+.0f} ({:+.1f} %)", more, 100.0 * more / bare.instructions_a_ball_tick);
}

// The largest relative difference from the bare gas, over all solvers.
std::string largest_change(const std::vector<std::optional<Count>>& without,
                           const std::vector<std::optional<Count>>& bare) {
    double largest = 0.0;
    for (std::size_t i = 0; i < bare.size(); ++i) {
        if (!without[i]) return "-";
        const double change = without[i]->instructions_a_tick / bare[i]->instructions_a_tick - 1.0;
        if (std::abs(change) > std::abs(largest)) largest = change;
    }
    return largest == 0.0 ? "0" : fmt::format("{:+.3f} %", 100.0 * largest);
}

double added_bytes(const std::vector<std::optional<Count>>& with,
                   const std::vector<std::optional<Count>>& bare) {
    double most = 0.0;
    for (std::size_t i = 0; i < bare.size(); ++i)
        if (with[i]) most = std::max(most, with[i]->bytes_a_ball - bare[i]->bytes_a_ball);
    return most;
}

}  // namespace

std::string term_table(InstructionCounter& counter, const std::string& gas) {
    std::vector<std::string> heads{"<term"};
    for (const SolverKind solver : solvers_available())
        heads.emplace_back(name(solver));
    heads.insert(heads.end(), {"bytes a ball", "stated, no effect"});
    Table table(heads);

    const auto bare = counts(counter, bare_scene(gas));
    std::vector<std::string> first{"none"};
    double bytes = 0.0;
    for (const auto& count : bare) {
        first.push_back(fmt::format("{:.0f}", count->instructions_a_ball_tick));
        bytes = std::max(bytes, count->bytes_a_ball);
    }
    first.insert(first.end(), {fmt::format("{:.0f}", bytes), "0"});
    table.add(first);
    for (const TermScene& scene : term_scenes(gas)) {
        const auto with = counts(counter, scene.with);
        if (!with.front()) continue;
        std::vector<std::string> row{scene.term};
        for (std::size_t i = 0; i < bare.size(); ++i)
            row.push_back(added(with[i], *bare[i]));
        row.push_back(fmt::format("{:+.0f}", added_bytes(with, bare)));
        row.push_back(scene.without ? largest_change(counts(counter, *scene.without), bare) : "-");
        table.add(row);
    }
    return table.text();
}

}  // namespace carom::bench

#include "lab/run/choice.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lab/run/run_record.h"

namespace carom {
namespace {

// Relative tolerance: rates such as 33.3 and 99.9 are not exact multiples.
constexpr double rounding = 1e-9;

void add_new(std::vector<Choice>& choices, const Choice& choice) {
    if (std::ranges::find(choices, choice) == choices.end()) choices.push_back(choice);
}

void add_variants(std::vector<Choice>& choices, SolverKind kind, double rate) {
    if (kind == SolverKind::substep) {
        for (const int updates : {1, 2, 8, 16})
            add_new(choices, {{.kind = kind, .updates = updates}, rate});
    }
    if (kind == SolverKind::swept) {
        for (const int substeps : {2, 4, 8})
            add_new(choices, {{.kind = kind, .substeps = substeps}, rate});
    }
    if (kind == SolverKind::contact) {
        for (const int substeps : {2, 8, 16})
            add_new(choices, {{.kind = kind, .contact_substeps = substeps}, rate});
    }
}

}  // namespace

void write_settings(JsonWriter& json, const SolverSettings& solver) {
    json.begin_object(JsonWriter::Layout::one_line);
    for (const SolverCount& count : counts_of(solver.kind))
        json.field(count.name, static_cast<std::uint64_t>(solver.*count.value));
    if (solver.kind == SolverKind::event) json.field("extended", solver.extended);
    json.end_object();
}

std::vector<Choice> choices_for(const Scene& scene, std::span<const SolverKind> kinds,
                                std::span<const double> rates) {
    std::vector<Choice> choices;
    const SolverSettings own = solver_for(scene);
    if (std::ranges::find(kinds, own.kind) != kinds.end()) {
        choices.push_back({own, scene.world.rate()});
    }
    for (const SolverKind kind : kinds) {
        if (!supports(kind, scene.world.model())) continue;
        for (const double rate : rates)
            add_new(choices, {{.kind = kind}, rate});
        add_variants(choices, kind, scene.world.rate());
    }
    return choices;
}

std::vector<double> usual_rates(double own) {
    return {own / 4.0, own / 2.0, own, own * 2.0, own * 4.0};
}

double common_rate(std::span<const double> rates) {
    double common = rates.front();
    for (double rate : rates) {
        // Euclid's algorithm.
        while (rate > rounding * common) {
            double rest = std::fmod(common, rate);
            if (rate - rest < rounding * common) rest = 0.0;
            common = rate;
            rate = rest;
        }
    }
    return common;
}

std::uint64_t ticks_each(double rate, double common) {
    return static_cast<std::uint64_t>(std::llround(rate / common));
}

Reference reference_settings(double rate) {
    return {.truth = {{.kind = SolverKind::event, .extended = true}, rate},
            .check = {{.kind = SolverKind::event}, rate}};
}

}  // namespace carom

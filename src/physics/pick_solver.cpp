#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/solver.h"
#include "physics/solver_cost.h"

namespace carom {
namespace {

// More accuracy is worth a factor of 1.5 in cost, and no more. Where balls come to rest, estimates
// between 1.2 and 1.6 are too low by 13 % on average, so the estimate must leave a margin.
constexpr double worth = 1.3;

struct Candidate {
    SolverSettings settings;
    double work = 0.0;   // operations a tick
    double error = 0.0;  // radii, after the time that the level names
};

// Most accurate first. `discrete` and `substep` let balls overlap, so only a budget that nothing
// else keeps takes them.
std::vector<SolverSettings> settings_to_weigh(const Need& need) {
    std::vector<SolverSettings> all{{.kind = SolverKind::event}};
    const bool is_asked = need.tolerance || need.budget;
    for (const int substeps : {16, 8})
        if (is_asked) all.push_back({.kind = SolverKind::contact, .contact_substeps = substeps});
    all.push_back({.kind = SolverKind::contact});
    for (const int substeps : {8, 4, 2})
        if (is_asked) all.push_back({.kind = SolverKind::swept, .substeps = substeps});
    all.push_back({.kind = SolverKind::swept});
    if (need.budget) {
        all.push_back({.kind = SolverKind::substep});
        all.push_back({.kind = SolverKind::discrete});
    }
    return all;
}

bool is_sound(const Candidate& candidate) {
    return candidate.settings.kind >= SolverKind::swept;
}

// Two digits, without an exponent: "2.1 us", "43 us", "680 us", "1.7 ms".
std::string time_text(double nanoseconds) {
    const bool is_long = nanoseconds >= 0.995e6;
    const double value = nanoseconds * (is_long ? 1e-6 : 1e-3);
    const double step = value < 0.995 ? 0.01 : value < 9.95 ? 0.1 : value < 99.5 ? 1.0 : 10.0;
    return fmt::format("{:g} {}", std::round(value / step) * step, is_long ? "ms" : "us");
}

std::string priced(const Candidate& candidate) {
    return fmt::format("{} {}", settings_text(candidate.settings, SettingsText::unusual),
                       time_text(candidate.work));
}

// ". A tick takes about 2.1 us; with swept 3.4 us, contact 4 us"
std::string weighed(const std::vector<Candidate>& all, const Candidate& picked) {
    std::string text = ". A tick takes about " + time_text(picked.work);
    const char* joint = "; with ";
    for (const Candidate& candidate : all) {
        if (&candidate == &picked || !is_sound(candidate)) continue;
        if (candidate.settings != SolverSettings{.kind = candidate.settings.kind}) continue;
        text += joint + priced(candidate);
        joint = ", ";
    }
    return text;
}

// Where nothing is asked for: the cheapest, or the most accurate if its cost is worth it.
const Candidate& best_value(const std::vector<Candidate>& all) {
    const Candidate& cheapest = *std::ranges::min_element(all, {}, &Candidate::work);
    return all.front().work <= worth * cheapest.work ? all.front() : cheapest;
}

std::string_view quality_of(const Candidate& picked, const Load& load) {
    if (load.rest > 0.0 && picked.settings.kind == SolverKind::contact)
        return "balls come to rest on one another, and it solves all their contacts together";
    switch (picked.settings.kind) {
        case SolverKind::event:
            return "exact from impact to impact, and cheap enough";
        case SolverKind::contact:
        case SolverKind::swept:
            return load.is_straight ? "exact on straight paths, and the cheapest"
                                    : "nothing passes through anything, and it is the cheapest";
        default:
            return "cheap, but balls overlap";
    }
}

SolverPick pick_for_need(const World& world, const std::vector<Candidate>& all) {
    const Need& need = world.definition().need;
    const double budget = need.budget.value_or(1e300) * 1e9;
    const double tolerance = need.tolerance.value_or(1e300);
    const Candidate* best = nullptr;
    for (const Candidate& candidate : all) {
        if (candidate.work > budget || candidate.error > tolerance || !is_sound(candidate))
            continue;
        // Within a budget the most accurate; within a tolerance alone the cheapest.
        const bool is_better =
            !best || (need.budget ? candidate.error < best->error : candidate.work < best->work);
        if (is_better) best = &candidate;
    }
    if (best)
        return {best->settings,
                fmt::format("it keeps what the level asks for, by estimate: {:.1g} radii off after "
                            "{:g} s{}",
                            best->error, need.within, weighed(all, *best))};
    // The tolerance is the harder promise: a slow answer is still an answer.
    if (need.tolerance) {
        const Candidate& closest = *std::ranges::min_element(all, {}, &Candidate::error);
        return {closest.settings,
                fmt::format("NOTHING keeps what the level asks for, by estimate; this is the most "
                            "accurate, {:.1g} radii off after {:g} s{}",
                            closest.error, need.within, weighed(all, closest))};
    }
    const Candidate& cheapest = *std::ranges::min_element(all, {}, [&](const Candidate& c) {
        return std::pair(c.work > budget, c.work <= budget ? c.error : c.work);
    });
    return {cheapest.settings,
            fmt::format("NOTHING sound keeps the budget of the level, by estimate; {}{}",
                        cheapest.work <= budget ? "this keeps it, but balls overlap"
                                                : "this is the cheapest",
                        weighed(all, cheapest))};
}

}  // namespace

SolverPick pick_solver(const World& world) {
    const Load load = load_of(world);
    const Need& need = world.definition().need;
    std::vector<Candidate> all;
    for (const SolverSettings& settings : settings_to_weigh(need)) {
        if (!supports(settings.kind, world.model())) continue;
        all.push_back({settings, predicted_work(settings, world, load),
                       predicted_error(settings, world, load, need.within)});
    }
    if (need.tolerance || need.budget) return pick_for_need(world, all);
    if (world.model().cloth)
        return {all.front().settings,
                "exact from impact to impact, sliding, rolling and coming to rest on cloth"};
    if (world.model().modulus)
        return {all.front().settings, "the only one whose contacts last, as the level says"};
    const Candidate& picked = best_value(all);
    return {picked.settings, std::string(quality_of(picked, load)) + weighed(all, picked)};
}

}  // namespace carom

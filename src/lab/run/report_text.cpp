#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lab/run/choice.h"
#include "lab/run/report.h"
#include "level/text/joined.h"
#include "level/values/dimension.h"
#include "physics/world/fingerprint.h"

/// Reports for people: the summary of a run, its verdicts, and why the solver was chosen.
namespace carom {
namespace {

// The unit of a quantity after its number; empty in a level without units.
std::string unit_of(const Scene& scene, const Expect& expect) {
    return scene.unit == LengthUnit::natural ? "" : report_unit(expect.what.kind->dimension);
}

std::string statement_text(const Scene& scene, const Expect& expect) {
    const std::string unit = unit_of(scene, expect);
    std::string text =
        expect.relation == Expect::Relation::within
            ? fmt::format("{} {}{} within {}{}", expect.quantity, expect.value, unit,
                          expect.tolerance, unit)
            : fmt::format("{} {} {}{}", expect.quantity, sign(expect.relation), expect.value, unit);
    const bool is_over_ticks = expect.when != Expect::When::last;
    if (is_over_ticks) text += fmt::format(" {}", when_word(expect));
    if (expect.when == Expect::When::by) {
        text += fmt::format(" {}s", *expect.at);
    } else if (is_over_ticks && expect.at) {
        text += fmt::format(" by {}s", *expect.at);
    }
    return text;
}

std::string finding_text(const Scene& scene, const Expect& expect, const Judgement& judgement) {
    if (judgement.verdict == Verdict::not_judged) return std::string(judgement.reason);
    if (!judgement.measured) return "it has no value";
    std::string text = fmt::format("it is {}{}", *judgement.measured, unit_of(scene, expect));
    if (expect.when != Expect::When::last) text += fmt::format(" at {} s", *judgement.time);
    if (judgement.verdict == Verdict::fails && judgement.nearest)
        text += fmt::format(", nearest {}{} at {} s", *judgement.nearest, unit_of(scene, expect),
                            judgement.nearest_time);
    return text;
}

std::string summary_of_figures(const RunRecord& record, const World& world) {
    std::string lines;
    for (const Figure& figure : figures()) {
        const auto value = record.watch.value(figure, world);
        if (!figure.summary.empty() && value)
            lines += fmt::format(fmt::runtime(figure.summary), *value);
    }
    return lines;
}

// ", or +1.2e-13 of it": the drift, for when both numbers print identically.
std::string change_of(double start, double end) {
    if (start == 0.0 || start == end) return {};
    return fmt::format(", or {:+.1e} of it", (end - start) / std::abs(start));
}

// "game        player 2, shots 5, score1 3, score2 1"; empty without a game.
std::string summary_of_game(const RunRecord& record) {
    std::string text;
    for (const auto& [name, count] : record.tallies)
        text += fmt::format("{}{} {}", text.empty() ? "game        " : ", ", name, count);
    return text.empty() ? text : text + "\n";
}

// "event", or "event, then contact substeps=4": each once, in the order of their first ticks.
std::string solvers_of(const RunRecord& record) {
    std::vector<std::string> texts{settings_text(record.solver, SettingsText::used)};
    for (const SolverChange& change : record.solver_changes) {
        std::string text = settings_text(change.settings, SettingsText::used);
        if (std::ranges::find(texts, text) == texts.end()) texts.push_back(std::move(text));
    }
    return joined(texts, ", then ");
}

}  // namespace

std::string summary(const Scene& scene, const World& world, const RunRecord& record,
                    double seconds) {
    const double start = record.totals_start.energy();
    const double end = totals(world).energy();
    return fmt::format(
        "{}\n"
        "{} s simulated in {} ticks by {}, in {:.3g} s\n"
        "balls       {} now, {} removed\n"
        "collisions  {} of balls, {} with edges\n"
        "energy      {:.6g} at the start, {:.6g} now{}\n"
        "{}{}"
        "fingerprint {}\n",
        scene.title.empty() ? scene.file : scene.title, world.time(), world.tick(),
        solvers_of(record), seconds, world.balls().size(), world.ledger().removed.size(),
        world.ledger().ball_ball_collisions, world.ledger().ball_edge_collisions, start, end,
        change_of(start, end), summary_of_figures(record, world), summary_of_game(record),
        hexadecimal(fingerprint(world)));
}

std::string verdicts(const Scene& scene, const RunRecord& record, Verdict verdict) {
    std::string text;
    for (std::size_t i = 0; i < scene.expects.size(); ++i) {
        const Expect& expect = scene.expects[i];
        const Judgement& judgement = record.judgements[i];
        if (judgement.verdict != verdict) continue;
        text += fmt::format("{}:{}: {}: expect {}: {}\n", scene.file, expect.line,
                            verdict == Verdict::fails ? "error" : name(verdict),
                            statement_text(scene, expect), finding_text(scene, expect, judgement));
    }
    return text;
}

std::string explanation(const Scene& scene) {
    return explanation(scene.world.model(), scene.world.rate(), pick_solver(scene.world),
                       scene.solver);
}

std::string explanation(const Model& model, double rate, const SolverPick& pick,
                        const std::optional<SolverSettings>& asked_for) {
    const std::vector<std::string> terms = terms_in_force(model);
    const std::string model_text =
        terms.empty() ? "elastic, frictionless, weightless discs" : joined(terms, "\n        ");
    const std::string picked = settings_text(pick.settings, SettingsText::used);
    const std::string solver_text =
        asked_for ? fmt::format("{} (chosen by you)", settings_text(*asked_for, SettingsText::used))
                  : fmt::format("{} (chosen automatically)", picked);
    // The reason is that of the automatic choice, and stands below it.
    const std::string other =
        asked_for ? fmt::format("auto    would choose {}\n", picked) : std::string();
    const SolverSettings& solver = asked_for ? *asked_for : pick.settings;
    const std::string_view heaps =
        uses_hybrid_step(model, solver)
            ? "heaps   too dense for events, they go over to contact, and come back\n"
            : "";
    return fmt::format("model   {}\nsolver  {}\n{}{}reason  {}\nrate    {} ticks a second\n",
                       model_text, solver_text, heaps, other, pick.reason, rate);
}

}  // namespace carom

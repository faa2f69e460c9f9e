#include "lab/run/judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "game/statistics.h"

namespace carom {
namespace {

std::optional<double> chi_square(std::span<const double> counts, std::span<const double> shares) {
    if (shares.size() != counts.size()) return std::nullopt;
    const double total = moments_of(counts).total;
    const double whole = moments_of(shares).total;
    if (!(total > 0.0) || !(whole > 0.0)) return std::nullopt;
    double sum = 0.0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double expected = total * shares[i] / whole;
        const double off = counts[i] - expected;
        // An empty bin with no expected balls adds nothing.
        if (expected > 0.0 || off > 0.0) sum += off * off / expected;
    }
    return sum;
}

// A quantity of bins. Only "count" is defined for bins without balls.
struct BinsRow {
    std::string_view name;
    std::optional<double> (*value)(std::span<const double> counts, std::span<const double> shares);
};

std::optional<double> variance_ratio(std::span<const double> counts,
                                     std::span<const double> shares) {
    if (shares.size() != counts.size()) return std::nullopt;
    const double variance = moments_of(shares).variance;
    if (!(variance > 0.0)) return std::nullopt;
    return moments_of(counts).variance / variance;
}

constexpr std::array<BinsRow, 5> bins_rows{{
    {"count", [](auto counts, auto) -> std::optional<double> { return moments_of(counts).total; }},
    {"mean", [](auto counts, auto) -> std::optional<double> { return moments_of(counts).mean; }},
    {"variance",
     [](auto counts, auto) -> std::optional<double> { return moments_of(counts).variance; }},
    {"variance_ratio", variance_ratio},
    {"chi_square", chi_square},
}};

std::optional<double> of_bins(const Quantity& quantity, const World& world) {
    const std::vector<std::uint64_t> all = census(world);
    std::vector<double> counts;
    for (const std::uint32_t counter : quantity.counters)
        counts.push_back(static_cast<double>(all[counter]));
    const bool is_empty = !(moments_of(std::span<const double>(counts)).total > 0.0);
    if (is_empty && name(quantity.kind) != "count") return std::nullopt;
    const auto row = std::ranges::find(bins_rows, name(quantity.kind), &BinsRow::name);
    return row->value(counts, quantity.expected);
}

std::optional<double> of_ball(const Quantity& quantity, const World& world) {
    const std::optional<std::size_t> index = index_of(world, quantity.ball);
    if (!index) return std::nullopt;
    return quantity.kind->of_ball(world, *index);
}

}  // namespace

std::optional<double> measure(const Quantity& quantity, const World& world, const RunWatch* watch) {
    if (is_of_ball(quantity.kind)) return of_ball(quantity, world);
    if (is_of_bins(quantity.kind)) return of_bins(quantity, world);
    if (quantity.kind->observable) {
        const Observer* observer = watch ? watch->observer() : nullptr;
        return observer ? observer->value(quantity, world) : std::nullopt;
    }
    if (watch) return watch->value(quantity.kind, world);
    if (!quantity.kind->of_world) return std::nullopt;
    return quantity.kind->of_world(world);
}

std::string_view name(Verdict verdict) {
    switch (verdict) {
        case Verdict::holds:
            return "holds";
        case Verdict::fails:
            return "fails";
        default:
            return "not judged";
    }
}

std::string_view when_word(const Expect& expect) {
    switch (expect.when) {
        case Expect::When::by:
            return "by";
        case Expect::When::always:
            return "always";
        case Expect::When::never:
            return "never";
        case Expect::When::last:
            break;
    }
    return expect.at ? "at" : "end";
}

void judge(const Expect& expect, const World& world, const RunWatch& watch, bool is_last,
           Judgement& judgement) {
    using enum Expect::When;
    if (judgement.is_decided) return;
    const double due = expect.at ? std::round(*expect.at * world.rate()) : 0.0;
    const auto now = static_cast<double>(world.tick());
    if (expect.at && now > due) return;
    const bool is_due = expect.at ? now == due : is_last;
    if (expect.when == last && !is_due) return;

    const std::optional<double> measured = measure(expect.what, world, &watch);
    const bool is_so = measured && holds(expect, *measured);
    if (measured) {
        judgement.measured = measured;
        judgement.time = world.time();
    }
    const bool is_nearer =
        measured && (!judgement.nearest ||
                     shortfall(expect, *measured) < shortfall(expect, *judgement.nearest));
    if (expect.when == by && is_nearer) {
        judgement.nearest = measured;
        judgement.nearest_time = world.time();
    }
    const bool decides = (expect.when == by && is_so) || (expect.when == never && is_so) ||
                         (expect.when == always && measured && !is_so);
    if (!decides && !is_due) return;
    const bool is_met =
        expect.when == last || expect.when == by ? is_so : !decides && judgement.measured;
    judgement.verdict = is_met ? Verdict::holds : Verdict::fails;
    judgement.reason = {};
    judgement.is_decided = true;
}

}  // namespace carom

#include <fmt/format.h>

#include <algorithm>

#include "level/assemble/symbol_table.h"
#include "level/ir/numbers.h"
#include "level/text/brackets.h"
#include "level/text/joined.h"
#include "level/text/spelling.h"

// What `show` and `expect` refer to by name: members of SymbolTable.
namespace carom {
namespace {

// Of the lists that each `show` and each `expect` keeps of its bins or edges, in operations of a
// LoadBudget.
constexpr std::uint64_t cost_of_a_bin = 20;

// The parts of "name(inside)"; none: the word is not of that form.
struct Call {
    Word name;
    Word inside;
};
std::optional<Call> call_of(const Word& word) {
    const std::size_t open = word.text.find('(');
    if (open == std::string_view::npos || word.text.back() != ')') return std::nullopt;
    return Call{word.part(0, open), word.part(open + 1, word.text.size() - open - 2)};
}

}  // namespace

std::optional<std::vector<double>> SymbolTable::expected_shares(const Word& against,
                                                                std::size_t bins) {
    Reporter& reporter = context_.reporter;
    if (against.text == "uniform") {
        return std::vector<double>(bins, 1.0 / static_cast<double>(bins));
    }
    const std::string usage =
        fmt::format("write against=binomial({},0.5) or against=uniform", bins - 1);
    const std::optional<Call> call = call_of(against);
    if (!call || call->name.text != "binomial") {
        reporter.error("unknown-curve", against.span(),
                       fmt::format("'{}' is no known curve", against.text), usage);
        return std::nullopt;
    }
    const std::vector<Word> arguments = split_outside_brackets(call->inside, ",");
    if (arguments.size() != 2) {
        reporter.error("binomial-arguments", against.span(), "binomial takes two numbers", usage);
        return std::nullopt;
    }
    const Scope nothing;
    const auto n =
        read_number(arguments[0], {}, Measure::whole, Bound::not_negative, nothing, context_);
    const auto p =
        read_number(arguments[1], {}, Measure::number, Bound::unit_interval, nothing, context_);
    if (!n || !p) return std::nullopt;
    if (*n + 1.0 != static_cast<double>(bins)) {
        reporter.error("binomial-outcomes", arguments[0].span(),
                       fmt::format("{:.6g} tosses have {:.6g} outcomes, but there are {} bins", *n,
                                   *n + 1.0, bins),
                       usage);
        return std::nullopt;
    }
    return binomial_shares(static_cast<int>(*n), *p);
}

std::optional<Show> SymbolTable::make_show(const ShowIr& spec) {
    Show show;
    show.what = spec.what;
    show.observable = spec.observable;
    if (spec.what != Show::What::histogram) return show;
    const Bins* bins = bins_named(*spec.of);
    if (!bins) return std::nullopt;
    context_.work.spend(cost_of_a_bin * bins->zones.size());
    show.of = bins->name;
    for (std::uint32_t i = 0; i < bins->zones.size(); ++i) {
        show.counters.push_back(bins->first_counter + i);
    }
    if (!spec.against) return show;
    const auto shares = expected_shares(*spec.against, bins->zones.size());
    if (!shares) return std::nullopt;
    show.expected = *shares;
    show.against = std::string(spec.against->text);
    return show;
}

std::optional<Quantity> SymbolTable::quantity_of(const Word& word) {
    const std::size_t open = word.text.find('(');
    if (open != std::string_view::npos) {
        const QuantityKind kind = quantity_named(word.text.substr(0, open), true);
        const bool is_of_edges = kind && kind->scope == QuantityScope::edges;
        return is_of_edges ? edges_quantity(word, kind) : bins_quantity(word, open);
    }
    const std::size_t dot = word.text.rfind('.');
    if (dot != std::string_view::npos) return ball_quantity(word, dot);
    std::vector<std::string_view> known;
    for (const QuantityRow& row : quantities()) {
        const QuantityKind kind = &row;
        if (kind->scope == QuantityScope::edges) continue;  // "pressure" alone is another
        if (is_of_ball(kind) || is_of_bins(kind)) {
            if (name(kind) != word.text) continue;
            context_.reporter.error("quantity-without-subject", word.span(),
                                    fmt::format("{} of what?", word.text),
                                    is_of_ball(kind) ? fmt::format("write BALL.{}", word.text)
                                                     : fmt::format("write {}(BINS)", word.text));
            return std::nullopt;
        }
        if (name(kind) == word.text) return Quantity{kind, {}, {}, {}};
        known.push_back(name(kind));
    }
    context_.reporter.error(
        "unknown-quantity", word.span(), fmt::format("'{}' is no quantity", word.text),
        did_you_mean(word.text, known,
                     fmt::format("there are {}, BALL.x and mean(BINS)", joined(known, " "))));
    return std::nullopt;
}

std::optional<Quantity> SymbolTable::ball_quantity(const Word& word, std::size_t dot) {
    const Word ball = word.part(0, dot);
    const Word what = word.part(dot + 1);
    std::vector<std::string_view> kinds;
    std::optional<QuantityKind> found;
    for (const QuantityRow& row : quantities()) {
        const QuantityKind kind = &row;
        if (!is_of_ball(kind)) continue;
        kinds.push_back(name(kind));
        if (name(kind) == what.text) found = kind;
    }
    if (!found) {
        context_.reporter.error("unknown-ball-quantity", what.span(),
                                fmt::format("a ball has no '{}'", what.text),
                                fmt::format("it has {}", joined(kinds, " ")));
        return std::nullopt;
    }
    if (const auto number = ball_named(ball.text)) return Quantity{*found, BallId{*number}, {}, {}};
    if (is_error_name(ball.text)) return std::nullopt;
    const std::vector<std::string> known = names_of_statements();
    context_.reporter.error("unknown-ball", ball.span(),
                            fmt::format("there is no ball '{}'", ball.text),
                            did_you_mean(ball.text, {known.begin(), known.end()},
                                         "give the ball a name: ball NAME at=..."));
    return std::nullopt;
}

// "pressure(wall)". The ids of edges are their numbers.
std::optional<Quantity> SymbolTable::edges_quantity(const Word& word, QuantityKind kind) {
    const std::optional<Call> call = call_of(word);
    Quantity quantity{kind, {}, {}, {}, {}};
    std::vector<std::string_view> known;
    context_.work.spend(ir_.capsules.size());
    for (std::size_t i = 0; i < ir_.capsules.size(); ++i) {
        const std::string_view name =
            names_.edges[static_cast<std::size_t>(ir_.capsules[i].binding)].name;
        if (name.empty()) continue;
        if (call && name == call->inside.text)
            quantity.edges.push_back(CapsuleId{static_cast<std::uint32_t>(i)});
        if (known.empty() || known.back() != name) known.push_back(name);
    }
    context_.work.spend(cost_of_a_bin * quantity.edges.size());
    if (!quantity.edges.empty()) return quantity;
    if (call && is_error_name(call->inside.text)) return std::nullopt;
    const Word at = call ? call->inside : word;
    context_.reporter.error(
        "unknown-edges", at.span(),
        call ? fmt::format("there are no edges '{}'", at.text)
             : fmt::format("'{}' has no closing bracket", at.text),
        call ? did_you_mean(at.text, known, "give the edges a name: edge name=wall ...")
             : fmt::format("write {}(NAME), the name of edges", name(kind)));
    return std::nullopt;
}

std::optional<Quantity> SymbolTable::bins_quantity(const Word& word, std::size_t open) {
    const Word what = word.part(0, open);
    std::vector<std::string_view> kinds;
    std::optional<QuantityKind> found;
    for (const QuantityRow& row : quantities()) {
        const QuantityKind kind = &row;
        if (!is_of_bins(kind)) continue;
        kinds.push_back(name(kind));
        if (name(kind) == what.text) found = kind;
    }
    const std::optional<Call> call = call_of(word);
    if (!found || !call) {
        context_.reporter.error(
            "unknown-bins-quantity", what.span(), fmt::format("bins have no '{}'", what.text),
            did_you_mean(what.text, kinds,
                         fmt::format("they have {}, as in mean(bins)", joined(kinds, " "))));
        return std::nullopt;
    }
    const Bins* bins = bins_named(call->inside);
    if (!bins) return std::nullopt;
    context_.work.spend(cost_of_a_bin * bins->zones.size());
    Quantity quantity{*found, {}, {}, {}};
    for (std::uint32_t i = 0; i < bins->zones.size(); ++i) {
        quantity.counters.push_back(bins->first_counter + i);
    }
    context_.work.spend(shows_.size());
    for (const Show& show : shows_) {
        if (show.of == bins->name && !show.expected.empty()) quantity.expected = show.expected;
    }
    if (quantity.expected.empty()) {
        quantity.expected = binomial_shares(static_cast<int>(bins->zones.size()) - 1, 0.5);
    }
    return quantity;
}

std::optional<Expect> SymbolTable::make_expect(const ExpectIr& spec) {
    const auto what = quantity_of(spec.quantity);
    if (!what) return std::nullopt;
    if (name(what->kind) == "escaped" && std::ranges::none_of(ir_.chains, &ChainIr::is_closed))
        context_.reporter.warning("nothing-to-escape", spec.quantity.span(),
                                  "no edge is closed, so there is nothing to escape from",
                                  "close one, or draw a box; for balls removed: expect removed 0");
    Expect expect = spec.expect;
    expect.quantity = std::string(spec.quantity.text);
    expect.what = *what;
    expect.line = spec.quantity.line;
    return expect;
}

void SymbolTable::check_references() {
    collect_bins();
    for (const ShowIr& spec : ir_.shows) {
        context_.work.begin(spec.span);
        if (auto show = make_show(spec)) shows_.push_back(std::move(*show));
    }
    for (const ExpectIr& spec : ir_.expects) {
        context_.work.begin(spec.quantity.span());
        if (auto expect = make_expect(spec)) expects_.push_back(std::move(*expect));
    }
}

}  // namespace carom

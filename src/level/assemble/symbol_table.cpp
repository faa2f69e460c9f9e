#include "level/assemble/symbol_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "level/ir/numbers.h"
#include "level/text/brackets.h"
#include "level/text/spelling.h"

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

std::string_view bins_name(const EdgeBinding& binding) {
    return binding.plain.empty() ? binding.node->statement->name : binding.plain.front().text;
}

Group& group_named(std::vector<Group>& groups,
                   std::map<std::string, std::size_t, std::less<>>& index, std::string_view name) {
    const auto [found, is_new] = index.emplace(std::string(name), groups.size());
    if (is_new) groups.push_back({std::string(name), {}, {}, {}});
    return groups[found->second];
}

}  // namespace

void SymbolTable::name_balls(const std::vector<StartingBall>& balls) {
    std::map<std::string_view, std::pair<const Node*, std::uint32_t>> statements;
    ball_names_.assign(balls.size(), "");
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (balls[i].binding < 0) continue;
        const BallBinding& binding = ir_.ball_bindings[static_cast<std::size_t>(balls[i].binding)];
        if (!binding.name && !binding.is_numbered) continue;
        const std::string_view base =
            binding.name ? binding.name->text : binding.node->keyword().text;
        auto& [node, count] = statements[base];
        if (!node) node = binding.node;
        if (node != binding.node) {
            context_.reporter.error(
                "name-taken", binding.name ? binding.name->span() : binding.node->keyword().span(),
                fmt::format("the name '{}' is taken, in line {}", base, node->keyword().line),
                "give each ball a name of its own");
            continue;
        }
        ++count;
        const bool is_plain = count == 1 && !binding.is_numbered;
        ball_names_[i] = is_plain ? std::string(base) : fmt::format("{}.{}", base, count);
        if (binding.name && !is_identifier(base)) {
            context_.reporter.error("not-a-name", binding.name->span(),
                                    fmt::format("'{}' is not a name", base),
                                    "a name has letters, digits and '_', and begins with a letter");
        }
    }
    for (const ResolvedEdges& edges : names_.edges) {
        const auto taken = statements.find(edges.name);
        if (edges.name.empty() || taken == statements.end()) continue;
        context_.reporter.error("name-taken", edges.name_at,
                                fmt::format("the name '{}' is taken, in line {}", edges.name,
                                            taken->second.first->keyword().line),
                                "a ball has that name: choose another");
    }
}

void SymbolTable::collect_bins() {
    for (std::uint32_t i = 0; i < ir_.zones.size(); ++i) {
        const auto& binding = ir_.edge_bindings[static_cast<std::size_t>(ir_.zones[i].binding)];
        const std::string_view name = bins_name(binding);
        const auto [found, is_new] = bins_index_.emplace(std::string(name), bins_.size());
        if (is_new) bins_.push_back({std::string(name), {}, 0});
        bins_[found->second].zones.push_back(i);
    }
    std::uint32_t counter = 0;
    for (Bins& bins : bins_) {
        std::ranges::stable_sort(bins.zones, [&](std::uint32_t a, std::uint32_t b) {
            const Vec2 at_a = ir_.zones[a].zone.shape.start;
            const Vec2 at_b = ir_.zones[b].zone.shape.start;
            return std::pair(at_a.x, at_a.y) < std::pair(at_b.x, at_b.y);
        });
        bins.first_counter = counter;
        counter += static_cast<std::uint32_t>(bins.zones.size());
    }
}

bool SymbolTable::is_error_name(std::string_view name) const {
    return std::ranges::count(ir_.error_names, name) > 0;
}

const SymbolTable::Bins* SymbolTable::bins_named(const Word& name) {
    const auto found = bins_index_.find(name.text);
    if (found != bins_index_.end()) return &bins_[found->second];
    if (is_error_name(name.text) || (name.text == "bins" && context_.reporter.has_errors())) {
        return nullptr;
    }
    std::vector<std::string_view> known;
    for (const Bins& bins : bins_)
        known.emplace_back(bins.name);
    context_.reporter.error(
        "unknown-bins", name.span(), fmt::format("there are no bins '{}'", name.text),
        did_you_mean(name.text, known,
                     known.empty() ? "the level has no bins: add a line such as bins at=0,0 ..."
                                   : fmt::format("there are: {}", fmt::join(known, " "))));
    return nullptr;
}

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
                     fmt::format("there are {}, BALL.x and mean(BINS)", fmt::join(known, " "))));
    return std::nullopt;
}

// The number of the ball of this name. Sorts the names first: most levels of many balls never ask.
std::optional<std::uint32_t> SymbolTable::ball_named(std::string_view name) {
    const auto name_of = [&](std::uint32_t i) { return std::string_view(ball_names_[i]); };
    if (named_balls_.empty()) {
        for (std::uint32_t i = 0; i < ball_names_.size(); ++i)
            if (!ball_names_[i].empty()) named_balls_.push_back(i);
        std::ranges::sort(named_balls_, {}, name_of);
    }
    const auto found = std::ranges::lower_bound(named_balls_, name, {}, name_of);
    if (found == named_balls_.end() || name_of(*found) != name) return std::nullopt;
    return *found;
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
                                fmt::format("it has {}", fmt::join(kinds, " ")));
        return std::nullopt;
    }
    if (const auto number = ball_named(ball.text)) return Quantity{*found, BallId{*number}, {}, {}};
    if (is_error_name(ball.text)) return std::nullopt;
    std::vector<std::string_view> known;
    for (const std::uint32_t i : named_balls_)
        known.push_back(ball_names_[i]);
    context_.reporter.error(
        "unknown-ball", ball.span(), fmt::format("there is no ball '{}'", ball.text),
        did_you_mean(ball.text, known, "give the ball a name: ball NAME at=..."));
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
                         fmt::format("they have {}, as in mean(bins)", fmt::join(kinds, " "))));
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

void SymbolTable::fill_in(Scene& scene) {
    check_references();
    World& world = scene.world;
    scene.ball_names = ball_names_;
    std::map<std::string, std::size_t, std::less<>> index;
    for (std::size_t i = 0; i < ball_names_.size(); ++i) {
        if (ball_names_[i].empty()) continue;
        const std::string_view base =
            std::string_view(ball_names_[i]).substr(0, ball_names_[i].find('.'));
        group_named(scene.groups, index, base).balls.push_back(world.balls().id[i]);
    }
    for (std::size_t i = 0; i < ir_.capsules.size(); ++i) {
        const std::string& name =
            names_.edges[static_cast<std::size_t>(ir_.capsules[i].binding)].name;
        if (name.empty()) continue;
        group_named(scene.groups, index, name).capsules.push_back(world.capsules().id[i]);
    }
    std::uint32_t counter = 0;
    world_zones_.assign(ir_.zones.size(), 0);
    for (const Bins& bins : bins_) {
        for (std::uint32_t i = 0; i < bins.zones.size(); ++i) {
            world_zones_[bins.zones[i]] = static_cast<std::uint32_t>(world.zones().size());
            Zone zone = ir_.zones[bins.zones[i]].zone;
            zone.counter = counter++;
            world.edit_definition().zones.push_back(zone);
            scene.zone_names.push_back(fmt::format("{}.{}", bins.name, i + 1));
            scene.counter_names.push_back(scene.zone_names.back());
            group_named(scene.groups, index, bins.name).counters.push_back(zone.counter);
        }
    }
    world.edit_ledger().counters.assign(counter, 0);
    scene.shows = std::move(shows_);
    scene.expects = std::move(expects_);
    scene.observation = ir_.observation;
}

}  // namespace carom

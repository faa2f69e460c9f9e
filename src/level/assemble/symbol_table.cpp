#include "level/assemble/symbol_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "level/text/joined.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

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

void SymbolTable::name_balls(std::span<const int> bindings) {
    ball_names_.assign(bindings.size(), {});
    for (std::size_t i = 0; i < bindings.size(); ++i) {
        if (bindings[i] < 0) continue;
        const BallBinding& binding = ir_.ball_bindings[static_cast<std::size_t>(bindings[i])];
        if (!binding.name && !binding.is_numbered) continue;
        const std::string_view base =
            binding.name ? binding.name->text : binding.node->keyword().text;
        const auto [found, is_new] = ball_statement_index_.emplace(
            base, static_cast<std::uint32_t>(ball_statements_.size()));
        if (is_new) ball_statements_.push_back({base, binding.node, binding.is_numbered, 0});
        BallStatement& statement = ball_statements_[found->second];
        if (statement.node != binding.node) {
            const Span at = (binding.name ? *binding.name : binding.node->keyword()).span();
            const Word& holder = statement.node->keyword();
            context_.reporter.error("name-taken", at,
                                    taken_message(at, base, holder.text, holder.span()),
                                    "give each ball a name of its own");
            continue;
        }
        ball_names_[i] = {found->second, ++statement.count};
        if (binding.name && !is_identifier(base)) {
            context_.reporter.error("not-a-name", binding.name->span(),
                                    fmt::format("'{}' is not a name", base),
                                    "a name has letters, digits and '_', and begins with a letter");
        }
    }
    for (const ResolvedEdges& edges : names_.edges) {
        const auto taken = ball_statement_index_.find(edges.name);
        if (edges.name.empty() || taken == ball_statement_index_.end()) continue;
        const Word& holder = ball_statements_[taken->second].node->keyword();
        context_.reporter.error(
            "name-taken", edges.name_at,
            taken_message(edges.name_at, edges.name, holder.text, holder.span()),
            "balls have that name: choose another");
    }
}

std::string SymbolTable::name_of(const BallName& ball) const {
    if (ball.statement == none) return {};
    const BallStatement& statement = ball_statements_[ball.statement];
    const bool is_plain = ball.ordinal == 1 && !statement.is_numbered;
    return is_plain ? std::string(statement.name)
                    : fmt::format("{}.{}", statement.name, ball.ordinal);
}

std::vector<std::string> SymbolTable::names_of_statements() const {
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < ball_statements_.size(); ++i)
        names.push_back(name_of({i, 1}));
    std::ranges::sort(names);
    return names;
}

void SymbolTable::name_edges() {
    std::map<std::string_view, std::uint32_t> counts;
    const auto base_of = [&](const CapsuleIr& edge) -> std::string_view {
        return names_.edges[static_cast<std::size_t>(edge.binding)].name;
    };
    for (const CapsuleIr& edge : ir_.capsules)
        ++counts[base_of(edge)];
    std::map<std::string_view, std::uint32_t> seen;
    if (counts.size() > (counts.contains("") ? 1u : 0u))
        edge_names_.assign(ir_.capsules.size(), "");
    for (std::size_t i = 0; i < ir_.capsules.size(); ++i) {
        const std::string_view base = base_of(ir_.capsules[i]);
        if (base.empty()) continue;
        edge_names_[i] =
            counts[base] == 1 ? std::string(base) : fmt::format("{}.{}", base, ++seen[base]);
    }
}

std::optional<std::size_t> SymbolTable::edge_named(std::string_view name) {
    if (edge_index_.empty())
        for (std::size_t i = 0; i < edge_names_.size(); ++i)
            if (!edge_names_[i].empty()) edge_index_.emplace(edge_names_[i], i);
    const auto found = edge_index_.find(name);
    return found == edge_index_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> SymbolTable::body_names() const {
    std::vector<std::string> names = names_of_statements();
    for (const std::string& name : edge_names_)
        if (!name.empty()) names.push_back(name);
    return names;
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
                                   : fmt::format("there are: {}", joined(known, " "))));
    return nullptr;
}

// Sorts the names first: most levels of many balls never ask.
std::optional<std::uint32_t> SymbolTable::ball_named(std::string_view name) {
    const std::size_t dot = name.find('.');
    const auto statement = ball_statement_index_.find(name.substr(0, dot));
    if (statement == ball_statement_index_.end()) return std::nullopt;
    BallName wanted{statement->second, 1};
    if (dot != std::string_view::npos) {
        const std::string_view digits = name.substr(dot + 1);
        std::from_chars(digits.data(), digits.data() + digits.size(), wanted.ordinal);
    }
    // Other spellings of the number, and NAME.1 of NAME, are no names.
    if (name_of(wanted) != name) return std::nullopt;
    const auto of_ball = [&](std::uint32_t i) { return ball_names_[i]; };
    if (named_balls_.empty()) {
        for (std::uint32_t i = 0; i < ball_names_.size(); ++i)
            if (ball_names_[i].statement != none) named_balls_.push_back(i);
        std::ranges::sort(named_balls_, {}, of_ball);
    }
    const auto found = std::ranges::lower_bound(named_balls_, wanted, {}, of_ball);
    if (found == named_balls_.end() || of_ball(*found) != wanted) return std::nullopt;
    return *found;
}

void SymbolTable::fill_in(Scene& scene) {
    check_references();
    World& world = scene.world;
    scene.ball_names.clear();
    for (const BallName& name : ball_names_)
        scene.ball_names.push_back(name_of(name));
    std::map<std::string, std::size_t, std::less<>> index;
    for (std::size_t i = 0; i < ball_names_.size(); ++i) {
        if (ball_names_[i].statement == none) continue;
        const std::string_view base = ball_statements_[ball_names_[i].statement].name;
        group_named(scene.groups, index, base).balls.push_back(world.balls().id[i]);
    }
    scene.edge_numbers = edge_numbers_;
    scene.edge_names = edge_names_;
    if (!edge_names_.empty() && !edge_numbers_.empty()) {
        scene.edge_names.clear();
        for (const std::uint32_t edge : edge_numbers_)
            scene.edge_names.push_back(edge_names_[edge]);
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

#include "lab/run/rule_log.h"
#include "level/text/joined.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace carom {
namespace {

std::string message_of(const GameState& game) {
    if (const auto* shots = std::get_if<ShotsState>(&game)) return shots->message;
    if (const auto* pinball = std::get_if<PinballState>(&game)) return pinball->message;
    return {};
}

struct Number {
    std::string name;
    std::int64_t value = 0;
    std::optional<std::uint32_t> variable{};
};

// The variables first: they lead to what the game counts.
std::vector<Number> numbers_of(const Scene& scene, const GameState& game) {
    std::vector<Number> all;
    std::uint32_t variable = 0;
    for (const auto& [name, values] : variables(scene, game)) {
        for (std::size_t i = 0; i < values.size(); ++i)
            all.push_back(
                {values.size() > 1 ? fmt::format("{}{}", name, i + 1) : name, values[i], variable});
        ++variable;
    }
    for (auto& [name, count] : tallies(game))
        all.push_back({std::move(name), count});
    return all;
}

bool holds(std::int64_t value, RuleCondition::Relation relation, std::int64_t bound) {
    using enum RuleCondition::Relation;
    switch (relation) {
        case equal:
            return value == bound;
        case unequal:
            return value != bound;
        case less:
            return value < bound;
        case at_most:
            return value <= bound;
        case more:
            return value > bound;
        case at_least:
            break;
    }
    return value >= bound;
}

// Whether only rules of the event of `rule`, and at least one, change the variable: then a change
// says that the event has happened.
bool only_its_event_changes(const Rule& rule, std::uint32_t variable, const RuleBook& book) {
    bool is_changed = false;
    for (const Rule& other : book.rules)
        for (const RuleAction& action : other.actions) {
            if (action.what != RuleAction::What::set || action.index != variable) continue;
            is_changed = true;
            if (other.event != rule.event || other.subject != rule.subject ||
                other.other != rule.other)
                return false;
        }
    return is_changed;
}

bool sets(const Rule& rule, std::uint32_t variable) {
    return std::ranges::any_of(rule.actions, [&](const RuleAction& action) {
        return action.what == RuleAction::What::set && action.index == variable;
    });
}

// Whether a condition of the rule compares the variable with a number, and holds for the old value
// or the new one alone. A rule that ends its own condition means it.
bool saw_another(const Rule& rule, std::uint32_t variable, std::int64_t old, std::int64_t now) {
    for (const RuleClause& clause : rule.needs) {
        for (const RuleCondition& condition : clause.all) {
            const auto is = [](const RuleValue& value, RuleStep::What what) {
                return value.size() == 1 && value[0].what == what;
            };
            if (condition.what != RuleCondition::What::compare ||
                !is(condition.left, RuleStep::What::variable) ||
                !is(condition.right, RuleStep::What::number) ||
                condition.left[0].number != std::int64_t{variable})
                continue;
            const std::int64_t bound = condition.right[0].number;
            const bool held = holds(old, condition.relation, bound);
            if (held != holds(now, condition.relation, bound) && !(held && sets(rule, variable)))
                return true;
        }
    }
    return false;
}

// "; line 23 tested hits at 2": of rules that tested a variable before their event changed it. A
// variable that returns to its start is not one that an event has changed.
std::string tested_too_early(const RuleBook& book, std::string_view name, std::uint32_t variable,
                             std::int64_t old, std::int64_t now) {
    std::string text;
    if (now == book.variables[variable].start) return text;
    for (const Rule& rule : book.rules)
        if (saw_another(rule, variable, old, now) && only_its_event_changes(rule, variable, book))
            text += fmt::format("; line {} tested {} at {}", rule.line, name, old);
    return text;
}

}  // namespace

std::string RuleLog::line(const Scene& scene, const World& world, const GameState& game) {
    std::vector<std::string> changes;
    std::string tested;
    for (const auto& [name, number, variable] : numbers_of(scene, game)) {
        const auto [known, is_new] = numbers_.try_emplace(name, number);
        if (!is_new && known->second == number) continue;
        if (variable && !is_new)
            tested += tested_too_early(scene.rules, name, *variable, known->second, number);
        known->second = number;
        changes.push_back(fmt::format("{} {}", name, number));
    }
    std::string message = message_of(game);
    if (message != message_ && !message.empty()) changes.push_back(fmt::format("\"{}\"", message));
    message_ = std::move(message);
    if (!std::exchange(has_begun_, true) || changes.empty()) return {};
    return fmt::format("tick {}, {:.3f} s: {}{}\n", world.tick(),
                       static_cast<double>(world.tick()) / world.rate(), joined(changes, ", "),
                       tested);
}

}  // namespace carom

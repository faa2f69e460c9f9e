#include "level/assemble/futile_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "level/statements/rule_actions.h"

namespace carom {
namespace {

using Relation = RuleCondition::Relation;

// The whole numbers that a value may have, while conditions narrow them.
struct Range {
    std::int64_t least = -most_rule_number;
    std::int64_t most = most_rule_number;
    std::vector<std::int64_t> excluded{};

    void narrow(Relation relation, std::int64_t to) {
        using enum RuleCondition::Relation;
        if (relation == unequal) excluded.push_back(to);
        if (relation == equal || relation == at_least) least = std::max(least, to);
        if (relation == equal || relation == at_most) most = std::min(most, to);
        if (relation == more) least = std::max(least, to + 1);
        if (relation == less) most = std::min(most, to - 1);
    }

    bool is_empty() const {
        std::int64_t first = least;
        while (std::ranges::count(excluded, first) > 0)
            ++first;
        return first > most;
    }
};

Relation opposite(Relation relation) {
    using enum RuleCondition::Relation;
    switch (relation) {
        case equal:
            return unequal;
        case unequal:
            return equal;
        case less:
            return at_least;
        case at_most:
            return more;
        case more:
            return at_most;
        case at_least:
            break;
    }
    return less;
}

// `3<made` is `made>3`.
Relation swapped(Relation relation) {
    using enum RuleCondition::Relation;
    switch (relation) {
        case less:
            return more;
        case at_most:
            return at_least;
        case more:
            return less;
        case at_least:
            return at_most;
        default:
            return relation;
    }
}

bool is_number(const RuleValue& value) {
    return value.size() == 1 && value.front().what == RuleStep::What::number;
}

// A value that is no arithmetic, and the number that it is compared with.
struct Test {
    RuleStep step;
    Relation relation{};
    std::int64_t number = 0;
};

std::optional<Test> test_of(const RuleCondition& condition) {
    if (condition.what != RuleCondition::What::compare) return std::nullopt;
    const bool is_swapped = is_number(condition.left);
    const RuleValue& value = is_swapped ? condition.right : condition.left;
    const RuleValue& number = is_swapped ? condition.left : condition.right;
    if (value.size() != 1 || !is_number(number)) return std::nullopt;
    return Test{value.front(), is_swapped ? swapped(condition.relation) : condition.relation,
                number.front().number};
}

// The conditions that all hold where these clauses do, as far as they are single ones.
std::vector<Test> tests_of(const std::vector<RuleClause>& needs) {
    std::vector<Test> tests;
    for (const RuleClause& clause : needs) {
        if (clause.is_not && clause.all.size() > 1) continue;
        for (const RuleCondition& condition : clause.all) {
            auto test = test_of(condition);
            if (!test) continue;
            if (clause.is_not) test->relation = opposite(test->relation);
            tests.push_back(*test);
        }
    }
    return tests;
}

class FutileRules {
  public:
    FutileRules(const RuleBook& book, const RuleFacts& facts, Context& context)
        : book_(book), facts_(facts), context_(context), ir_(context.ir) {}

    void check_conditions() {
        for (std::size_t i = 0; i < book_.rules.size(); ++i)
            check_needs(book_.rules[i].needs, ir_.rules[i].needs);
        for (std::size_t i = 0; i < book_.tasks.size(); ++i)
            check_needs(book_.tasks[i].needs, ir_.tasks[i].text);
        for (std::size_t i = 0; i < book_.goals.size(); ++i)
            check_needs(book_.goals[i].needs, ir_.goals[i].text);
    }

    // Of tasks, the first whose conditions hold is shown: one without conditions is the last.
    void check_tasks() {
        const auto always = std::ranges::find_if(
            book_.tasks, [](const RuleTask& task) { return task.needs.empty(); });
        const auto last = static_cast<std::size_t>(always - book_.tasks.begin());
        for (std::size_t i = last + 1; i < book_.tasks.size(); ++i)
            warn("task-never-shown", ir_.tasks[i].text,
                 fmt::format("the task in line {} has no condition, so it hides this one",
                             ir_.tasks[last].text.line),
                 "put the task without a condition last");
    }

    // A variable that is read, is 0 at the start, and stays so. One with a start value is a number
    // of the level.
    void check_variables() {
        for (const auto& [name, symbol] : ir_.rule_symbols) {
            if (symbol.is_timer || !symbol.is_read) continue;
            if (book_.variables[symbol.index].start != 0 || is_set(symbol.index)) continue;
            warn("variable-unset", symbol.name,
                 fmt::format("nothing sets the variable '{}', so it is always 0", name),
                 fmt::format("add an action: {} +1", name));
        }
    }

    void check_endings() {
        for (std::size_t i = 0; i < book_.rules.size(); ++i) {
            std::optional<std::size_t> first;
            for (std::size_t k = 0; k < book_.rules[i].actions.size(); ++k) {
                if (!ends_game(book_.rules[i].actions[k])) continue;
                if (first) warn_of_ending(ir_.rules[i].actions[k], ir_.rules[i].actions[*first]);
                first = k;
            }
            if (first) compare_ending(i, *first);
        }
    }

  private:
    void warn(FaultCode code, const Word& at, std::string message, std::string remedy) {
        context_.reporter.warning(code, at.span(), std::move(message), std::move(remedy));
    }

    Range range_of(const RuleStep& step) const {
        using enum RuleStep::What;
        if (step.what == seconds || step.what == lit) return {0};
        if (step.what != count) return {};
        const bool is_taken =
            step.place >= 0 && facts_.takes_balls[static_cast<std::size_t>(step.place)];
        return {0, is_taken ? 0 : facts_.balls[static_cast<std::size_t>(step.number)]};
    }

    void check_needs(const std::vector<RuleClause>& needs, const Word& at) {
        using Key = std::tuple<RuleStep::What, std::int64_t, std::int32_t>;
        std::map<Key, Range> ranges;
        for (const auto& [step, relation, number] : tests_of(needs)) {
            const Key key{step.what, step.number, step.place};
            Range& range = ranges.try_emplace(key, range_of(step)).first->second;
            Range alone = range_of(step);
            alone.narrow(relation, number);
            range.narrow(relation, number);
            if (alone.is_empty()) return warn_of_count(step, at);
            if (!range.is_empty()) continue;
            return warn("condition-never-holds", at, "these conditions never hold together",
                        "two of them exclude each other: for 'or', write two lines");
        }
    }

    void warn_of_count(const RuleStep& step, const Word& at) {
        if (step.place >= 0 && facts_.takes_balls[static_cast<std::size_t>(step.place)])
            return warn("condition-never-holds", at,
                        "this never holds: balls that a pocket or a sink takes are not counted",
                        "count them with a variable: on BALLS pocketed  NAME +1");
        warn("condition-never-holds", at,
             step.what == RuleStep::What::count
                 ? fmt::format("this never holds: such a count is 0 to {}", range_of(step).most)
                 : std::string("this never holds: such a number is 0 or more"),
             "compare with a number that it can have");
    }

    bool is_set(std::uint32_t variable) const {
        return std::ranges::any_of(book_.rules, [&](const Rule& rule) {
            return std::ranges::any_of(rule.actions, [&](const RuleAction& action) {
                return action.what == RuleAction::What::set && action.index == variable;
            });
        });
    }

    static bool ends_game(const RuleAction& action) {
        using enum RuleAction::What;
        return action.what == win || action.what == lose || action.what == end;
    }

    static bool is_same_event(const Rule& a, const Rule& b) {
        return a.event == b.event && a.subject == b.subject && a.other == b.other &&
               a.once == b.once;
    }

    void warn_of_ending(const Word& at, const Word& other) {
        warn("game-ends-twice", at,
             fmt::format("the game also ends with '{}' in line {}", other.text, other.line),
             "keep one: of several, lose counts before win, and end before both");
    }

    // Whether an earlier rule ends the game otherwise whenever this one does.
    void compare_ending(std::size_t rule, std::size_t action) {
        const Rule& ours = book_.rules[rule];
        for (std::size_t i = 0; i < rule; ++i) {
            const Rule& other = book_.rules[i];
            if (!is_same_event(ours, other) || ours.needs != other.needs) continue;
            for (std::size_t k = 0; k < other.actions.size(); ++k)
                if (ends_game(other.actions[k]) &&
                    other.actions[k].what != ours.actions[action].what)
                    warn_of_ending(ir_.rules[rule].actions[action], ir_.rules[i].actions[k]);
        }
    }

    const RuleBook& book_;
    const RuleFacts& facts_;
    Context& context_;
    const LevelIr& ir_;
};

}  // namespace

void warn_of_futile_rules(const RuleBook& book, const RuleFacts& facts, Context& context) {
    FutileRules rules(book, facts, context);
    rules.check_conditions();
    rules.check_tasks();
    rules.check_variables();
    rules.check_endings();
}

}  // namespace carom

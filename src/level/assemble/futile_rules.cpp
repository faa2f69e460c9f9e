#include "level/assemble/futile_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "level/assemble/rule_tests.h"

namespace carom {
namespace {

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
            if (!first) continue;
            compare_ending(i, *first);
            compare_bounds(i, *first);
        }
    }

  private:
    void warn(FaultCode code, const Word& at, std::string message, std::string remedy) {
        context_.reporter.warning(code, at.span(), std::move(message), std::move(remedy));
    }

    RuleRange range_of(const RuleStep& step) const {
        using enum RuleStep::What;
        if (step.what == seconds || step.what == lit) return {0};
        if (step.what == variable)
            return range_of_variable(static_cast<std::uint32_t>(step.number));
        if (step.what != count) return {};
        const bool is_taken =
            step.place >= 0 && facts_.takes_balls[static_cast<std::size_t>(step.place)];
        return {0, is_taken ? 0 : facts_.balls[static_cast<std::size_t>(step.number)]};
    }

    // What one number may be, as far as it is plain: counts and times are 0 or more, a variable may
    // be anything.
    static RuleRange plain_range(const RuleValue& value) {
        if (value.size() != 1) return {};
        const RuleStep& step = value.front();
        if (step.what == RuleStep::What::number) return {step.number, step.number};
        const bool is_any =
            step.what == RuleStep::What::variable || step.what == RuleStep::What::quantity;
        return is_any ? RuleRange{} : RuleRange{0};
    }

    // From its start and all that rules add to it, or set it to. One that no rule changes is a
    // number of the level, which its conditions may know.
    RuleRange range_of_variable(std::uint32_t variable) const {
        if (!is_set(variable)) return {};
        const std::int64_t start = book_.variables[variable].start;
        RuleRange range{start, start};
        for (const Rule& rule : book_.rules)
            for (const RuleAction& action : rule.actions) {
                if (action.what != RuleAction::What::set || action.index != variable) continue;
                const RuleRange given = plain_range(action.value);
                if (!action.adds) range.least = std::min(range.least, given.least);
                if (!action.adds) range.most = std::max(range.most, given.most);
                if (action.adds && given.least < 0) range.least = -most_rule_number;
                if (action.adds && given.most > 0) range.most = most_rule_number;
            }
        return range;
    }

    void check_needs(const std::vector<RuleClause>& needs, const Word& at) {
        using Key = std::tuple<RuleStep::What, std::int64_t, std::int32_t>;
        std::map<Key, RuleRange> ranges;
        for (const auto& [step, relation, number] : tests_of(needs)) {
            const Key key{step.what, step.number, step.place};
            RuleRange& range = ranges.try_emplace(key, range_of(step)).first->second;
            RuleRange alone = range_of(step);
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
        const RuleRange range = range_of(step);
        const std::string what =
            step.what == RuleStep::What::count ? std::string("such a count")
            : step.what == RuleStep::What::variable
                ? fmt::format("'{}'", book_.variables[static_cast<std::size_t>(step.number)].name)
                : std::string("such a number");
        const std::string values =
            range.most == most_rule_number     ? fmt::format("{} or more", range.least)
            : range.least == -most_rule_number ? fmt::format("{} or less", range.most)
                                               : fmt::format("{} to {}", range.least, range.most);
        warn("condition-never-holds", at, fmt::format("this never holds: {} is {}", what, values),
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

    // Whether another rule of the same event ends the game otherwise, at a bound of the same number
    // that comes well before this one's: win at 10, lose at 20. Bounds side by side are meant, as
    // in win at 21, lose at 22.
    void compare_bounds(std::size_t rule, std::size_t action) {
        const Rule& ours = book_.rules[rule];
        const auto far = tests_of(ours.needs);
        if (far.size() != 1) return;
        for (std::size_t i = 0; i < book_.rules.size(); ++i) {
            const Rule& other = book_.rules[i];
            const auto near = tests_of(other.needs);
            const bool is_alone = i != rule && near.size() == 1 && other.needs.size() == 1 &&
                                  other.needs[0].all.size() == 1;
            if (!is_alone || !is_same_event(ours, other) || near[0].step != far[0].step) continue;
            RuleRange before;
            RuleRange behind;
            before.narrow(near[0].relation, near[0].number);
            behind.narrow(far[0].relation, far[0].number);
            const bool is_up = before.most == most_rule_number && behind.least > before.least + 1;
            if (!is_up || before.least == -most_rule_number) continue;
            for (std::size_t k = 0; k < other.actions.size(); ++k)
                if (ends_game(other.actions[k]) &&
                    other.actions[k].what != ours.actions[action].what)
                    warn("game-ends-before", ir_.rules[rule].actions[action],
                         fmt::format("'{}' in line {} comes first, unless the number leaps past it",
                                     ir_.rules[i].actions[k].text, ir_.rules[i].actions[k].line),
                         "take it out, or give the other rule a condition more");
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

#include <fmt/format.h>

#include "level/ir/numbers.h"
#include "level/statements/rule_words.h"
#include "level/statements/rules.h"

// The goal of a level, with its stars.
namespace carom {
namespace {

// `within 1 2 3 shots`, or `with 5 4 3 of VALUE`, from words[next] on. A word that is not expected;
// none: there are no limits, or they are read, or an error is reported.
std::optional<Word> read_limits(const std::vector<Word>& words, std::size_t& next, LevelGoal& goal,
                                RuleWords& reader, const Frame& frame, Context& context) {
    const std::string_view lead = next < words.size() ? words[next].text : std::string_view{};
    if (lead != "within" && lead != "with") return std::nullopt;
    const bool is_least = lead == "with";
    const auto is_end = [&](std::string_view word) {
        return is_least ? word == "of" : word == "shots" || word == "seconds";
    };
    for (++next; next < words.size() && !is_end(words[next].text); ++next) {
        const auto limit =
            read_number(words[next], {lead, " "}, Measure::whole,
                        is_least ? Bound::any : Bound::positive, *frame.scope, context);
        if (!limit) return std::nullopt;
        std::vector<double>& limits = goal.limits;
        const bool is_in_order =
            limits.empty() || (is_least ? *limit < limits.back() : *limit > limits.back());
        if (limits.size() == 3 || !is_in_order) return words[next];
        limits.push_back(*limit);
    }
    if (next == words.size() || goal.limits.empty()) return words[next - 1];
    if (is_least && next + 1 == words.size()) return words[next];
    using enum LevelGoal::Counts;
    goal.counts = is_least ? value : words[next].text == "seconds" ? seconds : shots;
    ++next;
    if (!is_least) return std::nullopt;
    if (auto counted = reader.value(words[next++], "", Bound::any))
        goal.value = std::move(*counted);
    return std::nullopt;
}

}  // namespace

void add_goal(const Arguments& arguments, const Frame& frame, Context& context) {
    const std::vector<Word>& words = arguments.plain;
    GoalIr goal;
    RuleWords reader(*frame.scope, context, goal.names);
    const std::size_t errors = context.reporter.errors();
    goal.text = words[0];
    const auto refuse = [&](const Word& at) {
        context.reporter.error("goal-malformed", at.span(),
                               fmt::format("'{}' is not expected here", at.text),
                               fmt::format("write it as: {}", arguments.statement->usage));
    };
    if (words[0].text.size() < 2 || words[0].text.front() != '"') return refuse(words[0]);
    goal.goal.text = std::string(words[0].text.substr(1, words[0].text.size() - 2));
    std::size_t next = 1;
    if (const auto at = read_limits(words, next, goal.goal, reader, frame, context))
        return refuse(*at);
    if (context.reporter.errors() > errors) return;
    auto needs = reader.clauses(words, next);
    if (!needs) return;
    if (next < words.size() || needs->empty()) return refuse(words.back());
    goal.goal.needs = std::move(*needs);
    context.ir.goals.push_back(std::move(goal));
}

}  // namespace carom

#include "level/assemble/idle_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace carom {
namespace {

class IdleWords {
  public:
    IdleWords(const RuleBook& book, const RuleFacts& facts, Context& context)
        : book_(book), facts_(facts), context_(context), ir_(context.ir) {}

    void check() {
        for (std::size_t i = 0; i < book_.rules.size(); ++i) {
            check_once(book_.rules[i], ir_.rules[i].event);
            check_needs(book_.rules[i].needs, ir_.rules[i].needs);
            for (std::size_t k = 0; k < book_.rules[i].actions.size(); ++k)
                check_action(book_.rules[i].actions[k], ir_.rules[i].actions[k]);
        }
        for (std::size_t i = 0; i < book_.tasks.size(); ++i) {
            check_needs(book_.tasks[i].needs, ir_.tasks[i].text);
            check_text(book_.tasks[i].text, ir_.tasks[i].text);
        }
        for (std::size_t i = 0; i < book_.goals.size(); ++i) {
            check_needs(book_.goals[i].needs, ir_.goals[i].text);
            check_value(book_.goals[i].value, ir_.goals[i].text);
        }
    }

  private:
    void warn(FaultCode code, const Word& at, std::string message, std::string remedy) {
        context_.reporter.warning(code, at.span(), std::move(message), std::move(remedy));
    }

    void check_once(const Rule& rule, const Word& at) {
        using enum RuleEvent;
        constexpr std::array meetings{balls_meet, rail, edge_hit, place_entered};
        if (!rule.once || std::ranges::count(meetings, rule.event) > 0) return;
        warn("once-without-meeting", at, fmt::format("'once' does nothing behind '{}'", at.text),
             "it is for hit, rail and enter: leave it out, or test a variable of shot");
    }

    // A pocket or a sink takes every ball that comes to it, so none is placed or lies there.
    void check_action(const RuleAction& action, const Word& at) {
        check_value(action.value, at);
        check_text(action.text, at);
        using enum RuleAction::What;
        const bool needs_zone =
            action.what == inhand || action.what == respot || action.what == remove;
        if (!needs_zone || action.place < 0) return;
        const auto place = static_cast<std::size_t>(action.place);
        if (!facts_.takes_balls[place]) return;
        warn("place-takes-balls", at,
             action.what == remove ? "no ball ever lies in a pocket or a sink, which takes it"
                                   : "a pocket or a sink takes the ball that is placed in it",
             fmt::format("name a zone without sink: {} {}ZONE", at.text,
                         action.what == inhand   ? ""
                         : action.what == remove ? "BALLS inside "
                                                 : "BALLS "));
    }

    void check_needs(const std::vector<RuleClause>& needs, const Word& at) {
        for (const RuleClause& clause : needs)
            for (const RuleCondition& condition : clause.all) {
                check_value(condition.left, at);
                check_value(condition.right, at);
            }
    }

    void check_text(const RuleText& text, const Word& at) {
        for (const auto& piece : text.pieces) {
            if (const auto* value = std::get_if<RuleValue>(&piece)) check_value(*value, at);
            if (const auto* counted = std::get_if<RuleText::Counted>(&piece))
                check_value(counted->value, at);
        }
    }

    void check_value(const RuleValue& value, const Word& at) {
        const RuleGames other = book_.is_shots ? RuleGames::pinball : RuleGames::shots;
        for (const RuleStep& step : value) {
            if (step.what != RuleStep::What::quantity) continue;
            const RuleQuantityRow& row = rule_quantities()[static_cast<std::size_t>(step.number)];
            if (row.games != other) continue;
            warn("number-of-other-game", at,
                 fmt::format("'{}' is a number of game {}, so here it is always 0", row.name,
                             book_.is_shots ? "pinball" : "shots"),
                 "count with a variable: var NAME");
        }
    }

    const RuleBook& book_;
    const RuleFacts& facts_;
    Context& context_;
    const LevelIr& ir_;
};

}  // namespace

void warn_of_idle_words(const RuleBook& book, const RuleFacts& facts, Context& context) {
    IdleWords(book, facts, context).check();
}

}  // namespace carom

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "game/digest.h"
#include "game/rules/rule_state.h"
#include "level/scene/rules.h"

/// The interpreter of the rules of a level (level/scene/rules.h has the language and its order of
/// evaluation). It knows variables, timers, conditions and texts. What a number of the game is, and
/// what an action does to the game, the game answers through RuleHost.
///
/// Cost: an event looks up its own rules, by a search over the events that have any; a tick without
/// events costs a comparison for each timer.
namespace carom {

/// A game that is played by rules.
class RuleHost {
  public:
    virtual ~RuleHost() = default;

    virtual std::uint64_t now() const = 0;  ///< ticks
    virtual double rate() const = 0;        ///< ticks a second
    /// A number that the game keeps. Quantities that it does not know are 0.
    virtual std::int64_t quantity(RuleQuantity what) const = 0;
    /// How many of these balls are in play; with a place, how many of them lie in it.
    virtual std::int64_t count(const RuleBalls& balls, const RulePlace* place) const = 0;
    /// How many devices of a group there are, and how many of them are lit.
    virtual std::pair<std::int64_t, std::int64_t> lights(std::uint32_t group) const = 0;
    /// Whether the mover with this index runs.
    virtual bool moves(std::uint32_t mover) const = 0;
    /// Carries out an action that is not about variables and timers. `value` is that of its
    /// RuleAction::value. `depth` grows with each event that an action causes in turn.
    virtual void act(const RuleAction& action, std::int64_t value, int depth) = 0;

    /// The ball that the event named last, for a rule that says `it`; none: no such event.
    std::optional<std::uint32_t> it;
};

/// The rules of a level in a game, while they process events.
struct Rules {
    const RuleBook& book;
    RuleState& state;
    RuleHost& host;
};

/// All variables at their start.
RuleState begin_rules(const RuleBook& book);
/// Sets the variables of this scope to their start; those of a player for the player whose turn it
/// is. For RuleScope::turn and shot.
void begin_scope(const RuleBook& book, RuleState& state, RuleScope scope);

/// The values of variable number `variable`: of each player in turn, or one.
std::span<const std::int64_t> values_of(const RuleBook& book, const RuleState& state,
                                        std::size_t variable);

/// An event of a device, of a timer, or without a subject: carries out the rules that wait for it.
/// Events that actions cause go no deeper than 8.
void happen(Rules rules, RuleEvent event, std::uint32_t subject = no_subject, int depth = 0);

/// An event of balls: `is_met` says whether it is one that the rule waits for, and sets
/// RuleHost::it.
template <typename IsMet>
void happen_if(Rules rules, RuleEvent event, IsMet&& is_met);

/// Carries out all rules whose timers have run out.
void end_timers(Rules rules);

std::int64_t value_of(const RuleBook& book, const RuleState& state, const RuleHost& host,
                      const RuleValue& value);
bool hold(const RuleBook& book, const RuleState& state, const RuleHost& host,
          const std::vector<RuleClause>& needs);
/// Formats 1234567 as 1,234,567, as texts of rules do.
std::string grouped(std::int64_t number);
std::string text_of(const RuleBook& book, const RuleState& state, const RuleHost& host,
                    const RuleText& text);
/// The first task whose conditions hold; null: there is none.
const RuleTask* task_of(const RuleBook& book, const RuleState& state, const RuleHost& host);
/// Its text; empty: there is none.
std::string task_text(const RuleBook& book, const RuleState& state, const RuleHost& host);

/// Whole seconds until the timer ends, rounded up; 0: it does not run.
std::int64_t seconds_left(const RuleState& state, const RuleHost& host, std::uint32_t timer);

/// Adds the state to a fingerprint; nothing where the level has no variables, timers or players, so
/// that older recordings keep their marks.
void add_to(Digest& digest, const RuleState& state);
std::size_t bytes_of(const RuleState& state);

/// `a + b`, within most_rule_number either way.
std::int64_t saturating_sum(std::int64_t a, std::int64_t b);

namespace detail {
/// A rule whose conditions have been tested, and the ball that it calls `it`.
struct Due {
    const Rule* rule = nullptr;
    std::optional<std::uint32_t> it;
};
void carry_out(Rules rules, const std::vector<Due>& due, int depth);
}  // namespace detail

template <typename IsMet>
void happen_if(Rules rules, RuleEvent event, IsMet&& is_met) {
    const RuleBook::Row* const row = rules_of(rules.book, event, no_subject);
    if (!row) return;
    std::vector<detail::Due> due;
    for (std::uint32_t i = row->first; i < row->last; ++i) {
        const Rule& rule = rules.book.rules[rules.book.order[i]];
        if (is_met(rule) && hold(rules.book, rules.state, rules.host, rule.needs))
            due.push_back({&rule, rules.host.it});
    }
    detail::carry_out(rules, due, 0);
}

}  // namespace carom

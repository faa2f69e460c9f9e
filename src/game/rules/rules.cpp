#include "game/rules/rules.h"

#include <algorithm>
#include <array>

namespace carom {
namespace {

constexpr int deepest = 8;

std::int64_t clamped(std::int64_t number) {
    return std::clamp(number, -most_rule_number, most_rule_number);
}

std::int64_t product(std::int64_t a, std::int64_t b) {
    if (a == 0 || b == 0) return 0;
    const auto size = [](std::int64_t n) { return n < 0 ? -n : n; };
    if (size(a) > most_rule_number / size(b))
        return (a < 0) == (b < 0) ? most_rule_number : -most_rule_number;
    return a * b;
}

std::size_t slots_of(const RuleBook& book, std::size_t variable) {
    return book.variables[variable].scope == RuleScope::player ? book.players : 1;
}

// The place of a variable's first value in RuleState::values.
std::size_t first_slot_of(const RuleBook& book, std::size_t variable) {
    std::size_t slot = 0;
    for (std::size_t i = 0; i < variable; ++i)
        slot += slots_of(book, i);
    return slot;
}

// The place of a variable's value, for the player whose turn it is.
std::size_t slot_of(const RuleBook& book, const RuleState& state, std::size_t variable) {
    return first_slot_of(book, variable) + (slots_of(book, variable) > 1 ? state.player : 0);
}

std::int64_t operand(const RuleBook& book, const RuleState& state, const RuleHost& host,
                     const RuleStep& step) {
    const auto index = static_cast<std::uint32_t>(step.number);
    switch (step.what) {
        case RuleStep::What::variable:
            return state.values[slot_of(book, state, index)];
        case RuleStep::What::quantity:
            return clamped(host.quantity(static_cast<RuleQuantity>(step.number)));
        case RuleStep::What::count:
            return host.count(
                book.balls[index],
                step.place < 0 ? nullptr : &book.places[static_cast<std::size_t>(step.place)]);
        case RuleStep::What::lit:
            return host.lights(index).second;
        case RuleStep::What::seconds:
            return seconds_left(state, host, index);
        default:
            return step.number;
    }
}

std::int64_t combined(RuleStep::What what, std::int64_t a, std::int64_t b) {
    switch (what) {
        case RuleStep::What::add:
            return saturating_sum(a, b);
        case RuleStep::What::subtract:
            return saturating_sum(a, -b);
        case RuleStep::What::multiply:
            return product(a, b);
        case RuleStep::What::min:
            return std::min(a, b);
        default:
            return std::max(a, b);
    }
}

bool holds(const RuleBook& book, const RuleState& state, const RuleHost& host,
           const RuleCondition& condition) {
    using Relation = RuleCondition::Relation;
    if (condition.what == RuleCondition::What::running)
        return state.timer_ends[condition.index] > 0;
    if (condition.what == RuleCondition::What::moving) return host.moves(condition.index);
    if (condition.what == RuleCondition::What::lit) {
        const auto [all, lit] = host.lights(condition.index);
        return all > 0 && lit == all;
    }
    const std::int64_t a = value_of(book, state, host, condition.left);
    const std::int64_t b = value_of(book, state, host, condition.right);
    switch (condition.relation) {
        case Relation::equal:
            return a == b;
        case Relation::unequal:
            return a != b;
        case Relation::less:
            return a < b;
        case Relation::at_most:
            return a <= b;
        case Relation::more:
            return a > b;
        case Relation::at_least:
            break;
    }
    return a >= b;
}

// Whether the tick may carry out one more action; counts it.
bool may_act(Rules rules) {
    RuleState& state = rules.state;
    if (state.tick != rules.host.now()) {
        state.tick = rules.host.now();
        state.actions = 0;
    }
    if (state.actions < most_actions_in_a_tick) {
        ++state.actions;
        return true;
    }
    if (state.left_out++ == 0) state.first_left_out = state.tick;
    return false;
}

void act(Rules rules, const RuleAction& action, int depth) {
    RuleState& state = rules.state;
    const std::int64_t value =
        action.value.empty() ? 0 : value_of(rules.book, state, rules.host, action.value);
    switch (action.what) {
        case RuleAction::What::set: {
            std::int64_t& variable = state.values[slot_of(rules.book, state, action.index)];
            variable = action.adds ? saturating_sum(variable, value) : value;
            break;
        }
        case RuleAction::What::start: {
            const double ticks = action.seconds * rules.host.rate() + 0.5;
            state.timer_ends[action.index] =
                rules.host.now() + (ticks < 1.0 ? 1 : static_cast<std::uint64_t>(ticks));
            break;
        }
        case RuleAction::What::stop:
            state.timer_ends[action.index] = 0;
            break;
        default:
            rules.host.act(action, value, depth);
            break;
    }
}

}  // namespace

std::int64_t saturating_sum(std::int64_t a, std::int64_t b) {
    return clamped(a + b);  // neither is beyond most_rule_number, so this does not overflow
}

RuleState begin_rules(const RuleBook& book) {
    RuleState state;
    for (const RuleVariable& variable : book.variables)
        state.values.insert(state.values.end(),
                            variable.scope == RuleScope::player ? book.players : 1, variable.start);
    state.timer_ends.assign(book.timers.size(), 0);
    return state;
}

std::span<const std::int64_t> values_of(const RuleBook& book, const RuleState& state,
                                        std::size_t variable) {
    return std::span(state.values).subspan(first_slot_of(book, variable), slots_of(book, variable));
}

void begin_scope(const RuleBook& book, RuleState& state, RuleScope scope) {
    for (std::size_t i = 0; i < book.variables.size(); ++i)
        if (book.variables[i].scope == scope)
            state.values[slot_of(book, state, i)] = book.variables[i].start;
}

std::int64_t value_of(const RuleBook& book, const RuleState& state, const RuleHost& host,
                      const RuleValue& value) {
    std::array<std::int64_t, most_rule_steps> stack{};
    std::size_t size = 0;
    for (const RuleStep& step : value) {
        if (step.what < RuleStep::What::add) {
            stack[size++] = operand(book, state, host, step);
            continue;
        }
        --size;
        stack[size - 1] = combined(step.what, stack[size - 1], stack[size]);
    }
    return size == 0 ? 0 : stack[0];
}

bool hold(const RuleBook& book, const RuleState& state, const RuleHost& host,
          const std::vector<RuleClause>& needs) {
    return std::ranges::all_of(needs, [&](const RuleClause& clause) {
        const bool are_all = std::ranges::all_of(clause.all, [&](const RuleCondition& condition) {
            return holds(book, state, host, condition);
        });
        return are_all != clause.is_not;
    });
}

void happen(Rules rules, RuleEvent event, std::uint32_t subject, int depth) {
    if (depth > deepest) return;  // rules that light each other in a cycle
    const RuleBook::Row* const row = rules_of(rules.book, event, subject);
    if (!row) return;
    std::vector<detail::Due> due;
    for (std::uint32_t i = row->first; i < row->last; ++i) {
        const Rule& rule = rules.book.rules[rules.book.order[i]];
        if (hold(rules.book, rules.state, rules.host, rule.needs)) due.push_back({&rule, {}});
    }
    detail::carry_out(rules, due, depth);
}

void detail::carry_out(Rules rules, const std::vector<Due>& due, int depth) {
    for (const auto& [rule, it] : due)
        for (const RuleAction& action : rule->actions) {
            rules.host.it = it;
            if (may_act(rules)) act(rules, action, depth);
        }
    rules.host.it.reset();
}

void end_timers(Rules rules) {
    for (std::uint32_t i = 0; i < rules.state.timer_ends.size(); ++i) {
        const std::uint64_t end = rules.state.timer_ends[i];
        if (end == 0 || rules.host.now() < end) continue;
        rules.state.timer_ends[i] = 0;
        happen(rules, RuleEvent::timer_ends, i);
    }
}

std::int64_t seconds_left(const RuleState& state, const RuleHost& host, std::uint32_t timer) {
    const std::uint64_t end = state.timer_ends[timer];
    if (end <= host.now()) return 0;
    const double seconds = static_cast<double>(end - host.now()) / host.rate();
    const auto whole = static_cast<std::int64_t>(seconds);
    return static_cast<double>(whole) < seconds ? whole + 1 : whole;
}

void add_to(Digest& digest, const RuleState& state) {
    for (const std::int64_t value : state.values)
        digest.add(static_cast<std::uint64_t>(value));
    for (const std::uint64_t end : state.timer_ends)
        digest.add(end);
    if (state.player > 0) digest.add(std::uint64_t{state.player});
    if (state.left_out > 0) digest.add(state.left_out);
}

std::size_t bytes_of(const RuleState& state) {
    return state.values.capacity() * sizeof(std::int64_t) +
           state.timer_ends.capacity() * sizeof(std::uint64_t);
}

}  // namespace carom

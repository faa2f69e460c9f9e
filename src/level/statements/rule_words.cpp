#include "level/statements/rule_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "level/ir/numbers.h"
#include "level/statements/rule_actions.h"
#include "level/statements/rule_events.h"
#include "level/statements/rule_habits.h"
#include "level/text/joined.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

bool is_digit(char c) {
    return (c >= '0' && c <= '9') || c == '.';
}

}  // namespace

std::optional<RuleQuantity> rule_quantity_named(std::string_view name) {
    const auto rows = rule_quantities();
    const auto* const found = row_named(rows, name);
    if (!found) return std::nullopt;
    return static_cast<RuleQuantity>(found - rows.data());
}

// A position in a word that is being parsed.
struct RuleWords::Cursor {
    const Word& word;
    std::size_t at = 0;
    int depth = 0;

    bool is_at_end() const { return at >= word.text.size(); }
    char next() const { return is_at_end() ? '\0' : word.text[at]; }
    bool take(char c) {
        if (next() != c) return false;
        ++at;
        return true;
    }
    Word rest() const { return is_at_end() ? word : word.part(at); }
    Word identifier() {
        const std::size_t from = at;
        while (!is_at_end() && continues_identifier(next()))
            ++at;
        return word.part(from, at - from);
    }
};

std::uint32_t RuleWords::name(const Word& word, RuleNameIr::Role role) {
    names_.push_back({word, role});
    return static_cast<std::uint32_t>(names_.size() - 1);
}

const RuleSymbolIr* RuleWords::read_symbol(std::string_view name) {
    const auto found = context_.ir.rule_symbols.find(name);
    if (found == context_.ir.rule_symbols.end()) return nullptr;
    found->second.is_read = true;
    return &found->second;
}

// Whether a value needs the rules to be known: without, it is a number like any other of a level.
bool RuleWords::mentions_rules(std::string_view text) const {
    for (std::size_t at = 0; at < text.size();) {
        if (!starts_identifier(text[at])) {
            ++at;
            continue;
        }
        std::size_t end = at;
        while (end < text.size() && continues_identifier(text[end]))
            ++end;
        const std::string_view name = text.substr(at, end - at);
        const bool is_call = end < text.size() && text[end] == '(';
        if (context_.ir.rule_symbols.contains(name) || rule_quantity_named(name) ||
            (is_call && (name == "count" || name == "lit")))
            return true;
        at = end;
    }
    return false;
}

std::nullopt_t RuleWords::malformed(const Word& at) {
    RuleAdvice advice = advice_on_value(at.text);
    context_.reporter.error("rule-value-malformed", at.span(), std::move(advice.message),
                            std::move(advice.remedy));
    return std::nullopt;
}

// Whether a line above names balls, or a kind of them, so. Of many lines, only the first are asked.
bool RuleWords::is_ball_above(std::string_view name) const {
    const auto is_named = [&](const BallBinding& ball) {
        return ball.name && ball.name->text == name;
    };
    const auto& balls = context_.ir.ball_bindings;
    const auto last =
        balls.begin() + static_cast<std::ptrdiff_t>(std::min(balls.size(), max_candidates));
    return std::any_of(balls.begin(), last, is_named) ||
           std::ranges::any_of(context_.ir.kinds,
                               [&](const KindIr& kind) { return kind.name.text == name; });
}

// Whether a word that the rules do not know is a number or arithmetic: the names of devices are
// identifiers, with `.2` behind them.
bool RuleWords::is_level_number(std::string_view text) const {
    if (!is_identifier(text.substr(0, text.find('.')))) return true;
    std::uint64_t cost = 0;
    const bool is_let = scope_.find(text, cost) || context_.top_level_lets.contains(text);
    context_.work.spend(cost);
    return is_let;
}

// Reports the first name in `word` that neither the rules nor the numbers of the level know. A
// function is none of the names to suggest: what is missing is a variable.
bool RuleWords::knows_names(const Word& word) {
    const std::string_view text = word.text;
    std::uint64_t cost = 0;
    for (std::size_t at = 0; at < text.size();) {
        const bool is_number = is_digit(text[at]);
        const std::size_t from = at;
        while (at < text.size() &&
               (continues_identifier(text[at]) || (is_number && is_digit(text[at]))))
            ++at;
        if (at == from) {
            ++at;
            continue;
        }
        const std::string_view name = text.substr(from, at - from);
        const bool is_call = at < text.size() && text[at] == '(';
        if (is_call && (name == "count" || name == "lit"))
            at = std::min(text.find(')', at), text.size());
        if (is_number || is_call) continue;
        if (name == "pi" || context_.ir.rule_symbols.contains(name) || rule_quantity_named(name) ||
            scope_.find(name, cost) || context_.top_level_lets.contains(name))
            continue;
        if (is_ball_above(name)) {
            context_.reporter.error(
                "unknown-name", word.part(from, at - from).span(),
                fmt::format("'{}' names balls, which are no number", name),
                fmt::format("to count those on the table, write count({})", name));
            return false;
        }
        if (begins_action(name, context_)) {
            context_.reporter.error("unknown-name", word.part(from, at - from).span(),
                                    fmt::format("'{}' is an action, which is no number", name),
                                    fmt::format("there are variables, and: {}",
                                                joined(names_of(rule_quantities()), " ")));
            return false;
        }
        std::vector<std::string_view> known = names_of(rule_quantities());
        for (const auto& [other, symbol] : context_.ir.rule_symbols)
            known.push_back(other);
        for (const auto& [other, line] : context_.top_level_lets)
            known.push_back(other);
        context_.reporter.error(
            "unknown-name", word.part(from, at - from).span(),
            fmt::format("'{}' is not known", name),
            did_you_mean(name, known, fmt::format("declare it above: var {}", name)));
        return false;
    }
    context_.work.spend(cost);
    return true;
}

std::optional<RuleValue> RuleWords::value(const Word& word, std::string_view label, Bound bound) {
    if (word.text.find('=') != std::string_view::npos) return malformed(word);
    if (!knows_names(word)) return std::nullopt;
    if (!mentions_rules(word.text)) {
        const auto number =
            read_number(word, {label, " "}, Measure::whole, bound, scope_, context_);
        if (!number) return std::nullopt;
        constexpr auto most = static_cast<double>(most_rule_number);
        const auto whole = static_cast<std::int64_t>(std::clamp(*number, -most, most));
        return RuleValue{{RuleStep::What::number, whole}};
    }
    Cursor cursor{word};
    RuleValue out;
    const std::size_t errors = context_.reporter.errors();
    if (sum(cursor, out) && cursor.is_at_end()) return out;
    if (context_.reporter.errors() == errors) malformed(cursor.rest());
    return std::nullopt;
}

bool RuleWords::push(const Cursor& cursor, RuleStep step, RuleValue& out) {
    if (out.size() == most_rule_steps) {
        context_.reporter.error("rule-value-too-long", cursor.word.span(),
                                fmt::format("a value has at most {} parts", most_rule_steps),
                                "take a variable for a part of it");
        return false;
    }
    out.push_back(step);
    return true;
}

bool RuleWords::sum(Cursor& cursor, RuleValue& out) {
    if (!product(cursor, out)) return false;
    while (cursor.next() == '+' || cursor.next() == '-') {
        const bool adds = cursor.next() == '+';
        ++cursor.at;
        if (!product(cursor, out)) return false;
        if (!push(cursor, {adds ? RuleStep::What::add : RuleStep::What::subtract}, out))
            return false;
    }
    return true;
}

bool RuleWords::product(Cursor& cursor, RuleValue& out) {
    if (!atom(cursor, out)) return false;
    while (cursor.take('*'))
        if (!atom(cursor, out) || !push(cursor, {RuleStep::What::multiply}, out)) return false;
    return true;
}

bool RuleWords::atom(Cursor& cursor, RuleValue& out) {
    if (++cursor.depth > max_nesting) return false;
    if (cursor.take('(')) {
        if (!sum(cursor, out) || !cursor.take(')')) return false;
    } else if (cursor.take('-')) {
        if (!push(cursor, {RuleStep::What::number, 0}, out) || !atom(cursor, out) ||
            !push(cursor, {RuleStep::What::subtract}, out))
            return false;
    } else if (starts_identifier(cursor.next())) {
        const Word word = cursor.identifier();
        if (!(cursor.next() == '(' ? call(cursor, word, out) : push_name(word, out))) return false;
    } else {
        const std::size_t from = cursor.at;
        while (is_digit(cursor.next()))
            ++cursor.at;
        if (cursor.at == from) return false;
        if (!push_number(cursor.word.part(from, cursor.at - from), out)) return false;
    }
    --cursor.depth;
    return true;
}

bool RuleWords::push_number(const Word& word, RuleValue& out) {
    const auto number = read_number(word, {"", ""}, Measure::whole, Bound::any, scope_, context_);
    if (!number) return false;
    out.push_back(
        {RuleStep::What::number, static_cast<std::int64_t>(std::clamp(*number, -1e15, 1e15))});
    return true;
}

bool RuleWords::push_name(const Word& word, RuleValue& out) {
    if (const RuleSymbolIr* symbol = read_symbol(word.text)) {
        out.push_back({symbol->is_timer ? RuleStep::What::seconds : RuleStep::What::variable,
                       std::int64_t{symbol->index}});
        return true;
    }
    if (const auto quantity = rule_quantity_named(word.text)) {
        out.push_back({RuleStep::What::quantity, static_cast<std::int64_t>(*quantity)});
        return true;
    }
    return push_number(word, out);
}

bool RuleWords::arguments_of(Cursor& cursor, RuleStep::What what, RuleValue& out) {
    return sum(cursor, out) && cursor.take(',') && sum(cursor, out) && cursor.take(')') &&
           push(cursor, {what}, out);
}

bool RuleWords::call(Cursor& cursor, const Word& function, RuleValue& out) {
    using enum RuleStep::What;
    cursor.take('(');
    if (function.text == "min") return arguments_of(cursor, min, out);
    if (function.text == "max") return arguments_of(cursor, max, out);
    if (function.text == "count" || function.text == "lit") {
        Word argument = cursor.identifier();
        // rack.3, a ball of a rack.
        if (cursor.next() == '.') {
            const std::size_t from = cursor.at - argument.text.size();
            while (is_digit(cursor.next()))
                ++cursor.at;
            argument = cursor.word.part(from, cursor.at - from);
        }
        const bool is_count = function.text == "count";
        if (argument.text.empty()) return false;
        RuleStep step{is_count ? count : lit};
        step.number = name(argument, is_count ? RuleNameIr::Role::balls : RuleNameIr::Role::lights);
        if (is_count && cursor.take(',')) {
            const Word place = cursor.identifier();
            if (place.text.empty()) return false;
            step.place = static_cast<std::int32_t>(name(place, RuleNameIr::Role::place));
        }
        return cursor.take(')') && push(cursor, step, out);
    }
    context_.reporter.error("unknown-function", function.span(),
                            fmt::format("a rule has no function '{}'", function.text),
                            fmt::format("there are: {}", joined(names_of(rule_functions()), " ")));
    return false;
}

}  // namespace carom

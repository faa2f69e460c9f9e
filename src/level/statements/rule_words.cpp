#include "level/statements/rule_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "level/ir/numbers.h"

// This file is over 320 lines because it holds one idea, the parser of the words of a rule.
namespace carom {
namespace {

using Relation = RuleCondition::Relation;

struct Sign {
    std::string_view text;
    Relation relation;
};
// Longer signs first: each is found before its own beginning.
constexpr std::array signs{Sign{"<=", Relation::at_most}, Sign{">=", Relation::at_least},
                           Sign{"!=", Relation::unequal}, Sign{"<", Relation::less},
                           Sign{">", Relation::more},     Sign{"=", Relation::equal}};

const Sign* sign_at(std::string_view text) {
    const auto found =
        std::ranges::find_if(signs, [&](const Sign& sign) { return text.starts_with(sign.text); });
    return found == signs.end() ? nullptr : found;
}

constexpr std::string_view sign_characters = "<>=!";

bool is_digit(char c) {
    return (c >= '0' && c <= '9') || c == '.';
}

}  // namespace

std::optional<RuleQuantity> rule_quantity_named(std::string_view name) {
    const auto found = std::ranges::find(quantity_names, name);
    if (found == std::end(quantity_names)) return std::nullopt;
    return static_cast<RuleQuantity>(found - std::begin(quantity_names));
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
    context_.reporter.error(
        "rule-value-malformed", at.span(), fmt::format("'{}' is no value of a rule", at.text),
        "write a number, a variable, or + - * of them without spaces: 100*mode");
    return std::nullopt;
}

std::optional<RuleValue> RuleWords::value(const Word& word, std::string_view label, Bound bound) {
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
        if (argument.text.empty() || !cursor.take(')')) return false;
        const bool is_count = function.text == "count";
        const auto role = is_count ? RuleNameIr::Role::balls : RuleNameIr::Role::lights;
        return push(cursor, {is_count ? count : lit, std::int64_t{name(argument, role)}}, out);
    }
    context_.reporter.error("unknown-function", function.span(),
                            fmt::format("a rule has no function '{}'", function.text),
                            "there are: count(BALLS) lit(LAMPS) min(A,B) max(A,B)");
    return false;
}

std::optional<RuleCondition> RuleWords::comparison(const Word& left, std::string_view sign,
                                                   const Word& right) {
    RuleCondition made;
    made.relation = sign_at(sign)->relation;
    auto a = value(left, "", Bound::any);
    auto b = a ? value(right, "", Bound::any) : std::nullopt;
    if (!b) return std::nullopt;
    made.left = std::move(*a);
    made.right = std::move(*b);
    return made;
}

// One condition: a>=b, or with spaces; or the name of a variable, a timer or lights.
std::optional<RuleCondition> RuleWords::condition(const std::vector<Word>& words,
                                                  std::size_t& next) {
    const Word& word = words[next];
    const std::size_t at = word.text.find_first_of(sign_characters);
    if (at != std::string_view::npos && at > 0) {
        const Sign* sign = sign_at(word.text.substr(at));
        const std::size_t end = at + (sign ? sign->text.size() : 1);
        ++next;
        if (!sign || end == word.text.size()) return malformed(word);
        return comparison(word.part(0, at), sign->text, word.part(end));
    }
    if (next + 2 < words.size() && sign_at(words[next + 1].text) &&
        sign_at(words[next + 1].text)->text == words[next + 1].text) {
        next += 3;
        return comparison(word, words[next - 2].text, words[next - 1]);
    }
    ++next;
    RuleCondition made;
    if (const RuleSymbolIr* symbol = read_symbol(word.text); symbol && symbol->is_timer) {
        made.what = RuleCondition::What::running;
        made.index = symbol->index;
        return made;
    }
    if (mentions_rules(word.text)) {
        auto number = value(word, "", Bound::any);
        if (!number) return std::nullopt;
        made.left = std::move(*number);
        made.right = {{RuleStep::What::number, 0}};
        made.relation = Relation::unequal;
        return made;
    }
    made.what = RuleCondition::What::lit;
    made.index = name(word, RuleNameIr::Role::lights);
    return made;
}

std::optional<std::vector<RuleClause>> RuleWords::clauses(const std::vector<Word>& words,
                                                          std::size_t& next) {
    std::vector<RuleClause> made;
    const auto is_lead = [&](std::size_t i) {
        return i < words.size() &&
               (words[i].text == "if" || words[i].text == "while" || words[i].text == "unless");
    };
    while (is_lead(next)) {
        RuleClause clause;
        clause.is_not = words[next].text == "unless";
        do {
            ++next;
            if (next == words.size()) {
                malformed(words[next - 1]);
                return std::nullopt;
            }
            auto one = condition(words, next);
            if (!one) return std::nullopt;
            clause.all.push_back(std::move(*one));
        } while (next < words.size() && words[next].text == "and");
        made.push_back(std::move(clause));
    }
    return made;
}

std::optional<RuleText> RuleWords::text(const Word& word, std::string_view sample) {
    if (word.text.size() < 2 || word.text.front() != '"') {
        context_.reporter.error("message-without-quotes", word.span(), "a message stands in quotes",
                                fmt::format("write it as: {}", sample));
        return std::nullopt;
    }
    RuleText made;
    for (std::size_t at = 1; at + 1 < word.text.size();) {
        const std::size_t last = word.text.size() - 1;
        const std::size_t open = std::min(word.text.find('{', at), last);
        if (open > at) made.pieces.emplace_back(std::string(word.text.substr(at, open - at)));
        if (open == last) break;
        const std::size_t close = word.text.find('}', open);
        if (close == std::string_view::npos || close == open + 1) {
            context_.reporter.error("message-brace", word.part(open, 1).span(),
                                    "a brace in a message holds a value",
                                    "write it as: \"{score} points\"");
            return std::nullopt;
        }
        const Word inside = word.part(open + 1, close - open - 1);
        if (const RuleSymbolIr* symbol = read_symbol(inside.text); symbol && symbol->is_timer) {
            made.pieces.emplace_back(RuleText::Clock{symbol->index});
        } else {
            auto number = value(inside, "", Bound::any);
            if (!number) return std::nullopt;
            made.pieces.emplace_back(std::move(*number));
        }
        at = close + 1;
    }
    return made;
}

}  // namespace carom

#include "level/statements/rule_habits.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "level/statements/rule_actions.h"

namespace carom {
namespace {

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

bool is_lead(std::string_view word) {
    return word == "if" || word == "while" || word == "unless";
}

// `made+=1` and `made=1`: the form that a rule has. `sign` begins with + - or =.
std::string assignment(std::string_view name, std::string_view sign, std::string_view value) {
    const bool adds = sign.front() != '=';
    if (value.empty()) value = "1";
    return fmt::format("write it as: {} {}{}", name, adds ? sign.substr(0, 1) : "", value);
}

}  // namespace

std::optional<RuleAdvice> advice_on_condition(std::string_view word) {
    if (word == "or" || word == "||")
        return RuleAdvice{fmt::format("there is no '{}' in conditions", word),
                          "write the line twice, once with each condition"};
    if (word == "&&")
        return RuleAdvice{"conditions are joined by 'and'", "write it as: if A and B"};
    if (word == "not" || (word.starts_with('!') && !word.starts_with("!=")))
        return RuleAdvice{fmt::format("there is no '{}' in conditions", word == "not" ? word : "!"),
                          "write unless in place of if, as in: unless made"};
    if (word == "then") return RuleAdvice{"there is no 'then'", "leave it out: if made=1 score 1"};
    if (word == "else")
        return RuleAdvice{"there is no 'else'", "write a second line, with unless in place of if"};
    if (contains(word, "==")) return RuleAdvice{"a comparison has one '='", "write it as: made=1"};
    if (word.starts_with('(') && std::ranges::count(word, '(') != std::ranges::count(word, ')'))
        return RuleAdvice{"brackets do not group conditions",
                          "join them by and; for or, write the line twice"};
    return std::nullopt;
}

RuleAdvice advice_on_value(std::string_view text) {
    if (contains(text, "/") || contains(text, "%"))
        return {fmt::format("'{}' is not a value: rules do not divide", text),
                "multiply the other side of the comparison, as in 2*made>=shots"};
    return {fmt::format("'{}' is not a value", text),
            "write a number, a variable, or + - * of them without spaces: 100*mode"};
}

std::optional<RuleAdvice> advice_on_action(std::string_view word, const Context& context) {
    if (const auto advice = advice_on_condition(word)) return advice;
    if (word == "and") return RuleAdvice{"'and' joins conditions", "separate actions with a comma"};
    if (is_lead(word))
        return RuleAdvice{"the conditions of a rule stand together",
                          "write them before the first action"};
    const std::size_t sign = word.find_first_of("+-=");
    if (sign == 0 || sign == std::string_view::npos) return std::nullopt;
    const std::string_view name = word.substr(0, sign);
    if (!begins_action(name, context)) return std::nullopt;
    const std::size_t value = word.find_first_not_of("+-=", sign);
    return RuleAdvice{
        fmt::format("a blank is missing behind '{}'", name),
        assignment(name, word.substr(sign),
                   value == std::string_view::npos ? std::string_view{} : word.substr(value))};
}

RuleAdvice advice_on_extra_word(std::span<const Word> words, std::size_t extra,
                                std::string_view sample, const Context& context) {
    const std::string_view word = words[extra].text;
    if (is_lead(word))
        return {"conditions stand before the actions",
                fmt::format("write {} and its condition behind the event", word)};
    if (word == "once") return {"'once' stands behind the event", "as in: on cue hit ball once"};
    if (word == "and")
        return {"a comma separates actions", "write it in place of 'and': score 1, turn"};
    if (auto advice = advice_on_condition(word)) return std::move(*advice);
    if (begins_action(word, context))
        return {fmt::format("a comma is missing before '{}'", word),
                "separate actions with a comma: score 1, turn"};
    if (extra == 2 && (words[1].text == "=" || words[1].text == "+=" || words[1].text == "-="))
        return {fmt::format("a variable is set without '{}'", words[1].text),
                assignment(words[0].text, words[1].text, word)};
    return {fmt::format("'{}' is not expected here", word),
            fmt::format("write it as: {}; a comma before the next action", sample)};
}

}  // namespace carom

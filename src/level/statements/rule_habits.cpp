#include "level/statements/rule_habits.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <utility>
#include <vector>

#include "level/statements/rule_actions.h"
#include "level/statements/rule_events.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

// `made+=1`, `made=1` and `made=made+1`: the form that a rule has. `sign` begins with + - or =.
std::string assignment(std::string_view name, std::string_view sign, std::string_view value) {
    const bool adds = sign.front() != '=';
    if (value.empty()) value = "1";
    const std::string_view rest = value.substr(std::min(name.size(), value.size()));
    const bool adds_to_itself =
        value.starts_with(name) && rest.size() > 1 && (rest[0] == '+' || rest[0] == '-');
    if (adds_to_itself) return fmt::format("write it as: {} {}", name, rest);
    return fmt::format("write it as: {} {}{}", name, adds ? sign.substr(0, 1) : "", value);
}

bool is_among(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

// A preposition or an article, which no rule has.
bool is_filler(std::string_view word) {
    return is_among(word, {"in", "into", "at", "on", "by", "with", "from", "the", "a", "to"});
}

// `(made>1)`, or the first word of `(made and fell)`: a bracket that closes behind a sign, if at
// all. `(a+b)*2>3` is a value.
bool groups_conditions(std::string_view word) {
    const std::string_view value = word.substr(0, word.find_first_of("<>=!"));
    return word.starts_with('(') && std::ranges::count(value, '(') > std::ranges::count(value, ')');
}

// `add score 1`, `set made 2`: a verb before what it changes. The name alone does that.
std::optional<RuleAdvice> advice_on_verb(std::span<const Word> words, const Context& context) {
    const std::string_view verb = words[0].text;
    const bool takes = is_among(verb, {"subtract", "decrease", "deduct", "decrement"});
    const bool adds = is_among(verb, {"add", "increase", "give", "increment", "award", "inc"});
    if (!takes && !adds && !is_among(verb, {"set", "let", "change", "make"})) return std::nullopt;
    std::vector<std::string_view> rest;
    for (const Word& word : words.subspan(1))
        if (!is_among(word.text, {"to", "by", "from", "=", "+", "-"})) rest.push_back(word.text);
    // `add 1 to score`: the name stands last.
    if (rest.size() == 2 && !begins_action(rest[0], context)) std::swap(rest[0], rest[1]);
    std::string remedy = "name what it changes: score 1, made +1, made 1";
    if (!rest.empty() && begins_action(rest[0], context)) {
        std::string_view value = rest.size() > 1 ? rest[1] : "1";
        if (value.front() == '+') value.remove_prefix(1);
        const bool is_score = rest[0] == "score";
        remedy = fmt::format("write it as: {} {}{}", rest[0],
                             takes               ? "-"
                             : adds && !is_score ? "+"
                                                 : "",
                             value);
        if (is_score && !takes && !adds) remedy += ", which adds; a variable can be set";
    }
    return RuleAdvice{fmt::format("rules do without '{}'", verb), std::move(remedy)};
}

// The keyword of a line above that gives this name to balls, a kind, edges, zones or pockets. Of
// many lines, only the first are asked.
std::optional<std::string_view> holder_of(std::string_view name, const Context& context) {
    const auto first = [](const auto& all) {
        return std::span(all).first(std::min(all.size(), max_candidates));
    };
    for (const BallBinding& ball : first(context.ir.ball_bindings))
        if (ball.name && ball.name->text == name) return ball.node->keyword().text;
    for (const KindIr& kind : first(context.ir.kinds))
        if (kind.name.text == name) return "kind";
    for (const EdgeBinding& edge : first(context.ir.edge_bindings)) {
        const bool is_plain = !edge.plain.empty() && edge.plain.back().text == name;
        if (is_plain || (edge.name && edge.name->text == name)) return edge.node->keyword().text;
    }
    return std::nullopt;
}

// Words behind an action that say whom it is for: it is always the player whose turn it is.
std::optional<RuleAdvice> advice_on_player(const ActionShape& shape, const Word& first,
                                           const Word& extra) {
    const bool is_player = first.text.starts_with("player") || extra.text.starts_with("player") ||
                           first.text == "opponent" || extra.text == "opponent" ||
                           extra.text == "for" || extra.text == "of";
    if (!is_player) return std::nullopt;
    using enum RuleAction::What;
    const bool is_end = shape.what == win || shape.what == lose;
    return RuleAdvice{
        fmt::format("'{}' is for the player whose turn it is", shape.name),
        is_end ? fmt::format("write it alone: {}; for the other player, {}", shape.name,
                             shape.what == win ? "lose" : "win")
        : shape.what == turn
            ? std::string("write it alone: turn; the next player shoots")
            : fmt::format("write it as: {}; to ask who plays: if player=2", shape.sample)};
}

bool is_comparison(std::string_view word) {
    const std::size_t sign = word.find_first_of("<>!");
    return sign != 0 && sign != std::string_view::npos;
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
    if (contains(word, "=>")) return RuleAdvice{"there is no '=>'", "at least is >=: made>=1"};
    if (contains(word, "=<")) return RuleAdvice{"there is no '=<'", "at most is <=: made<=1"};
    if (contains(word, "<>")) return RuleAdvice{"there is no '<>'", "unequal is !=: made!=1"};
    if (word == "of" || word == "for")
        return RuleAdvice{fmt::format("there is no '{}' in conditions", word),
                          "score, fouls and variables of player are of whose turn it is: player=1"};
    if (is_among(word, {"in", "inside", "outside", "on"}))
        return RuleAdvice{fmt::format("there is no '{}' in conditions", word),
                          "to ask how many lie in a zone: if count(red,tray)>0"};
    if (word == "is") return RuleAdvice{"there is no 'is'", "compare with a sign: player=1"};
    if (word == "count" || word == "lit")
        return RuleAdvice{fmt::format("{} needs brackets", word),
                          fmt::format("write it without blanks, as in: {}(red)=0", word)};
    if (word.ends_with(':') || word.ends_with(';'))
        return RuleAdvice{
            fmt::format("there is no '{}' in rules", word.back()),
            "a blank ends a condition, and a comma an action: if made=1 score 1, turn"};
    if (groups_conditions(word))
        return RuleAdvice{"brackets do not group conditions",
                          "join them by and; for or, write the line twice"};
    return std::nullopt;
}

RuleAdvice advice_on_value(std::string_view text) {
    if (contains(text, "/") || contains(text, "%"))
        return {fmt::format("'{}' is not a value: rules do not divide", text),
                "multiply the other side of the comparison, as in 2*made>=shots"};
    if (std::ranges::count(text, '(') > std::ranges::count(text, ')'))
        return {fmt::format("'{}' ends within its brackets", text),
                "write it without blanks, as in: count(red,tray)"};
    if (contains(text, ",") && !contains(text, "("))
        return {"no comma joins conditions", "write and, between blanks: if made and count(red)=0"};
    if (contains(text, "="))
        return {fmt::format("'{}' is not a value", text),
                "write the number alone: made 1 sets, made +1 and made -1 add"};
    return {fmt::format("'{}' is not a value", text),
            "write a number, a variable, or + - * of them without spaces: 100*mode"};
}

std::optional<RuleAdvice> advice_on_action(std::span<const Word> words, const Context& context) {
    const std::string_view word = words[0].text;
    if (const auto advice = advice_on_verb(words, context)) return advice;
    if (const auto holder = holder_of(word, context)) {
        const bool are_two = words.size() > 1 && holder_of(words[1].text, context);
        return RuleAdvice{
            fmt::format("'{}' is the name of a {}, which is no action", word, *holder),
            are_two ? "an event names one thing: write the line twice, once for each"
                    : "write an action: NAME +1, respot NAME, remove NAME"};
    }
    if (is_filler(word))
        return RuleAdvice{fmt::format("rules do without '{}'", word),
                          "leave it out, as in: on red pocketed corner  score 1"};
    if (const auto advice = advice_on_condition(word)) return advice;
    if (word == "and") return RuleAdvice{"'and' joins conditions", "separate actions with a comma"};
    if (begins_clause(word))
        return RuleAdvice{"the conditions of a rule stand together",
                          "write them before the first action"};
    if (is_comparison(word))
        return RuleAdvice{fmt::format("'{}' is a condition", word),
                          "write if before it; or and, behind another condition"};
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

std::optional<RuleAdvice> advice_on_event(std::string_view subject, std::string_view event,
                                          const Context& context) {
    if (is_among(event, {"is", "are", "was", "gets", "has", "it"}))
        return RuleAdvice{fmt::format("there is no event '{}'", event),
                          fmt::format("leave it out, as in: on {} pocketed", subject)};
    if (is_among(subject, {"hit", "rail", "pocketed", "enter", "leave", "all"}))
        return RuleAdvice{fmt::format("'{}' stands behind what it happens to", subject),
                          fmt::format("write it as: on {} {}", event, subject)};
    if (subject == "timer")
        return RuleAdvice{"a timer is called by its name alone",
                          fmt::format("write it as: on {} ends", event)};
    if (subject == "player" || subject.starts_with("player"))
        return RuleAdvice{"a player has no events of its own",
                          "ask whose turn it is: on turn begins if player=2"};
    if (!is_among(event, {"begins", "ends", "judged", "begin", "end", "starts"}))
        return std::nullopt;
    const std::string_view moment =
        event == "judged" || event.starts_with("end") ? "ends" : "begins";
    std::vector<std::string_view> known{"shot"};
    if (moment == "begins") known.insert(known.end(), {"game", "turn"});
    for (const auto& [name, symbol] : context.ir.rule_symbols)
        if (symbol.is_timer && moment == "ends") known.push_back(name);
    return RuleAdvice{
        fmt::format("'{}' neither begins nor ends", subject),
        did_you_mean(subject, known,
                     fmt::format("write on shot {}; a timer needs a line above: timer {} 20s",
                                 moment, subject))};
}

bool looks_like_variable(std::span<const Word> action) {
    if (action.size() != 2 || !is_identifier(action[0].text)) return false;
    return std::string_view("+-0123456789").find(action[1].text.front()) != std::string_view::npos;
}

RuleAdvice advice_on_extra_word(std::span<const Word> words, const ActionShape& shape,
                                const Context& context) {
    const std::size_t extra = words_of(shape.takes).most;
    const std::string_view word = words[extra].text;
    if (begins_clause(word))
        return {"conditions stand before the actions",
                fmt::format("write {} and its condition behind the event", word)};
    if (word == "once") return {"'once' stands behind the event", "as in: on cue hit ball once"};
    if (word == "and")
        return {"a comma separates actions", "write it in place of 'and': score 1, turn"};
    if (auto advice = advice_on_player(shape, words[1], words[extra])) return std::move(*advice);
    const auto filler = std::ranges::find_if(words.subspan(1, extra),
                                             [](const Word& each) { return is_filler(each.text); });
    if (filler != words.subspan(1, extra).end())
        return {fmt::format("rules do without '{}'", filler->text),
                fmt::format("leave it out: {}", shape.sample)};
    if (auto advice = advice_on_condition(word)) return std::move(*advice);
    if (extra == 2 && is_among(words[1].text, {"=", "+=", "-="})) {
        std::string value;  // what follows, without the blanks in it
        for (const Word& part : words.subspan(2))
            value += part.text;
        return {fmt::format("a number is changed without '{}'", words[1].text),
                assignment(words[0].text, words[1].text, value)};
    }
    if (begins_action(word, context))
        return {fmt::format("a comma is missing before '{}'", word),
                "separate actions with a comma: score 1, turn"};
    if (extra == 2 && is_among(word, {"+", "-", "*"}))
        return {"a value has no blanks", fmt::format("write it as: {} 2*made+1", words[0].text)};
    if (extra == 2 && is_among(words[1].text, {"+", "-"}))
        return {"a value has no blanks",
                fmt::format("write it as: {} {}{}", words[0].text, words[1].text, word)};
    if (extra == 1)
        return {fmt::format("'{}' takes nothing behind it", shape.name),
                fmt::format("write it alone; {}", shape.does)};
    return {fmt::format("'{}' is not expected here", word),
            fmt::format("write it as: {}; a comma before the next action", shape.sample)};
}

}  // namespace carom

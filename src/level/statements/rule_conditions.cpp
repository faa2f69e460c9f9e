#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "level/statements/rule_events.h"
#include "level/statements/rule_habits.h"
#include "level/statements/rule_words.h"

// The conditions of rules, and their texts with values in braces: members of RuleWords.
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

bool starts_number(std::string_view word) {
    return word.front() >= '0' && word.front() <= '9';
}

}  // namespace

std::nullopt_t RuleWords::refuse(const Word& at, RuleAdvice advice) {
    context_.reporter.error("condition-malformed", at.span(), std::move(advice.message),
                            std::move(advice.remedy));
    return std::nullopt;
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

// One condition: a>=b, or with spaces; or the name of a variable, a timer, a motion or lights.
std::optional<RuleCondition> RuleWords::condition(const std::vector<Word>& words,
                                                  std::size_t& next) {
    const Word& word = words[next];
    if (auto advice = advice_on_condition(word.text)) return refuse(word, std::move(*advice));
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
        if (auto advice = advice_on_condition(words[next - 1].text))
            return refuse(words[next - 1], std::move(*advice));
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
    const std::vector<MotionIr>& motions = context_.ir.motions;
    const auto motion = std::ranges::find_if(
        motions, [&](const MotionIr& each) { return each.names.front().text == word.text; });
    if (motion != motions.end()) {
        made.what = RuleCondition::What::moving;
        made.index = static_cast<std::uint32_t>(motion - motions.begin());
        return made;
    }
    if (is_level_number(word.text))
        return refuse(word, {fmt::format("'{}' is a number, which is no condition", word.text),
                             "compare it, as in: if score>=10; what always holds has no if"});
    made.what = RuleCondition::What::lit;
    made.index = name(word, RuleNameIr::Role::lights);
    return made;
}

std::optional<std::vector<RuleClause>> RuleWords::clauses(const std::vector<Word>& words,
                                                          std::size_t& next) {
    std::vector<RuleClause> made;
    while (next < words.size() && begins_clause(words[next].text)) {
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
    if (!made.empty() && next < words.size() && starts_number(words[next].text) &&
        is_identifier(words[next - 1].text) && mentions_rules(words[next - 1].text))
        return refuse(words[next],
                      {fmt::format("a sign is missing before '{}'", words[next].text),
                       fmt::format("write it as: {}={}", words[next - 1].text, words[next].text)});
    if (!made.empty() && next < words.size())
        if (auto advice = advice_on_condition(words[next].text))
            return refuse(words[next], std::move(*advice));
    return made;
}

// {hits hit|hits}: a value, a blank, and the words for one and for any other number.
std::optional<RuleText::Counted> RuleWords::counted_text(const Word& inside, std::size_t blank) {
    const std::string_view words = inside.text.substr(blank + 1);
    const std::size_t bar = words.find('|');
    const bool is_whole = blank > 0 && bar != std::string_view::npos && bar > 0 &&
                          bar + 1 < words.size() && words.find('|', bar + 1) == words.npos;
    if (!is_whole) {
        context_.reporter.error("message-brace", inside.span(),
                                "a value in braces has no blanks, but words for one and for more",
                                "write it as: {made} or {made point|points}");
        return std::nullopt;
    }
    auto number = value(inside.part(0, blank), "", Bound::any);
    if (!number) return std::nullopt;
    return RuleText::Counted{std::move(*number), std::string(words.substr(0, bar)),
                             std::string(words.substr(bar + 1))};
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
        if (const std::size_t blank = inside.text.find(' '); blank != std::string_view::npos) {
            auto counted = counted_text(inside, blank);
            if (!counted) return std::nullopt;
            made.pieces.emplace_back(std::move(*counted));
        } else if (const RuleSymbolIr* symbol = read_symbol(inside.text);
                   symbol && symbol->is_timer) {
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

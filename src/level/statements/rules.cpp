#include "level/statements/rules.h"

#include <fmt/format.h>

#include "level/ir/numbers.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

using What = RuleAction::What;

// The argument of an action.
enum class Takes { points, sum, count, time, name, name_and_time, text, nothing };

struct ActionShape {
    std::string_view name;
    What what;
    Takes takes;
    std::string_view sample;
};

constexpr ActionShape shapes[] = {
    {"score", What::score, Takes::points, "score 100"},
    {"bonus", What::bonus, Takes::sum, "bonus +1"},
    {"multiplier", What::multiplier, Takes::sum, "multiplier +1"},
    {"multiball", What::multiball, Takes::count, "multiball 2"},
    {"save", What::save, Takes::time, "save 10s"},
    {"extraball", What::extraball, Takes::nothing, "extraball"},
    {"reset", What::reset, Takes::name, "reset NAME"},
    {"light", What::light, Takes::name_and_time, "light NAME"},
    {"unlight", What::unlight, Takes::name, "unlight NAME"},
    {"advance", What::advance, Takes::name, "advance NAME"},
    {"message", What::message, Takes::text, "message \"TEXT\""},
};

class RuleReader {
  public:
    RuleReader(const Arguments& arguments, const Scope& scope, Context& context)
        : arguments_(arguments), scope_(scope), context_(context) {}

    std::optional<RuleIr> read() {
        const std::vector<Word>& words = arguments_.plain;
        RuleIr rule;
        rule.name = words[0];
        rule.when_word = words[1];
        if (!read_when(rule)) return std::nullopt;
        std::size_t next = 2;
        for (; words[next].text == "while" || words[next].text == "unless"; next += 2) {
            const Word& word = words[next];
            if (words.size() < next + 3)
                return refuse("rule-incomplete", word,
                              fmt::format("{} what, and what then?", word.text));
            rule.needs.push_back({words[next + 1], word.text == "unless"});
        }
        std::vector<Word> action;
        for (; next < words.size(); ++next) {
            Word word = words[next];
            const bool ends = word.text.back() == ',' && word.text.front() != '"';
            if (ends) word = word.part(0, word.text.size() - 1);
            if (!word.text.empty()) action.push_back(word);
            if (!ends && next + 1 < words.size()) continue;
            if (action.empty())
                return refuse("action-missing", words[next], "an action is missing here");
            if (!read_action(action, rule)) return std::nullopt;
            action.clear();
            if (ends && next + 1 == words.size())
                return refuse("action-missing", words[next],
                              "an action is missing behind the comma");
        }
        return rule;
    }

  private:
    std::nullopt_t refuse(FaultCode code, const Word& at, std::string message) {
        context_.reporter.error(code, at.span(), std::move(message),
                                fmt::format("write it as: {}", arguments_.statement->usage));
        return std::nullopt;
    }

    bool read_when(RuleIr& rule) {
        const Word& word = rule.when_word;
        if (word.text == "hit")
            rule.when = Rule::When::hit;
        else if (word.text == "all")
            rule.when = Rule::When::all;
        else if (word.text == "enter")
            rule.when = Rule::When::enter;
        else
            context_.reporter.error(
                "unknown-event", word.span(),
                fmt::format("there is no '{}' to wait for", word.text),
                did_you_mean(word.text, {"hit", "all", "enter"}, "write hit, all or enter"));
        return word.text == "hit" || word.text == "all" || word.text == "enter";
    }

    bool read_action(const std::vector<Word>& words, RuleIr& rule) {
        const ActionShape* shape = row_named(shapes, words[0].text);
        if (!shape) {
            context_.reporter.error(
                "unknown-action", words[0].span(),
                fmt::format("there is no action '{}'", words[0].text),
                did_you_mean(words[0].text, names_of(shapes),
                             fmt::format("there are: {}", fmt::join(names_of(shapes), " "))));
            return false;
        }
        const std::size_t wanted = shape->takes == Takes::nothing ? 1 : 2;
        const bool has_time = shape->takes == Takes::name_and_time && words.size() == 3;
        if (words.size() != wanted && !has_time) {
            const Word& at = words.size() > wanted ? words[wanted] : words[0];
            context_.reporter.error(
                "action-malformed", at.span(),
                words.size() > wanted ? fmt::format("'{}' is not expected here", at.text)
                                      : fmt::format("{} is not complete", shape->name),
                fmt::format("write it as: {}, with a comma before the next", shape->sample));
            return false;
        }
        RuleActionIr spec;
        spec.action.what = shape->what;
        if (wanted == 2 && !read_value(*shape, words[1], spec)) return false;
        if (has_time && !read_time(*shape, words[2], spec.action)) return false;
        rule.actions.push_back(std::move(spec));
        return true;
    }

    bool read_value(const ActionShape& shape, const Word& word, RuleActionIr& spec) {
        switch (shape.takes) {
            case Takes::points:
            case Takes::sum:
                spec.action.adds = word.text.front() == '+';
                return read_amount(shape, word, Bound::any, spec.action);
            case Takes::count:
                return read_amount(shape, word, Bound::positive, spec.action);
            case Takes::time:
                return read_time(shape, word, spec.action);
            case Takes::name:
            case Takes::name_and_time:
                spec.group = word;
                return true;
            default:
                break;
        }
        if (word.text.size() < 2 || word.text.front() != '"') {
            context_.reporter.error("message-without-quotes", word.span(),
                                    "a message stands in quotes",
                                    fmt::format("write it as: {}", shape.sample));
            return false;
        }
        spec.action.text = std::string(word.text.substr(1, word.text.size() - 2));
        return true;
    }

    bool read_time(const ActionShape& shape, const Word& word, RuleAction& action) {
        const auto time = read_number(word, {shape.name, " "}, Measure::time, Bound::not_negative,
                                      scope_, context_);
        action.seconds = time.value_or(0.0);
        return time.has_value();
    }

    bool read_amount(const ActionShape& shape, const Word& word, Bound bound, RuleAction& action) {
        constexpr double most = 1e12;
        const auto amount =
            read_number(word, {shape.name, " "}, Measure::whole, bound, scope_, context_);
        if (!amount) return false;
        const double largest = shape.what == What::multiball    ? 8.0
                               : shape.what == What::multiplier ? 100.0
                                                                : most;
        if (*amount > largest || *amount < -largest) {
            context_.reporter.error("action-value-too-large", word.span(),
                                    fmt::format("{} goes up to {:.0f}", shape.name, largest),
                                    fmt::format("write a smaller number, as in: {}", shape.sample));
            return false;
        }
        action.amount = static_cast<std::int64_t>(*amount);
        return true;
    }

    const Arguments& arguments_;
    const Scope& scope_;
    Context& context_;
};

}  // namespace

void add_rule(const Arguments& arguments, const Frame& frame, Context& context) {
    auto rule = RuleReader(arguments, *frame.scope, context).read();
    if (rule) context.ir.rules.push_back(std::move(*rule));
}

}  // namespace carom

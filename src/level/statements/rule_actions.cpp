#include "level/statements/rule_actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "level/ir/numbers.h"
#include "level/statements/action_shapes.h"
#include "level/statements/rule_habits.h"
#include "level/text/joined.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

using What = RuleAction::What;

class ActionReader {
  public:
    ActionReader(const ActionShape& shape, const Scope& scope, Context& context, RuleWords& reader)
        : shape_(shape), scope_(scope), context_(context), reader_(reader) {}

    bool read(std::span<const Word> words, RuleAction& action) {
        using Role = RuleNameIr::Role;
        switch (shape_.takes) {
            case Takes::nothing:
                return true;
            case Takes::points:
                return read_amount(words[1], Bound::any, action);
            case Takes::sum:
                return read_sum(words[1], action);
            case Takes::count:
                return read_amount(words[1], Bound::positive, action);
            case Takes::time:
                return read_time(words[1], action);
            case Takes::lights:
            case Takes::lights_and_maybe_time:
                action.index = reader_.name(words[1], Role::switched);
                return words.size() < 3 || read_time(words[2], action);
            case Takes::opening:
            case Takes::opening_and_maybe_time:
                action.index = reader_.name(words[1], Role::opening);
                return words.size() < 3 || read_time(words[2], action);
            case Takes::holder:
                action.index = reader_.name(words[1], Role::holder);
                return true;
            case Takes::timer:
            case Takes::timer_and_maybe_time:
                if (!read_timer(words[1], action)) return false;
                return words.size() < 3 || read_duration(words[2], action);
            case Takes::balls_and_maybe_place:
                action.index = reader_.name(words[1], Role::balls);
                if (words.size() == 3) read_place(words[2], action);
                return true;
            case Takes::balls_and_maybe_side:
                action.index = reader_.name(words[1], Role::balls);
                return words.size() == 2 || read_side(words, action);
            case Takes::maybe_place:
                if (words.size() == 2) read_place(words[1], action);
                return true;
            case Takes::text:
                break;
        }
        auto text = reader_.text(words[1], shape_.sample);
        if (text) action.text = std::move(*text);
        return text.has_value();
    }

  private:
    void read_place(const Word& word, RuleAction& action) {
        action.place = static_cast<std::int32_t>(reader_.name(word, RuleNameIr::Role::place));
    }

    // inside ZONE, outside ZONE
    bool read_side(std::span<const Word> words, RuleAction& action) {
        action.is_outside = words[2].text == "outside";
        if (words.size() == 4 && (action.is_outside || words[2].text == "inside")) {
            read_place(words[3], action);
            return true;
        }
        context_.reporter.error("action-malformed", words[2].span(),
                                fmt::format("'{}' is not expected here", words[2].text),
                                fmt::format("write it as: {}; or inside ZONE", shape_.sample));
        return false;
    }

    bool read_time(const Word& word, RuleAction& action) {
        const auto time = read_number(word, {shape_.name, " "}, Measure::time, Bound::not_negative,
                                      scope_, context_);
        action.seconds = time.value_or(0.0);
        return time.has_value();
    }

    // A timer or a motion.
    bool read_timer(const Word& word, RuleAction& action) {
        const auto found = context_.ir.rule_symbols.find(word.text);
        if (found != context_.ir.rule_symbols.end() && found->second.is_timer) {
            action.index = found->second.index;
            action.seconds = context_.ir.timers[action.index].seconds;
            return true;
        }
        const std::vector<MotionIr>& motions = context_.ir.motions;
        const auto motion = std::ranges::find_if(
            motions, [&](const MotionIr& each) { return each.names.front().text == word.text; });
        if (motion != motions.end()) {
            action.what = shape_.what == What::start ? What::start_motion : What::stop_motion;
            action.index = static_cast<std::uint32_t>(motion - motions.begin());
            return true;
        }
        if (std::ranges::count(context_.ir.error_names, word.text) > 0) return false;
        context_.reporter.error("unknown-timer", word.span(),
                                fmt::format("there is no timer or motion '{}'", word.text),
                                is_identifier(word.text)
                                    ? fmt::format("add a line above: timer {} 20s", word.text)
                                    : fmt::format("write it as: {}", shape_.sample));
        return false;
    }

    bool read_duration(const Word& word, RuleAction& action) {
        if (action.what != What::start_motion) return read_time(word, action);
        context_.reporter.error("action-malformed", word.span(),
                                fmt::format("'{}' is not expected here", word.text),
                                "a motion runs until it stops: write start NAME");
        return false;
    }

    // +N and -N add to a variable, N sets it; of bonus and multiplier, only +N adds.
    bool read_sum(const Word& word, RuleAction& action) {
        const char first = word.text.front();
        action.adds = first == '+' || (first == '-' && action.what == What::set);
        return read_amount(word, Bound::any, action);
    }

    bool read_amount(const Word& word, Bound bound, RuleAction& action) {
        const bool has_plus = word.text.front() == '+' && word.text.size() > 1;
        auto value = reader_.value(has_plus ? word.part(1) : word, shape_.name, bound);
        if (!value) return false;
        const bool is_number = value->size() == 1 && value->front().what == RuleStep::What::number;
        const auto most = static_cast<std::int64_t>(shape_.most);
        if (is_number && (value->front().number > most || value->front().number < -most)) {
            context_.reporter.error(
                "action-value-too-large", word.span(),
                fmt::format("{} goes up to {:.0f}", shape_.name, shape_.most),
                fmt::format("write a smaller number, as in: {}", shape_.sample));
            return false;
        }
        action.value = std::move(*value);
        return true;
    }

    const ActionShape& shape_;
    const Scope& scope_;
    Context& context_;
    RuleWords& reader_;
};

// The actions of the level's game; of both games while it is not known.
std::vector<std::string_view> names_offered(const Context& context) {
    const LevelSettings& settings = context.ir.settings;
    std::vector<std::string_view> names;
    for (const ActionShape& shape : action_shapes())
        if ((shape.games != RuleGames::pinball || !settings.is_shots) &&
            (shape.games != RuleGames::shots || !settings.table.is_game))
            names.push_back(shape.name);
    return names;
}

const ActionShape* shape_named(const Word& word, const Context& context) {
    const auto symbol = context.ir.rule_symbols.find(word.text);
    if (symbol != context.ir.rule_symbols.end() && !symbol->second.is_timer)
        return &variable_shape();
    return row_named(action_shapes(), word.text);
}

}  // namespace

RuleGames games_of(RuleAction::What what) {
    return action_shape_of(what).games;
}

std::string_view name_of(RuleAction::What what) {
    return action_shape_of(what).name;
}

bool begins_action(std::string_view word, const Context& context) {
    const auto symbol = context.ir.rule_symbols.find(word);
    if (symbol != context.ir.rule_symbols.end()) return !symbol->second.is_timer;
    return row_named(action_shapes(), word) != nullptr;
}

bool read_rule_action(std::span<const Word> words, const Scope& scope, Context& context,
                      RuleWords& reader, RuleIr& rule) {
    const ActionShape* shape = shape_named(words[0], context);
    if (!shape) {
        if (auto advice = advice_on_action(words, context)) {
            context.reporter.error("action-malformed", words[0].span(), std::move(advice->message),
                                   std::move(advice->remedy));
            return false;
        }
        std::vector<std::string_view> known = names_offered(context);
        const std::string otherwise =
            looks_like_variable(words)
                ? fmt::format("declare it above: var {}", words[0].text)
                : fmt::format("there are: {}, and variables (var NAME)", joined(known, " "));
        for (const auto& [name, symbol] : context.ir.rule_symbols)
            known.push_back(name);
        context.reporter.error("unknown-action", words[0].span(),
                               fmt::format("there is no action '{}'", words[0].text),
                               did_you_mean(words[0].text, known, otherwise));
        return false;
    }
    const WordCounts counts = words_of(shape->takes);
    if (words.size() < counts.least || words.size() > counts.most) {
        const bool is_long = words.size() > counts.most;
        RuleAdvice advice = is_long ? advice_on_extra_word(words, *shape, context)
                                    : RuleAdvice{fmt::format("{} is not complete", words[0].text),
                                                 fmt::format("write it as: {}", shape->sample)};
        context.reporter.error("action-malformed", words[is_long ? counts.most : 0].span(),
                               std::move(advice.message), std::move(advice.remedy));
        return false;
    }
    RuleAction action;
    action.what = shape->what;
    if (shape == &variable_shape())
        action.index = context.ir.rule_symbols.find(words[0].text)->second.index;
    if (!ActionReader(*shape, scope, context, reader).read(words, action)) return false;
    rule.rule.actions.push_back(std::move(action));
    rule.actions.push_back(words[0]);
    return true;
}

}  // namespace carom

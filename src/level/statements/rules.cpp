#include "level/statements/rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "level/ir/numbers.h"
#include "level/statements/rule_actions.h"
#include "level/statements/rule_events.h"
#include "level/statements/rule_words.h"
#include "level/text/joined.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

// Words that stand for balls, so that no action can begin with them.
bool is_ball_word(std::string_view word) {
    return word == "ball" || word == "cue" || word == "opponent" || word == "it";
}

class RuleReader {
  public:
    RuleReader(const Arguments& arguments, const Scope& scope, Context& context)
        : arguments_(arguments), scope_(scope), context_(context), words_(arguments.plain) {}

    std::optional<RuleIr> read() {
        RuleIr rule;
        RuleWords reader(scope_, context_, rule.names);
        rule.subject = words_[0];
        rule.event = words_[1];
        rule.rule.line = rule.subject.line;
        std::size_t next = 2;
        if (!read_event(rule, next) || !ends_event(rule, next)) return std::nullopt;
        if (next < words_.size() && words_[next].text == "once") {
            rule.rule.once = true;
            ++next;
        }
        const std::size_t conditions = next;
        rule.needs = next < words_.size() ? words_[next] : rule.event;
        auto needs = read_needs(reader, next);
        if (!needs) return std::nullopt;
        rule.rule.needs = std::move(*needs);
        if (next == words_.size())
            return refuse("rule-incomplete", words_[conditions < next ? conditions : next - 1],
                          conditions < next
                              ? fmt::format("{} what, and what then?", words_[conditions].text)
                              : std::string("what happens then?"));
        if (!read_actions(reader, next, rule)) return std::nullopt;
        return rule;
    }

  private:
    std::nullopt_t refuse(FaultCode code, const Word& at, std::string message) {
        context_.reporter.error(code, at.span(), std::move(message),
                                fmt::format("write it as: {}", arguments_.statement->usage));
        return std::nullopt;
    }

    std::optional<std::vector<RuleClause>> read_needs(RuleWords& reader, std::size_t& next) {
        if (next < words_.size() && begins_clause(words_[next].text) && words_.size() < next + 3) {
            const Word& word = words_[next];
            refuse("rule-incomplete", word, fmt::format("{} what, and what then?", word.text));
            return std::nullopt;
        }
        return reader.clauses(words_, next);
    }

    bool read_event(RuleIr& rule, std::size_t& next) {
        const Word& word = rule.event;
        if (const RuleSymbolIr* timer = timer_named(rule.subject.text)) {
            if (word.text != "ends") return refuse_event(word, {"ends"});
            rule.rule.event = RuleEvent::timer_ends;
            rule.rule.subject = timer->index;
            return true;
        }
        std::vector<std::string_view> known;
        const bool is_moment = rule.subject.text == "game" || rule.subject.text == "turn" ||
                               rule.subject.text == "shot";
        for (const EventWord& row : event_words()) {
            if (is_moment ? row.subject != rule.subject.text
                          : !row.subject.empty() && row.subject != rule.subject.text)
                continue;
            const bool is_of_other_game =
                (row.games == RuleGames::pinball && context_.ir.settings.is_shots) ||
                (row.games == RuleGames::shots && context_.ir.settings.table.is_game);
            if (is_moment || !is_of_other_game) known.push_back(row.name);
            if (row.name != word.text) continue;
            rule.rule.event = row.event;
            if (row.takes_other && has_other(next)) rule.other = words_[next++];
            return true;
        }
        if (!is_moment)
            if (auto advice = advice_on_event(rule.subject.text, word.text, context_)) {
                context_.reporter.error("unknown-event", rule.subject.span(),
                                        std::move(advice->message), std::move(advice->remedy));
                return false;
            }
        return refuse_event(word, known);
    }

    // Nothing joins an event to what stands behind it, or to a second event.
    bool ends_event(const RuleIr& rule, std::size_t next) {
        const auto stop = [&](const Word& at, std::string message, std::string remedy) {
            context_.reporter.error("event-malformed", at.span(), std::move(message),
                                    std::move(remedy));
            return false;
        };
        if (rule.other && rule.other->text.ends_with(','))
            return stop(*rule.other, "no comma stands behind the event", "leave the comma out");
        if (next < words_.size() && (words_[next].text == "and" || words_[next].text == "or"))
            return stop(words_[next], "a rule waits for one event",
                        "write the line twice, once for each; or ball, for any ball");
        return true;
    }

    bool refuse_event(const Word& word, const std::vector<std::string_view>& known) {
        context_.reporter.error(
            "unknown-event", word.span(), fmt::format("there is no event '{}'", word.text),
            did_you_mean(word.text, known, fmt::format("write {}", joined(known, ", "))));
        return false;
    }

    const RuleSymbolIr* timer_named(std::string_view name) const {
        const auto found = context_.ir.rule_symbols.find(name);
        if (found == context_.ir.rule_symbols.end() || !found->second.is_timer) return nullptr;
        return &found->second;
    }

    // Whether words_[next] is a second name, and not the beginning of an action: then what comes
    // after it begins one, or a condition.
    bool has_other(std::size_t next) const {
        if (next + 1 >= words_.size()) return false;
        const std::string_view word = words_[next].text;
        const auto is_lead = [](std::string_view text) {
            return text == "once" || begins_clause(text) || text == "and" || text == "or";
        };
        if (is_lead(word)) return false;
        if (is_ball_word(word)) return true;
        if (begins_action(word, context_)) return false;
        std::string_view after = words_[next + 1].text;
        if (after.ends_with(',')) after.remove_suffix(1);
        return is_lead(after) || begins_action(after, context_);
    }

    // The actions, separated by commas, from words_[next] on.
    bool read_actions(RuleWords& reader, std::size_t next, RuleIr& rule) {
        std::vector<Word> action;
        for (; next < words_.size(); ++next) {
            Word word = words_[next];
            const bool ends = word.text.back() == ',' && word.text.front() != '"';
            if (ends) word = word.part(0, word.text.size() - 1);
            if (!word.text.empty()) action.push_back(word);
            if (!ends && next + 1 < words_.size()) continue;
            if (action.empty()) {
                refuse("action-missing", words_[next], "an action is missing here");
                return false;
            }
            if (!read_rule_action(action, scope_, context_, reader, rule)) return false;
            action.clear();
            if (ends && next + 1 == words_.size()) {
                context_.reporter.error("action-missing", words_[next].span(),
                                        "an action is missing behind the comma",
                                        "leave the comma out; a line goes on behind a \\");
                return false;
            }
        }
        return true;
    }

    const Arguments& arguments_;
    const Scope& scope_;
    Context& context_;
    const std::vector<Word>& words_;
};

// Adds a name to the variables and timers. False: it has another meaning, which is reported.
bool declare(const Word& name, bool is_timer, Context& context) {
    LevelIr& ir = context.ir;
    const auto refuse = [&](std::string message) {
        context.reporter.error("rule-name-taken", name.span(), std::move(message),
                               "choose another name");
        return false;
    };
    if (!is_identifier(name.text)) {
        context.reporter.error("not-a-name", name.span(),
                               fmt::format("'{}' is not a name", name.text),
                               "a name has letters, digits and '_', and begins with a letter");
        return false;
    }
    constexpr std::array<std::string_view, 13> words{"if",   "while", "unless", "and", "once",
                                                     "game", "shot",  "count",  "lit", "min",
                                                     "max",  "of",    "seconds"};
    if (rule_quantity_named(name.text))
        return refuse(fmt::format("'{}' is a number that the game keeps itself", name.text));
    if (begins_action(name.text, context) && !ir.rule_symbols.contains(name.text))
        return refuse(fmt::format("'{}' is an action", name.text));
    if (std::ranges::count(words, name.text) > 0 || is_ball_word(name.text))
        return refuse(fmt::format("'{}' is a word of the rules", name.text));
    const auto index =
        static_cast<std::uint32_t>(is_timer ? ir.timers.size() : ir.variables.size());
    const auto [found, is_new] =
        ir.rule_symbols.emplace(std::string(name.text), RuleSymbolIr{name, is_timer, index});
    if (is_new) return true;
    const RuleSymbolIr& other = found->second;
    return refuse(taken_message(name.span(), name.text, other.is_timer ? "timer" : "variable",
                                other.name.span()));
}

std::optional<RuleScope> scope_named(std::string_view name) {
    using enum RuleScope;
    constexpr std::array names{
        std::pair(std::string_view("game"), game), std::pair(std::string_view("player"), player),
        std::pair(std::string_view("turn"), turn), std::pair(std::string_view("shot"), shot)};
    for (const auto& [known, scope] : names)
        if (known == name) return scope;
    return std::nullopt;
}

}  // namespace

void add_rule(const Arguments& arguments, const Frame& frame, Context& context) {
    auto rule = RuleReader(arguments, *frame.scope, context).read();
    if (rule) context.ir.rules.push_back(std::move(*rule));
}

void add_variable(const Arguments& arguments, const Frame&, Context& context) {
    const std::vector<Word>& words = arguments.plain;
    RuleVariable variable;
    variable.name = std::string(words[0].text);
    if (words.size() > 1) {
        const auto scope =
            words.size() == 3 && words[1].text == "of" ? scope_named(words[2].text) : std::nullopt;
        if (!scope) {
            const bool is_of = words[1].text == "of" || words[1].text == "start";
            const Word& at = is_of ? words.back() : words[1];
            const bool at_start = words.size() == 3 && words[1].text == "start";
            context.reporter.error(
                "unknown-scope", at.span(), fmt::format("'{}' is not expected here", at.text),
                did_you_mean(
                    at.text, {"game", "player", "turn", "shot"},
                    at_start ? fmt::format("write it as: var {} start={}", words[0].text, at.text)
                             : fmt::format("write it as: var {} of shot (or game, "
                                           "player, turn)",
                                           words[0].text)));
            return;
        }
        variable.scope = *scope;
    }
    variable.start =
        static_cast<std::int64_t>(std::clamp(arguments.number_or("start", 0.0), -1e15, 1e15));
    if (declare(words[0], false, context)) context.ir.variables.push_back(std::move(variable));
}

void add_timer(const Arguments& arguments, const Frame& frame, Context& context) {
    const Word& word = arguments.plain[1];
    const auto time =
        read_number(word, {"timer", " "}, Measure::time, Bound::positive, *frame.scope, context);
    if (!declare(arguments.plain[0], true, context)) return;
    context.ir.timers.push_back({std::string(arguments.plain[0].text), time.value_or(1.0)});
}

void add_task(const Arguments& arguments, const Frame& frame, Context& context) {
    TaskIr task;
    RuleWords reader(*frame.scope, context, task.names);
    task.text = arguments.plain[0];
    auto text = reader.text(task.text, "task \"SHOOT THE RAMP\" if mode=1");
    if (!text) return;
    std::size_t next = 1;
    std::vector<std::uint32_t> shots;
    if (next + 1 < arguments.plain.size() && arguments.plain[next].text == "for")
        for (++next; next < arguments.plain.size() && !begins_clause(arguments.plain[next].text);
             ++next)
            shots.push_back(reader.name(arguments.plain[next], RuleNameIr::Role::device));
    auto needs = reader.clauses(arguments.plain, next);
    if (!needs) return;
    if (next < arguments.plain.size()) {
        const Word& at = arguments.plain[next];
        context.reporter.error("task-malformed", at.span(),
                               fmt::format("'{}' is not expected here", at.text),
                               fmt::format("write it as: {}", arguments.statement->usage));
        return;
    }
    task.task = {std::move(*text), std::move(*needs), std::move(shots)};
    context.ir.tasks.push_back(std::move(task));
}

}  // namespace carom

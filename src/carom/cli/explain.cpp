#include "carom/cli/explain.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "carom/files/print.h"
#include "carom/text/suggest.h"
#include "level/build/all_statements.h"
#include "level/scene/quantities.h"
#include "level/statements/action_shapes.h"
#include "level/statements/rule_events.h"
#include "level/text/joined.h"
#include "level/values/dimension.h"

namespace carom {
namespace {

std::string_view shape_text(KeyShape shape) {
    switch (shape) {
        case KeyShape::pair:
            return "X,Y: each ";
        case KeyShape::box:
            return "X0,Y0,X1,Y1: each ";
        case KeyShape::range:
        case KeyShape::deferred:
            return "one value, or a range A..B: ";
        case KeyShape::word:
            return "a word";
        case KeyShape::color:
            return "a colour: its name, or #rrggbb";
        case KeyShape::call:
            return "a name, or NAME(VALUES)";
        case KeyShape::scalar:
            break;
    }
    return "";
}

std::string_view bound_text(Bound bound) {
    switch (bound) {
        case Bound::not_negative:
            return ", 0 or more";
        case Bound::positive:
            return ", more than 0";
        case Bound::unit_interval:
            return ", 0 to 1";
        case Bound::positive_unit_interval:
            return ", more than 0, 1 at most";
        case Bound::up_to_thousand:
            return ", 1 to 1000";
        case Bound::layer:
            return ", 0 to 3";
        case Bound::any:
            break;
    }
    return "";
}

std::string key_text(const KeyRule& key) {
    const bool has_measure =
        key.shape != KeyShape::word && key.shape != KeyShape::color && key.shape != KeyShape::call;
    return fmt::format("    {:<10} {}{}{}{}{}{}\n", fmt::format("{}=", key.name),
                       shape_text(key.shape), has_measure ? described(key.measure) : "",
                       has_measure ? bound_text(key.bound) : "",
                       key.is_required ? "; required" : "", key.repeats ? "; may be repeated" : "",
                       key.needs_spin ? "; needs `use spin`" : "");
}

std::string statement_text(const Statement& statement) {
    std::string text = fmt::format("{}\n", statement.usage);
    for (const KeyRule& key : statement.keys)
        text += key_text(key);
    if (statement.opens_block) text += "    a block: it ends with `end`\n";
    if (statement.place == Place::top) text += "    outside of blocks only\n";
    if (statement.is_unique) text += "    once in a level\n";
    if (statement.settable != Settable::no) text += "    --set takes it\n";
    return text;
}

std::string_view game_text(RuleGames games) {
    return games == RuleGames::pinball ? " (pinball)" : games == RuleGames::shots ? " (shots)" : "";
}

std::string line_text(std::string_view form, std::string_view meaning, RuleGames games) {
    return fmt::format("    {:<25}  {}{}\n", form, meaning, game_text(games));
}

template <typename Rows>
std::string lines_text(const Rows& rows) {
    std::string text;
    for (const auto& row : rows)
        text += line_text(row.name, row.meaning, RuleGames::both);
    return text;
}

std::string event_text(const EventWord& event) {
    return line_text(event.form, event.when, event.games);
}

std::string action_text(const ActionShape& action) {
    return line_text(action.sample, action.does, action.games);
}

std::string quantities_text() {
    std::string text;
    for (const RuleQuantityRow& row : rule_quantities())
        text += line_text(row.name, row.meaning, row.games);
    return text;
}

std::string rules_text() {
    std::string text = "events\n";
    for (const EventWord& event : event_words())
        text += event_text(event);
    text += line_text("TIMER ends", "its time is over", RuleGames::both);
    text += "filters (conditions and values: carom explain if)\n" + lines_text(rule_filters());
    text += "actions, with commas between them\n";
    for (const ActionShape& action : action_shapes())
        text += action_text(action);
    text += action_text(variable_shape());
    return text + "The conditions of all rules of an event are tested before any of them acts.\n";
}

std::string conditions_text() {
    return "conditions\n" + lines_text(condition_forms()) + "numbers that the game keeps\n" +
           quantities_text() + "functions, and the seconds left on a TIMER\n" +
           lines_text(rule_functions());
}

// What is listed below the usage of a statement.
std::string list_text(std::string_view statement) {
    if (statement == "on") return rules_text();
    if (statement == "expect") return "quantities\n" + lines_text(quantities());
    if (statement == "task" || statement == "goal") return conditions_text();
    return {};
}

// A word of the rules: an event, a filter, an action, a number.
std::string rule_word_text(std::string_view word) {
    if (begins_clause(word)) return lines_text(rule_filters()) + conditions_text();
    std::string text;
    for (const EventWord& event : event_words())
        if (event.name == word) text += event_text(event);
    for (const ActionShape& action : action_shapes())
        if (action.name == word) text += action_text(action);
    const auto add = [&](const auto& rows) {
        for (const auto& row : rows)
            if (row.name.substr(0, row.name.find('(')) == word)
                text += line_text(row.name, row.meaning, RuleGames::both);
    };
    add(rule_filters());
    for (const RuleQuantityRow& row : rule_quantities())
        if (row.name == word) text += line_text(row.name, row.meaning, row.games);
    add(rule_functions());
    return text;
}

bool is_meant(std::string_view name, std::string_view wanted) {
    return name == wanted || (name.starts_with(wanted) && name[wanted.size()] == ' ');
}

}  // namespace

int explain(const ExplainOptions& options) {
    if (options.words.empty()) return print_out(all_statements().grammar()) ? 0 : 2;
    const std::string wanted = fmt::format("{}", joined(options.words, " "));
    std::string text;
    std::vector<std::string_view> names;
    for (const Statement& statement : all_statements().rows()) {
        names.push_back(statement.name);
        if (!is_meant(statement.name, wanted)) continue;
        text += (text.empty() ? "" : "\n") + statement_text(statement) + list_text(statement.name);
    }
    if (const std::string of_rules = rule_word_text(wanted); !of_rules.empty())
        text += (text.empty() ? "in rules (on, task, goal):\n" : "\nin rules (on, task, goal):\n") +
                of_rules;
    if (text.empty()) {
        const std::string meant = suggestion(wanted, names);
        print_error(fmt::format("there is no statement '{}'{}", wanted,
                                meant.empty() ? "; `carom explain` prints them all" : meant));
        return 2;
    }
    return print_out(text) ? 0 : 2;
}

}  // namespace carom

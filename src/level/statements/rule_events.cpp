#include "level/statements/rule_events.h"

#include "level/text/spelling.h"

namespace carom {
namespace {

using enum RuleGames;

constexpr EventWord event_rows[] = {
    {"hit",
     RuleEvent::hit,
     {},
     true,
     both,
     "NAME hit [NAME]",
     "they touch; or a ball hits a part of a pinball table"},
    {"all", RuleEvent::all, {}, false, pinball, "NAME all", "the last unlit one lights up"},
    {"enter",
     RuleEvent::enter,
     {},
     true,
     both,
     "NAME enter [ZONE]",
     "a ball comes into a zone, or a part of a pinball table"},
    {"leave",
     RuleEvent::place_left,
     {},
     true,
     shots,
     "NAME leave [ZONE]",
     "a ball goes out of a zone"},
    {"rail", RuleEvent::rail, {}, true, shots, "BALLS rail", "one of them touches any edge"},
    {"pocketed",
     RuleEvent::pocketed,
     {},
     true,
     shots,
     "BALLS pocketed [POCKET]",
     "a pocket or a sink takes it"},
    {"begins", RuleEvent::game_begins, "game", false, both, "game begins", "once, at the start"},
    {"begins", RuleEvent::turn_begins, "turn", false, both, "turn begins",
     "before a player's first shot; at pinball, before each ball"},
    {"begins", RuleEvent::shot_begins, "shot", false, shots, "shot begins",
     "the cue strikes; variables of shot are at their start again"},
    {"ends", RuleEvent::shot_ends, "shot", false, shots, "shot ends", "all balls are at rest"},
    {"judged", RuleEvent::shot_judged, "shot", false, shots, "shot judged",
     "the rules of shot ends have run, so the score is complete"},
    {"launch", RuleEvent::launch, "ball", false, pinball, "ball launch",
     "a ball leaves the plunger"},
    {"drain", RuleEvent::drain, "ball", false, pinball, "ball drain", "a ball leaves the table"},
};

// The first is no clause.
constexpr RuleForm filter_rows[] = {
    {"once", "for the first time in a shot that the two meet (shots)"},
    {"if", "all conditions hold: if A and B; for 'or', write two lines"},
    {"while", "the same as if"},
    {"unless", "not all of them hold"},
};

constexpr RuleForm condition_rows[] = {
    {"A<B", "also <= = != >= >; whole numbers, and + - * without blanks"},
    {"VARIABLE", "it is not 0"},
    {"TIMER", "it runs"},
    {"MOTION", "it runs"},
    {"LAMPS", "all of that name are lit (pinball)"},
};

constexpr RuleForm function_rows[] = {
    {"count(BALLS)", "how many are on the table"},
    {"count(BALLS,ZONE)", "how many of them lie in a zone"},
    {"lit(LAMPS)", "how many are lit (pinball)"},
    {"min(A,B)", "the lower of two numbers"},
    {"max(A,B)", "the higher of two numbers"},
};

}  // namespace

std::span<const RuleForm> rule_filters() {
    return filter_rows;
}

bool begins_clause(std::string_view word) {
    const auto* const row = row_named(filter_rows, word);
    return row && row != filter_rows;
}

std::span<const RuleForm> condition_forms() {
    return condition_rows;
}

std::span<const RuleForm> rule_functions() {
    return function_rows;
}

std::span<const EventWord> event_words() {
    return event_rows;
}

}  // namespace carom

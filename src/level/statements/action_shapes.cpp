#include "level/statements/action_shapes.h"

#include <algorithm>
#include <iterator>

namespace carom {
namespace {

using What = RuleAction::What;
using enum RuleGames;

constexpr ActionShape shapes[] = {
    {"score", What::score, Takes::points, both, "score 100",
     "adds to the score of the player whose turn it is"},
    {"bonus", What::bonus, Takes::sum, pinball, "bonus +1",
     "adds to the bonus, or sets it: bonus 1"},
    {"multiplier", What::multiplier, Takes::sum, pinball, "multiplier +1",
     "adds to the multiplier of the bonus, or sets it", 100.0},
    {"multiball", What::multiball, Takes::count, pinball, "multiball 2",
     "so many balls in play; the table serves those missing", 8.0},
    {"save", What::save, Takes::time, pinball, "save 10s",
     "a ball that drains within this time returns"},
    {"extraball", What::extraball, Takes::nothing, pinball, "extraball",
     "the player gets another ball"},
    {"reset", What::reset, Takes::lights, pinball, "reset NAME", "lights off, drop targets up"},
    {"light", What::light, Takes::lights_and_maybe_time, pinball, "light NAME",
     "lights on; with a time, for so long: light NAME 20s"},
    {"unlight", What::unlight, Takes::lights, pinball, "unlight NAME", "lights off"},
    {"advance", What::advance, Takes::lights, pinball, "advance NAME",
     "lights the first unlit one; the last one gives all"},
    {"open", What::open, Takes::opening_and_maybe_time, pinball, "open NAME 2s",
     "opens a gate or lowers a post; without a time, until shut"},
    {"shut", What::shut, Takes::opening, pinball, "shut NAME", "shuts it"},
    {"release", What::release, Takes::holder, pinball, "release NAME",
     "holes and magnets let go what they hold"},
    {"message", What::message, Takes::text, both, "message \"TEXT\"",
     "shows a text, with values: {score}, {score point|points}"},
    {"start", What::start, Takes::timer_and_maybe_time, both, "start TIMER 20s",
     "a timer or a motion runs; without a time, for its own"},
    {"stop", What::stop, Takes::timer, both, "stop TIMER",
     "a timer or a motion stops, without an event"},
    {"foul", What::foul, Takes::text, shots, "foul \"TEXT\"", "counts a foul, and says why"},
    {"turn", What::turn, Takes::nothing, shots, "turn", "the next player shoots, after this shot"},
    {"respot", What::respot, Takes::balls_and_maybe_place, shots, "respot BALLS ZONE",
     "balls return to their start, or to the middle of a zone"},
    {"remove", What::remove, Takes::balls_and_maybe_side, shots, "remove BALLS outside ZONE",
     "balls leave the table: all, or those inside or outside a zone"},
    {"inhand", What::inhand, Takes::maybe_place, shots, "inhand ZONE",
     "the next shooter places the cue ball, anywhere or in a zone"},
    {"look", What::look, Takes::maybe_place, shots, "look ZONE",
     "the picture shows a zone, or the whole table"},
    {"win", What::win, Takes::nothing, shots, "win",
     "the game ends: the player whose turn it is wins"},
    {"lose", What::lose, Takes::nothing, shots, "lose",
     "the game ends: the player whose turn it is loses"},
    {"end", What::end, Takes::nothing, shots, "end", "the game ends: the score decides"},
};

constexpr ActionShape of_variable{"a variable",  What::set,
                                  Takes::sum,    both,
                                  "VARIABLE +1", "adds to a variable, or sets it: VARIABLE 1"};

}  // namespace

std::span<const ActionShape> action_shapes() {
    return shapes;
}

const ActionShape& variable_shape() {
    return of_variable;
}

const ActionShape& action_shape_of(What what) {
    if (what == What::start_motion) what = What::start;
    if (what == What::stop_motion) what = What::stop;
    const auto found = std::ranges::find(shapes, what, &ActionShape::what);
    return found == std::end(shapes) ? of_variable : *found;
}

WordCounts words_of(Takes takes) {
    switch (takes) {
        case Takes::nothing:
            return {1, 1};
        case Takes::maybe_place:
            return {1, 2};
        case Takes::lights_and_maybe_time:
        case Takes::opening_and_maybe_time:
        case Takes::timer_and_maybe_time:
        case Takes::balls_and_maybe_place:
            return {2, 3};
        case Takes::balls_and_maybe_side:
            return {2, 4};
        default:
            return {2, 2};
    }
}

}  // namespace carom

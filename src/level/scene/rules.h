#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "physics/world/ids.h"

/// The rules of a level, as plain data: one language for pinball and for games of balls and shots.
/// The game executes them (game/rules/rules.h). docs/levels.md is the manual for authors.
///
/// A rule waits for an event, tests conditions, and acts:
///
///     on SUBJECT EVENT [OTHER] [once] [if|while|unless CONDITION [and CONDITION ...]] ACTION, ...
///
/// Three-cushion, the ball game that carom is named after:
///
///     game shots players=2
///     cue ball=white power=0..6m/s             # player 1 strikes white, player 2 yellow
///     cue ball=yellow power=0..6m/s
///     var cushions of shot                     # 0 at the start of each shot
///     var balls of shot
///     on cue rail if balls<2        cushions +1
///     on cue hit ball once          balls +1
///     on shot ends if balls=2 and cushions>=3  score 1
///     on shot ends if balls=2 and cushions<3   turn, message "{cushions} cushions before it"
///     on shot ends if balls<2                  turn, message "no second ball"
///     on shot judged if score=15               win
///
/// A ladder of modes at pinball:
///
///     var mode of player
///     timer hurry 20s
///     on lanes all if mode=0        mode 1, start hurry, reset lanes
///     on ramp enter if mode=1       score 5000*multiplier, mode 2, start hurry
///     on hurry ends if mode>0       mode 0, message "TOO LATE"
///
/// Order of evaluation. Events come in the order in which the game finds them in a tick (contacts
/// by time, then zones, pockets, timers, rest). For each event, all conditions of all its rules are
/// tested first; then the actions of those that hold run in the order of the file. Actions change
/// variables at once. `turn`, `win`, `lose` and `end` take effect after `shot judged`.
///
/// There are no loops: a rule never waits for a variable. The only actions that cause events in the
/// same tick are `advance`, which may complete a group (`all`), and `turn`; and a tick runs at most
/// most_actions_in_a_tick, counts those that it leaves out, and the run says so.
namespace carom {

/// When a variable gets its start value again: never, with each turn, with each shot. A player's
/// variable exists once for each player.
enum class RuleScope : std::uint8_t { game, player, turn, shot };

struct RuleVariable {
    std::string name;
    std::int64_t start = 0;
    RuleScope scope = RuleScope::game;
};

struct RuleTimer {
    std::string name;
    double seconds = 0.0;  ///< that `start NAME` gives it
};

/// A number that the game knows.
enum class RuleQuantity : std::uint8_t {
    score,
    player,
    players,
    ball,
    bonus,
    multiplier,
    innings,
    shots,
    fouls,
    best,
    multiball,
    rest,
    count
};

/// The games that know an action, an event or a number.
enum class RuleGames : std::uint8_t { both, pinball, shots };

struct RuleQuantityRow {
    std::string_view name;
    std::string_view meaning;
    RuleGames games = RuleGames::both;
};
/// What each RuleQuantity is called in rules, and what it is, in their order.
std::span<const RuleQuantityRow> rule_quantities();

/// A step of a value in postfix order, on a stack of whole numbers. Sums and products saturate at
/// most_rule_number, either way.
struct RuleStep {
    enum class What : std::uint8_t {
        number,    ///< pushes `number`
        variable,  ///< pushes the variable with this index
        quantity,  ///< pushes the RuleQuantity
        count,     ///< pushes how many of the balls with this index (RuleBook::balls) are in play,
                   ///< or lie in `place`
        lit,       ///< pushes how many devices of this group are lit
        seconds,   ///< pushes the whole seconds left of this timer, rounded up
        add,
        subtract,
        multiply,
        min,
        max
    };
    What what = What::number;
    std::int64_t number = 0;  ///< or the index
    std::int32_t place = -1;  ///< count: index into RuleBook::places; -1: anywhere

    friend bool operator==(const RuleStep&, const RuleStep&) = default;
};
using RuleValue = std::vector<RuleStep>;

inline constexpr std::int64_t most_rule_number = 1'000'000'000'000'000;
inline constexpr std::size_t most_rule_steps = 64;
inline constexpr std::uint32_t most_actions_in_a_tick = 1000;

struct RuleCondition {
    enum class What : std::uint8_t {
        lit,      ///< all devices of the group are lit
        running,  ///< the timer runs
        moving,   ///< the mover `index` runs
        compare   ///< left and right
    };
    enum class Relation : std::uint8_t { equal, unequal, less, at_most, more, at_least };
    What what = What::compare;
    std::uint32_t index = 0;
    Relation relation = Relation::equal;
    RuleValue left;
    RuleValue right;

    friend bool operator==(const RuleCondition&, const RuleCondition&) = default;
};

/// `if A and B`: all of them hold; `unless A and B`: not all of them do.
struct RuleClause {
    std::vector<RuleCondition> all;
    bool is_not = false;

    friend bool operator==(const RuleClause&, const RuleClause&) = default;
};

/// A text, with values in braces.
struct RuleText {
    struct Clock {
        std::uint32_t timer = 0;  ///< shown as minutes and seconds left: 0:18
    };
    struct Counted {  ///< shown as 1 hit, 2 hits
        RuleValue value;
        std::string one;    ///< hit
        std::string other;  ///< hits
    };
    std::vector<std::variant<std::string, RuleValue, Clock, Counted>> pieces;
};

struct RuleAction {
    enum class What : std::uint8_t {
        score,         ///< adds `value` to the score
        set,           ///< adds `value` to the variable `index`, or sets it
        start,         ///< the timer `index` runs for `seconds`
        stop,          ///< the timer `index` stops, without an event
        start_motion,  ///< the mover `index` runs
        stop_motion,
        message,     ///< shows `text`
        foul,        ///< counts a foul, and shows `text`
        win,         ///< the game ends, and the player wins
        lose,        ///< the game ends, and the player loses
        end,         ///< the game ends; the score decides
        turn,        ///< shots: the turn passes after this shot
        respot,      ///< shots: the balls `index` return to their places, or to `place`
        remove,      ///< shots: the balls `index` leave the table: all, or by `place`
        inhand,      ///< shots: the next shooter places the cue ball, anywhere or in `place`
        look,        ///< shots: the picture shows `place`, or the whole table
        bonus,       ///< pinball: adds `value` to the bonus, or sets it
        multiplier,  ///< pinball: of the bonus
        multiball,   ///< pinball: `value` balls in play
        save,        ///< pinball: drained balls return to play for `seconds`
        extraball,   ///< pinball: the player gets another ball
        reset,       ///< pinball: lights of the group `index` off, its drop targets up
        light,       ///< pinball: lights on, for `seconds`, or 0 until they are switched off
        unlight,     ///< pinball: lights off
        advance,     ///< pinball: the first unlit light on
        open,        ///< pinball: gates or posts open, for `seconds`, or 0 until they are shut
        shut,        ///< pinball: gates or posts shut
        release      ///< pinball: holes and magnets let go what they hold
    };
    What what = What::score;
    bool adds = false;  ///< set, bonus, multiplier
    RuleValue value;
    double seconds = 0.0;
    std::uint32_t index = 0;
    std::int32_t place = -1;  ///< index into RuleBook::places; -1: none
    bool is_outside = false;  ///< remove: those that lie outside of `place`, else inside
    RuleText text;
};

enum class RuleEvent : std::uint8_t {
    // Of devices; the subject is a group of PinballTable.
    hit,    ///< a ball hits one of the group
    all,    ///< the whole group is lit, for the first time since its reset
    enter,  ///< a ball enters one of its zones
    // Of balls; subject and `other` are indices into RuleBook::balls.
    balls_meet,
    rail,      ///< a ball of the subject meets an edge
    pocketed,  ///< a pocket takes it; `other`: a place, or none
    // Of places (RuleBook::places); `other`: balls, or none.
    place_entered,
    place_left,
    edge_hit,  ///< a ball of `other` hits an edge of the place
    // Without a subject.
    game_begins,
    turn_begins,
    shot_begins,
    shot_ends,    ///< all balls are at rest
    shot_judged,  ///< the rules of shot_ends have run
    launch,       ///< pinball: a ball leaves the plunger
    drain,        ///< pinball: a ball leaves the table, saved or not
    timer_ends,   ///< the subject is the timer
    count
};

inline constexpr std::uint32_t no_subject = 0xffffffff;

struct Rule {
    RuleEvent event = RuleEvent::hit;
    std::uint32_t subject = no_subject;
    std::uint32_t other = no_subject;
    bool once = false;  ///< in a shot, once for each pair of things that meet
    int line = 0;       ///< of the level's file
    std::vector<RuleClause> needs;
    std::vector<RuleAction> actions;
};

/// Balls that a rule names: a ball, a rack, a kind; or `ball`, `cue`, `opponent`.
struct RuleBalls {
    enum class Who : std::uint8_t {
        listed,
        any,
        cue,       ///< that which the player whose turn it is strikes
        opponent,  ///< those which the next player strikes
        it         ///< the ball that the event named last
    };
    Who who = Who::listed;
    std::vector<BallId> balls;  ///< as at the start, ascending
    std::int32_t kind = -1;     ///< all of this kind, also those that come later; -1: by `balls`
};

/// Pockets, zones or edges of one name.
struct RulePlace {
    std::string name;
    std::vector<std::uint32_t> zones;  ///< indices into World::zones
    std::vector<CapsuleId> edges;      ///< ascending
};

/// A line that says what to do now: the first whose conditions hold is shown.
struct RuleTask {
    RuleText text;
    std::vector<RuleClause> needs;
    /// Pinball: groups of PinballTable to shoot for. They flash while the task is shown.
    std::vector<std::uint32_t> shots;
};

/// What counts as done in a level, and how well.
struct LevelGoal {
    std::string text;
    std::vector<RuleClause> needs;
    enum class Counts : std::uint8_t {
        shots,
        seconds,
        value,  ///< `with`: the more of `value`, the better
        cost    ///< `within`: the less of `value`, the better
    };
    Counts counts = Counts::shots;
    RuleValue value{};  ///< of Counts::value and cost
    /// For three stars, two and one: at most so many shots or seconds, or that cost, ascending; or
    /// at least that value, descending.
    std::vector<double> limits;
};

/// All rules of a level.
struct RuleBook {
    std::vector<RuleVariable> variables;
    std::vector<RuleTimer> timers;
    std::vector<RuleBalls> balls;
    std::vector<RulePlace> places;
    std::vector<Rule> rules;
    std::vector<RuleTask> tasks;
    std::vector<LevelGoal> goals;  ///< one at most
    std::uint32_t players = 1;

    bool is_shots = false;    ///< `game shots`
    bool least_wins = false;  ///< the lowest score wins
    double settle = 0.0;      ///< s that the balls lie before a shot is judged, to be looked at
    bool may_miss = false;    ///< a stroke may fail, as in a match of pool: `stroke=hand`

    /// Rules by event, and by subject where that is a device or a timer, so that an event looks at
    /// its own rules only: order[first .. last) of its row. Made by index_rules().
    struct Row {
        RuleEvent event{};
        std::uint32_t subject = no_subject;
        std::uint32_t first = 0;
        std::uint32_t last = 0;
    };
    std::vector<Row> rows;             ///< ascending by event and subject
    std::vector<std::uint32_t> order;  ///< indices into `rules`, in the order of the file in a row
};

/// Fills in RuleBook::rows and order.
void index_rules(RuleBook& book);
/// The rules of this event and subject, no_subject where it is neither a device nor a timer; null
/// if there are none.
const RuleBook::Row* rules_of(const RuleBook& book, RuleEvent event, std::uint32_t subject);

}  // namespace carom

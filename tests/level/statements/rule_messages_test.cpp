#include <string>
#include <string_view>

#include <doctest/doctest.h>

#include "level/load.h"

using namespace carom;

// The messages that a first-time author meets. A message helps if it names the fault and a form
// that the language accepts, so the tests compare the words.
namespace {

constexpr std::string_view table = R"(carom 1 "A table with rules"
units mm
use cloth slide=0.2 roll=0.01 spin=10rad/s2
kind ivory r=30 m=210g e=0.95
box 0,0 1400,700 r=10
pocket hole at=1250,350 r=60
zone trap 700,600 700,600 r=50
ball white at=300,350 kind=ivory
ball red at=900,350 kind=ivory
cue ball=white power=0..6m/s
timer hurry 20s
game shots players=2
var hits of shot
on cue hit red   hits +1
on shot ends unless hits  turn
on shot judged if score>=10  win
on hurry ends  foul "slow"
on shot begins  start hurry
)";

LoadResult load(std::string_view lines) {
    return load_level(std::string(table) + std::string(lines) + "\n", "table.level", {});
}

struct Told {
    std::string_view line;
    std::string_view message;  // or a part of it
    std::string_view remedy;
};

void check_that(const Told& told) {
    CAPTURE(told.line);
    const LoadResult result = load(told.line);
    REQUIRE(result.diagnostics.size() == 1);
    const Diagnostic& diagnostic = result.diagnostics.front();
    CAPTURE(diagnostic.message);
    CAPTURE(diagnostic.remedy);
    CHECK(diagnostic.message.find(told.message) != std::string::npos);
    CHECK(diagnostic.remedy.find(told.remedy) != std::string::npos);
}

}  // namespace

TEST_CASE("rules: the table of these tests has no faults of its own") {
    CHECK(load("").diagnostics.empty());
}

TEST_CASE("rules: the message about an unknown event lists the events that exist") {
    constexpr Told cases[] = {
        {"on shots ends  score 1", "'shots' neither begins nor ends", "'shot'"},
        {"on patience ends  turn", "'patience' neither begins", "timer patience 20s"},
        {"on timer hurry ends  turn", "by its name alone", "on hurry ends"},
        {"on player 2 begins  score 1", "no events of its own", "on turn begins if player=2"},
        {"on red potted  score 1", "no event 'potted'", "'pocketed'"},
        {"on red is pocketed  score 1", "no event 'is'", "on red pocketed"},
        {"on hit red cue  score 1", "'hit' stands behind", "on red hit"},
        {"on red pocketed in hole  score 1", "do without 'in'", "on red pocketed corner"},
        {"on hole pocketed  score 1", "their name stands first", "on ball pocketed hole"},
        {"on cue hit red and white  score 1", "waits for one event", "the line twice"},
        {"on cue hit red, turn", "no comma stands behind the event", "leave the comma out"},
        {"on CUE hit red  score 1", "'CUE'", "'cue'"},
        {"on cue hit rail  score 1", "no edge is called 'rail'", "rail in place of hit"},
        {"on cue hit wall  score 1", "no edge is called 'wall'", "on cue rail"},
        {"if hits>1  score 1", "'if' is not a statement", "'on'"},
    };
    for (const Told& told : cases)
        check_that(told);
}

TEST_CASE("rules: conditions from other languages get their form in this one") {
    constexpr Told cases[] = {
        {"on shot ends hits>1  score 1", "'hits>1' is a condition", "write if before it"},
        {"on shot ends if hits=>1  score 1", "no '=>'", ">="},
        {"on shot ends if hits=<1  score 1", "no '=<'", "<="},
        {"on shot ends if hits<>1  score 1", "no '<>'", "!="},
        {"on shot ends if (hits>1)  score 1", "brackets do not group", "join them by and"},
        {"on shot ends if hits>1:  score 1", "no ':'", "a blank ends a condition"},
        {"on shot ends if score >= 10:  win", "no ':'", "a blank ends a condition"},
        {"on shot ends if player is 1  score 1", "no 'is'", "player=1"},
        {"on shot ends if count red = 0  score 1", "count needs brackets", "count(red)=0"},
        {"on shot ends if count(red, trap)=1  score 1", "ends within its brackets", "blanks"},
        {"on shot ends if count(red)=0,hits=1  score 1", "no comma joins", "write and"},
        {"on shot ends if red=0  score 1", "'red' names balls", "count(red)"},
        {"on shot ends if turn=2  score 1", "'turn' is an action", "player"},
        {"on shot ends if score of player 1>3  win", "there is no 'of'", "player=1"},
        {"on shot ends if red in trap  score 1", "no 'in' in conditions", "count(red,tray)>0"},
        {"on shot ends if count(trap)>0  score 1", "'trap' names a place", "count(ball,trap)"},
        {"on shot ends if player 1  score 1", "a sign is missing before '1'", "player=1"},
        {"on shot ends if red  score 1", "'red' names balls", "if count(red)>0"},
        {"on shot ends if trap  score 1", "'trap' names a place", "if count(ball,trap)>0"},
        {"task \"A\" if 0", "'0' is a number", "has no if"},
        {"task \"A\" unless 2*3", "'2*3' is a number", "has no if"},
        {"let n=3\ntask \"A\" if n", "'n' is a number", "has no if"},
    };
    for (const Told& told : cases)
        check_that(told);
}

TEST_CASE("rules: actions and variables from other languages get their form in this one") {
    constexpr Told cases[] = {
        {"on shot ends  score = score + 1", "without '='", "score +1"},
        {"on shot ends  hits=hits+1", "blank is missing", "hits +1"},
        {"on shot ends  score - 1", "no blanks", "score -1"},
        {"on shot ends  score 2 * hits", "no blanks", "score 2*"},
        {"on shot ends  hits -=1", "'-=1' is not a value", "made -1"},
        {"on shot ends  total +1", "no action 'total'", "var total"},
        {"on shot ends  score 1,", "an action is missing", "leave the comma out"},
        {"on shot ends  add score 1", "without 'add'", "score 1"},
        {"on shot ends  add 2 to hits", "without 'add'", "hits +2"},
        {"on shot ends  subtract 1 from score", "without 'subtract'", "score -1"},
        {"on shot ends  set hits 3", "without 'set'", "hits 3"},
        {"on shot ends  set score 3", "without 'set'", "which adds"},
        {"on shot ends  add 1", "without 'add'", "name what it changes"},
        {"on shot ends  score player 1", "whose turn it is", "score 100"},
        {"on shot ends  score 1 for opponent", "whose turn it is", "player=2"},
        {"on shot ends  win player 2", "whose turn it is", "lose"},
        {"on shot ends  turn player 2", "whose turn it is", "the next player shoots"},
        {"on shot ends  win now", "takes nothing behind it", "write it alone"},
        {"on shot ends  end 3", "takes nothing behind it", "the score decides"},
        {"on red pocketed hole trap  score 1", "'hole' is the name of a pocket", "line twice"},
        {"on shot ends  respot red to trap", "without 'to'", "respot BALLS ZONE"},
        {"var made=3", "no key 'made'", "var NAME [of"},
        {"on shot ends  red 1", "'red' is the name of a ball", "respot NAME"},
        {"on shot ends  start 20s", "no timer or motion '20s'", "start TIMER 20s"},
        {"on shot ends  message \"{hits hit}\"", "has no blanks", "{made point|points}"},
        {"on shot ends  message \"{2 * hits}\"", "has no blanks", "{made}"},
        {"on shot ends  message \"{hits |hits}\"", "has no blanks", "{made}"},
        {"on shot ends  message \"{maid hit|hits}\"", "'maid' is not known", "declare it"},
        {"var made start 3", "'3' is not expected", "var made start=3"},
        {"var made on shot", "'on' is not expected", "var made of shot"},
    };
    for (const Told& told : cases)
        check_that(told);
}

TEST_CASE("rules: a goal says what its limits are and when it is reached") {
    constexpr Told cases[] = {
        {"goal \"x\" within 3 shot if hits", "'shot'", "'shots'"},
        {"goal \"x\" within 3 2 1 shots if hits", "at most so much", "within 1 2 3 shots"},
        {"goal \"x\" with 1 2 3 of hits if hits", "at least so much", "with 5 4 3 of made"},
        {"goal \"x\" within 1 2 3 4 shots if hits", "three limits at most", "leave this one out"},
        {"goal \"x\" within 3 shots", "does not say when", "if count(red)=0"},
        {"goal \"x\" if hits within 3 shots", "before the condition", "within N"},
        {"goal x within 3 shots if hits", "in quotes", "goal \"Pocket the red.\""},
    };
    for (const Told& told : cases)
        check_that(told);
}

TEST_CASE("rules that can do nothing are warned of") {
    constexpr Told cases[] = {
        {"on shot ends if hits>1 and hits<1  score 1", "never hold together", "two lines"},
        {"on shot ends if hits unless hits  score 1", "never hold together", "two lines"},
        {"on shot ends if hits=1 if 2=hits  score 1", "never hold together", "two lines"},
        {"on shot ends if count(red)=2  score 1", "such a count is 0 to 1", "that it can have"},
        {"on shot ends if count(ball)<0  score 1", "such a count is 0 to 2", "that it can have"},
        {"on shot ends if hurry<0  score 1", "0 or more", "that it can have"},
        {"on shot ends if count(red,hole)=1  score 1", "never holds", "on BALLS pocketed"},
        {"on red pocketed trap  score 1", "balls pass through 'trap'", "sink"},
        {"on cue hit opponent  score 1", "the cue ball itself", "for each player"},
        {"task \"A\"\ntask \"B\" if hits", "hides this one", "last"},
        {"task \"A\" if hits>1 and hits<1", "never hold together", "two lines"},
        {"goal \"A\" if count(red)>1", "such a count is 0 to 1", "that it can have"},
        {"var total\non shot ends if total>3  score 1", "nothing sets", "total +1"},
        {"on shot judged if score>=10  lose", "also ends with 'win' in line 16", "keep one"},
        {"on shot judged if fouls=3  lose, win", "also ends with 'lose'", "keep one"},
        {"on shot judged if score>=20  lose", "'win' in line 16 comes first", "take it out"},
        {"on shot judged if score=15  end", "'win' in line 16 comes first", "take it out"},
        {"on shot ends once  score 1", "'once' does nothing behind 'ends'", "a variable of shot"},
        {"on red pocketed once  score 1", "'once' does nothing behind", "leave it out"},
        {"on cue leave trap once  score 1", "'once' does nothing behind", "leave it out"},
        {"on shot ends  inhand hole", "takes the ball that is placed", "inhand ZONE"},
        {"on shot ends  respot red hole", "takes the ball that is placed", "respot BALLS ZONE"},
        {"on shot ends  remove red inside hole", "no ball ever lies", "BALLS inside ZONE"},
        {"on shot ends if multiball  score 1", "of game pinball", "with a variable"},
        {"on shot ends  score bonus", "of game pinball", "with a variable"},
        {"task \"BALL {ball}\"", "of game pinball", "with a variable"},
        {"task \"{multiplier X|XX}\"", "of game pinball", "with a variable"},
        {"on shot ends if hits<0  score 1", "'hits' is 0 or more", "that it can have"},
        {"var made of shot\non red pocketed  made 1\non shot ends if made=2  score 1",
         "'made' is 0 to 1", "that it can have"},
        {"var left start=3\non red pocketed  left -1\non shot ends if left>3  score 1",
         "'left' is 3 or less", "that it can have"},
    };
    for (const Told& told : cases) {
        check_that(told);
        CHECK(load(told.line).scene);
    }
}

TEST_CASE("rules that resemble those without effect are not warned of") {
    for (const std::string_view lines :
         {"on shot ends if hits>=1 and hits<=1  score 1",
          "on shot ends if hits=2  score 1",
          "on shot ends if hits!=0 unless hits=1  score 1",
          "on shot ends unless hits>1 and hits<1  score 1",
          "on shot ends if count(red,trap)=1  score 1",
          "on shot ends if count(ball)=2  score 1",
          "on ball pocketed hole  score 1",
          "task \"A\" if hits\ntask \"B\"",
          "var par start=3\non shot ends if hits>par  score 1",
          "on shot judged if score>=11  lose",
          "on shot judged if score>=20 and fouls  lose",
          "on shot judged if score>=5 and hurry  lose",
          "on shot judged if fouls>=20  lose",
          "on shot judged if score>=20  win",
          "on cue hit red once  score 1",
          "on cue rail once  score 1",
          "on cue enter trap once  score 1",
          "on shot ends  inhand trap",
          "var pot\non red pocketed  pot hits-1\non shot ends if pot<0  score 1",
          "var pot\non red pocketed  pot -hits\non shot ends if pot<0  score 1",
          "var pot\non red pocketed  pot +score\non shot ends if pot<0  score 1",
          "on shot judged if score>=10  win"}) {
        CAPTURE(lines);
        CHECK(load(lines).diagnostics.empty());
    }
}

TEST_CASE("the message about a taken name says what has it, and where") {
    constexpr Told cases[] = {
        {"ball red at=500,500 kind=ivory", "taken by the ball in line 9", "of its own"},
        {"zone red 500,500 500,500 r=9", "taken by the ball in line 9", "choose another"},
        {"rack triangle reds at=500,350 kind=ivory\nzone reds 500,500 500,500 r=9",
         "taken by the rack in line 19", "choose another"},
        {"kind ivory r=9", "taken by the kind in line 4", "of its own"},
        {"var hurry", "taken by the timer in line 11", "choose another"},
        {"timer hits 3s", "taken by the variable in line 13", "choose another"},
    };
    for (const Told& told : cases)
        check_that(told);
}

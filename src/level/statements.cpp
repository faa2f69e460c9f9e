#include "level/statements.h"

#include <algorithm>

namespace carom {
namespace {

using enum Form;
using enum Bound;

std::vector<Statement> make_statements() {
    constexpr auto number = Measure::number;
    constexpr auto whole = Measure::whole;
    constexpr auto length = Measure::length;
    constexpr auto angle = Measure::angle;
    constexpr auto time = Measure::time;
    constexpr auto mass = Measure::mass;
    constexpr auto speed = Measure::speed;
    const KeyRule at{"at", pair, length, any, true};
    const KeyRule kind{"kind", word};
    const KeyRule material{"material", word};
    const KeyRule ball_radius{"r", scalar, length, positive};
    const KeyRule edge_radius{"r", scalar, length, not_negative};
    const KeyRule side{"side", word};
    const KeyRule restitution{"e", scalar, number, share};
    const KeyRule friction{"mu", scalar, number, not_negative};
    const KeyRule ball_mass{"m", scalar, mass, positive};

    std::vector<Statement> all{
        {.name = "carom",
         .usage = R"(carom 1 "TITLE")",
         .place = Place::top,
         .plain_least = 2,
         .plain_most = 2},
        {.name = "physics",
         .usage = "physics 1",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1},
        {.name = "units",
         .usage = "units mm|cm|m|in",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1},
        {.name = "let", .usage = "let NAME=NUMBER ...", .takes_any_key = true},
        {.name = "world",
         .usage = "world X0,Y0 X1,Y1",
         .place = Place::top,
         .points_least = 2,
         .points_most = 2},
        {.name = "use gravity",
         .usage = "use gravity X,Y",
         .place = Place::top,
         .points_least = 1,
         .points_most = 1,
         .point_measure = Measure::acceleration},
        {.name = "use drag",
         .usage = "use drag RATE",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1},
        {.name = "use stop",
         .usage = "use stop SPEED",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1},
        {.name = "use limit",
         .usage = "use limit SPEED",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1},
        {.name = "use scatter",
         .usage = "use scatter ANGLE",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1},
        {.name = "use wrap", .usage = "use wrap", .place = Place::top},
        {.name = "use overlap", .usage = "use overlap", .place = Place::top},
        {.name = "use spin", .usage = "use spin", .place = Place::top, .is_in_version = false},
        {.name = "use cloth",
         .usage = "use cloth slide= roll= spin= [g=]",
         .place = Place::top,
         .is_in_version = false},
        {.name = "collide",
         .usage = "collide A B     (kinds, materials, ball, edge)",
         .place = Place::top,
         .plain_least = 2,
         .plain_most = 2},
        {.name = "solver",
         .usage = "solver discrete|substep|swept [updates=] [steps=] [substeps=]",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1,
         .keys = {{"updates", scalar, whole, up_to_thousand},
                  {"steps", scalar, whole, up_to_thousand},
                  {"substeps", scalar, whole, up_to_thousand}}},
        {.name = "rate",
         .usage = "rate HZ",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1},
        {.name = "seed", .usage = "seed N", .place = Place::top, .plain_least = 1, .plain_most = 1},
        {.name = "kind",
         .usage = "kind NAME [r=] [m=] [density=] [e=] [mu=]",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1,
         .keys = {ball_radius,
                  ball_mass,
                  {"density", scalar, Measure::density, positive},
                  restitution,
                  friction}},
        {.name = "material",
         .usage = "material NAME [e=] [soften=] [mu=]",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1,
         .keys = {restitution, {"soften", scalar, Measure::soften, not_negative}, friction}},
        {.name = "ball",
         .usage = "ball [NAME] at=X,Y [kind=] [v=VX,VY] [r=] [m=] [e=] [w=]",
         .plain_most = 1,
         .keys = {at,
                  kind,
                  {"v", pair, speed},
                  ball_radius,
                  ball_mass,
                  restitution,
                  {"w", scalar, number},
                  friction}},
        {.name = "edge",
         .usage = "edge [MATERIAL] [NAME] X,Y X,Y ... [r=] [close] [fillet=] [side=left|right]",
         .plain_most = 2,
         .points_least = 2,
         .points_most = many,
         .keys = {edge_radius, {"fillet", scalar, length, not_negative}, side},
         .flags = {"close"}},
        {.name = "arc",
         .usage = "arc [MATERIAL] [NAME] at=X,Y radius= [from=] [to=] [r=] [side=left|right]",
         .plain_most = 2,
         .keys = {at,
                  {"radius", scalar, length, positive, true},
                  {"from", scalar, angle},
                  {"to", scalar, angle},
                  edge_radius,
                  side}},
        {.name = "peg",
         .usage = "peg [MATERIAL] [NAME] at=X,Y r=",
         .plain_most = 2,
         .keys = {at, {"r", scalar, length, not_negative, true}}},
        {.name = "box",
         .usage = "box [MATERIAL] [NAME] X0,Y0 X1,Y1 [r=] [fillet=] [side=left|right]",
         .plain_most = 2,
         .points_least = 2,
         .points_most = 2,
         .keys = {edge_radius, {"fillet", scalar, length, not_negative}, side}},
        {.name = "spawn",
         .usage = "spawn KIND at=X,Y every=TIME count=N [v=VX,VY] [jitter=DX,DY] [vjitter=DVX,DVY]",
         .plain_least = 1,
         .plain_most = 1,
         .keys = {at,
                  {"every", scalar, time, positive, true},
                  {"count", scalar, whole, positive, true},
                  {"v", pair, speed},
                  {"jitter", pair, length, not_negative},
                  {"vjitter", pair, speed, not_negative}}},
        {.name = "fill",
         .usage = "fill [KIND] count=N box=X0,Y0,X1,Y1 [r=A..B] [m=A..B] [density=] [e=] "
                  "[v=VX,VY] [speed=A..B] [rms=]",
         .plain_most = 1,
         .keys = {{"count", scalar, whole, positive, true},
                  {"box", Form::box, length, any, true},
                  {"r", deferred, length, positive},
                  {"m", range, mass, positive},
                  {"density", scalar, Measure::density, positive},
                  restitution,
                  {"v", pair, speed},
                  {"speed", range, speed, not_negative},
                  {"rms", scalar, speed, not_negative}}},
        {.name = "pegs triangle",
         .usage = "pegs triangle [NAME] at=X,Y rows=N pitch= r= [row=] [material=]",
         .plain_most = 1,
         .keys = {at,
                  {"rows", scalar, whole, positive, true},
                  {"pitch", scalar, length, positive, true},
                  {"r", scalar, length, not_negative, true},
                  {"row", scalar, length, positive},
                  material}},
        {.name = "pegs grid",
         .usage = "pegs grid [NAME] at=X,Y rows=N columns=N pitch= r= [row=] [material=] [stagger]",
         .plain_most = 1,
         .keys = {at,
                  {"rows", scalar, whole, positive, true},
                  {"columns", scalar, whole, positive, true},
                  {"pitch", scalar, length, positive, true},
                  {"r", scalar, length, not_negative, true},
                  {"row", scalar, length, positive},
                  material},
         .flags = {"stagger"}},
        {.name = "bins",
         .usage = "bins [NAME] at=X,Y count=N width= depth= [wall=] [material=] [sink] [open]",
         .plain_most = 1,
         .keys = {at,
                  {"count", scalar, whole, positive, true},
                  {"width", scalar, length, positive, true},
                  {"depth", scalar, length, positive, true},
                  {"wall", scalar, length, not_negative},
                  material},
         .flags = {"sink", "open"}},
        {.name = "zone",
         .usage = "zone [NAME] X,Y X,Y r= [sink]",
         .plain_most = 1,
         .points_least = 2,
         .points_most = 2,
         .keys = {{"r", scalar, length, positive, true}},
         .flags = {"sink"}},
        {.name = "cradle",
         .usage = "cradle [NAME] at=X,Y count=N v=SPEED [in=N] [gap=] [swing=] [r=] [m=] [e=] "
                  "[kind=] [material=]",
         .plain_most = 1,
         .keys = {at,
                  {"count", scalar, whole, positive, true},
                  {"v", scalar, speed, not_negative, true},
                  {"in", scalar, whole, positive},
                  {"gap", scalar, length, not_negative},
                  {"swing", scalar, length, positive},
                  ball_radius,
                  ball_mass,
                  restitution,
                  kind,
                  material}},
        {.name = "mirror",
         .usage = "mirror [x=X] [y=Y] ... end",
         .opens_block = true,
         .keys = {{"x", scalar, length}, {"y", scalar, length}}},
        {.name = "repeat",
         .usage = "repeat N [NAME] [step=DX,DY] ... end",
         .opens_block = true,
         .plain_least = 1,
         .plain_most = 2,
         .keys = {{"step", pair, length}}},
        {.name = "part",
         .usage = "part NAME [KEY=[NUMBER] ...] ... end",
         .place = Place::top,
         .opens_block = true,
         .plain_least = 1,
         .plain_most = 1,
         .takes_any_key = true},
        {.name = "place",
         .usage = "place NAME at=X,Y [turn=ANGLE] [flip] [KEY=NUMBER ...]",
         .plain_least = 1,
         .plain_most = 1,
         .keys = {at, {"turn", scalar, angle}},
         .flags = {"flip"},
         .takes_any_key = true},
        {.name = "include", .usage = R"(include "FILE")", .plain_least = 1, .plain_most = 1},
        {.name = "map",
         .usage = "map cell=S [at=X,Y] [r=] [kind=] [material=] ... end",
         .opens_block = true,
         .keys = {{"cell", scalar, length, positive, true},
                  {"at", pair, length},
                  edge_radius,
                  kind,
                  material}},
        {.name = "legend ball",
         .usage = "legend ball LETTER [kind=] [v=VX,VY]",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1,
         .keys = {kind, {"v", pair, speed}}},
        {.name = "legend peg",
         .usage = "legend peg LETTER [material=] [r=]",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1,
         .keys = {material, edge_radius}},
        {.name = "legend solid",
         .usage = "legend solid LETTER [material=]",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1,
         .keys = {material}},
        {.name = "game",
         .usage = "game sandbox|galton",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1},
        {.name = "show histogram",
         .usage = "show histogram of=NAME [against=binomial(N,P)|uniform]",
         .place = Place::top,
         .keys = {{"of", word, number, any, true}, {"against", call}}},
        {.name = "show energy", .usage = "show energy", .place = Place::top},
        {.name = "expect",
         .usage = "expect QUANTITY VALUE within TOLERANCE [at=TIME]",
         .place = Place::top,
         .plain_least = 4,
         .plain_most = 4,
         .keys = {{"at", scalar, time, not_negative}}},
        {.name = "end", .usage = "end"},
    };
    for (const std::string_view later :
         {"rack", "pocket", "cue", "flipper", "bumper", "slingshot", "plunger", "gate", "rollover",
          "droptarget", "drain", "on"}) {
        all.push_back({.name = later, .usage = later, .is_in_version = false});
    }
    return all;
}

const std::vector<Statement>& table() {
    static const std::vector<Statement> statements = make_statements();
    return statements;
}

std::string_view first_word(std::string_view name) {
    return name.substr(0, name.find(' '));
}

}  // namespace

std::span<const Statement> statements() {
    return table();
}

const Statement* statement_named(std::string_view name) {
    const auto found = std::ranges::find(table(), name, &Statement::name);
    return found == table().end() ? nullptr : &*found;
}

std::vector<std::string_view> keywords() {
    std::vector<std::string_view> result;
    for (const Statement& statement : table()) {
        const std::string_view word = first_word(statement.name);
        if (std::ranges::find(result, word) == result.end()) result.push_back(word);
    }
    return result;
}

std::vector<std::string_view> second_words(std::string_view keyword) {
    std::vector<std::string_view> result;
    for (const Statement& statement : table()) {
        const std::string_view first = first_word(statement.name);
        if (first != keyword || first.size() == statement.name.size()) continue;
        result.push_back(statement.name.substr(first.size() + 1));
    }
    return result;
}

std::string grammar() {
    std::string result;
    for (const Statement& statement : table()) {
        if (statement.is_in_version) result.append(statement.usage).append("\n");
    }
    return result;
}

}  // namespace carom

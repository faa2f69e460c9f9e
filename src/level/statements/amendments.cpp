#include <fmt/format.h>

#include "level/ir/arguments.h"
#include "level/ir/context.h"
#include "level/statements/families.h"

/// `move` and `remove`: they change what other statements have placed. A level that is saved in
/// play keeps its author's text, and says with these what has changed.
namespace carom {
namespace {

// Names the body by its name, or by its number among the balls or among the edges.
std::optional<AmendmentIr> amendment_of(const Arguments& arguments, Context& context) {
    AmendmentIr amendment;
    amendment.span = arguments.node->keyword().span();
    if (!arguments.plain.empty()) amendment.name = arguments.plain.front();
    if (arguments.has("ball")) amendment.ball = arguments.count("ball");
    if (arguments.has("edge")) amendment.edge = arguments.count("edge");
    const int ways = int{amendment.name.has_value()} + int{amendment.ball.has_value()} +
                     int{amendment.edge.has_value()};
    if (ways == 1) return amendment;
    context.reporter.error("amends-what", amendment.span,
                           fmt::format("{} needs one ball or edge", arguments.statement->name),
                           "write its name, or ball=NUMBER, or edge=NUMBER");
    return std::nullopt;
}

void build_move(const Arguments& arguments, const Frame&, Context& context) {
    auto amendment = amendment_of(arguments, context);
    if (!amendment) return;
    const auto pair = [&](std::string_view key) {
        return arguments.has(key) ? std::optional(arguments.pair_or(key, {})) : std::nullopt;
    };
    amendment->position = pair("at");
    amendment->velocity = pair("v");
    amendment->roll = pair("roll");
    amendment->spin = arguments.number("w");
    amendment->ends = arguments.points;
    amendment->clock = arguments.number("time");
    amendment->tilt = arguments.number("tilt");
    amendment->turning = arguments.number("turning");
    if (arguments.flag("runs") || arguments.flag("waits")) amendment->runs = arguments.flag("runs");
    const bool is_of_body = amendment->position || amendment->velocity || amendment->roll ||
                            amendment->spin || !amendment->ends.empty();
    if (amendment->is_of_motion() && (is_of_body || !amendment->name)) {
        context.reporter.error("amends-otherwise", amendment->span,
                               "a motion has a name, and time=, runs or waits",
                               "write such as: move blades time=1.5s");
        return;
    }
    if (amendment->is_of_seesaw() &&
        (is_of_body || amendment->is_of_motion() || !amendment->name)) {
        context.reporter.error(
            "amends-otherwise", amendment->span,
            "a seesaw has a name, and tilt= and turning=", "write such as: move plank tilt=10deg");
        return;
    }
    context.ir.amendments.push_back(std::move(*amendment));
}

void build_remove(const Arguments& arguments, const Frame&, Context& context) {
    auto amendment = amendment_of(arguments, context);
    if (!amendment) return;
    amendment->removes = true;
    context.ir.amendments.push_back(std::move(*amendment));
}

}  // namespace

std::vector<Statement> amendment_statements() {
    using enum KeyShape;
    const KeyRule ball{"ball", scalar, Measure::whole, Bound::not_negative};
    const KeyRule edge{"edge", scalar, Measure::whole, Bound::not_negative};
    return {
        {.name = "move",
         .usage = "move [NAME] [ball=N] [edge=N] [X,Y [X,Y]] [at=X,Y] [v=VX,VY] [w=] [roll=VX,VY] "
                  "[time=TIME] [runs] [waits] [tilt=ANGLE] [turning=]",
         .action = build_move,
         .place = Place::top,
         .plain_most = 1,
         .points_most = 2,
         .keys = {ball,
                  edge,
                  {"at", pair, Measure::length},
                  {"v", pair, Measure::speed},
                  {.name = "w", .measure = Measure::angular_speed, .needs_spin = true},
                  {"roll", pair, Measure::speed},
                  {"time", scalar, Measure::time, Bound::not_negative},
                  {"tilt", scalar, Measure::angle},
                  {"turning", scalar, Measure::angular_speed}},
         .flags = {"runs", "waits"}},
        {.name = "remove",
         .usage = "remove [NAME] [ball=N] [edge=N]",
         .action = build_remove,
         .place = Place::top,
         .plain_most = 1,
         .keys = {ball, edge}},
    };
}

}  // namespace carom

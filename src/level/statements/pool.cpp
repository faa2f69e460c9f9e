#include <fmt/format.h>

#include "level/ir/arguments.h"
#include "level/ir/emit.h"
#include "level/scene/games.h"
#include "level/scene/racking.h"
#include "level/statements/families.h"
#include "level/statements/keys.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

std::optional<Vec2> toward_of(const Arguments& arguments, Context& context) {
    const auto word = arguments.word("toward");
    if (!word || word->text == "east") return Vec2{1.0, 0.0};
    if (word->text == "west") return Vec2{-1.0, 0.0};
    if (word->text == "north") return Vec2{0.0, 1.0};
    if (word->text == "south") return Vec2{0.0, -1.0};
    context.reporter.error("unknown-direction", word->span(),
                           fmt::format("'{}' is no way to go", word->text),
                           did_you_mean(word->text, {"east", "west", "north", "south"},
                                        "write toward=east, west, north or south"));
    return std::nullopt;
}

void build_rack(const Arguments& arguments, const Frame& frame, Context& context) {
    RackIr rack;
    rack.layout = rack_layout(arguments.statement->name);
    const auto toward = toward_of(arguments, context);
    if (!toward) return;
    BallBinding binding;
    binding.node = arguments.node;
    if (!arguments.plain.empty()) binding.name = arguments.plain.front();
    binding.kind = arguments.word("kind");
    binding.is_numbered = true;
    rack.binding = name_balls(binding, context);
    rack.foot = arguments.pair_or("at", {});
    rack.toward = *toward;
    rack.gap = arguments.number_or("gap", 0.0);
    if (arguments.has("seed"))
        rack.seed = static_cast<std::uint64_t>(arguments.number_or("seed", 0.0));
    for (const RackedBall& place : racked({rack.layout, rack.toward, rack.gap, rack.seed}, 0)) {
        BallIr ball;
        ball.position = rack.foot + place.shift;
        ball.racked = place.grid;
        ball.gap = place.gap;
        ball.binding = rack.binding;
        ball.origin = Origin(arguments.span_of("at"));
        emit_ball(ball, frame, context);
    }
    context.ir.racks.push_back(rack);
}

void build_pocket(const Arguments& arguments, const Frame& frame, Context& context) {
    reserve_zones(1, arguments.span_of("r"), context);
    Zone zone;
    const Vec2 at = frame.transform.point(arguments.pair_or("at", {}));
    zone.shape = {at, at, arguments.number_or("r", 0.0)};
    zone.effect = Zone::Effect::sink;
    EdgeBinding names{arguments.node, arguments.plain, false, {}};
    names.makes_edges = false;
    const int binding = bind_edges(names, context);
    ZoneIr spec{zone, binding, Origin(arguments.span_of("r"), frame.image)};
    spec.is_pocket = true;
    context.ir.zones.push_back(spec);
}

void add_cue(const Arguments& arguments, const Frame&, Context& context) {
    const auto& power = arguments.values.at("power").numbers;
    context.ir.cues.push_back(
        {*arguments.word("ball"), power[0], power[1], arguments.number_or("scatter", 0.0)});
}

// One statement for each layout.
std::vector<Statement> rack_statements() {
    static const std::vector<std::string> usages = [] {
        std::vector<std::string> lines;
        for (const RackLayout& layout : rack_layouts())
            lines.push_back(std::string(layout.statement) +
                            " [NAME] at=X,Y [kind=] [toward=east|west|north|south] [gap=] [seed=]");
        return lines;
    }();
    std::vector<Statement> statements;
    for (const RackLayout& layout : rack_layouts())
        statements.push_back(
            {.name = layout.statement,
             .usage = usages[statements.size()],
             .action = build_rack,
             .place = Place::top,
             .plain_most = 1,
             .keys = {keys::at,
                      keys::kind,
                      {"toward", KeyShape::word},
                      {"gap", KeyShape::scalar, Measure::length, Bound::not_negative},
                      {"seed", KeyShape::scalar, Measure::whole, Bound::not_negative}},
             .binds_names = true});
    return statements;
}

}  // namespace

std::vector<Statement> pool_statements() {
    using enum KeyShape;
    using enum Bound;
    std::vector<Statement> statements = rack_statements();
    const std::vector<Statement> others{
        {.name = "pocket",
         .usage = "pocket [NAME] at=X,Y r=",
         .action = build_pocket,
         .plain_most = 1,
         .keys = {keys::at, {"r", scalar, Measure::length, positive, true}},
         .binds_names = true},
        {.name = "cue",
         .usage = "cue ball=NAME power=A..B [scatter=ANGLE]",
         .action = add_cue,
         .place = Place::top,
         .keys = {{"ball", word, Measure::number, any, true},
                  {"power", range, Measure::speed, not_negative, true},
                  {"scatter", scalar, Measure::angle, not_negative}}},
    };
    statements.insert(statements.end(), others.begin(), others.end());
    return statements;
}

}  // namespace carom

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "geometry/elementary.h"
#include "level/ir/arguments.h"
#include "level/ir/emit.h"
#include "level/scene/games.h"
#include "level/statements/families.h"
#include "level/statements/keys.h"
#include "level/text/spelling.h"
#include "physics/world/random.h"

namespace carom {
namespace {

constexpr double row_height = 0.86602540378443865;  // sqrt(3)/2: equal gaps all around

// The positions of a rack, row by row from the apex, in units of the distance between neighbours: x
// away from the apex, y to the left.
std::vector<Vec2> places_of(const RackLayout& layout) {
    std::vector<Vec2> places;
    for (std::size_t row = 0; row < layout.rows.size(); ++row) {
        const int count = layout.rows[row];
        for (int i = 0; i < count; ++i)
            places.push_back({static_cast<double>(row) * row_height, 0.5 * (count - 1.0) - i});
    }
    return places;
}

// Puts one ball of each group into the rear corners, if both have balls of one group.
void part_groups(const RackLayout& layout, std::vector<int>& numbers) {
    const std::size_t right = numbers.size() - 1;
    const std::size_t left = numbers.size() - static_cast<std::size_t>(layout.rows.back());
    const auto is_low = [&](std::size_t place) { return numbers[place] < layout.group_border; };
    const auto is_placed = [&](std::size_t place) {
        return std::ranges::count(layout.placed, static_cast<int>(place),
                                  &RackLayout::Placed::place) > 0;
    };
    if (is_low(left) != is_low(right)) return;
    const bool wants_low = !is_low(left);
    for (std::size_t i = 0; i < right; ++i) {
        if (i == left || is_placed(i) || is_low(i) != wants_low) continue;
        return std::swap(numbers[i], numbers[right]);
    }
}

// The number of the ball at each position: shuffled by the seed, except where the rules prescribe
// it.
std::vector<int> numbers_of(const RackLayout& layout, std::uint64_t seed) {
    std::vector<int> numbers(static_cast<std::size_t>(layout.balls()));
    std::iota(numbers.begin(), numbers.end(), 1);
    if (!layout.is_shuffled) return numbers;
    for (std::size_t i = numbers.size(); i-- > 1;) {
        const std::uint64_t other = random_bits(seed, RandomStream::rack, 0, i) % (i + 1);
        std::swap(numbers[i], numbers[static_cast<std::size_t>(other)]);
    }
    for (const RackLayout::Placed& placed : layout.placed)
        std::swap(*std::ranges::find(numbers, placed.ball),
                  numbers[static_cast<std::size_t>(placed.place)]);
    if (layout.group_border > 0) part_groups(layout, numbers);
    return numbers;
}

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
    const std::vector<Vec2> places = places_of(*rack.layout);
    const auto seed = static_cast<std::uint64_t>(arguments.number_or("seed", 0.0));
    const std::vector<int> numbers = numbers_of(*rack.layout, seed);
    const double gap = arguments.number_or("gap", 0.0);
    const bool is_shaken = arguments.has("seed");
    for (int number = 1; number <= static_cast<int>(numbers.size()); ++number) {
        const auto place =
            static_cast<std::size_t>(std::ranges::find(numbers, number) - numbers.begin());
        BallIr ball;
        // Random shifts leave at least half of the gap between any two balls.
        const auto shake = [&](std::uint64_t draw) {
            return is_shaken ? random_between(-0.25, 0.25, seed, RandomStream::rack,
                                              static_cast<std::uint64_t>(number), draw) *
                                   gap * 0.70710678118654752
                             : 0.0;
        };
        ball.position = rack.foot + Vec2{shake(0), shake(1)};
        ball.racked = rack.toward * places[place].x + perpendicular(rack.toward) * places[place].y;
        ball.gap = gap;
        ball.binding = rack.binding;
        ball.origin.span = arguments.span_of("at");
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
    ZoneIr spec{zone, binding, {arguments.span_of("r"), frame.image}};
    spec.is_pocket = true;
    context.ir.zones.push_back(spec);
}

void add_cue(const Arguments& arguments, const Frame&, Context& context) {
    const auto& power = arguments.values.at("power").numbers;
    context.ir.cues.push_back({*arguments.word("ball"), power[0], power[1]});
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
         .usage = "cue ball=NAME power=A..B",
         .action = add_cue,
         .place = Place::top,
         .keys = {{"ball", word, Measure::number, any, true},
                  {"power", range, Measure::speed, not_negative, true}},
         .is_unique = true},
    };
    statements.insert(statements.end(), others.begin(), others.end());
    return statements;
}

}  // namespace carom

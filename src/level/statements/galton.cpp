#include <fmt/format.h>

#include <algorithm>

#include "level/ir/arguments.h"
#include "level/ir/emit.h"
#include "level/statements/families.h"
#include "level/statements/keys.h"

namespace carom {
namespace {

EdgeBinding edge_binding_of(const Arguments& arguments) {
    return {.node = arguments.node,
            .plain = arguments.plain,
            .material = arguments.word("material"),
            .color = arguments.color()};
}

enum class PegLayout { triangle, grid };

void build_pegs(PegLayout layout, const Arguments& arguments, const Frame& frame,
                Context& context) {
    constexpr double equilateral = 0.86602540378443865;  // sqrt(3)/2: equal gaps all around
    const bool is_triangle = layout == PegLayout::triangle;
    const bool is_staggered = is_triangle || arguments.flag("stagger");
    const Vec2 at = arguments.pair_or("at", {});
    const double pitch = arguments.number_or("pitch", 0.0);
    const double row = arguments.number_or("row", is_staggered ? equilateral * pitch : pitch);
    const double radius = arguments.number_or("r", 0.0);
    const int binding = bind_edges(edge_binding_of(arguments), context);
    const std::uint32_t rows = arguments.count("rows");
    for (std::uint32_t i = 0; i < rows; ++i) {
        std::uint32_t columns = i + 1;
        if (!is_triangle) {
            columns = arguments.count("columns");
            if (is_staggered && i % 2 == 1) --columns;
        }
        for (std::uint32_t k = 0; k < columns; ++k) {
            const Vec2 place{at.x + (k - 0.5 * (columns - 1.0)) * pitch, at.y - i * row};
            emit_capsule({place, place, radius}, Side::both, binding, begin_chain(false, context),
                         arguments.span_of("rows"), frame, context);
        }
    }
}

void build_peg_triangle(const Arguments& arguments, const Frame& frame, Context& context) {
    build_pegs(PegLayout::triangle, arguments, frame, context);
}

void build_peg_grid(const Arguments& arguments, const Frame& frame, Context& context) {
    build_pegs(PegLayout::grid, arguments, frame, context);
}

void build_bins(const Arguments& arguments, const Frame& frame, Context& context) {
    const std::uint32_t count = arguments.count("count");
    const double width = arguments.number_or("width", 0.0);
    const double depth = arguments.number_or("depth", 0.0);
    const double wall = 0.5 * arguments.number_or("wall", 0.0);
    const Vec2 at = arguments.pair_or("at", {});
    const bool is_sink = arguments.flag("sink");
    const bool is_open = arguments.flag("open");
    const double floor = at.y - depth;
    const Span span = arguments.span_of("count");
    const int binding = bind_edges(edge_binding_of(arguments), context);
    const auto x_of = [&](double i) { return at.x + (i - 0.5 * count) * width; };

    reserve_zones(count, span, context);
    for (std::uint32_t i = 0; i <= count && !is_open; ++i) {
        const Vec2 foot{x_of(i), floor};
        emit_capsule({foot, {foot.x, at.y - wall}, wall}, Side::both, binding,
                     begin_chain(false, context), span, frame, context);
    }
    if (!is_sink && !is_open) {
        emit_capsule({{x_of(0), floor}, {x_of(count), floor}, wall}, Side::both, binding,
                     begin_chain(false, context), span, frame, context);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        // The zone of a census is the bin itself; without walls, it reaches into the corners at the
        // top. The zone of a sink lies below the bin, and is too deep for a ball to jump over.
        const double x = x_of(i + 0.5);
        const double rim = is_open ? at.y : std::max(floor, at.y - 0.5 * width);
        const double top = is_sink ? floor : rim;
        const double bottom = is_sink ? floor - depth - 2.0 * width : floor;
        const Transform& t = frame.transform;
        Zone zone;
        zone.shape = {t.point({x, bottom}), t.point({x, top}), 0.5 * width};
        zone.effect = is_sink ? Zone::Effect::sink : Zone::Effect::census;
        context.ir.zones.push_back({zone, binding, Origin(span, frame.image)});
    }
}

// Makes a single zone that counts balls. Zones with the same name form a group of bins.
void build_zone(const Arguments& arguments, const Frame& frame, Context& context) {
    reserve_zones(1, arguments.node->keyword().span(), context);
    const Transform& t = frame.transform;
    Zone zone;
    zone.shape = {t.point(arguments.points[0]), t.point(arguments.points[1]),
                  arguments.number_or("r", 0.0)};
    zone.effect = arguments.flag("sink") ? Zone::Effect::sink : Zone::Effect::census;
    EdgeBinding names = edge_binding_of(arguments);
    names.makes_edges = false;
    const int binding = bind_edges(names, context);
    context.ir.zones.push_back({zone, binding, Origin(arguments.span_of("r"), frame.image)});
}

}  // namespace

std::vector<Statement> galton_statements() {
    using enum KeyShape;
    using enum Bound;
    constexpr auto length = Measure::length;
    constexpr auto whole = Measure::whole;
    const KeyRule rows{"rows", scalar, whole, positive, true};
    const KeyRule pitch{"pitch", scalar, length, positive, true};
    const KeyRule row{"row", scalar, length, positive};
    return {
        {.name = "pegs triangle",
         .usage = "pegs triangle [NAME] at=X,Y rows=N pitch= r= [row=] [material=] [color=]",
         .action = build_peg_triangle,
         .plain_most = 1,
         .keys = {keys::at, rows, pitch, keys::required_edge_radius, row, keys::material,
                  keys::color},
         .binds_names = true},
        {.name = "pegs grid",
         .usage = "pegs grid [NAME] at=X,Y rows=N columns=N pitch= r= [row=] [material=] [color=] "
                  "[stagger]",
         .action = build_peg_grid,
         .plain_most = 1,
         .keys = {keys::at,
                  rows,
                  {"columns", scalar, whole, positive, true},
                  pitch,
                  keys::required_edge_radius,
                  row,
                  keys::material,
                  keys::color},
         .flags = {"stagger"},
         .binds_names = true},
        {.name = "bins",
         .usage =
             "bins [NAME] at=X,Y count=N width= depth= [wall=] [material=] [color=] [sink] [open]",
         .action = build_bins,
         .plain_most = 1,
         .keys = {keys::at,
                  {"count", scalar, whole, positive, true},
                  {"width", scalar, length, positive, true},
                  {"depth", scalar, length, positive, true},
                  {"wall", scalar, length, not_negative},
                  keys::material,
                  keys::color},
         .flags = {"sink", "open"},
         .binds_names = true},
        {.name = "zone",
         .usage = "zone [NAME] X,Y X,Y r= [color=] [sink]",
         .action = build_zone,
         .plain_most = 1,
         .points_least = 2,
         .points_most = 2,
         .keys = {{"r", scalar, length, positive, true}, keys::color},
         .flags = {"sink"},
         .binds_names = true},
    };
}

}  // namespace carom

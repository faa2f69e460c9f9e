#include <fmt/format.h>

#include <cmath>

#include "geometry/unit.h"
#include "level/ir/arguments.h"
#include "level/ir/emit.h"
#include "level/statements/families.h"
#include "level/statements/keys.h"

namespace carom {
namespace {

// The largest distance of a chord from its arc, in radii.
constexpr double arc_tolerance = 1e-3;

Side side_of(const Arguments& arguments) {
    const std::optional<Word> side = arguments.word("side");
    if (!side) return Side::both;
    return side->text == "left" ? Side::left : Side::right;
}

bool is_side_known(const Arguments& arguments, Context& context) {
    const std::optional<Word> side = arguments.word("side");
    if (!side || side->text == "left" || side->text == "right") return true;
    context.reporter.error("unknown-side", side->span(),
                           fmt::format("an edge has no side '{}'", side->text),
                           "write side=left or side=right, seen along the edge");
    return false;
}

EdgeBinding shape_binding(const Arguments& arguments) {
    return {.node = arguments.node,
            .plain = arguments.plain,
            .may_begin_with_material = true,
            .material = arguments.word("material"),
            .name = arguments.word("name"),
            .color = arguments.color()};
}

// A vertex of a polyline, and the span for messages about the piece that ends there.
struct Corner {
    Vec2 point;
    Span span;
};

// Appends the arc about `center` from direction `from` to `to` (unit vectors, less than a half turn
// apart), without its first point. Bisects the arc until each chord is within tolerance.
void append_arc(Vec2 center, double radius, Vec2 from, Vec2 to, const Span& span,
                std::vector<Corner>& out) {
    // The sagitta of a chord is 1 - cos(half its angle), and cos = |from + to| / 2.
    const Vec2 middle = (from + to) * 0.5;
    const double cosine = length(middle);
    if (1.0 - cosine > arc_tolerance) {
        const Vec2 halfway = middle / cosine;
        append_arc(center, radius, from, halfway, span, out);
        append_arc(center, radius, halfway, to, span, out);
        return;
    }
    out.push_back({center + to * radius, span});
}

// The distance from a corner to the points where its fillet touches the two edges.
double tangent_length(Vec2 before, Vec2 corner, Vec2 after, double radius) {
    const double cosine = dot(unit(before - corner), unit(after - corner));
    return radius * std::sqrt((1.0 + cosine) / (1.0 - cosine));
}

bool is_straight(Vec2 before, Vec2 corner, Vec2 after) {
    const Vec2 in = unit(corner - before);
    const Vec2 out = unit(after - corner);
    return std::abs(cross(in, out)) < 1e-12;
}

// Appends the arc that is tangent to both edges of a corner, in place of the corner.
void append_fillet(Vec2 before, const Corner& corner, Vec2 after, double radius,
                   std::vector<Corner>& out) {
    const Vec2 back = unit(before - corner.point);
    const Vec2 on = unit(after - corner.point);
    const double reach = tangent_length(before, corner.point, after, radius);
    const double sine_half = std::sqrt(0.5 * (1.0 - dot(back, on)));
    const Vec2 center = corner.point + unit(back + on) * (radius / sine_half);
    const Vec2 first = corner.point + back * reach;
    const Vec2 last = corner.point + on * reach;
    out.push_back({first, corner.span});
    append_arc(center, radius, unit(first - center), unit(last - center), corner.span, out);
    out.back().point = last;
}

bool fillets_fit(const std::vector<Corner>& corners, bool is_closed, double radius,
                 Context& context) {
    const std::size_t n = corners.size();
    const auto reach_at = [&](std::size_t i) {
        if (!is_closed && (i == 0 || i == n - 1)) return 0.0;
        const Vec2 before = corners[(i + n - 1) % n].point;
        const Vec2 after = corners[(i + 1) % n].point;
        if (is_straight(before, corners[i].point, after)) return 0.0;
        return tangent_length(before, corners[i].point, after, radius);
    };
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < n; ++i) {
        const std::size_t next = (i + 1) % n;
        const double room = distance(corners[i].point, corners[next].point);
        // Two arcs may share a whole side, so rounding must not make them too long for it.
        if (reach_at(i) + reach_at(next) <= room * (1.0 + 1e-9)) continue;
        context.reporter.error("fillet-does-not-fit", corners[next].span,
                               "the fillet does not fit between these points",
                               "make it smaller, or move the points apart");
        return false;
    }
    return true;
}

std::vector<Corner> rounded(const std::vector<Corner>& corners, bool is_closed, double radius) {
    std::vector<Corner> out;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 before = corners[(i + n - 1) % n].point;
        const Vec2 after = corners[(i + 1) % n].point;
        const bool is_end = !is_closed && (i == 0 || i == n - 1);
        if (is_end || is_straight(before, corners[i].point, after)) {
            out.push_back(corners[i]);
        } else {
            append_fillet(before, corners[i], after, radius, out);
        }
    }
    return out;
}

void add_polyline(std::vector<Corner> corners, bool is_closed, const Arguments& arguments,
                  const Frame& frame, Context& context, bool is_smooth) {
    for (std::size_t i = 1; i < corners.size(); ++i) {
        if (!(corners[i].point == corners[i - 1].point)) continue;
        context.reporter.error("edge-without-length", corners[i].span,
                               "this piece of the edge has no length",
                               "move or drop the point; a single point is a peg");
        return;
    }
    const bool is_ring = corners.size() > 2 && corners.front().point == corners.back().point;
    if (is_closed && is_ring) {
        context.reporter.error("edge-closed-already", corners.back().span,
                               "the edge is already back at its first point",
                               "drop this point, or 'close'");
        return;
    }
    if (is_ring) corners.pop_back();
    const bool closes = is_closed || is_ring;
    const double fillet = arguments.number_or("fillet", 0.0);
    if (fillet > 0.0) {
        if (!fillets_fit(corners, closes, fillet, context)) return;
        corners = rounded(corners, closes, fillet);
    }
    const double radius = arguments.number_or("r", 0.0);
    const int binding = bind_edges(shape_binding(arguments), context);
    const int chain = begin_chain(closes, context, is_smooth || fillet > 0.0);
    if (arguments.flag("tight")) context.ir.chains.back().has_gaps = false;
    const std::size_t pieces = closes ? corners.size() : corners.size() - 1;
    for (std::size_t i = 0; i < pieces; ++i) {
        const Corner& end = corners[(i + 1) % corners.size()];
        if (corners[i].point == end.point) continue;  // two fillets that meet
        emit_capsule({corners[i].point, end.point, radius}, side_of(arguments), binding, chain,
                     end.span, frame, context);
    }
}

void build_edge(const Arguments& arguments, const Frame& frame, Context& context) {
    if (!is_side_known(arguments, context)) return;
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < arguments.points.size(); ++i) {
        corners.push_back({arguments.points[i], arguments.point_words[i].span()});
    }
    if (arguments.flag("close") && corners.size() < 3) {
        context.reporter.error("edge-too-short-to-close", arguments.node->keyword().span(),
                               "an edge of two points cannot be closed", "add a third point");
        return;
    }
    add_polyline(std::move(corners), arguments.flag("close"), arguments, frame, context,
                 arguments.flag("smooth"));
}

void build_box(const Arguments& arguments, const Frame& frame, Context& context) {
    if (!is_side_known(arguments, context)) return;
    const Vec2 a = arguments.points[0];
    const Vec2 b = arguments.points[1];
    const Span span = arguments.point_words[1].span();
    if (!(a.x < b.x && a.y < b.y)) {
        context.reporter.error("box-empty", span, "the box is empty",
                               "write its lower left corner, then its upper right one");
        return;
    }
    add_polyline({{a, span}, {{b.x, a.y}, span}, {b, span}, {{a.x, b.y}, span}}, true, arguments,
                 frame, context, false);
}

void build_arc(const Arguments& arguments, const Frame& frame, Context& context) {
    if (!is_side_known(arguments, context)) return;
    const double from = arguments.number_or("from", 0.0);
    const double to = arguments.number_or("to", 360.0);
    const double sweep = to - from;
    if (std::abs(sweep) > 360.0 || sweep == 0.0) {
        context.reporter.error("arc-sweep", arguments.span_of("to"),
                               fmt::format("the arc sweeps {:.6g} degrees", sweep),
                               "from= and to= differ by 360 degrees at most, and not by 0");
        return;
    }
    const Vec2 center = arguments.pair_or("at", {});
    const double radius = arguments.number_or("radius", 0.0);
    // The chord of an arc of angle a is less than a^2/8 radii away from it.
    const double widest = 2.0 * std::sqrt(2.0 * arc_tolerance) * 180.0 / pi;
    const int pieces = static_cast<int>(std::ceil(std::abs(sweep) / widest));
    const Span span = arguments.node->keyword().span();
    std::vector<Corner> corners;
    for (int i = 0; i <= pieces; ++i) {
        const double share = static_cast<double>(i) / pieces;
        const SinCos at = sin_cos_degrees(i == pieces ? to : from + sweep * share);
        corners.push_back({center + Vec2{at.cos, at.sin} * radius, span});
    }
    add_polyline(std::move(corners), false, arguments, frame, context, true);
}

void build_peg(const Arguments& arguments, const Frame& frame, Context& context) {
    const Vec2 at = arguments.pair_or("at", {});
    const int binding = bind_edges(shape_binding(arguments), context);
    emit_capsule({at, at, arguments.number_or("r", 0.0)}, Side::both, binding,
                 begin_chain(false, context), arguments.span_of("at"), frame, context);
}

}  // namespace

std::vector<Statement> shape_statements() {
    using enum KeyShape;
    using enum Bound;
    const KeyRule fillet{"fillet", scalar, Measure::length, not_negative};
    const KeyRule side{"side", word};
    return {
        {.name = "edge",
         .usage = "edge [MATERIAL] [NAME] X,Y X,Y ... [r=] [close] [smooth] [tight] "
                  "[fillet=] [side=left|right] [material=] [name=] [color=]",
         .action = build_edge,
         .plain_most = 2,
         .points_least = 2,
         .points_most = many,
         .keys = {keys::edge_radius, fillet, side, keys::material, keys::name, keys::color},
         .flags = {"close", "smooth", "tight"},
         .binds_names = true},
        {.name = "arc",
         .usage = "arc [MATERIAL] [NAME] at=X,Y radius= [from=] [to=] [r=] [tight] "
                  "[side=left|right] [material=] [name=] [color=]",
         .action = build_arc,
         .plain_most = 2,
         .keys = {keys::at,
                  {"radius", scalar, Measure::length, positive, true},
                  {"from", scalar, Measure::angle},
                  {"to", scalar, Measure::angle},
                  keys::edge_radius,
                  side,
                  keys::material,
                  keys::name,
                  keys::color},
         .flags = {"tight"},
         .binds_names = true},
        {.name = "peg",
         .usage = "peg [MATERIAL] [NAME] at=X,Y r= [material=] [name=] [color=]",
         .action = build_peg,
         .plain_most = 2,
         .keys = {keys::at, keys::required_edge_radius, keys::material, keys::name, keys::color},
         .binds_names = true},
        {.name = "box",
         .usage = "box [MATERIAL] [NAME] X0,Y0 X1,Y1 [r=] [fillet=] [side=left|right] [material=] "
                  "[name=] [color=]",
         .action = build_box,
         .plain_most = 2,
         .points_least = 2,
         .points_most = 2,
         .keys = {keys::edge_radius, fillet, side, keys::material, keys::name, keys::color},
         .binds_names = true},
    };
}

}  // namespace carom

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "level/assemble/checks.h"

namespace carom {
namespace {

// The highest step that a ball rolls over, as a share of its radius.
constexpr double harmless_step = 0.1;
// An edge leads to a flipper if it lies in line with it, within 40 degrees.
constexpr double least_in_line = 0.77;

/// The step from an edge up to the flipper behind whose pivot it ends.
struct Step {
    std::size_t edge = 0;
    double height = 0.0;
    double away = std::numeric_limits<double>::infinity();  ///< from its end to the pivot
};

// Of the edges of `layer` that end within a ball of the flipper's thick end, the nearest. `up` is
// the normal of the flipper's upper face at rest.
std::optional<Step> step_to(const Capsule& bat, const Flipper& flipper, Vec2 up, double ball,
                            const std::vector<std::size_t>& candidates, const LevelIr& ir) {
    Step nearest;
    for (const std::size_t i : candidates) {
        const Capsule& edge = ir.capsules[i].shape;
        for (const bool is_reversed : {false, true}) {
            const Vec2 low = is_reversed ? edge.end : edge.start;
            const Vec2 high = is_reversed ? edge.start : edge.end;
            const double away = distance(low, bat.start);
            if (away > bat.radius + edge.radius + ball || away >= nearest.away) continue;
            const double whole = distance(low, high);
            if (!(dot(low - high, flipper.rest) > least_in_line * whole)) continue;
            Vec2 normal = perpendicular(high - low) / whole;
            if (dot(normal, up) < 0.0) normal = -normal;
            const double surface = dot(low - bat.start, normal) + edge.radius;
            nearest = {i, bat.radius - surface, away};
        }
    }
    if (nearest.away == std::numeric_limits<double>::infinity()) return std::nullopt;
    return nearest;
}

// The space between the tips of two flippers at rest that point towards each other; none: they do
// not, so that a ball lies on one of them at most.
std::optional<double> space_between_tips(const CapsuleIr& one, const Flipper& flipper,
                                         const CapsuleIr& other, const Flipper& second) {
    const Vec2 apart = other.shape.end - one.shape.end;
    if (dot(apart, flipper.rest) < 0.0 || dot(apart, second.rest) > 0.0) return std::nullopt;
    if (dot(flipper.rest, second.rest) > least_in_line) return std::nullopt;
    return length(apart) - one.shape.radius - other.shape.radius;
}

// A ball that cannot fall between two flippers lies on both for ever.
void check_tips(double ball, const ResolvedNames& names, Context& context) {
    const LevelIr& ir = context.ir;
    const auto flipper_of = [&](const CapsuleIr& capsule) -> const Flipper* {
        if (capsule.device < 0) return nullptr;
        const auto& flipper = ir.devices[static_cast<std::size_t>(capsule.device)].flipper;
        return flipper ? &*flipper : nullptr;
    };
    const auto layer_of = [&](const CapsuleIr& capsule) {
        return names
            .material_layers[names.edges[static_cast<std::size_t>(capsule.binding)].material];
    };
    std::vector<const CapsuleIr*> bats;
    for (const CapsuleIr& capsule : ir.capsules) {
        const Flipper* const flipper = flipper_of(capsule);
        if (!flipper) continue;
        for (const CapsuleIr* other : bats) {
            if (layer_of(*other) != layer_of(capsule)) continue;
            const auto space = space_between_tips(*other, *flipper_of(*other), capsule, *flipper);
            if (!space || *space >= 2.0 * ball) continue;
            const auto in_units = [&](double value) {
                return fmt::format("{}{}", written(value, Measure::length, context.unit),
                                   symbol(context.unit));
            };
            context.reporter.warning(
                "flippers-too-close", capsule.origin.span(),
                *space > 0.0
                    ? fmt::format("no ball can pass the gap of {} between the flippers' tips",
                                  in_units(*space))
                    : std::string("no ball can pass between the flippers' tips, which touch"),
                fmt::format("shorten them, or move them apart: a gap of {} is usual",
                            in_units(3.0 * ball)));
        }
        bats.push_back(&capsule);
    }
}

}  // namespace

void check_flippers(const std::vector<StartingBall>& balls, const ResolvedNames& names,
                    Context& context) {
    const LevelIr& ir = context.ir;
    if (balls.empty()) return;
    const double ball = balls.front().radius;
    check_tips(ball, names, context);
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < ir.capsules.size(); ++i) {
        const ResolvedEdges& drawn = names.edges[static_cast<std::size_t>(ir.capsules[i].binding)];
        if (ir.capsules[i].device < 0 && names.material_layers[drawn.material] == 0)
            candidates.push_back(i);
    }
    for (const CapsuleIr& capsule : ir.capsules) {
        if (capsule.device < 0) continue;
        const auto& flipper = ir.devices[static_cast<std::size_t>(capsule.device)].flipper;
        if (!flipper) continue;
        const Capsule& bat = capsule.shape;
        const Vec2 up = perpendicular(flipper->rest) * (flipper->sweep > 0.0 ? 1.0 : -1.0);
        const auto step = step_to(bat, *flipper, up, ball, candidates, ir);
        if (!step || step->height <= harmless_step * ball) continue;
        const CapsuleIr& edge = ir.capsules[step->edge];
        const Vec2 flush = bat.start + up * (bat.radius - edge.shape.radius);
        const auto in_units = [&](double value) {
            return written(value, Measure::length, context.unit);
        };
        context.reporter.warning(
            "flipper-stands-proud", capsule.origin.span(),
            fmt::format("the flipper stands {}{} proud of the edge of line {}: balls jump over it",
                        in_units(step->height), symbol(context.unit), edge.origin.span().line),
            fmt::format("end that edge at {},{}, in line with the flipper at rest",
                        in_units(flush.x), in_units(flush.y)));
    }
}

}  // namespace carom

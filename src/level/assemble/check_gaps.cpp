#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include "geometry/closest.h"
#include "level/assemble/checks.h"
#include "level/fill/box_tree.h"

namespace carom {
namespace {

constexpr std::uint64_t most_pairs = 4'000'000;  // bounds the work for a mere warning

bool cross_each_other(const Capsule& a, const Capsule& b) {
    const Vec2 along_a = a.end - a.start;
    const Vec2 along_b = b.end - b.start;
    const auto sides_differ = [](double p, double q) {
        return (p > 0.0 && q < 0.0) || (p < 0.0 && q > 0.0);
    };
    return sides_differ(cross(along_a, b.start - a.start), cross(along_a, b.end - a.start)) &&
           sides_differ(cross(along_b, a.start - b.start), cross(along_b, a.end - b.start));
}

// The distance between the surfaces of two capsules; 0 or less if they touch.
double gap_between(const Capsule& a, const Capsule& b) {
    if (cross_each_other(a, b)) return 0.0;
    const double nearest = std::min({distance(a.start, closest_point(b.start, b.end, a.start)),
                                     distance(a.end, closest_point(b.start, b.end, a.end)),
                                     distance(b.start, closest_point(a.start, a.end, b.start)),
                                     distance(b.end, closest_point(a.start, a.end, b.end))});
    return nearest - a.radius - b.radius;
}

// Union-find over edges that touch. Two edges of one set that come close form a corner, not a gap.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t find(std::size_t i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

  private:
    std::vector<std::size_t> parent_;
};

double smallest_radius(const std::vector<StartingBall>& balls, const ResolvedNames& names,
                       const LevelIr& ir) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const StartingBall& ball : balls)
        smallest = std::min(smallest, ball.radius);
    for (std::size_t i = 0; i < ir.emitters.size(); ++i) {
        smallest = std::min(smallest, names.kinds[names.emitters[i].kind].radius);
    }
    return smallest;
}

// Whether both edges are near a captive ball, whose cell is closed on purpose.
bool is_of_cell(const Capsule& a, const Capsule& b, const std::vector<StartingBall>& balls,
                const LevelIr& ir) {
    return std::ranges::any_of(balls, [&](const StartingBall& ball) {
        if (ball.spec < 0 || ir.balls[static_cast<std::size_t>(ball.spec)].device < 0) return false;
        const Disc near{ball.position, 2.0 * ball.radius};
        return separation(near, a) < 0.0 && separation(near, b) < 0.0;
    });
}

struct Gap {
    std::size_t a = 0;
    std::size_t b = 0;
    double width = 0.0;
};

}  // namespace

void check_gaps(const std::vector<StartingBall>& balls, const ResolvedNames& names,
                Context& context) {
    const std::vector<CapsuleIr>& edges = context.ir.capsules;
    const std::vector<ChainIr>& chains = context.ir.chains;
    if (balls.empty() && context.ir.emitters.empty()) return;
    const double diameter = 2.0 * smallest_radius(balls, names, context.ir);
    std::vector<Box> boxes;
    for (const CapsuleIr& edge : edges)
        boxes.push_back(bounds(edge.shape));
    const BoxTree tree(boxes);
    DisjointSets connected(context.ir.chains.size() + edges.size());
    const auto layer_of = [&names](const CapsuleIr& edge) {
        const ResolvedEdges& drawn = names.edges[static_cast<std::size_t>(edge.binding)];
        return names.material_layers[drawn.material];
    };
    std::vector<Gap> gaps;
    std::uint64_t pairs = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto chain = static_cast<std::size_t>(edges[i].chain);
        connected.join(edges.size() + chain, i);
        tree.query(grow(boxes[i], diameter), [&](std::uint32_t k) {
            if (k >= i || edges[k].chain == edges[i].chain) return ++pairs < most_pairs;
            if (!chains[chain].has_gaps ||
                !chains[static_cast<std::size_t>(edges[k].chain)].has_gaps) {
                return ++pairs < most_pairs;
            }
            if (layer_of(edges[i]) != layer_of(edges[k])) return ++pairs < most_pairs;
            if (edges[i].is_moved || edges[k].is_moved) return ++pairs < most_pairs;
            const double gap = gap_between(edges[i].shape, edges[k].shape);
            // Edges that the author made to touch, and that rounding separates, have no gap.
            if (gap <= 1e-9 * diameter) {
                connected.join(i, k);
            } else if (gap < diameter * (1.0 - 1e-9)) {
                gaps.push_back({i, k, gap});
            }
            return ++pairs < most_pairs;
        });
        if (pairs < most_pairs) continue;
        context.reporter.warning("gap-check-gave-up", edges[i].origin.span(),
                                 "the level is too crowded to look for gaps that no ball can pass",
                                 "expect such gaps among its edges");
        return;
    }
    std::set<std::pair<int, int>> told;
    for (const Gap& gap : gaps) {
        if (connected.find(gap.a) == connected.find(gap.b)) continue;
        if (is_of_cell(edges[gap.a].shape, edges[gap.b].shape, balls, context.ir)) continue;
        if (!told.emplace(edges[gap.a].binding, edges[gap.b].binding).second) continue;
        context.reporter.warning(
            "gap-too-narrow", edges[gap.a].origin.span(),
            fmt::format("no ball can pass the gap of {}{} to the edge of line {}",
                        written(gap.width, Measure::length, context.unit), symbol(context.unit),
                        edges[gap.b].origin.span().line),
            fmt::format(
                "close it, make it wider than the smallest ball, {}{}, or write edge ... tight",
                written(diameter, Measure::length, context.unit), symbol(context.unit)));
    }
}

}  // namespace carom

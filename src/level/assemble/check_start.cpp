#include "level/assemble/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "geometry/closest.h"
#include "level/fill/box_tree.h"
#include "physics/world/images.h"

namespace carom {
namespace {

// The depth of overlap that rounding explains: authors compute positions at contact, and 0.1*3 !=
// 0.3.
double rounding(Vec2 at, double reach) {
    return 1e-9 * reach + 1e-14 * (std::abs(at.x) + std::abs(at.y));
}

std::string length_text(double value, const Context& context) {
    return fmt::format("{}{}", written(value, Measure::length, context.unit), symbol(context.unit));
}

class StartCheck {
  public:
    StartCheck(const std::vector<StartingBall>& balls, const ResolvedNames& names, Context& context)
        : balls_(balls), names_(names), context_(context), ir_(context.ir) {}

    void run() {
        check_torus();
        check_emitters_in_world();
        if (ir_.settings.may_overlap || balls_.size() + ir_.emitters.size() == 0) return;
        const BoxTree edges = edge_tree();
        check_edges(edges);
        check_emitters(edges);
        if (names_.some_balls_collide()) check_balls();
    }

  private:
    void check_torus() {
        const std::optional<Box>& world = ir_.settings.world;
        if (!ir_.settings.wrap) return;
        if (!world) {
            context_.reporter.error("wrap-without-world", *ir_.settings.wrap,
                                    "use wrap needs a world",
                                    "say how large the torus is: world x0,y0 x1,y1");
            return;
        }
        const double side = std::min(size(*world).x, size(*world).y);
        for (const StartingBall& ball : balls_) {
            const Vec2 p = ball.position;
            const bool is_in = p.x >= world->low.x && p.x < world->high.x && p.y >= world->low.y &&
                               p.y < world->high.y;
            if (!is_in) {
                context_.reporter.error("ball-outside-torus", ball.origin.span(),
                                        "the ball starts outside the world",
                                        "under use wrap the world is all there is: move it inside");
            } else if (4.0 * ball.radius > side) {
                context_.reporter.error("ball-too-large-for-torus", ball.origin.span(),
                                        "the ball is too large for the wrapped world",
                                        "each side of the world must be 4 radii at least");
            }
        }
        check_edges_of_torus(*world);
    }

    void check_edges_of_torus(const Box& world) {
        const Model torus{.wrap = world};
        int last = -1;
        for (const CapsuleIr& edge : ir_.capsules) {
            if (has_all_images(torus, edge.shape)) continue;
            if (std::exchange(last, edge.chain) == edge.chain) continue;
            context_.reporter.error("edge-too-large-for-torus", edge.origin.span(),
                                    "the edge reaches too far out of the wrapped world",
                                    "it may go beyond a border by 3/4 of the world's side at most");
        }
    }

    void check_emitters_in_world() {
        const std::optional<Box>& world = ir_.settings.world;
        if (!world) return;
        for (const EmitterIr& spec : ir_.emitters) {
            if (contains(*world, spec.emitter.at)) continue;
            context_.reporter.error("spawn-outside-world", spec.origin.span(),
                                    "the spawn lies outside the world",
                                    "move it inside, or make the world larger");
        }
    }

    BoxTree edge_tree() const {
        std::vector<Box> boxes;
        for (const CapsuleIr& capsule : ir_.capsules)
            boxes.push_back(bounds(capsule.shape));
        return BoxTree(std::move(boxes));
    }

    // Whether the edge is solid to a ball with this centre. One-sided edges are solid on one side.
    static bool pushes(const CapsuleIr& edge, Vec2 center) {
        if (edge.side == Side::both) return true;
        const double side = cross(edge.shape.end - edge.shape.start, center - edge.shape.start);
        return edge.side == Side::left ? side > 0.0 : side < 0.0;
    }

    // The first edge that a ball of this kind overlaps, and the depth. `span` is the ball's
    // position in the file.
    std::optional<std::pair<const CapsuleIr*, double>> edge_around(const BoxTree& tree,
                                                                   const Disc& disc,
                                                                   ClassIndex kind,
                                                                   const Span& span) {
        std::optional<std::pair<const CapsuleIr*, double>> found;
        tree.query(bounds(disc), [&](std::uint32_t i) {
            if (!has_time(span)) return false;
            const CapsuleIr& edge = ir_.capsules[i];
            const ResolvedEdges& binding = names_.edges[static_cast<std::size_t>(edge.binding)];
            const double gap = separation(disc, edge.shape);
            if (gap >= -rounding(disc.center, disc.radius + edge.shape.radius)) return true;
            if (!binding.is_valid || !names_.kind_collides_with(kind, binding.material))
                return true;
            if (!pushes(edge, disc.center)) return true;
            found = {&edge, -gap};
            return false;
        });
        return found;
    }

    // Bounds the work: a million balls in one place that do not collide make n^2 pairs.
    bool has_time(const Span& span) {
        constexpr std::uint64_t most_pairs = 50'000'000;
        if (++pairs_ <= most_pairs) return true;
        if (pairs_ == most_pairs + 1) {
            context_.reporter.warning("overlap-check-gave-up", span,
                                      "the level is too crowded to check how its balls start",
                                      "expect balls that start inside one another");
        }
        return false;
    }

    // Balls of a fill overlap nothing by construction.
    static bool is_filled(const StartingBall& ball) { return ball.binding < 0; }

    void check_edges(const BoxTree& tree) {
        for (const StartingBall& ball : balls_) {
            if (is_filled(ball)) continue;
            if (!has_time(ball.origin.span())) return;
            const auto edge =
                edge_around(tree, {ball.position, ball.radius}, ball.kind, ball.origin.span());
            if (!edge) continue;
            context_.reporter.error(
                "ball-inside-edge", ball.origin.span(),
                fmt::format("the ball starts inside the edge of line {}, {} deep",
                            edge->first->origin.span().line, length_text(edge->second, context_)),
                "move the ball or the edge; a ball reaches r around its centre, an edge r around "
                "its line");
        }
    }

    void check_emitters(const BoxTree& tree) {
        for (std::size_t i = 0; i < ir_.emitters.size(); ++i) {
            const EmitterIr& spec = ir_.emitters[i];
            if (!names_.emitters[i].is_valid) continue;
            if (!has_time(spec.origin.span())) return;
            const ClassIndex kind = names_.emitters[i].kind;
            const auto edge = edge_around(tree, {spec.emitter.at, names_.kinds[kind].radius}, kind,
                                          spec.origin.span());
            if (!edge) continue;
            context_.reporter.error(
                "spawn-inside-edge", spec.origin.span(),
                fmt::format("the spawn lies inside the edge of line {}, {} deep",
                            edge->first->origin.span().line, length_text(edge->second, context_)),
                "move the spawn or the edge");
        }
    }

    void check_balls() {
        std::vector<Box> boxes;
        for (std::uint32_t i = 0; i < balls_.size(); ++i) {
            if (is_filled(balls_[i])) continue;
            boxes.push_back(bounds(disc_of(balls_[i])));
            checked_.push_back(i);
        }
        const BoxTree tree(std::move(boxes));
        for (const std::uint32_t i : checked_) {
            if (!has_time(balls_[i].origin.span())) return;
            for (const Vec2 image : images_of(balls_[i]))
                check_ball(tree, i, image);
        }
    }

    static Disc disc_of(const StartingBall& ball) { return {ball.position, ball.radius}; }

    // The periodic images of a ball that reach into the world: the ball itself, and one beyond each
    // side that it crosses.
    std::vector<Vec2> images_of(const StartingBall& ball) const {
        std::vector<Vec2> images{ball.position};
        if (!ir_.settings.wrap || !ir_.settings.world) return images;
        const Box& world = *ir_.settings.world;
        const Box around = bounds(disc_of(ball));
        const double dx = around.low.x < world.low.x     ? size(world).x
                          : around.high.x > world.high.x ? -size(world).x
                                                         : 0.0;
        const double dy = around.low.y < world.low.y     ? size(world).y
                          : around.high.y > world.high.y ? -size(world).y
                                                         : 0.0;
        if (dx != 0.0) images.push_back(ball.position + Vec2{dx, 0.0});
        if (dy != 0.0) images.push_back(ball.position + Vec2{0.0, dy});
        if (dx != 0.0 && dy != 0.0) images.push_back(ball.position + Vec2{dx, dy});
        return images;
    }

    void check_ball(const BoxTree& tree, std::uint32_t i, Vec2 at) {
        const StartingBall& ball = balls_[i];
        const Disc disc{at, ball.radius};
        tree.query(bounds(disc), [&](std::uint32_t entry) {
            if (!has_time(ball.origin.span())) return false;
            const std::uint32_t k = checked_[entry];
            const StartingBall& other = balls_[k];
            if (k == i || (k > i && at == ball.position)) return true;
            if (reported_.contains({i, k}) || reported_.contains({k, i})) return true;
            const double depth = overlap_at_start(disc, disc_of(other));
            if (!(depth > 0.0)) return true;
            if (!names_.kinds_collide(ball.kind, other.kind)) return true;
            reported_.emplace(i, k);
            const StartingBall& later = i > k ? ball : other;
            const StartingBall& earlier = i > k ? other : ball;
            report_ball_inside_ball(later.origin, earlier.origin, depth, context_);
            return false;
        });
    }

    const std::vector<StartingBall>& balls_;
    const ResolvedNames& names_;
    Context& context_;
    const LevelIr& ir_;
    std::uint64_t pairs_ = 0;
    std::vector<std::uint32_t> checked_;  ///< index of the ball for each box of the tree
    std::set<std::pair<std::uint32_t, std::uint32_t>> reported_;
};

}  // namespace

double overlap_at_start(const Disc& disc, const Disc& other) {
    const double depth = -separation(disc, other);
    return depth > rounding(disc.center, disc.radius + other.radius) ? depth : 0.0;
}

void report_ball_inside_ball(const Origin& later, const Origin& earlier, double depth,
                             Context& context) {
    context.reporter.error("ball-inside-ball", later.span(),
                           fmt::format("the ball starts inside the ball of line {}, {} deep",
                                       earlier.span().line, length_text(depth, context)),
                           "move one of them, or write 'use overlap'");
}

void check_terms(Context& context) {
    if (context.ir.needs_cloth && !context.ir.settings.cloth)
        context.reporter.error("roll-without-cloth", *context.ir.needs_cloth,
                               "roll= needs 'use cloth'",
                               "add a line 'use cloth', or leave roll= out");
    if (context.ir.settings.modulus && context.ir.settings.gravity)
        context.reporter.error("modulus-with-gravity", *context.ir.settings.modulus_at,
                               "use modulus does not go with 'use gravity'",
                               "contacts that last are for balls on a table or in free flight");
    if (context.ir.settings.spin || context.ir.settings.cloth) return;
    for (const SpinNeed& need : context.ir.spin_needs) {
        context.reporter.error("value-needs-spin", need.value.span(),
                               fmt::format("{}={} needs 'use spin'", need.key, need.value.text),
                               fmt::format("add a line 'use spin', or leave {}= out", need.key));
    }
}

void check_start(const std::vector<StartingBall>& balls, const ResolvedNames& names,
                 Context& context) {
    StartCheck(balls, names, context).run();
}

}  // namespace carom

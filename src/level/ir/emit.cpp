#include "level/ir/emit.h"

#include <fmt/format.h>

namespace carom {
namespace {

Side turned(Side side, const Transform& transform) {
    if (side == Side::both || !transform.reflects()) return side;
    return side == Side::left ? Side::right : Side::left;
}

// The key of a binding: a statement, and the word by which its bindings differ, since a map draws
// with several materials.
BindingKey key_of(const Node* node, const std::optional<Word>& word) {
    return {node, word ? word->text.data() : nullptr};
}

}  // namespace

void reserve_balls(std::uint64_t count, const Span& at, Context& context) {
    context.ir.balls_reserved += count;
    if (context.ir.balls_reserved <= max_items) return;
    context.reporter.stop("too-many-balls", at,
                          fmt::format("the level has more than {} balls", max_items),
                          "make fewer of them");
}

void reserve_zones(std::uint64_t count, const Span& at, Context& context) {
    if (context.ir.zones.size() + count <= max_zones) return;
    context.reporter.stop("too-many-zones", at,
                          fmt::format("the level has more than {} zones and bins", max_zones),
                          "make fewer of them");
}

int begin_chain(bool is_closed, Context& context, bool is_smooth) {
    context.ir.chains.push_back({is_closed, is_smooth});
    return static_cast<int>(context.ir.chains.size()) - 1;
}

void emit_capsule(const Capsule& shape, Side side, int binding, int chain, const Span& at,
                  const Frame& frame, Context& context) {
    if (context.ir.capsules.size() >= max_items) {
        context.reporter.stop("too-many-edges", at,
                              fmt::format("the level has more than {} edges", max_items),
                              "draw fewer of them");
    }
    context.work.earn(1);
    const Transform& t = frame.transform;
    context.ir.capsules.push_back(
        {.shape = {t.point(shape.start), t.point(shape.end), shape.radius},
         .binding = binding,
         .chain = chain,
         .origin = Origin(at, frame.image),
         .side = turned(side, t)});
}

int bind_edges(EdgeBinding binding, Context& context) {
    auto& all = context.ir.edge_bindings;
    const auto [found, is_new] =
        context.edge_binding_index.emplace(key_of(binding.node, binding.material), all.size());
    if (is_new) all.push_back(std::move(binding));
    return static_cast<int>(found->second);
}

int name_balls(BallBinding binding, Context& context) {
    auto& all = context.ir.ball_bindings;
    const auto [found, is_new] =
        context.ball_binding_index.emplace(key_of(binding.node, binding.kind), all.size());
    if (is_new) all.push_back(std::move(binding));
    return static_cast<int>(found->second);
}

void emit_ball(const BallIr& ball, const Frame& frame, Context& context) {
    reserve_balls(1, ball.origin.span(), context);
    context.work.earn(1);
    BallIr placed = ball;
    placed.position = frame.transform.point(ball.position);
    placed.velocity = frame.transform.direction(ball.velocity);
    if (ball.roll) placed.roll = frame.transform.direction(*ball.roll);
    if (frame.transform.reflects()) placed.spin = -placed.spin;
    placed.origin.image = frame.image;
    if (context.ir.balls.push_back(placed)) context.work.spend(sizeof(BallIr));
}

}  // namespace carom

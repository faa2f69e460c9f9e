#include "level/draft/add_to_draft.h"

#include <fmt/format.h>

namespace carom {
namespace {

Side turned(Side side, const Transform& transform) {
    if (side == Side::both || !transform.reflects()) return side;
    return side == Side::left ? Side::right : Side::left;
}

// A statement and the word that varies within it: a map draws with several materials.
NamingKey key_of(const Node* node, const std::optional<Word>& word) {
    return {node, word ? word->text.data() : nullptr};
}

}  // namespace

bool plan_balls(std::uint64_t count, const Span& at, Context& context) {
    context.draft.balls_planned += count;
    if (context.draft.balls_planned <= max_items) return true;
    context.reporter.error(at, fmt::format("the level has more than {} balls", max_items),
                           "make fewer of them");
    context.is_full = true;
    return false;
}

int begin_chain(bool is_closed, Context& context) {
    context.draft.chains.push_back({is_closed});
    return static_cast<int>(context.draft.chains.size()) - 1;
}

bool add_piece(const Capsule& shape, Side side, int naming, int chain, const Span& at,
               const Frame& frame, Context& context) {
    if (context.draft.capsules.size() >= max_items) {
        context.reporter.error(at, fmt::format("the level has more than {} edges", max_items),
                               "draw fewer of them");
        context.is_full = true;
        return false;
    }
    const Transform& t = frame.transform;
    context.draft.capsules.push_back({{t.point(shape.start), t.point(shape.end), shape.radius},
                                      turned(side, t),
                                      naming,
                                      chain,
                                      {at, frame.image}});
    return true;
}

int name_edges(EdgeNaming naming, Context& context) {
    auto& all = context.draft.edge_namings;
    const auto [found, is_new] =
        context.naming_index.emplace(key_of(naming.node, naming.material), all.size());
    if (is_new) all.push_back(std::move(naming));
    return static_cast<int>(found->second);
}

int name_balls(BallNaming naming, Context& context) {
    auto& all = context.draft.ball_namings;
    const auto [found, is_new] =
        context.ball_naming_index.emplace(key_of(naming.node, naming.kind), all.size());
    if (is_new) all.push_back(std::move(naming));
    return static_cast<int>(found->second);
}

void add_ball_draft(const BallDraft& ball, const Frame& frame, Context& context) {
    if (!plan_balls(1, ball.origin.span, context)) return;
    BallDraft placed = ball;
    placed.position = frame.transform.point(ball.position);
    placed.velocity = frame.transform.direction(ball.velocity);
    if (ball.roll) placed.roll = frame.transform.direction(*ball.roll);
    if (frame.transform.reflects()) placed.spin = -placed.spin;
    placed.origin.image = frame.image;
    context.draft.balls.push_back(placed);
}

}  // namespace carom

#include "carom/context/pointer_tool.h"

#include <fmt/format.h>

#include <algorithm>

#include "game/session/predict.h"

namespace carom {
namespace {

/// On a torus, the image of the point within the torus.
Vec2 inside(const World& world, Vec2 point) {
    if (!world.model().wrap) return point;
    const Vec2 middle = center(*world.model().wrap);
    return middle + offset(world, middle, point);
}

std::optional<Vec2> place_of(const World& world, BallId ball) {
    const auto index = index_of(world, ball);
    if (!index) return std::nullopt;
    return world.balls().position[*index];
}

/// Whether the world already holds the object of the command at the position of the command.
bool is_held_so(const World& world, const Command& command) {
    if (const auto* hold = std::get_if<command::HoldBall>(&command)) {
        const HeldBall* const held = held_of(world, hold->ball);
        return held && held->target == hold->target;
    }
    const auto& hold = std::get<command::HoldCapsule>(command);
    const HeldCapsule* const held = held_of(world, hold.capsule);
    return held && held->start_target == hold.start_target && held->end_target == hold.end_target;
}

/// The number of ticks that the predicted path looks ahead: a second and a half, unless a frame has
/// time for fewer.
std::uint64_t foresight(const World& world) {
    constexpr double seconds = 1.5;
    constexpr double most_ball_ticks = 20000.0;
    const double balls = static_cast<double>(world.balls().size()) + 1.0;
    return static_cast<std::uint64_t>(std::min(seconds * world.rate(), most_ball_ticks / balls));
}

}  // namespace

Vec2 cue_velocity(const World& world, Vec2 ball, Vec2 hand) {
    return offset(world, hand, ball) * PointerTool::cue_gain;
}

bool PointerTool::take(const World& world, Vec2 at, double slack) {
    // What lies under the pointer comes before a ball beside it.
    constexpr double right_here = 0.2;
    return take_within(world, at, right_here * slack) || take_within(world, at, slack);
}

bool PointerTool::take_within(const World& world, Vec2 at, double slack) {
    if (const auto ball = ball_at(world, at, slack)) {
        state_ = BallInHand{*ball, offset(world, at, *place_of(world, *ball)), at};
        return true;
    }
    if (const auto end = edge_end_at(world, at, slack)) {
        state_ = EdgesInHand{grip_joint(world, *end, at), at, end->capsule};
        return true;
    }
    if (const auto edge = edge_at(world, at, slack)) {
        state_ = EdgesInHand{grip_edge(world, *edge, at), at, *edge};
        return true;
    }
    return false;
}

void PointerTool::grab_to_place(const World& world, BallId ball, Vec2 at) {
    state_ = BallInHand{ball, offset(world, at, *place_of(world, ball)), at, true};
}

void PointerTool::take_cue(BallId ball, Vec2 at) {
    state_ = CueInHand{ball, at};
}

void PointerTool::start_edge(Vec2 at, double radius, ClassIndex material) {
    state_ = NewEdge{{at, at, radius}, material};
}

void PointerTool::widen_edge(double factor) {
    std::get<NewEdge>(state_).shape.radius *= factor;
}

double PointerTool::edge_width() const {
    return 2.0 * std::get<NewEdge>(state_).shape.radius;
}

bool PointerTool::holds_ball(BallId ball) const {
    const auto* held = std::get_if<BallInHand>(&state_);
    return held && held->ball == ball;
}

bool PointerTool::holds_edge(CapsuleId edge) const {
    const auto* held = std::get_if<EdgesInHand>(&state_);
    return held && std::ranges::count(held->grip.parts, edge, &EdgeGrip::Part::capsule) > 0;
}

std::vector<Command> PointerTool::holds(const World& world) const {
    if (const auto* held = std::get_if<BallInHand>(&state_)) {
        if (held->is_placed || !index_of(world, held->ball)) return {};
        return {command::HoldBall{held->ball, inside(world, held->at + held->grip)}};
    }
    if (const auto* held = std::get_if<EdgesInHand>(&state_))
        return carry(world, held->grip, held->at);
    return {};
}

std::optional<Complaint> PointerTool::move(Session& session, Vec2 to, bool is_paused) {
    const World& world = session.world();
    std::vector<Command> commands;
    if (auto* held = std::get_if<BallInHand>(&state_)) {
        held->at = to;
        const Vec2 place = inside(world, to + held->grip);
        if (!index_of(world, held->ball))
            forget();
        else if (is_paused || held->is_placed)
            commands = {command::PlaceBall{held->ball, place}};
    } else if (auto* edges = std::get_if<EdgesInHand>(&state_)) {
        edges->at = to;
        if (is_paused) commands = place(world, edges->grip, to);
    } else if (auto* cue = std::get_if<CueInHand>(&state_)) {
        cue->at = to;
    } else if (auto* edge = std::get_if<NewEdge>(&state_)) {
        edge->shape.end = to;
    }
    // All or none, so that joined ends stay joined.
    for (const Command& command : commands)
        if (auto why_not = refusal(session.scene(), world, session.game(), command))
            return Complaint{*std::move(why_not), obstacle_to(world, command)};
    for (const Command& command : commands)
        session.apply(command);
    return std::nullopt;
}

std::optional<Complaint> PointerTool::open(Session& session) {
    const World& world = session.world();
    std::optional<Complaint> complaint;
    if (const auto* cue = std::get_if<CueInHand>(&state_)) {
        if (const auto ball = place_of(world, cue->ball))
            if (auto why_not =
                    session.apply(command::Strike{cue->ball, cue_velocity(world, *ball, cue->at)}))
                complaint = Complaint{*std::move(why_not), std::nullopt};
    } else if (const auto* edge = std::get_if<NewEdge>(&state_)) {
        const Command add = command::AddCapsule{edge->shape, edge->material};
        const auto place = obstacle_to(world, add);
        // It stays in the hand: the player can move it elsewhere.
        if (auto why_not = session.apply(add)) return Complaint{*std::move(why_not), place};
    }
    cancel(session);
    return complaint;
}

void PointerTool::cancel(Session& session) {
    if (const auto* held = std::get_if<BallInHand>(&state_)) {
        if (is_held(session.world(), held->ball)) session.apply(command::DropBall{held->ball});
    } else if (const auto* edges = std::get_if<EdgesInHand>(&state_)) {
        for (const Command& command : drop(session.world(), edges->grip))
            session.apply(command);
    }
    forget();
}

void PointerTool::prepare(Session& session) {
    for (const Command& command : holds(session.world()))
        if (!is_held_so(session.world(), command)) session.apply(command);
    if (session.world().tick() < session.latest()) return;
    const std::vector<HeldBall> balls = session.world().held_balls();
    const std::vector<HeldCapsule> edges = session.world().held_capsules();
    for (const HeldBall& held : balls)
        if (!holds_ball(held.id)) session.apply(command::DropBall{held.id});
    for (const HeldCapsule& held : edges)
        if (!holds_edge(held.id)) session.apply(command::DropCapsule{held.id});
}

void PointerTool::annotate(const World& world, const SolverSettings& solver, std::string_view unit,
                           Annotations& annotations) const {
    if (const auto* held = std::get_if<BallInHand>(&state_)) {
        annotations.selected_ball = held->ball;
    } else if (const auto* edges = std::get_if<EdgesInHand>(&state_)) {
        annotations.selected_capsule = edges->edge;
    } else if (const auto* cue = std::get_if<CueInHand>(&state_)) {
        annotations.selected_ball = cue->ball;
        const auto ball = place_of(world, cue->ball);
        if (!ball) return;
        const Vec2 velocity = cue_velocity(world, *ball, cue->at);
        const double speed = length(velocity);
        annotations.cue = CueLine{*ball, cue->at, fmt::format("{:.3g}{}", speed, unit)};
        if (speed > 0.0)
            annotations.path = predicted_path(world, solver, cue->ball, velocity, foresight(world));
    } else if (const auto* edge = std::get_if<NewEdge>(&state_)) {
        annotations.new_capsule = edge->shape;
    }
}

}  // namespace carom

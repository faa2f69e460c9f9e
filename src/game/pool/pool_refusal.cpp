#include <fmt/format.h>

#include <algorithm>

#include "game/pool/pool.h"
#include "game/pool/table_places.h"
#include "game/referees/referee.h"

/// The commands that the rules of pool refuse, and why.
namespace carom {
namespace {

using Refusal = std::optional<std::string>;

Refusal refused(const Scene& scene, const World& world, const PoolPlay& play,
                const command::Strike& strike) {
    if (auto why = refusal_to_shoot(play, strike.ball)) return why;
    if (auto why = refusal(world, Command(strike))) return why;
    return refusal_of_cue(strike.velocity, scene.pool.cue->most_power);
}

// Names the ball, or the table's edge, over which the ball would be placed.
std::string in_the_way(const World& world, const PoolPlay& play, const command::PlaceBall& place) {
    const Balls& balls = world.balls();
    const double radius = balls.radius[*index_of(world, place.ball)];
    for (std::size_t number = 1; number < play.balls.size(); ++number) {
        const auto index = play.balls[number] ? index_of(world, *play.balls[number]) : std::nullopt;
        if (index &&
            distance(balls.position[*index], place.position) < radius + balls.radius[*index])
            return fmt::format("Blocked: it would overlap {}",
                               play.rules.referee->ball_name(static_cast<int>(number)));
    }
    return "Blocked: it would overlap a cushion";
}

Refusal refused(const Scene& scene, const World& world, const PoolPlay& play,
                const command::PlaceBall& place) {
    if (auto why = refusal_to_place(scene, play, place.ball, place.position)) return why;
    if (auto why = refusal(world, Command(place)))
        return obstacle_to(world, Command(place)) ? in_the_way(world, play, place) : why;
    const double radius = world.balls().radius[*index_of(world, place.ball)];
    if (!is_on_table(scene, world, place.position, radius)) return "it must lie on the table";
    return std::nullopt;
}

Refusal refused(const Scene& scene, const World&, const PoolPlay& play,
                const command::CallShot& call) {
    using enum PoolCall::Kind;
    if (auto why = refusal_to_shoot(play, play.balls[cue_ball].value_or(BallId{}))) return why;
    if (call.call.kind == push_out)
        return play.rules.may_push_out ? Refusal{} : "a push-out is for the shot after the break";
    if (call.call.kind == none) return std::nullopt;
    if (const auto why = play.rules.referee->why_no_call(play.rules, call.call.kind); !why.empty())
        return std::string(why);
    if (call.call.kind == safety) return std::nullopt;
    const int last = object_balls(scene);
    if (call.call.ball < 1 || call.call.ball > last ||
        !play.balls[static_cast<std::size_t>(call.call.ball)])
        return fmt::format("the {} is not on the table", call.call.ball);
    const int pockets = static_cast<int>(scene.pool.pockets.size());
    if (call.call.pocket < 0 || call.call.pocket >= pockets) return "there is no such pocket";
    return std::nullopt;
}

Refusal refused(const Scene&, const World&, const PoolPlay& play, const command::Decide& decide) {
    if (play.rules.phase == PoolPhase::choosing &&
        std::ranges::count(play.rules.choices, decide.choice))
        return std::nullopt;
    return "that is not to be chosen now";
}

Refusal refused(const Scene&, const World&, const PoolPlay& play, const command::RackAgain&) {
    return play.is_shooting ? Refusal{"the balls are still rolling"} : Refusal{};
}

Refusal refused(const Scene& scene, const World&, const PoolPlay& play, const command::TimeOut&) {
    if (scene.pool.clock == 0.0) return "there is no shot clock";
    return is_awaited(play) ? Refusal{} : "the shot clock does not run";
}

Refusal refused(const Scene&, const World&, const PoolPlay& play, const command::Concede&) {
    if (play.is_shooting) return "the balls are still rolling";
    return is_awaited(play) && play.shooter ? Refusal{} : "there is no frame to concede";
}

Refusal refused(const Scene&, const World& world, const PoolPlay&, const command::SetSolver& set) {
    return refusal(world, Command(set));
}

template <typename Other>
Refusal refused(const Scene&, const World&, const PoolPlay&, const Other&) {
    return "Disabled under rules. Use pool-table for free play.";
}

}  // namespace

std::optional<std::string> refusal(const Scene& scene, const World& world, const PoolPlay& play,
                                   const Command& command) {
    return std::visit([&](const auto& c) { return refused(scene, world, play, c); }, command);
}

std::optional<std::string> refusal_to_shoot(const PoolPlay& play, BallId ball) {
    if (play.is_shooting) return "the balls are still rolling";
    if (play.rules.phase == PoolPhase::over) return "the rack is over";
    if (play.rules.phase == PoolPhase::choosing) return "there is something to decide first";
    if (play.balls[cue_ball] != std::optional(ball)) return "only the cue ball is struck";
    return std::nullopt;
}

std::optional<std::string> refusal_to_place(const Scene& scene, const PoolPlay& play, BallId ball,
                                            Vec2 place) {
    if (play.is_shooting) return "the balls are still rolling";
    if (play.balls[cue_ball] != std::optional(ball) || play.rules.in_hand == CueInHand::no)
        return "the ball stays where it lies";
    if (is_in_hand_area(scene, play.rules.in_hand, place)) return std::nullopt;
    return play.rules.in_hand == CueInHand::in_d ? "it must lie in the D"
                                                 : "it must lie behind the head string";
}

}  // namespace carom

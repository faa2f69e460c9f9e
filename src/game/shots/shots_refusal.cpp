#include <fmt/format.h>

#include <algorithm>

#include "game/pool/pool.h"
#include "game/shots/shots.h"
#include "game/shots/shots_play.h"
#include "geometry/closest.h"
#include "geometry/impact.h"

// The commands that a game of shots refuses, and why.
namespace carom {
namespace {

using Refusal = std::optional<std::string>;

// Whether a ball gets from its start to a place without meeting an edge, and does not lie in a
// pocket there. For tables without corners that point inwards.
bool is_on_cloth(const Scene& scene, const World& world, Vec2 from, Vec2 place, double radius) {
    for (const Capsule& edge : world.capsules().shape)
        if (first_impact(Disc{from, radius}, place - from, edge, 1.0)) return false;
    return std::ranges::none_of(scene.pool.pockets, [&](std::uint32_t pocket) {
        return is_inside(scene.world.zones()[pocket].shape, place);
    });
}

// Which ball the player strikes, and its number, which changes when it comes back to the table.
std::string wrong_ball(const Scene& scene, const ShotsState& state) {
    const auto ball = cue_ball_of(scene, state);
    return fmt::format("player {} strikes {}{}", state.rules.player + 1,
                       cue_name(scene, cue_in_turn(scene, state)),
                       ball ? fmt::format(", ball {}", number(*ball)) : std::string());
}

Refusal refused(const Scene& scene, const World& world, const ShotsState& state,
                const command::Strike& strike) {
    if (auto why = refusal_to_shoot(world, state)) return why;
    if (std::ranges::count(cue_balls_of(scene, state), strike.ball) == 0)
        return wrong_ball(scene, state);
    if (auto why = refusal(world, Command(strike))) return why;
    return refusal_of_cue(strike.velocity, cue_in_turn(scene, state).most_power);
}

Refusal refused(const Scene& scene, const World& world, const ShotsState& state,
                const command::PlaceBall& place) {
    if (auto why = refusal_to_shoot(world, state)) return why;
    const std::uint32_t cue = cue_of(scene, state);
    if (!state.is_in_hand || state.balls[cue] != std::optional(place.ball))
        return "the ball stays where it lies";
    if (auto why = refusal(world, Command(place))) return why;
    const double radius = scene.world.balls().radius[cue];
    if (state.hand_place >= 0) {
        const RulePlace& hand = scene.rules.places[static_cast<std::size_t>(state.hand_place)];
        const bool is_there = std::ranges::any_of(hand.zones, [&](std::uint32_t zone) {
            return is_inside(world.zones()[zone].shape, place.position);
        });
        return is_there ? Refusal{} : fmt::format("it must lie in '{}'", hand.name);
    }
    if (is_on_cloth(scene, world, start_of(scene, cue), place.position, radius))
        return std::nullopt;
    return "it must lie on the table";
}

Refusal refused(const Scene&, const World&, const ShotsState& state, const command::RackAgain&) {
    return state.is_shooting ? Refusal{"the balls are still rolling"} : Refusal{};
}

Refusal refused(const Scene&, const World& world, const ShotsState&,
                const command::SetSolver& set) {
    return refusal(world, Command(set));
}

template <typename Other>
Refusal refused(const Scene&, const World&, const ShotsState&, const Other&) {
    return "Only the cue moves balls in this game.";
}

}  // namespace

std::optional<std::string> refusal_to_shoot(const World& world, const ShotsState& state) {
    if (state.is_over) return "the game is over";
    if (state.is_shooting || !is_at_rest(world)) return "the balls are still rolling";
    return std::nullopt;
}

std::optional<std::string> refusal(const Scene& scene, const World& world, const ShotsState& state,
                                   const Command& command) {
    return std::visit([&](const auto& c) { return refused(scene, world, state, c); }, command);
}

}  // namespace carom

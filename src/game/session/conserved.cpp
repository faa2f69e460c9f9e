#include "game/session/conserved.h"

#include <algorithm>

namespace carom {
namespace {

bool is_closed(const World& world) {
    const bool is_fed = std::ranges::any_of(
        world.emitters(), [](const Emitter& emitter) { return emitter.emitted < emitter.count; });
    const bool is_drained = std::ranges::any_of(
        world.zones(), [](const Zone& zone) { return zone.effect == Zone::Effect::sink; });
    return !is_fed && !is_drained && world.held_balls().empty() && world.held_capsules().empty() &&
           world.movers().empty();
}

bool is_without_loss(const Model& model) {
    return !loses_energy(model) && !model.speed_limit;
}

}  // namespace

bool conserves_energy(const World& world) {
    return is_closed(world) && is_without_loss(world.model()) &&
           !(world.model().gravity && world.model().wrap);
}

bool conserves_momentum(const World& world) {
    const bool has_edges = world.model().ball_edge && world.capsules().size() > 0;
    // Losses between balls conserve momentum; drag, limits and a stop do not.
    const Model& model = world.model();
    return is_closed(world) && !has_edges && !model.gravity && !model.drag && !model.stop_speed &&
           !model.speed_limit;
}

}  // namespace carom

#include "level_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "level/load.h"
#include "physics/tick/emitters_and_sinks.h"

namespace carom::bench {
namespace {

void append_balls(SceneList& list, const Balls& balls, std::int64_t tick) {
    for (std::size_t i = 0; i < balls.size(); ++i) {
        list.balls.push_back({.tick = tick,
                              .x = balls.position[i].x,
                              .y = balls.position[i].y,
                              .vx = balls.velocity[i].x,
                              .vy = balls.velocity[i].y,
                              .radius = balls.radius[i],
                              .mass = 1.0 / balls.inverse_mass[i]});
    }
}

// Emitted balls are removed at once, so that every place is free.
void append_births(SceneList& list, World world) {
    const auto is_done = [](const Emitter& emitter) { return emitter.emitted == emitter.count; };
    for (; !std::ranges::all_of(world.emitters(), is_done); ++world.edit_tick()) {
        while (world.balls().size() > 0)
            remove_ball(world, world.balls().id.front());
        emit(world);
        append_balls(list, world.balls(), static_cast<std::int64_t>(world.tick()));
    }
}

// The property that all bodies share, if they do.
template <typename Property>
std::optional<double> common(const World& world, Property property) {
    std::set<double> values;
    for (const Kind& kind : world.kinds())
        values.insert(property(kind));
    for (const ClassIndex material : world.capsules().material)
        values.insert(property(world.materials()[material]));
    if (values.size() > 1) return std::nullopt;
    return values.empty() ? 0.0 : *values.begin();
}

}  // namespace

LoadedScene load_scene(const std::string& path, const std::vector<std::string>& overrides) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return {.error = fmt::format("cannot read {}", path)};
    const std::string text(std::istreambuf_iterator<char>(file), {});
    LoadOptions options;
    options.overrides = overrides;
    LoadResult result = load_level(text, path, options);
    if (result.scene) return {.scene = std::move(*result.scene)};
    const std::string message = render(result.diagnostics.front());
    return {.error = message.substr(0, message.find('\n'))};
}

ListedScene list_of(const World& world, const RunPlan& plan) {
    Model listed = world.model();
    listed.gravity.reset();
    listed.inelastic = false;
    listed.rough = false;
    listed.spin.reset();
    if (listed != Model{}) return {.error = "the list of a scene has no word for its terms"};
    const auto is_sink = [](const Zone& zone) { return zone.effect == Zone::Effect::sink; };
    if (std::ranges::any_of(world.zones(), is_sink))
        return {.error = "the list of a scene has no word for sinks"};
    const auto restitution = common(world, [](const auto& body) { return body.restitution; });
    const auto friction = common(world, [](const auto& body) { return body.friction; });
    if (!restitution || !friction)
        return {.error = "the list of a scene has one restitution and one friction"};

    const Vec2 gravity = world.model().gravity.value_or(Vec2{});
    SceneList list{.rate = world.rate(),
                   .gravity_x = gravity.x,
                   .gravity_y = gravity.y,
                   .restitution = *restitution,
                   .friction = world.model().spin ? *friction : 0.0,
                   .plan = plan};
    for (const Capsule& shape : world.capsules().shape) {
        list.capsules.push_back({.start_x = shape.start.x,
                                 .start_y = shape.start.y,
                                 .end_x = shape.end.x,
                                 .end_y = shape.end.y,
                                 .radius = shape.radius});
    }
    append_balls(list, world.balls(), 0);
    append_births(list, world);
    return {.list = std::move(list)};
}

}  // namespace carom::bench

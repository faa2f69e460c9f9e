#include "level/assemble/dress_assembly.h"

#include <algorithm>
#include <map>

#include "level/values/color_names.h"

namespace carom {
namespace {

using Colors = std::vector<std::optional<Rgb24>>;

// A list without any colour is as good as empty, and takes no memory.
Colors kept(Colors colors) {
    const auto has_color = [](const std::optional<Rgb24>& color) { return color.has_value(); };
    if (std::ranges::none_of(colors, has_color)) return {};
    return colors;
}

// `own` has the colours of the first of the names; further ones belong to defaults and to copies
// on other layers, which share the colour of the first of their name.
Colors class_colors(const std::vector<std::string>& names, Colors own) {
    for (std::size_t i = 0; i < own.size(); ++i)
        if (!own[i]) own[i] = color_named(names[i]);
    const std::size_t declared = own.size();
    for (std::size_t i = declared; i < names.size(); ++i) {
        const auto first = std::ranges::find(
            names.begin(), names.begin() + static_cast<std::ptrdiff_t>(declared), names[i]);
        const auto index = static_cast<std::size_t>(first - names.begin());
        own.push_back(index < declared ? own[index] : std::nullopt);
    }
    return kept(std::move(own));
}

// The name of a ball without the suffix of a copy.
std::string_view base_of(std::string_view name) {
    return name.substr(0, name.find('.'));
}

// Balls of a cradle that move at the start are pulled back from where they hang.
void hang_cradles(const std::vector<StartingBall>& balls, const LevelIr& ir, Dress& dress) {
    std::map<int, std::uint32_t> hung;  // by binding
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (balls[i].binding < 0) continue;
        const auto& cradle = ir.ball_bindings[static_cast<std::size_t>(balls[i].binding)].cradle;
        if (!cradle) continue;
        const double speed = length(balls[i].velocity);
        const Vec2 pulled = speed > 0.0 ? balls[i].velocity * (cradle->swing / speed) : Vec2{};
        const std::uint32_t place = hung[balls[i].binding]++ % cradle->count;
        dress.strings.push_back(
            {static_cast<std::uint32_t>(i), balls[i].position + pulled + cradle->up, place == 0});
    }
}

}  // namespace

void fill_in_dress(const std::vector<StartingBall>& balls, const ResolvedNames& names,
                   const std::vector<std::uint32_t>& world_zones, Scene& scene, Context& context) {
    LevelIr& ir = context.ir;
    Dress& dress = scene.dress;
    Colors kinds;
    for (const KindIr& kind : ir.kinds)
        kinds.push_back(kind.color);
    dress.kinds = class_colors(names.kind_names, std::move(kinds));
    Colors materials;
    for (const MaterialIr& material : ir.materials)
        materials.push_back(material.color);
    dress.materials = class_colors(names.material_names, std::move(materials));
    Colors of_balls(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (balls[i].binding >= 0)
            of_balls[i] = ir.ball_bindings[static_cast<std::size_t>(balls[i].binding)].color;
        if (!of_balls[i] && i < scene.ball_names.size())
            of_balls[i] = color_named(base_of(scene.ball_names[i]));
    }
    dress.balls = kept(std::move(of_balls));
    hang_cradles(balls, ir, dress);
    const auto color_of_binding = [&](int binding) {
        return ir.edge_bindings[static_cast<std::size_t>(binding)].color;
    };
    Colors edges(ir.capsules.size());
    for (std::size_t i = 0; i < ir.capsules.size(); ++i)
        edges[i] = color_of_binding(ir.capsules[i].binding);
    dress.edges = kept(std::move(edges));
    Colors zones(ir.zones.size());
    for (std::size_t i = 0; i < ir.zones.size(); ++i)
        zones[world_zones[i]] = color_of_binding(ir.zones[i].binding);
    dress.zones = kept(std::move(zones));
    dress.areas = std::move(ir.areas);
    dress.labels = std::move(ir.labels);
    dress.theme = ir.theme;
    dress.layers = names.material_layers;
    dress.layers.resize(names.materials.size(), 0);
}

}  // namespace carom

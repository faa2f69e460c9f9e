#include "level/assemble/pinball_assembly.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "level/text/spelling.h"

namespace carom {
std::string PinballAssembly::name_of(const DeviceIr& device) const {
    const std::string& name = names_.edges[static_cast<std::size_t>(device.binding)].name;
    return name.empty() ? std::string(traits(device.device.kind).name) : name;
}

// Collects the devices that have a capsule or a zone, and all lamps, in the order of the file.
void PinballAssembly::collect_devices() {
    std::vector<bool> is_drawn(ir_.devices.size(), false);
    for (const CapsuleIr& capsule : ir_.capsules)
        if (capsule.device >= 0) is_drawn[static_cast<std::size_t>(capsule.device)] = true;
    for (const ZoneIr& zone : ir_.zones)
        if (zone.device >= 0) is_drawn[static_cast<std::size_t>(zone.device)] = true;
    for (std::size_t i = 0; i < ir_.balls.size(); ++i) {
        const int captive = ir_.balls[i].device;
        if (captive >= 0) is_drawn[static_cast<std::size_t>(captive)] = true;
    }
    scene_device_.assign(ir_.devices.size(), -1);
    for (std::size_t i = 0; i < ir_.devices.size(); ++i) {
        const DeviceIr& spec = ir_.devices[i];
        const bool is_lamp = spec.device.kind == DeviceKind::lamp;
        const bool is_duplicate =
            is_lamp && std::ranges::any_of(table_.devices, [&](const Device& d) {
                return d.kind == DeviceKind::lamp && d.place == spec.device.place;
            });
        if (is_lamp ? is_duplicate : !is_drawn[i]) continue;
        check_layers(spec);
        const std::string name = name_of(spec);
        const auto [found, is_new] =
            groups_.emplace(name, static_cast<std::uint32_t>(table_.groups.size()));
        if (is_new) table_.groups.push_back({name, spec.device.kind, {}});
        DeviceGroup& group = table_.groups[found->second];
        if (group.kind != spec.device.kind) {
            context_.reporter.error(
                "group-of-two-kinds", spec.origin.span(),
                fmt::format("'{}' is the name of a {} and of a {}", name, traits(group.kind).name,
                            traits(spec.device.kind).name),
                "give each of them a name of its own");
            continue;
        }
        scene_device_[i] = static_cast<int>(table_.devices.size());
        group.devices.push_back(static_cast<std::uint32_t>(table_.devices.size()));
        table_.devices.push_back(spec.device);
        table_.devices.back().group = found->second;
        looks_.push_back(spec.dress);
        if (!looks_.back().color)
            looks_.back().color = ir_.edge_bindings[static_cast<std::size_t>(spec.binding)].color;
    }
}

void PinballAssembly::check_layers(const DeviceIr& ramp) {
    const std::size_t highest = std::max(ramp.device.from, ramp.device.to);
    if (highest < names_.layers) return;
    context_.reporter.error(
        "layer-is-empty", ramp.origin.span(), fmt::format("nothing stands on layer {}", highest),
        fmt::format("say which material does: material rail layer={}", highest));
}

// lanes.2: the second device of that name, as a group of its own.
std::optional<std::uint32_t> PinballAssembly::one_of_group(std::string_view name) {
    const std::size_t dot = name.find('.');
    const auto base = groups_.find(name.substr(0, dot));
    if (dot == std::string_view::npos || base == groups_.end()) return std::nullopt;
    std::uint32_t number = 0;
    const auto [end, fault] =
        std::from_chars(name.data() + dot + 1, name.data() + name.size(), number);
    const DeviceGroup& all = table_.groups[base->second];
    if (fault != std::errc() || end != name.data() + name.size() || number < 1 ||
        number > all.devices.size())
        return std::nullopt;
    const std::uint32_t device = all.devices[number - 1];
    const auto group = static_cast<std::uint32_t>(table_.groups.size());
    groups_.emplace(std::string(name), group);
    table_.groups.push_back({std::string(name), all.kind, {device}});
    table_.devices[device].own_group = static_cast<std::int32_t>(group);
    return group;
}

// Finds a group of devices by name. If `may_be_edge`, the edges of that name become one device.
std::optional<std::uint32_t> PinballAssembly::group_named(const Word& name, bool may_be_edge) {
    if (const auto found = groups_.find(name.text); found != groups_.end()) return found->second;
    if (const auto one = one_of_group(name.text)) return one;
    const auto is_edge = [&](const CapsuleIr& capsule) {
        return names_.edges[static_cast<std::size_t>(capsule.binding)].name == name.text;
    };
    if (may_be_edge && std::ranges::any_of(ir_.capsules, is_edge)) {
        const auto group = static_cast<std::uint32_t>(table_.groups.size());
        groups_.emplace(std::string(name.text), group);
        table_.groups.push_back({std::string(name.text),
                                 DeviceKind::edge,
                                 {static_cast<std::uint32_t>(table_.devices.size())}});
        table_.devices.push_back({.kind = DeviceKind::edge, .group = group});
        looks_.emplace_back();
        return group;
    }
    if (std::ranges::count(ir_.error_names, name.text) > 0) return std::nullopt;
    std::vector<std::string_view> known;
    for (const DeviceGroup& group : table_.groups)
        known.emplace_back(group.name);
    for (const ResolvedEdges& edges : names_.edges)
        if (may_be_edge && !edges.name.empty()) known.emplace_back(edges.name);
    context_.reporter.error(
        "unknown-device", name.span(),
        fmt::format("nothing on the table is called '{}'", name.text),
        did_you_mean(name.text, known, "name a part of the table, such as: bumper NAME at=..."));
    return std::nullopt;
}

bool PinballAssembly::keeps_balls(std::uint32_t group) const {
    return std::ranges::all_of(table_.groups[group].devices,
                               [&](std::uint32_t device) { return table_.devices[device].keeps; });
}

int PinballAssembly::captive_device(const StartingBall& ball) const {
    return ball.spec < 0 ? -1 : ir_.balls[static_cast<std::size_t>(ball.spec)].device;
}

void PinballAssembly::check(const std::vector<StartingBall>& balls) {
    if (!ir_.settings.table.is_game) return;
    const Span& at = *ir_.settings.game_at;
    const auto has = [&](DeviceKind kind) {
        return std::ranges::count(table_.devices, kind, &Device::kind) > 0;
    };
    if (!balls.empty() && captive_device(balls.front()) >= 0)
        context_.reporter.error("captive-before-ball", balls.front().origin.span(),
                                "the first ball of a table is the one that is served",
                                "write the captive ball below it");
    if (balls.empty())
        context_.reporter.error("pinball-without-ball", at, "pinball needs a ball",
                                "put one where each ball begins: ball NAME at=...");
    if (!has(DeviceKind::drain))
        context_.reporter.error("pinball-without-drain", at, "pinball needs a drain",
                                "say where balls are lost: drain NAME x,y x,y");
}

void PinballAssembly::fill_in_captives(const std::vector<StartingBall>& balls, Scene& scene) {
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const int spec = captive_device(balls[i]);
        const int device = spec < 0 ? -1 : scene_device_[static_cast<std::size_t>(spec)];
        if (device < 0) continue;
        const auto index = static_cast<std::uint32_t>(device);
        table_.devices[index].place = balls[i].position;
        table_.captives.push_back({scene.world.balls().id[i], index});
    }
}

void PinballAssembly::fill_in_edges(Scene& scene) {
    World& world = scene.world;
    table_.device_of_capsule.assign(ir_.capsules.size(), -1);
    for (std::size_t i = 0; i < ir_.capsules.size(); ++i) {
        const CapsuleIr& spec = ir_.capsules[i];
        const CapsuleId id = world.capsules().id[i];
        int device = -1;
        if (spec.device >= 0) {
            const DeviceIr& from = ir_.devices[static_cast<std::size_t>(spec.device)];
            device = scene_device_[static_cast<std::size_t>(spec.device)];
            if (from.flipper) {
                world.edit_flippers().push_back(*from.flipper);
                world.edit_flippers().back().capsule = id;
                table_.flipper_buttons.push_back(from.button);
            }
        } else {
            const auto found =
                groups_.find(names_.edges[static_cast<std::size_t>(spec.binding)].name);
            if (found != groups_.end() && table_.groups[found->second].kind == DeviceKind::edge)
                device = static_cast<int>(table_.groups[found->second].devices.front());
        }
        table_.device_of_capsule[i] = device;
        if (device < 0) continue;
        Device& made = table_.devices[static_cast<std::size_t>(device)];
        made.capsules.push_back(id);
        made.place = (spec.shape.start + spec.shape.end) * 0.5;
        made.side = spec.side;
    }
}

void PinballAssembly::fill_in(const std::vector<StartingBall>& balls, Scene& scene,
                              const std::vector<std::uint32_t>& world_zones) {
    const PinballTable settings = ir_.settings.table;
    table_.is_game = settings.is_game;
    table_.balls = settings.balls;
    table_.save = settings.save;
    table_.warnings = settings.warnings;
    table_.bonus = settings.bonus;
    table_.replay = settings.replay;
    table_.highscores = settings.highscores;
    fill_in_edges(scene);
    fill_in_captives(balls, scene);
    for (std::uint32_t i = 0; i < table_.devices.size(); ++i) {
        const Device& device = table_.devices[i];
        if (traits(device.kind).light == DeviceLight::opening) table_.openings.push_back(i);
        table_.has_locks = table_.has_locks || device.kind == DeviceKind::lock || device.keeps;
    }
    for (std::size_t i = 0; i < ir_.zones.size(); ++i) {
        if (ir_.zones[i].device < 0) continue;
        const int device = scene_device_[static_cast<std::size_t>(ir_.zones[i].device)];
        if (device < 0) continue;
        Device& made = table_.devices[static_cast<std::size_t>(device)];
        const Capsule& shape = ir_.zones[i].zone.shape;
        made.zone = world_zones[i];
        made.place = (shape.start + shape.end) * 0.5;
    }
    scene.table = std::move(table_);
    scene.dress.devices = std::move(looks_);
}

}  // namespace carom

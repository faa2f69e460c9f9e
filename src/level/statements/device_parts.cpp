#include "level/statements/device_parts.h"

#include <fmt/format.h>

#include "level/statements/keys.h"

namespace carom {

bool has_units(const Context& context) {
    return context.unit != LengthUnit::natural;
}

double default_size(double metres, double natural, const Context& context) {
    return has_units(context) ? metres : natural;
}

Material default_material(Material material, const Context& context) {
    if (!has_units(context)) material.soften = 0.0;
    return material;
}

int bind_device(const Arguments& arguments, const std::optional<Material>& material,
                Context& context) {
    EdgeBinding binding{arguments.node, arguments.plain, material.has_value(), std::nullopt};
    binding.makes_edges = material.has_value();
    binding.device_material = material;
    binding.material = arguments.word("material");
    binding.name = arguments.word("name");
    binding.color = arguments.color();
    return bind_edges(std::move(binding), context);
}

Origin origin_of(const Arguments& arguments, const Frame& frame) {
    return Origin(arguments.node->keyword().span(), frame.image);
}

int add_device(DeviceIr device, Context& context) {
    if (context.ir.devices.size() >= max_zones) {
        context.reporter.stop("too-many-devices", device.origin.span(),
                              fmt::format("the level has more than {} devices", max_zones),
                              "make fewer of them");
    }
    context.ir.devices.push_back(std::move(device));
    return static_cast<int>(context.ir.devices.size()) - 1;
}

void emit_device_capsule(const Capsule& shape, Side side, DeviceIr device, const Span& at,
                         const Frame& frame, Context& context) {
    const int chain = begin_chain(false, context);
    context.ir.chains.back().has_gaps = false;
    const int binding = device.binding;
    const int number = add_device(std::move(device), context);
    emit_capsule(shape, side, binding, chain, at, frame, context);
    context.ir.capsules.back().device = number;
}

void emit_device_zone(const Capsule& shape, Zone::Effect effect, DeviceIr device, const Span& at,
                      const Frame& frame, Context& context) {
    reserve_zones(1, at, context);
    const Transform& t = frame.transform;
    const int binding = device.binding;
    const int number = add_device(std::move(device), context);
    Zone zone;
    zone.shape = {t.point(shape.start), t.point(shape.end), shape.radius};
    zone.effect = effect;
    context.ir.zones.push_back({zone, binding, Origin(at, frame.image), number});
}

double zone_radius(const Arguments& arguments, Context& context) {
    return arguments.number_or("r", default_size(0.015, 1.0, context));
}

DeviceIr device_at(Vec2 at, const Device& device, int binding, const Arguments& arguments,
                   const Frame& frame) {
    DeviceIr made{.device = device, .binding = binding, .origin = origin_of(arguments, frame)};
    made.device.place = frame.transform.point(at);
    return made;
}

void build_zones(Device device, const Arguments& arguments, const Frame& frame, Context& context) {
    const double radius = zone_radius(arguments, context);
    device.from = static_cast<std::uint8_t>(arguments.number_or("layer", 0.0));
    const int binding = bind_device(arguments, std::nullopt, context);
    for (std::size_t i = 0; i < arguments.places.size(); ++i) {
        const Vec2 at = arguments.places[i];
        emit_device_zone({at, at, radius}, Zone::Effect::census,
                         device_at(at, device, binding, arguments, frame),
                         arguments.place_words[i].span(), frame, context);
    }
}

Statement placed_device(std::string_view name, std::string_view usage, StatementAction action,
                        const std::vector<KeyRule>& other_keys,
                        std::vector<std::string_view> flags) {
    std::vector<KeyRule> all{keys::places};
    all.insert(all.end(), other_keys.begin(), other_keys.end());
    all.push_back(keys::color);
    return {.name = name,
            .usage = usage,
            .action = action,
            .plain_most = 1,
            .keys = std::move(all),
            .flags = std::move(flags),
            .binds_names = true};
}

std::optional<Vec2> read_direction(const Arguments& arguments, std::string_view key,
                                   Context& context) {
    const std::optional<Word> word = arguments.word(key);
    if (word->text == "up") return Vec2{0.0, 1.0};
    if (word->text == "down") return Vec2{0.0, -1.0};
    if (word->text == "left") return Vec2{-1.0, 0.0};
    if (word->text == "right") return Vec2{1.0, 0.0};
    context.reporter.error("unknown-direction", word->span(),
                           fmt::format("'{}' is no direction", word->text),
                           fmt::format("write {}=up, down, left or right", key));
    return std::nullopt;
}

}  // namespace carom

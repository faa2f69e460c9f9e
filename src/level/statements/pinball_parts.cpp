#include <fmt/format.h>

#include <algorithm>

#include "level/statements/builders.h"

namespace carom {
namespace {

// Measured on tables and taken from the makers of simulators: docs/levels.md lists them.
constexpr Material rubber{.restitution = 0.8, .soften = 0.43, .friction = 0.6};
constexpr Material drop_target{.restitution = 0.38, .friction = 0.25};
constexpr Material standing_target{.restitution = 0.33, .friction = 0.25};
constexpr Material steel{.restitution = 0.4, .friction = 0.15};

// In m/s; a level without units has no speeds of its own.
constexpr double softest_hit = 0.1;

bool has_units(const Context& context) {
    return context.unit != LengthUnit::natural;
}

/// A size that a part has where the author says none.
double default_size(double metres, double natural, const Context& context) {
    return has_units(context) ? metres : natural;
}

Material made_of(Material material, const Context& context) {
    if (!has_units(context)) material.soften = 0.0;
    return material;
}

int bind_device(const Arguments& arguments, const std::optional<Material>& material,
                Context& context) {
    EdgeBinding binding{arguments.node, arguments.plain, material.has_value(), std::nullopt};
    binding.makes_edges = material.has_value();
    binding.device_material = material;
    return bind_edges(std::move(binding), context);
}

Origin origin_of(const Arguments& arguments, const Frame& frame) {
    return {arguments.node->keyword().span(), frame.image};
}

int add_device(DeviceIr device, Context& context) {
    context.ir.devices.push_back(std::move(device));
    return static_cast<int>(context.ir.devices.size()) - 1;
}

/// The device's one capsule. What ends there is meant to: its ends make no gaps.
void draw_device(const Capsule& shape, Side side, DeviceIr device, const Span& at,
                 const Frame& frame, Context& context) {
    const int chain = begin_chain(false, context);
    context.ir.chains.back().has_gaps = false;
    const int binding = device.binding;
    const int number = add_device(std::move(device), context);
    if (emit_capsule(shape, side, binding, chain, at, frame, context))
        context.ir.capsules.back().device = number;
}

void draw_zone(const Capsule& shape, Zone::Effect effect, DeviceIr device, const Span& at,
               const Frame& frame, Context& context) {
    if (context.ir.zones.size() >= max_items) {
        context.reporter.error(at, fmt::format("the level has more than {} zones", max_items),
                               "make fewer of them");
        context.is_at_limit = true;
        return;
    }
    const Transform& t = frame.transform;
    const int binding = device.binding;
    const int number = add_device(std::move(device), context);
    Zone zone;
    zone.shape = {t.point(shape.start), t.point(shape.end), shape.radius};
    zone.effect = effect;
    context.ir.zones.push_back({zone, binding, {at, frame.image}, number});
}

/// up, down, left or right, as unit vectors; none: reported.
std::optional<Vec2> direction_of(const Arguments& arguments, std::string_view key,
                                 Context& context) {
    const std::optional<Word> word = arguments.word(key);
    if (word->text == "up") return Vec2{0.0, 1.0};
    if (word->text == "down") return Vec2{0.0, -1.0};
    if (word->text == "left") return Vec2{-1.0, 0.0};
    if (word->text == "right") return Vec2{1.0, 0.0};
    context.reporter.error(word->span(), fmt::format("'{}' is no direction", word->text),
                           fmt::format("write {}=up, down, left or right", key));
    return std::nullopt;
}

DeviceKind kind_of(const Arguments& arguments) {
    const std::string_view name = arguments.statement->name;
    if (name == "slingshot") return DeviceKind::slingshot;
    if (name == "droptarget") return DeviceKind::droptarget;
    if (name == "target") return DeviceKind::target;
    if (name == "gate") return DeviceKind::gate;
    if (name == "rollover") return DeviceKind::rollover;
    if (name == "spinner") return DeviceKind::spinner;
    if (name == "kickback") return DeviceKind::kickback;
    if (name == "hole") return DeviceKind::hole;
    return DeviceKind::lamp;
}

Material material_of(DeviceKind kind) {
    switch (kind) {
        case DeviceKind::slingshot:
            return rubber;
        case DeviceKind::droptarget:
            return drop_target;
        case DeviceKind::target:
            return standing_target;
        default:
            return steel;
    }
}

void take_kick(const Arguments& arguments, Material& material, const Context& context) {
    material.kick = arguments.number_or("kick", 0.0);
    material.kick_from = arguments.number_or("from", default_size(softest_hit, 0.0, context));
}

/// Where the hole sends its balls; false: nowhere, told.
bool aim_hole(const Arguments& arguments, Vec2 at, Device& hole, const Frame& frame,
              Context& context) {
    const Vec2 way = arguments.pair_or("toward", {}) - at;
    const double distance = length(way);
    if (distance > 0.0) {
        hole.direction = frame.transform.direction(way / distance);
        return true;
    }
    context.reporter.error(arguments.span_of("toward"), "the hole sends balls to where it is",
                           "give a point that it aims at");
    return false;
}

// Which button moves it: as it stands, not as it was drawn before mirrors.
std::optional<Button> button_of(const Arguments& arguments, Vec2 rest, Context& context) {
    const std::optional<Word> key = arguments.word("key");
    if (!key || key->text == "auto")
        return rest.x >= 0.0 ? Button::left_flipper : Button::right_flipper;
    if (key->text == "left") return Button::left_flipper;
    if (key->text == "right") return Button::right_flipper;
    context.reporter.error(key->span(), fmt::format("no flipper has the key '{}'", key->text),
                           "write key=left, key=right or key=auto");
    return std::nullopt;
}

}  // namespace

void build_flipper(const Arguments& arguments, const Frame& frame, Context& context) {
    const double rest = arguments.number_or("rest", -31.0);
    const double up = arguments.number_or("up", 20.0);
    if (rest == up) {
        context.reporter.error(arguments.span_of("up"), "the flipper does not move",
                               "rest= and up= are two directions, such as rest=-31 up=20");
        return;
    }
    const SinCos at = sin_cos_degrees(rest);
    const Vec2 direction = frame.transform.direction({at.cos, at.sin});
    const double sweep = (up - rest) * pi / 180.0;
    Flipper flipper;
    flipper.length = arguments.number_or("length", 0.0);
    flipper.rest = direction;
    flipper.sweep = frame.transform.reflects() ? -sweep : sweep;
    flipper.rise = arguments.number_or("rise", flipper.rise);
    flipper.fall = arguments.number_or("fall", flipper.fall);
    const auto button = button_of(arguments, direction, context);
    if (!button) return;
    const Vec2 pivot = arguments.pair_or("at", {});
    const Vec2 end = pivot + Vec2{at.cos, at.sin} * flipper.length;
    DeviceIr device{.device = {.kind = DeviceKind::flipper},
                    .binding = bind_device(arguments, made_of(rubber, context), context),
                    .flipper = flipper,
                    .button = *button,
                    .origin = origin_of(arguments, frame)};
    draw_device({pivot, end, arguments.number_or("r", 0.0)}, Side::both, std::move(device),
                arguments.span_of("at"), frame, context);
}

void build_bumper(const Arguments& arguments, const Frame& frame, Context& context) {
    Material material = made_of(rubber, context);
    take_kick(arguments, material, context);
    const int binding = bind_device(arguments, material, context);
    for (std::size_t i = 0; i < arguments.places.size() && !context.is_at_limit; ++i) {
        const Vec2 at = arguments.places[i];
        draw_device({at, at, arguments.number_or("r", 0.0)}, Side::both,
                    {.device = {.kind = DeviceKind::bumper},
                     .binding = binding,
                     .origin = origin_of(arguments, frame)},
                    arguments.place_words[i].span(), frame, context);
    }
}

void build_device_edges(const Arguments& arguments, const Frame& frame, Context& context) {
    const DeviceKind kind = kind_of(arguments);
    if (arguments.points.size() % 2 != 0) {
        context.reporter.error(arguments.point_words.back().span(),
                               fmt::format("this {} has only one end", arguments.statement->name),
                               "give each of them two points");
        return;
    }
    Material material = made_of(material_of(kind), context);
    if (kind == DeviceKind::slingshot) {
        take_kick(arguments, material, context);
        material.kicks_in_the_middle = true;
    }
    std::optional<Vec2> pass;
    if (kind == DeviceKind::gate) {
        pass = direction_of(arguments, "pass", context);
        if (!pass) return;
    }
    const int binding = bind_device(arguments, material, context);
    for (std::size_t i = 0; i < arguments.points.size() && !context.is_at_limit; i += 2) {
        const Vec2 from = arguments.points[i];
        const Vec2 to = arguments.points[i + 1];
        const Span span = arguments.point_words[i + 1].span();
        if (from == to) {
            context.reporter.error(span,
                                   fmt::format("this {} has no length", arguments.statement->name),
                                   "move one of its ends");
            return;
        }
        Side side = Side::both;
        if (pass) {
            // It holds what comes from where balls leave it.
            const double left = cross(to - from, *pass);
            if (left == 0.0) {
                context.reporter.error(arguments.span_of("pass"),
                                       "no ball passes a gate along its own line",
                                       "turn the gate, or let balls pass across it");
                return;
            }
            side = left > 0.0 ? Side::left : Side::right;
        }
        draw_device(
            {from, to, arguments.number_or("r", 0.0)}, side,
            {.device = {.kind = kind}, .binding = binding, .origin = origin_of(arguments, frame)},
            span, frame, context);
    }
}

void build_device_spots(const Arguments& arguments, const Frame& frame, Context& context) {
    const DeviceKind kind = kind_of(arguments);
    const double radius = arguments.number_or("r", default_size(0.015, 1.0, context));
    Device device{.kind = kind};
    if (kind == DeviceKind::kickback) {
        const auto direction = direction_of(arguments, "dir", context);
        if (!direction) return;
        device.direction = frame.transform.direction(*direction);
        device.most_speed = arguments.number_or("speed", 0.0);
    }
    if (kind == DeviceKind::hole) {
        device.most_speed = arguments.number_or("speed", 0.0);
        device.hold = arguments.number_or("hold", 1.0);
    }
    const int binding = bind_device(arguments, std::nullopt, context);
    for (std::size_t i = 0; i < arguments.places.size() && !context.is_at_limit; ++i) {
        const Vec2 at = arguments.places[i];
        if (kind == DeviceKind::hole && !aim_hole(arguments, at, device, frame, context)) return;
        DeviceIr spec{.device = device, .binding = binding, .origin = origin_of(arguments, frame)};
        spec.device.place = frame.transform.point(at);
        if (kind == DeviceKind::lamp)
            add_device(std::move(spec), context);
        else
            draw_zone({at, at, radius}, Zone::Effect::census, std::move(spec),
                      arguments.place_words[i].span(), frame, context);
    }
}

void build_ramp(const Arguments& arguments, const Frame& frame, Context& context) {
    const auto pass = direction_of(arguments, "pass", context);
    if (!pass) return;
    const double layer = arguments.number_or("layer", 0.0);
    const double from = arguments.number_or("from", layer > 0.0 ? 0.0 : 1.0);
    if (layer == from) {
        context.reporter.error(arguments.span_of("layer"), "the ramp leads to where it begins",
                               "layer= and from= are two layers, such as layer=1 from=0");
        return;
    }
    DeviceIr spec{.device = {.kind = DeviceKind::ramp},
                  .binding = bind_device(arguments, std::nullopt, context),
                  .origin = origin_of(arguments, frame)};
    spec.device.direction = frame.transform.direction(*pass);
    spec.device.from = static_cast<std::uint8_t>(from);
    spec.device.to = static_cast<std::uint8_t>(layer);
    draw_zone({arguments.points[0], arguments.points[1],
               arguments.number_or("r", default_size(0.015, 1.0, context))},
              Zone::Effect::census, std::move(spec), arguments.point_words[0].span(), frame,
              context);
}

void build_plunger(const Arguments& arguments, const Frame& frame, Context& context) {
    const auto direction = direction_of(arguments, "dir", context);
    if (!direction) return;
    const Vec2 at = arguments.pair_or("at", {});
    const Vec2 across = perpendicular(*direction) *
                        (0.5 * arguments.number_or("width", default_size(0.02, 2.0, context)));
    const std::optional<double> least = arguments.number("speed");
    DeviceIr spec{.device = {.kind = DeviceKind::plunger},
                  .binding = bind_device(arguments, made_of(steel, context), context),
                  .origin = origin_of(arguments, frame)};
    spec.device.direction = frame.transform.direction(*direction);
    spec.device.least_speed = least.value_or(0.0);
    spec.device.most_speed = arguments.values.find("speed")->second.numbers[1];
    draw_device({at - across, at + across, 0.0}, Side::both, std::move(spec),
                arguments.span_of("at"), frame, context);
}

void build_drain(const Arguments& arguments, const Frame& frame, Context& context) {
    draw_zone({arguments.points[0], arguments.points[1],
               arguments.number_or("r", default_size(0.02, 1.0, context))},
              Zone::Effect::sink,
              {.device = {.kind = DeviceKind::drain},
               .binding = bind_device(arguments, std::nullopt, context),
               .origin = origin_of(arguments, frame)},
              arguments.point_words[0].span(), frame, context);
}

}  // namespace carom

#include <fmt/format.h>

#include "level/statements/device_parts.h"
#include "level/statements/families.h"
#include "level/statements/keys.h"

namespace carom {
namespace {

void build_rollover(const Arguments& arguments, const Frame& frame, Context& context) {
    build_zones({.kind = DeviceKind::rollover}, arguments, frame, context);
}

void build_spinner(const Arguments& arguments, const Frame& frame, Context& context) {
    build_zones({.kind = DeviceKind::spinner}, arguments, frame, context);
}

void build_kickback(const Arguments& arguments, const Frame& frame, Context& context) {
    const auto direction = read_direction(arguments, "dir", context);
    if (!direction) return;
    Device device{.kind = DeviceKind::kickback};
    device.direction = frame.transform.direction(*direction);
    device.most_speed = arguments.number_or("speed", 0.0);
    build_zones(device, arguments, frame, context);
}

void build_ramp(const Arguments& arguments, const Frame& frame, Context& context) {
    const auto pass = read_direction(arguments, "pass", context);
    if (!pass) return;
    const double layer = arguments.number_or("layer", 0.0);
    const double from = arguments.number_or("from", layer > 0.0 ? 0.0 : 1.0);
    if (layer == from) {
        context.reporter.error("ramp-leads-nowhere", arguments.span_of("layer"),
                               "the ramp leads to where it begins",
                               "layer= and from= are two layers, such as layer=1 from=0");
        return;
    }
    if (arguments.has("speed") && layer < from) {
        context.reporter.error("ramp-falls", arguments.span_of("speed"),
                               "a ball needs no speed to come down a ramp",
                               "take speed= out, or give it to the ramp that leads up");
        return;
    }
    DeviceIr spec{.device = {.kind = DeviceKind::ramp},
                  .binding = bind_device(arguments, std::nullopt, context),
                  .origin = origin_of(arguments, frame)};
    spec.device.direction = frame.transform.direction(*pass);
    spec.device.least_speed = arguments.number_or("speed", 0.0);
    spec.device.from = static_cast<std::uint8_t>(from);
    spec.device.to = static_cast<std::uint8_t>(layer);
    emit_device_zone({arguments.points[0], arguments.points[1],
                      arguments.number_or("r", default_size(0.015, 1.0, context))},
                     Zone::Effect::census, std::move(spec), arguments.point_words[0].span(), frame,
                     context);
}

// A lamp is a device without a shape.
void build_lamp(const Arguments& arguments, const Frame& frame, Context& context) {
    const int binding = bind_device(arguments, std::nullopt, context);
    for (const Vec2 at : arguments.places)
        add_device(device_at(at, {.kind = DeviceKind::lamp}, binding, arguments, frame), context);
}

void build_drain(const Arguments& arguments, const Frame& frame, Context& context) {
    emit_device_zone({arguments.points[0], arguments.points[1],
                      arguments.number_or("r", default_size(0.02, 1.0, context))},
                     Zone::Effect::sink,
                     {.device = {.kind = DeviceKind::drain},
                      .binding = bind_device(arguments, std::nullopt, context),
                      .origin = origin_of(arguments, frame)},
                     arguments.point_words[0].span(), frame, context);
}

}  // namespace

std::vector<Statement> pinball_zone_statements() {
    using enum KeyShape;
    using enum Bound;
    constexpr auto number = Measure::number;
    const KeyRule required_speed{"speed", scalar, Measure::speed, positive, true};
    return {
        placed_device("rollover", "rollover [NAME] at=X,Y ... [layer=0..3] [r=] [color=]",
                      build_rollover, {keys::zone_layer, keys::zone_radius}),
        placed_device("spinner", "spinner [NAME] at=X,Y ... [layer=0..3] [r=] [color=]",
                      build_spinner, {keys::zone_layer, keys::zone_radius}),
        placed_device(
            "kickback", "kickback [NAME] at=X,Y ... dir=up|down|left|right speed= [r=] [color=]",
            build_kickback, {{"dir", word, number, any, true}, required_speed, keys::zone_radius}),
        {.name = "ramp",
         .usage =
             "ramp [NAME] X,Y X,Y pass=up|down|left|right layer=0..3 [from=0..3] [speed=] [r=] "
             "[color=]",
         .action = build_ramp,
         .plain_most = 1,
         .points_least = 2,
         .points_most = 2,
         .keys = {{"pass", word, number, any, true},
                  {"layer", scalar, Measure::whole, layer, true},
                  {"from", scalar, Measure::whole, layer},
                  {"speed", scalar, Measure::speed, positive},
                  keys::zone_radius,
                  keys::color},
         .binds_names = true},
        placed_device("lamp", "lamp [NAME] at=X,Y ... [color=]", build_lamp, {}),
        {.name = "drain",
         .usage = "drain [NAME] X,Y X,Y [r=]",
         .action = build_drain,
         .plain_most = 1,
         .points_least = 2,
         .points_most = 2,
         .keys = {keys::zone_radius},
         .binds_names = true},
    };
}

}  // namespace carom

#include <fmt/format.h>

#include "level/statements/device_parts.h"
#include "level/statements/families.h"
#include "level/statements/keys.h"

// Devices that hold balls: for a while, until a rule lets them go, or for good.
namespace carom {
namespace {

// A hole aims at the point toward=, so each position has its own direction.
void build_hole(const Arguments& arguments, const Frame& frame, Context& context) {
    Device device{.kind = DeviceKind::hole};
    device.most_speed = arguments.number_or("speed", 0.0);
    device.hold = arguments.number_or("hold", 1.0);
    device.keeps = arguments.flag("keeps");
    device.to = static_cast<std::uint8_t>(arguments.number_or("layer", 0.0));
    if (device.keeps && arguments.has("hold")) {
        context.reporter.error("hole-keeps-and-holds", arguments.span_of("hold"),
                               "a hole that keeps balls has no time to hold them",
                               "take out hold=, or the word keeps");
        return;
    }
    const double radius = zone_radius(arguments, context);
    const int binding = bind_device(arguments, std::nullopt, context);
    for (std::size_t i = 0; i < arguments.places.size(); ++i) {
        const Vec2 at = arguments.places[i];
        const Vec2 aim = arguments.pair_or("toward", {}) - at;
        const double distance = length(aim);
        if (!(distance > 0.0)) {
            context.reporter.error("hole-aims-at-itself", arguments.span_of("toward"),
                                   "the hole sends balls to where it is",
                                   "give a point that it aims at");
            return;
        }
        device.direction = frame.transform.direction(aim / distance);
        emit_device_zone({at, at, radius}, Zone::Effect::census,
                         device_at(at, device, binding, arguments, frame),
                         arguments.place_words[i].span(), frame, context);
    }
}

void build_lock(const Arguments& arguments, const Frame& frame, Context& context) {
    build_zones({.kind = DeviceKind::lock}, arguments, frame, context);
}

void build_magnet(const Arguments& arguments, const Frame& frame, Context& context) {
    Device device{.kind = DeviceKind::magnet};
    device.hold = arguments.number_or("hold", 1.0);
    build_zones(device, arguments, frame, context);
}

// A captive ball is a ball with a device, so that rules can wait until it is hit.
void build_captive(const Arguments& arguments, const Frame& frame, Context& context) {
    const int binding = bind_device(arguments, std::nullopt, context);
    BallBinding kind{.node = arguments.node, .name = {}, .kind = arguments.word("kind")};
    kind.color = arguments.color();
    BallIr ball;
    ball.binding = name_balls(std::move(kind), context);
    for (std::size_t i = 0; i < arguments.places.size(); ++i) {
        const Vec2 at = arguments.places[i];
        ball.position = at;
        ball.origin = Origin(arguments.place_words[i].span());
        ball.device = add_device(
            device_at(at, {.kind = DeviceKind::captive}, binding, arguments, frame), context);
        emit_ball(ball, frame, context);
    }
}

}  // namespace

std::vector<Statement> pinball_holder_statements() {
    using enum KeyShape;
    using enum Bound;
    const KeyRule hold{"hold", scalar, Measure::time, positive};
    return {
        placed_device("hole",
                      "hole [NAME] at=X,Y ... toward=X,Y speed= [hold=TIME] [keeps] [layer=1..3] "
                      "[r=] [color=]",
                      build_hole,
                      {{"toward", pair, Measure::length, any, true},
                       {"speed", scalar, Measure::speed, positive, true},
                       hold,
                       {"layer", scalar, Measure::whole, layer},
                       keys::zone_radius},
                      {"keeps"}),
        placed_device("lock", "lock [NAME] at=X,Y ... [layer=0..3] [r=] [color=]", build_lock,
                      {keys::zone_layer, keys::zone_radius}),
        placed_device("magnet", "magnet [NAME] at=X,Y ... [hold=TIME] [r=] [color=]", build_magnet,
                      {hold, keys::zone_radius}),
        placed_device("captive", "captive [NAME] at=X,Y ... kind=KIND [color=]", build_captive,
                      {{"kind", word, Measure::number, any, true}}),
    };
}

}  // namespace carom

#include <fmt/format.h>

#include "level/statements/device_parts.h"
#include "level/statements/families.h"
#include "level/statements/keys.h"

namespace carom {
namespace {

// Measured on real tables, and taken from simulators: docs/levels.md lists the sources.
constexpr Material rubber{.restitution = 0.8, .soften = 0.43, .friction = 0.6};
// A flipper gives way a little: between 0.72, the 0.88 of its rubber times 0.815 at the start of a
// stroke, and 0.45, a caught ball (nFozzy's and the VPW's settings for Visual Pinball, measured on
// real machines).
constexpr Material flipper_rubber{.restitution = 0.6, .soften = 0.43, .friction = 0.6};
constexpr Material drop_target{.restitution = 0.38, .friction = 0.25};
constexpr Material standing_target{.restitution = 0.33, .friction = 0.25};
constexpr Material steel{.restitution = 0.4, .friction = 0.15};

// The slowest hit that triggers a kick, m/s. A level without units has no such default.
constexpr double softest_hit = 0.1;

void take_kick(const Arguments& arguments, Material& material, const Context& context) {
    material.kick = arguments.number_or("kick", 0.0);
    material.kick_from = arguments.number_or("from", default_size(softest_hit, 0.0, context));
}

// The button that moves the flipper. key=auto depends on the direction after mirroring.
std::optional<Button> button_of(const Arguments& arguments, Vec2 rest, Context& context) {
    const std::optional<Word> key = arguments.word("key");
    if (!key || key->text == "auto")
        return rest.x >= 0.0 ? Button::left_flipper : Button::right_flipper;
    if (key->text == "left") return Button::left_flipper;
    if (key->text == "right") return Button::right_flipper;
    context.reporter.error("unknown-flipper-key", key->span(),
                           fmt::format("no flipper has the key '{}'", key->text),
                           "write key=left, key=right or key=auto");
    return std::nullopt;
}

void build_flipper(const Arguments& arguments, const Frame& frame, Context& context) {
    const double rest = arguments.number_or("rest", -31.0);
    const double up = arguments.number_or("up", 31.0);
    if (rest == up) {
        context.reporter.error("flipper-does-not-move", arguments.span_of("up"),
                               "the flipper does not move",
                               "rest= and up= are two directions, such as rest=-31 up=31");
        return;
    }
    const SinCos at = sin_cos_degrees(rest);
    const Vec2 direction = frame.transform.direction({at.cos, at.sin});
    const double sweep = (up - rest) * pi / 180.0;
    Flipper flipper;
    flipper.length = arguments.number_or("length", 0.0);
    flipper.rest = direction;
    flipper.sweep = frame.transform.reflects() ? -sweep : sweep;
    flipper.rise = arguments.number_or("rise", 0.023);
    flipper.fall = arguments.number_or("fall", flipper.fall);
    const auto button = button_of(arguments, direction, context);
    if (!button) return;
    const Vec2 pivot = arguments.pair_or("at", {});
    const Vec2 end = pivot + Vec2{at.cos, at.sin} * flipper.length;
    DeviceIr device{
        .device = {.kind = DeviceKind::flipper},
        .binding = bind_device(arguments, default_material(flipper_rubber, context), context),
        .flipper = flipper,
        .button = *button,
        .origin = origin_of(arguments, frame)};
    emit_device_capsule({pivot, end, arguments.number_or("r", 0.0)}, Side::both, std::move(device),
                        arguments.span_of("at"), frame, context);
}

void build_bumper(const Arguments& arguments, const Frame& frame, Context& context) {
    Material material = default_material(rubber, context);
    take_kick(arguments, material, context);
    const int binding = bind_device(arguments, material, context);
    for (std::size_t i = 0; i < arguments.places.size(); ++i) {
        const Vec2 at = arguments.places[i];
        emit_device_capsule({at, at, arguments.number_or("r", 0.0)}, Side::both,
                            {.device = {.kind = DeviceKind::bumper},
                             .binding = binding,
                             .origin = origin_of(arguments, frame)},
                            arguments.place_words[i].span(), frame, context);
    }
}

// Whether the number of points is even, two for each device; reports an odd one.
bool are_ends_paired(const Arguments& arguments, Context& context) {
    if (arguments.points.size() % 2 == 0) return true;
    context.reporter.error("device-end-missing", arguments.point_words.back().span(),
                           fmt::format("this {} has only one end", arguments.statement->name),
                           "give each of them two points");
    return false;
}

// Makes a device for each two points: a slingshot, droptarget, target or gate of this material. A
// gate stops balls that come from the side to which `pass` points.
void build_edges(DeviceKind kind, Material material, const std::optional<Vec2>& pass,
                 const Arguments& arguments, const Frame& frame, Context& context) {
    if (!are_ends_paired(arguments, context)) return;
    const int binding = bind_device(arguments, default_material(material, context), context);
    for (std::size_t i = 0; i < arguments.points.size(); i += 2) {
        const Vec2 from = arguments.points[i];
        const Vec2 to = arguments.points[i + 1];
        const Span span = arguments.point_words[i + 1].span();
        if (from == to) {
            context.reporter.error("device-without-length", span,
                                   fmt::format("this {} has no length", arguments.statement->name),
                                   "move one of its ends");
            return;
        }
        Side side = Side::both;
        if (pass) {
            const double left = cross(to - from, *pass);
            if (left == 0.0) {
                context.reporter.error("gate-along-itself", arguments.span_of("pass"),
                                       "no ball passes a gate along its own line",
                                       "turn the gate, or let balls pass across it");
                return;
            }
            side = left > 0.0 ? Side::left : Side::right;
        }
        emit_device_capsule(
            {from, to, arguments.number_or("r", 0.0)}, side,
            {.device = {.kind = kind}, .binding = binding, .origin = origin_of(arguments, frame)},
            span, frame, context);
    }
}

void build_slingshot(const Arguments& arguments, const Frame& frame, Context& context) {
    Material material = rubber;
    take_kick(arguments, material, context);
    material.kicks_in_the_middle = true;
    build_edges(DeviceKind::slingshot, material, {}, arguments, frame, context);
}

void build_droptarget(const Arguments& arguments, const Frame& frame, Context& context) {
    build_edges(DeviceKind::droptarget, drop_target, {}, arguments, frame, context);
}

void build_target(const Arguments& arguments, const Frame& frame, Context& context) {
    build_edges(DeviceKind::target, standing_target, {}, arguments, frame, context);
}

void build_post(const Arguments& arguments, const Frame& frame, Context& context) {
    build_edges(DeviceKind::post, steel, {}, arguments, frame, context);
}

void build_gate(const Arguments& arguments, const Frame& frame, Context& context) {
    if (!are_ends_paired(arguments, context)) return;
    const auto pass = read_direction(arguments, "pass", context);
    if (pass) build_edges(DeviceKind::gate, steel, pass, arguments, frame, context);
}

void build_plunger(const Arguments& arguments, const Frame& frame, Context& context) {
    const auto direction = read_direction(arguments, "dir", context);
    if (!direction) return;
    const Vec2 at = arguments.pair_or("at", {});
    const Vec2 across = perpendicular(*direction) *
                        (0.5 * arguments.number_or("width", default_size(0.02, 2.0, context)));
    const std::optional<double> least = arguments.number("speed");
    DeviceIr spec{.device = {.kind = DeviceKind::plunger},
                  .binding = bind_device(arguments, default_material(steel, context), context),
                  .origin = origin_of(arguments, frame)};
    spec.device.direction = frame.transform.direction(*direction);
    spec.device.least_speed = least.value_or(0.0);
    spec.device.scatter = arguments.number_or("scatter", 0.0);
    spec.device.most_speed = arguments.values.find("speed")->second.numbers[1];
    emit_device_capsule({at - across, at + across, 0.0}, Side::both, std::move(spec),
                        arguments.span_of("at"), frame, context);
}

}  // namespace

std::vector<Statement> pinball_statements() {
    using enum KeyShape;
    using enum Bound;
    constexpr auto length = Measure::length;
    constexpr auto angle = Measure::angle;
    constexpr auto time = Measure::time;
    constexpr auto speed = Measure::speed;
    const KeyRule kick{"kick", scalar, speed, not_negative, true};
    const KeyRule from{"from", scalar, speed, not_negative};
    const auto edges = [](std::string_view name, std::string_view usage, StatementAction action,
                          std::vector<KeyRule> own) {
        own.insert(own.end(), {keys::material, keys::name, keys::color});
        return Statement{.name = name,
                         .usage = usage,
                         .action = action,
                         .plain_most = 2,
                         .points_least = 2,
                         .points_most = many,
                         .keys = std::move(own),
                         .binds_names = true};
    };
    return {
        {.name = "flipper",
         .usage = "flipper [MATERIAL] [NAME] at=X,Y length= r= [rest=ANGLE] [up=ANGLE] "
                  "[rise=TIME] [fall=TIME] [key=auto|left|right] [material=] [name=] [color=]",
         .action = build_flipper,
         .plain_most = 2,
         .keys = {keys::at,
                  {"length", scalar, length, positive, true},
                  keys::required_edge_radius,
                  {"rest", scalar, angle},
                  {"up", scalar, angle},
                  {"rise", scalar, time, positive},
                  {"fall", scalar, time, positive},
                  {"key", word},
                  keys::material,
                  keys::name,
                  keys::color},
         .binds_names = true},
        {.name = "bumper",
         .usage = "bumper [MATERIAL] [NAME] at=X,Y ... r= kick=SPEED [from=SPEED] [material=] "
                  "[name=] [color=]",
         .action = build_bumper,
         .plain_most = 2,
         .keys = {keys::places,
                  {"r", scalar, length, positive, true},
                  kick,
                  from,
                  keys::material,
                  keys::name,
                  keys::color},
         .binds_names = true},
        edges("slingshot",
              "slingshot [MATERIAL] [NAME] X,Y X,Y ... kick=SPEED [from=SPEED] [r=] "
              "[material=] [name=] [color=]",
              build_slingshot, {kick, from, keys::edge_radius}),
        edges("droptarget",
              "droptarget [MATERIAL] [NAME] X,Y X,Y ... [r=] [material=] [name=] [color=]",
              build_droptarget, {keys::edge_radius}),
        edges("target", "target [MATERIAL] [NAME] X,Y X,Y ... [r=] [material=] [name=] [color=]",
              build_target, {keys::edge_radius}),
        edges("post", "post [MATERIAL] [NAME] X,Y X,Y ... [r=] [material=] [name=] [color=]",
              build_post, {keys::edge_radius}),
        edges("gate",
              "gate [MATERIAL] [NAME] X,Y X,Y ... pass=up|down|left|right [r=] [material=] [name=] "
              "[color=]",
              build_gate, {{"pass", word, Measure::number, any, true}, keys::edge_radius}),
        {.name = "plunger",
         .usage = "plunger [MATERIAL] [NAME] at=X,Y dir=up|down|left|right speed=A..B [width=] "
                  "[scatter=] [material=] [name=] [color=]",
         .action = build_plunger,
         .plain_most = 2,
         .keys = {keys::at,
                  {"dir", word, Measure::number, any, true},
                  {"speed", range, speed, not_negative, true},
                  {"width", scalar, length, positive},
                  {"scatter", scalar, Measure::number, not_negative},
                  keys::material,
                  keys::name,
                  keys::color},
         .binds_names = true},
    };
}

}  // namespace carom

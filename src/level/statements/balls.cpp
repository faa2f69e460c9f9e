#include <fmt/format.h>

#include <cmath>

#include "level/ir/arguments.h"
#include "level/ir/emit.h"
#include "level/ir/numbers.h"
#include "level/statements/families.h"
#include "level/statements/keys.h"

namespace carom {
namespace {

constexpr std::size_t max_fills = 1000;  // each tests all items before it

BallBinding ball_binding(const Arguments& arguments, bool is_numbered) {
    BallBinding binding;
    binding.node = arguments.node;
    if (!arguments.plain.empty()) binding.name = arguments.plain.front();
    binding.kind = arguments.word("kind");
    binding.is_numbered = is_numbered;
    binding.color = arguments.color();
    return binding;
}

bool keeps_axes(const Arguments& arguments, const Frame& frame, Context& context) {
    if (frame.transform.keeps_axes()) return true;
    context.reporter.error(
        "box-turned", arguments.node->keyword().span(),
        fmt::format("{} cannot be turned by this angle", arguments.statement->name),
        "turn the part by a multiple of 90 degrees");
    return false;
}

Vec2 absolute(Vec2 v) {
    return {std::abs(v.x), std::abs(v.y)};
}

// Copies the variables that an expression uses, so that it can be evaluated later.
Scope names_in(const Word& expression, const Scope& scope) {
    Scope asked;
    std::uint64_t cost = 0;  // that of the word is spent where it is evaluated
    const std::string_view text = expression.text;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && continues_identifier(text[end]))
            ++end;
        const std::string_view name = text.substr(i, end - i);
        const Variable* variable = scope.find(name, cost);
        if (variable) asked.names.emplace(std::string(name), *variable);
        i = end + 1;
    }
    return asked;
}

// Reads r=, which is a range, or, with m=, an expression of the mass such as sqrt(m)*0.8.
bool read_radius(const Arguments& arguments, const Frame& frame, FillIr& fill, Context& context) {
    const Word expression = *arguments.word("r");
    bool uses_mass = false;
    Scope scope = names_in(expression, *frame.scope);
    if (arguments.has("m")) {
        scope.names["m"] = {Value{fill.least_mass, {}}, arguments.span_of("m"), &uses_mass};
    }
    const auto range =
        read_range(expression, {"r"}, Measure::length, Bound::positive, scope, context);
    if (!range) return false;
    fill.least_radius = range->first;
    fill.most_radius = range->second;
    if (uses_mass) {
        // The fill outlives the blocks whose variables it uses.
        for (auto& [name, variable] : scope.names)
            variable.used = nullptr;
        fill.radius_of_mass = expression;
        fill.scope = std::move(scope);
    }
    return true;
}

void build_ball(const Arguments& arguments, const Frame& frame, Context& context) {
    BallIr ball;
    ball.position = arguments.pair_or("at", {});
    ball.velocity = arguments.pair_or("v", {});
    ball.radius = arguments.number("r");
    ball.mass = arguments.number("m");
    ball.restitution = arguments.number("e");
    ball.spin = arguments.number_or("w", 0.0);
    if (arguments.has("roll")) {
        ball.roll = arguments.pair_or("roll", {});
        if (!context.ir.needs_cloth) context.ir.needs_cloth = arguments.span_of("roll");
    }
    ball.binding = name_balls(ball_binding(arguments, false), context);
    ball.origin = Origin(arguments.span_of("at"));
    emit_ball(ball, frame, context);
}

void build_spawn(const Arguments& arguments, const Frame& frame, Context& context) {
    const Transform& t = frame.transform;
    const Vec2 jitter = arguments.pair_or("jitter", {});
    const Vec2 velocity_jitter = arguments.pair_or("vjitter", {});
    const bool has_jitter = !(jitter == Vec2{}) || !(velocity_jitter == Vec2{});
    if (has_jitter && !keeps_axes(arguments, frame, context)) return;
    reserve_balls(arguments.count("count"), arguments.span_of("count"), context);
    EmitterIr spec;
    spec.kind = arguments.plain.front();
    spec.emitter.at = t.point(arguments.pair_or("at", {}));
    spec.emitter.velocity = t.direction(arguments.pair_or("v", {}));
    spec.emitter.jitter = absolute(t.direction(jitter));
    spec.emitter.velocity_jitter = absolute(t.direction(velocity_jitter));
    spec.emitter.every = arguments.number_or("every", 1.0);
    spec.emitter.count = arguments.count("count");
    spec.origin = Origin(arguments.span_of("at"), frame.image);
    context.ir.emitters.push_back(std::move(spec));
}

void build_fill(const Arguments& arguments, const Frame& frame, Context& context) {
    if (!keeps_axes(arguments, frame, context)) return;
    const std::uint32_t count = arguments.count("count");
    reserve_balls(count, arguments.span_of("count"), context);
    if (context.ir.fills.size() >= max_fills) {
        context.reporter.error("too-many-fills", arguments.node->keyword().span(),
                               fmt::format("the level has more than {} fills", max_fills),
                               "fill larger boxes, with more balls each");
        return;
    }
    if (arguments.has("rms") && (arguments.has("speed") || arguments.has("v"))) {
        context.reporter.error("rms-with-other-speed", arguments.span_of("rms"),
                               "rms= stands beside speed= or v=", "keep one of them");
        return;
    }
    FillIr fill;
    if (!arguments.plain.empty()) fill.kind = arguments.plain.front();
    fill.count = count;
    fill.number = static_cast<int>(context.ir.fills.size());
    const std::array<double, 4>& corners = arguments.values.at("box").numbers;
    const Vec2 a = frame.transform.point({corners[0], corners[1]});
    const Vec2 b = frame.transform.point({corners[2], corners[3]});
    fill.box = join({a, a}, {b, b});
    fill.least_mass = arguments.number_or("m", 0.0);
    if (arguments.has("m")) fill.most_mass = arguments.values.at("m").numbers[1];
    fill.density = arguments.number("density");
    fill.restitution = arguments.number("e");
    fill.velocity = frame.transform.direction(arguments.pair_or("v", {}));
    if (arguments.has("speed")) {
        fill.least_speed = arguments.values.at("speed").numbers[0];
        fill.most_speed = arguments.values.at("speed").numbers[1];
    }
    fill.rms_speed = arguments.number_or("rms", 0.0);
    fill.balls_before = context.ir.balls.size();
    fill.origin = Origin(arguments.span_of("count"), frame.image);
    if (arguments.has("r") && !read_radius(arguments, frame, fill, context)) return;
    context.ir.fills.push_back(std::move(fill));
}

void build_cradle(const Arguments& arguments, const Frame& frame, Context& context) {
    const std::uint32_t count = arguments.count("count");
    const double radius = arguments.number_or("r", 1.0);
    const double pitch = 2.0 * radius + arguments.number_or("gap", 0.0);
    const double swing = arguments.number_or("swing", 4.0 * radius);
    const double moving = arguments.number_or("in", 1.0);
    const Vec2 at = arguments.pair_or("at", {});
    if (moving > count) {
        context.reporter.error("cradle-moves-too-many", arguments.span_of("in"),
                               fmt::format("in={:.6g} is more than count={}", moving, count),
                               "move as many balls as there are, or fewer");
        return;
    }
    BallIr ball;
    ball.radius = radius;
    ball.mass = arguments.number("m");
    ball.restitution = arguments.number("e");
    constexpr double string = 2.5;  // radii: how far above its ball a string ends
    BallBinding hung = ball_binding(arguments, true);
    hung.cradle = CradleIr{frame.transform.direction({0.0, string * radius}), swing, count};
    ball.binding = name_balls(std::move(hung), context);
    ball.origin = Origin(arguments.span_of("count"));
    const double half = 0.5 * (count - 1.0) * pitch;
    for (std::uint32_t i = 0; i < count; ++i) {
        const bool is_moving = i < moving;
        ball.position = {at.x + (i - 0.5 * (count - 1.0)) * pitch - (is_moving ? swing : 0.0),
                         at.y};
        ball.velocity = {is_moving ? arguments.number_or("v", 0.0) : 0.0, 0.0};
        emit_ball(ball, frame, context);
    }
    // The walls are twice the swing away from the ends of the row, and send the outer balls back.
    const double wall = half + radius + 2.0 * swing;
    EdgeBinding binding{.node = arguments.node, .material = arguments.word("material")};
    const int edges = bind_edges(std::move(binding), context);
    for (const double x : {at.x - wall, at.x + wall}) {
        const int chain = begin_chain(false, context);
        context.ir.chains.back().has_gaps = false;
        emit_capsule({{x, at.y - 2.0 * radius}, {x, at.y + 2.0 * radius}, 0.0}, Side::both, edges,
                     chain, arguments.node->keyword().span(), frame, context);
    }
}

constexpr KeyRule velocity{"v", KeyShape::pair, Measure::speed};
constexpr KeyRule count{"count", KeyShape::scalar, Measure::whole, Bound::positive, true};

std::vector<KeyRule> fill_keys() {
    using enum KeyShape;
    using enum Bound;
    return {count,
            {"box", box, Measure::length, any, true},
            {"r", deferred, Measure::length, positive},
            {"m", range, Measure::mass, positive},
            {"density", scalar, Measure::density, positive},
            keys::restitution,
            velocity,
            {"speed", range, Measure::speed, not_negative},
            {"rms", scalar, Measure::speed, not_negative}};
}

}  // namespace

std::vector<Statement> ball_statements() {
    using enum KeyShape;
    using enum Bound;
    constexpr auto length = Measure::length;
    constexpr auto speed = Measure::speed;
    constexpr auto whole = Measure::whole;
    return {
        {.name = "ball",
         .usage = "ball [NAME] at=X,Y [kind=] [v=VX,VY] [r=] [m=] [e=] [w=] [roll=VX,VY] [color=]",
         .action = build_ball,
         .plain_most = 1,
         .keys = {keys::at,
                  keys::kind,
                  velocity,
                  keys::ball_radius,
                  keys::ball_mass,
                  keys::restitution,
                  {.name = "w", .measure = Measure::angular_speed, .needs_spin = true},
                  {"roll", pair, speed},
                  keys::color},
         .binds_names = true},
        {.name = "spawn",
         .usage = "spawn KIND at=X,Y every=TIME count=N [v=VX,VY] [jitter=DX,DY] [vjitter=DVX,DVY]",
         .action = build_spawn,
         .plain_least = 1,
         .plain_most = 1,
         .keys = {keys::at,
                  {"every", scalar, Measure::time, positive, true},
                  count,
                  velocity,
                  {"jitter", pair, length, not_negative},
                  {"vjitter", pair, speed, not_negative}},
         .binds_names = true},
        {.name = "fill",
         .usage = "fill [KIND] count=N box=X0,Y0,X1,Y1 [r=A..B] [m=A..B] [density=] [e=] "
                  "[v=VX,VY] [speed=A..B] [rms=]",
         .action = build_fill,
         .plain_most = 1,
         .keys = fill_keys(),
         .binds_names = true},
        {.name = "cradle",
         .usage = "cradle [NAME] at=X,Y count=N v=SPEED [in=N] [gap=] [swing=] [r=] [m=] [e=] "
                  "[kind=] [material=] [color=]",
         .action = build_cradle,
         .plain_most = 1,
         .keys = {keys::at,
                  count,
                  {"v", scalar, speed, not_negative, true},
                  {"in", scalar, whole, positive},
                  {"gap", scalar, length, not_negative},
                  {"swing", scalar, length, positive},
                  keys::ball_radius,
                  keys::ball_mass,
                  keys::restitution,
                  keys::kind,
                  keys::material,
                  keys::color},
         .binds_names = true},
    };
}

}  // namespace carom

#include "game/replay/replay_commands.h"

#include <fmt/format.h>

#include <iterator>
#include <string_view>

namespace carom {
namespace {

using namespace command;

/// The words for Side in replays, by its value.
constexpr std::string_view side_names[] = {"both", "left", "right", "none"};
/// The words for Button.
constexpr std::string_view button_names[] = {"left",        "right",    "plunger",   "nudge-left",
                                             "nudge-right", "nudge-up", "add-player"};
static_assert(std::size(button_names) == button_count);
/// The words for PoolCall::Kind and PoolChoice.
constexpr std::string_view call_names[] = {"none", "pot", "safety", "push-out"};
constexpr std::string_view choice_names[] = {"take-table", "break-again", "let-break",
                                             "spot-eight", "return-push", "replace"};
/// The words for Aids and ShotSetup::Intent.
constexpr std::string_view aids_names[] = {"none", "ghost", "full", "cloud"};
constexpr std::string_view intent_names[] = {"automatic", "pocket", "safety", "push-out"};

std::string text_of(Vec2 v) {
    return fmt::format("{},{}", v.x, v.y);
}

struct CommandText {
    std::string operator()(const Strike& c) const {
        std::string text = fmt::format("strike {} {}", number(c.ball), text_of(c.velocity));
        if (c.side != 0.0) text += fmt::format(" side={}", c.side);
        if (c.follow != 0.0) text += fmt::format(" follow={}", c.follow);
        return text;
    }
    std::string operator()(const HoldBall& c) const {
        return fmt::format("hold-ball {} {}", number(c.ball), text_of(c.target));
    }
    std::string operator()(const DropBall& c) const {
        return fmt::format("drop-ball {}", number(c.ball));
    }
    std::string operator()(const HoldCapsule& c) const {
        return fmt::format("hold-edge {} {} {}", number(c.capsule), text_of(c.start_target),
                           text_of(c.end_target));
    }
    std::string operator()(const DropCapsule& c) const {
        return fmt::format("drop-edge {}", number(c.capsule));
    }
    std::string operator()(const PlaceBall& c) const {
        return fmt::format("place-ball {} {}", number(c.ball), text_of(c.position));
    }
    std::string operator()(const PlaceCapsule& c) const {
        return fmt::format("place-edge {} {} {}", number(c.capsule), text_of(c.start),
                           text_of(c.end));
    }
    std::string operator()(const AddBall& c) const {
        const BallSpec& spec = c.spec;
        std::string text = fmt::format("add-ball {} {} {}", spec.kind, text_of(spec.position),
                                       text_of(spec.velocity));
        if (spec.radius) text += fmt::format(" r={}", *spec.radius);
        if (spec.mass) text += fmt::format(" m={}", *spec.mass);
        if (spec.restitution) text += fmt::format(" e={}", *spec.restitution);
        if (spec.spin != 0.0) text += fmt::format(" w={}", spec.spin);
        return text;
    }
    std::string operator()(const RemoveBall& c) const {
        return fmt::format("remove-ball {}", number(c.ball));
    }
    std::string operator()(const AddCapsule& c) const {
        return fmt::format("add-edge {} {} {} {} {}", c.material, text_of(c.shape.start),
                           text_of(c.shape.end), c.shape.radius,
                           side_names[static_cast<std::size_t>(c.side)]);
    }
    std::string operator()(const RemoveCapsule& c) const {
        return fmt::format("remove-edge {}", number(c.capsule));
    }
    std::string operator()(const SetGravity& c) const {
        return "gravity " + (c.gravity ? text_of(*c.gravity) : "off");
    }
    std::string operator()(const Press& c) const {
        return fmt::format("{} {}", c.is_down ? "press" : "release",
                           button_names[static_cast<std::size_t>(c.button)]);
    }
    std::string operator()(const Pull& c) const {
        return fmt::format("{} {}", c.lets_go ? "launch" : "pull", c.share);
    }
    std::string operator()(const CallShot& c) const {
        std::string text =
            fmt::format("call {}", call_names[static_cast<std::size_t>(c.call.kind)]);
        if (c.call.kind == PoolCall::Kind::pot)
            text += fmt::format(" {} {}", c.call.ball, c.call.pocket);
        return text;
    }
    std::string operator()(const Decide& c) const {
        return fmt::format("decide {}", choice_names[static_cast<std::size_t>(c.choice)]);
    }
    std::string operator()(const RackAgain&) const { return "rack"; }
    std::string operator()(const TimeOut&) const { return "time-out"; }
    std::string operator()(const Concede&) const { return "concede"; }
    std::string operator()(const SetSolver& c) const {
        return "solver " + settings_text(c.settings, SettingsText::recorded);
    }
};

BallId ball_of(Words& words) {
    return BallId{words.integer<std::uint32_t>()};
}

CapsuleId capsule_of(Words& words) {
    return CapsuleId{words.integer<std::uint32_t>()};
}

// Reads the next word as the name of a value.
template <typename Value, std::size_t count>
Value value_of(Words& words, const std::string_view (&names)[count]) {
    const auto word = words.next();
    for (std::size_t i = 0; i < count; ++i)
        if (word == names[i]) return static_cast<Value>(i);
    words.fail();
    return Value{};
}

Command call_of(Words& words) {
    CallShot call{{value_of<PoolCall::Kind>(words, call_names)}};
    if (call.call.kind != PoolCall::Kind::pot) return call;
    call.call.ball = words.integer<int>();
    call.call.pocket = words.integer<int>();
    return call;
}

Command strike_of(Words& words) {
    Strike strike{ball_of(words), words.point()};
    strike.side = words.optional_real("side=").value_or(0.0);
    strike.follow = words.optional_real("follow=").value_or(0.0);
    return strike;
}

Command add_ball_of(Words& words) {
    BallSpec spec;
    spec.kind = words.integer<ClassIndex>();
    spec.position = words.point();
    spec.velocity = words.point();
    spec.radius = words.optional_real("r=");
    spec.mass = words.optional_real("m=");
    spec.restitution = words.optional_real("e=");
    spec.spin = words.optional_real("w=").value_or(0.0);
    return AddBall{spec};
}

Command add_edge_of(Words& words) {
    AddCapsule add;
    add.material = words.integer<ClassIndex>();
    add.shape.start = words.point();
    add.shape.end = words.point();
    add.shape.radius = words.real();
    add.side = value_of<Side>(words, side_names);
    return add;
}

Command gravity_of(Words& words) {
    if (words.rest() != "off") return SetGravity{words.point()};
    words.next();
    return SetGravity{};
}

}  // namespace

std::string replay_text(const Command& command) {
    return std::visit(CommandText{}, command);
}

std::string replay_text(const ShotSetup& setup) {
    return fmt::format("{} {} {} {} {} {} {}", setup.bearing, setup.speed, setup.side, setup.follow,
                       aids_names[static_cast<std::size_t>(setup.aids)],
                       intent_names[static_cast<std::size_t>(setup.intent)], setup.pocket);
}

ShotSetup read_shot_setup(Words& words) {
    ShotSetup setup;
    setup.bearing = words.real();
    setup.speed = words.real();
    setup.side = words.real();
    setup.follow = words.real();
    setup.aids = value_of<Aids>(words, aids_names);
    setup.intent = value_of<ShotSetup::Intent>(words, intent_names);
    setup.pocket = words.integer<int>();
    return setup;
}

SolverSettings read_solver(Words& words) {
    const auto settings = parse_solver_settings(words.take_rest());
    if (!settings) words.fail();
    return settings.value_or(SolverSettings{});
}

std::optional<Command> read_command(Words& words) {
    const std::string_view what = words.next().value_or("");
    // Arguments in braces are evaluated from left to right.
    if (what == "strike") return strike_of(words);
    if (what == "hold-ball") return HoldBall{ball_of(words), words.point()};
    if (what == "drop-ball") return DropBall{ball_of(words)};
    if (what == "hold-edge") return HoldCapsule{capsule_of(words), words.point(), words.point()};
    if (what == "drop-edge") return DropCapsule{capsule_of(words)};
    if (what == "place-ball") return PlaceBall{ball_of(words), words.point()};
    if (what == "place-edge") return PlaceCapsule{capsule_of(words), words.point(), words.point()};
    if (what == "add-ball") return add_ball_of(words);
    if (what == "remove-ball") return RemoveBall{ball_of(words)};
    if (what == "add-edge") return add_edge_of(words);
    if (what == "remove-edge") return RemoveCapsule{capsule_of(words)};
    if (what == "gravity") return gravity_of(words);
    if (what == "press") return Press{value_of<Button>(words, button_names), true};
    if (what == "release") return Press{value_of<Button>(words, button_names), false};
    if (what == "pull") return Pull{words.real(), false};
    if (what == "launch") return Pull{words.real(), true};
    if (what == "call") return call_of(words);
    if (what == "decide") return Decide{value_of<PoolChoice>(words, choice_names)};
    if (what == "rack") return RackAgain{};
    if (what == "time-out") return TimeOut{};
    if (what == "concede") return Concede{};
    if (what == "solver") return SetSolver{read_solver(words)};
    return std::nullopt;
}

}  // namespace carom

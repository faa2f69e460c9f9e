#include "game/replay_text.h"

#include <fmt/format.h>

#include <iterator>

#include "game/replay_words.h"
#include "physics/fingerprint.h"

namespace carom {
namespace {

using namespace command;

std::string text_of(Vec2 v) {
    return fmt::format("{},{}", v.x, v.y);
}

std::string text_of(const SolverSettings& settings) {
    return fmt::format("{} updates={} steps={} substeps={}", name(settings.kind), settings.updates,
                       settings.steps, settings.substeps);
}

struct CommandText {
    std::string operator()(const Strike& c) const {
        return fmt::format("strike {} {}", number(c.ball), text_of(c.velocity));
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
    std::string operator()(const SetSolver& c) const { return "solver " + text_of(c.settings); }
};

}  // namespace

std::string replay_text(const Replay& replay) {
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "carom replay 1\nlevel {}\nhash {}\nsolver {}\nrate {}\nseed {}\n",
                   replay.level, hexadecimal(replay.level_hash), text_of(replay.solver),
                   replay.rate, replay.seed);
    for (const std::string& statement : replay.overrides)
        fmt::format_to(out, "set {}\n", statement);
    for (const TimedCommand& timed : replay.commands)
        fmt::format_to(out, "at {} {}\n", timed.tick, std::visit(CommandText{}, timed.command));
    for (const FingerprintMark& mark : replay.marks)
        fmt::format_to(out, "mark {} {}\n", mark.tick, hexadecimal(mark.fingerprint));
    fmt::format_to(out, "end {}\nstands {}\n", replay.end, replay.stands);
    return text;
}

}  // namespace carom

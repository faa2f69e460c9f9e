#include "game/replayer.h"

#include <fmt/format.h>

#include <utility>

#include "physics/fingerprint.h"

namespace carom {

Replay record(const Session& session, std::string level, std::span<const std::string> overrides) {
    Replay replay;
    replay.level = std::move(level);
    replay.level_hash = session.scene().text_hash;
    replay.solver = session.first_solver();
    replay.rate = session.world().rate;
    replay.seed = session.world().seed;
    replay.overrides.assign(overrides.begin(), overrides.end());
    replay.commands.assign(session.commands().begin(), session.commands().end());
    replay.marks = {{session.world().tick, fingerprint(session.world())}};
    replay.end = session.latest();
    replay.stands = session.world().tick;
    return replay;
}

Replayer::Replayer(Replay replay, Scene scene, std::size_t rewind_bytes)
    : replay_(std::move(replay)), session_(std::move(scene), replay_.solver, rewind_bytes) {
    obey();
    check();
}

void Replayer::obey() {
    while (!failure_ && next_command_ < replay_.commands.size() &&
           replay_.commands[next_command_].tick == session_.world().tick) {
        if (const auto why = session_.apply(replay_.commands[next_command_++].command))
            failure_ = fmt::format("at tick {}: {}", session_.world().tick, *why);
    }
}

void Replayer::check() {
    while (!failure_ && next_mark_ < replay_.marks.size() &&
           replay_.marks[next_mark_].tick == session_.world().tick) {
        if (fingerprint(session_.world()) != replay_.marks[next_mark_++].fingerprint)
            failure_ = fmt::format("at tick {}: the fingerprint differs", session_.world().tick);
    }
}

bool Replayer::advance(std::uint64_t ticks) {
    for (; ticks > 0 && !failure_ && session_.latest() < replay_.end; --ticks) {
        session_.step_forward();
        obey();
        check();
    }
    if (failure_) return false;
    if (session_.latest() < replay_.end) return true;
    session_.go_to(replay_.stands);
    return false;
}

double Replayer::progress() const {
    if (replay_.end == 0) return 1.0;
    return static_cast<double>(session_.latest()) / static_cast<double>(replay_.end);
}

}  // namespace carom

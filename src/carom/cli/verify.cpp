#include "carom/cli/verify.h"

#include <fmt/format.h>

#include <utility>

#include "carom/cli/interrupt.h"
#include "carom/cli/progress.h"
#include "carom/files/print.h"
#include "carom/files/recording.h"
#include "carom/text/version.h"
#include "game/replay/replayer.h"
#include "physics/version.h"
#include "physics/world/fingerprint.h"

namespace carom {
namespace {

std::string seconds_of(std::uint64_t tick, double rate) {
    return fmt::format("{:.6g} s", static_cast<double>(tick) / rate);
}

// The first tick that differs, as precisely as the fingerprints tell.
std::string difference(const Replayer& replayer, const Replay& replay) {
    if (!replayer.first_different()) return fmt::format("it differs {}", *replayer.failure());
    const FingerprintMark& mark = *replayer.first_different();
    const std::string found = hexadecimal(fingerprint(
        replayer.session().world(), replayer.session().game(), replay.fingerprint_version));
    std::string where;
    if (mark.tick == 0)
        where = "it differs from the start, tick 0";
    else if (!replayer.last_equal())
        where = fmt::format("the first tick that differs is one of 0 to {}", mark.tick);
    else if (replayer.last_equal()->tick + 1 == mark.tick)
        where = fmt::format("the first tick that differs is {} ({})", mark.tick,
                            seconds_of(mark.tick, replay.rate));
    else
        where = fmt::format("the first tick that differs is one of {} to {} ({} to {})",
                            replayer.last_equal()->tick + 1, mark.tick,
                            seconds_of(replayer.last_equal()->tick + 1, replay.rate),
                            seconds_of(mark.tick, replay.rate));
    return fmt::format("{}: at tick {} the fingerprint is {}, and was {}", where, mark.tick, found,
                       hexadecimal(mark.fingerprint));
}

std::string other_program(const Replay& replay) {
    if (replay.program.empty() || replay.program == version()) return {};
    return fmt::format("      = it was recorded by carom {}, and this is carom {}\n",
                       replay.program, version());
}

}  // namespace

int verify(const VerifyOptions& options) {
    auto opened = open_replay(options.file);
    if (const auto* error = std::get_if<std::string>(&opened)) {
        print_note(*error);
        return 2;
    }
    auto& [replay, scene] = std::get<OpenedReplay>(opened);
    if (replay.marks.empty()) {
        print_error(fmt::format("'{}' has no fingerprints ('mark'): there is nothing to compare",
                                options.file));
        return 2;
    }
    Replayer replayer(replay, std::move(scene), 0);
    {
        const InterruptGuard guard;
        Progress progress(replay.end);
        while (InterruptGuard::signal() == 0 && replayer.advance(1))
            progress.update(replayer.session().world().tick());
    }
    if (const int signal = InterruptGuard::signal()) die_of(signal);
    if (replayer.failure() && replay.physics_version != physics_version) {
        print_error(fmt::format("'{}' was recorded under physics {}; this is physics {}",
                                options.file, replay.physics_version, physics_version));
        return 2;
    }
    if (replayer.failure()) {
        const std::string text = fmt::format("{}: {}\n{}", printable(options.file),
                                             difference(replayer, replay), other_program(replay));
        return print_out(text) ? 1 : 2;
    }
    const std::string text =
        fmt::format("{}: the same: {} ticks ({}), {} commands, {} fingerprints\n",
                    printable(options.file), replay.end, seconds_of(replay.end, replay.rate),
                    replay.commands.size(), replay.marks.size());
    return print_out(text) ? 0 : 2;
}

}  // namespace carom

#include "game/replay/replay_text.h"

#include <fmt/format.h>

#include "game/replay/replay_commands.h"
#include "physics/world/fingerprint.h"

namespace carom {
namespace {

std::string barred(std::string_view text) {
    std::string barred = "|";
    for (const char c : text) {
        barred += c;
        if (c == '\n') barred += '|';
    }
    return barred + '\n';
}

}  // namespace

std::string replay_text(const Replay& replay) {
    std::string text = fmt::format(
        "carom replay 3\nprogram {}\nphysics {}\nfingerprint {}\nlevel {}\n", replay.program,
        replay.physics_version, replay.fingerprint_version, replay.level);
    for (std::size_t file = 0; file < replay.texts.size(); ++file)
        text += fmt::format("file {}\n{}", file, barred(replay.texts[file]));
    for (const Include& include : replay.includes)
        text += fmt::format("include {} {} {}\n", include.from, include.file, include.path);
    text += fmt::format("hash {}\n", hexadecimal(replay.level_hash));
    for (const std::string& statement : replay.overrides)
        text += fmt::format("set {}\n", statement);
    text +=
        fmt::format("solver {}\nrate {}\nseed {}\n",
                    settings_text(replay.solver, SettingsText::recorded), replay.rate, replay.seed);
    auto mark = replay.marks.begin();
    const auto marks_before = [&](std::uint64_t tick) {
        for (; mark != replay.marks.end() && mark->tick < tick; ++mark)
            text += fmt::format("mark {} {}\n", mark->tick, hexadecimal(mark->fingerprint));
    };
    for (const TimedCommand& timed : replay.commands) {
        marks_before(timed.tick);
        text += fmt::format("at {} {}\n", timed.tick, replay_text(timed.command));
    }
    marks_before(replay.end + 1);
    if (replay.opponent > 0) text += fmt::format("opponent {}\n", replay.opponent);
    if (replay.time_left) text += fmt::format("time-left {}\n", *replay.time_left);
    if (replay.setup) text += fmt::format("stance {}\n", replay_text(*replay.setup));
    if (replay.is_unranked) text += "unranked\n";
    if (replay.position != replay.end) text += fmt::format("stands {}\n", replay.position);
    text += fmt::format("end {}\n", replay.end);
    return text;
}

}  // namespace carom

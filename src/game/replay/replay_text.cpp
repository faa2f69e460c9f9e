#include "game/replay/replay_text.h"

#include <fmt/format.h>

#include <iterator>

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
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "carom replay 3\nprogram {}\nphysics {}\nfingerprint {}\nlevel {}\n",
                   replay.program, replay.physics_version, replay.fingerprint_version,
                   replay.level);
    for (std::size_t file = 0; file < replay.texts.size(); ++file)
        fmt::format_to(out, "file {}\n{}", file, barred(replay.texts[file]));
    for (const Include& include : replay.includes)
        fmt::format_to(out, "include {} {} {}\n", include.from, include.file, include.path);
    fmt::format_to(out, "hash {}\n", hexadecimal(replay.level_hash));
    for (const std::string& statement : replay.overrides)
        fmt::format_to(out, "set {}\n", statement);
    fmt::format_to(out, "solver {}\nrate {}\nseed {}\n",
                   settings_text(replay.solver, SettingsText::recorded), replay.rate, replay.seed);
    auto mark = replay.marks.begin();
    const auto marks_before = [&](std::uint64_t tick) {
        for (; mark != replay.marks.end() && mark->tick < tick; ++mark)
            fmt::format_to(out, "mark {} {}\n", mark->tick, hexadecimal(mark->fingerprint));
    };
    for (const TimedCommand& timed : replay.commands) {
        marks_before(timed.tick);
        fmt::format_to(out, "at {} {}\n", timed.tick, replay_text(timed.command));
    }
    marks_before(replay.end + 1);
    if (replay.opponent > 0) fmt::format_to(out, "opponent {}\n", replay.opponent);
    if (replay.time_left) fmt::format_to(out, "time-left {}\n", *replay.time_left);
    if (replay.setup) fmt::format_to(out, "stance {}\n", replay_text(*replay.setup));
    if (replay.is_unranked) text += "unranked\n";
    if (replay.position != replay.end) fmt::format_to(out, "stands {}\n", replay.position);
    fmt::format_to(out, "end {}\n", replay.end);
    return text;
}

}  // namespace carom

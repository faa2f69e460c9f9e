#include "game/replay/replayer.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "game/session/game_state.h"
#include "level/load.h"
#include "physics/version.h"
#include "physics/world/fingerprint.h"

namespace carom {
namespace {

/// The name of file number `i` while the level is loaded; names are unique.
std::string file_name(const Replay& replay, std::size_t i) {
    return i == 0 ? replay.level : fmt::format("{}, file {}", replay.level, i);
}

IncludeResolver resolver_of(const Replay& replay) {
    return [&](std::string_view from, std::string_view path) -> std::optional<IncludedFile> {
        for (const Include& include : replay.includes)
            if (include.path == path && file_name(replay, include.from) == from)
                return IncludedFile{file_name(replay, include.file), replay.texts[include.file]};
        return std::nullopt;
    };
}

}  // namespace

Replay begin_replay(const Scene& scene, const SolverSettings& solver, std::string level,
                    std::span<const std::string> overrides) {
    Replay replay;
    replay.physics_version = physics_version;
    replay.fingerprint_version = fingerprint_version;
    replay.level = std::move(level);
    replay.texts = scene.texts;
    replay.includes = scene.includes;
    replay.level_hash = scene.text_hash;
    replay.overrides.assign(overrides.begin(), overrides.end());
    replay.solver = solver;
    replay.rate = scene.world.rate();
    replay.seed = scene.world.seed();
    return replay;
}

Replay record(const Session& session, std::string level, std::span<const std::string> overrides) {
    Replay replay =
        begin_replay(session.scene(), session.first_solver(), std::move(level), overrides);
    replay.commands.assign(session.commands().begin(), session.commands().end());
    replay.fingerprint_version = session.fingerprints().version();
    const auto marks = session.fingerprints().marks();
    replay.marks.assign(marks.begin(), marks.end());
    replay.end = session.latest();
    replay.position = session.world().tick();
    const auto place =
        std::ranges::lower_bound(replay.marks, replay.position, {}, &FingerprintMark::tick);
    if (place == replay.marks.end() || place->tick != replay.position)
        replay.marks.insert(place, {replay.position, fingerprint(session.world(), session.game(),
                                                                 replay.fingerprint_version)});
    return replay;
}

std::variant<Scene, ReplayError> scene_of(const Replay& replay) {
    LoadOptions options;
    options.resolve_include = resolver_of(replay);
    options.overrides = replay.overrides;
    options.seed = replay.seed;
    options.rate = replay.rate;
    LoadResult loaded = load_level(replay.texts.front(), replay.level, options);
    const std::string remedy = "take an unchanged copy of the recording, or record the game again";
    if (!loaded.scene) {
        const Diagnostic& first = loaded.diagnostics.front();
        return ReplayError{replay.hash_line,
                           fmt::format("the level in it does not load: {}:{}: {}", first.file,
                                       first.line, first.message),
                           remedy};
    }
    if (loaded.scene->text_hash != replay.level_hash)
        return ReplayError{
            1,
            fmt::format("the level in it has been changed: its hash is {}, not {}",
                        hexadecimal(loaded.scene->text_hash), hexadecimal(replay.level_hash)),
            remedy};
    for (const TimedCommand& timed : replay.commands)
        if (!is_within_reach(*loaded.scene, timed.command))
            return ReplayError{
                1,
                fmt::format("the command at tick {} names a place that is too far away",
                            timed.tick),
                remedy};
    return std::move(*loaded.scene);
}

Replayer::Replayer(Replay replay, Scene scene, std::size_t rewind_bytes)
    : replay_(std::move(replay)), session_(std::move(scene), replay_.solver, rewind_bytes) {
    session_.follow(replay_.commands, replay_.end, replay_.fingerprint_version);
    check();
}

void Replayer::check() {
    failure_ = session_.fault();
    while (!failure_ && next_mark_ < replay_.marks.size() &&
           replay_.marks[next_mark_].tick == session_.world().tick()) {
        const FingerprintMark& mark = replay_.marks[next_mark_++];
        if (fingerprint(session_.world(), session_.game(), replay_.fingerprint_version) ==
            mark.fingerprint) {
            last_equal_ = mark;
        } else {
            first_different_ = mark;
            failure_ = fmt::format("at tick {}: the fingerprint differs", mark.tick);
        }
    }
}

bool Replayer::advance(std::uint64_t ticks) {
    for (; ticks > 0 && !failure_ && session_.step_forward(); --ticks)
        check();
    if (failure_) return false;
    if (session_.world().tick() < replay_.end) return true;
    session_.go_to(replay_.position);
    return false;
}

double Replayer::progress() const {
    if (replay_.end == 0) return 1.0;
    return static_cast<double>(session_.world().tick()) / static_cast<double>(replay_.end);
}

Session Replayer::take() && {
    session_.stop_following();
    return std::move(session_);
}

}  // namespace carom

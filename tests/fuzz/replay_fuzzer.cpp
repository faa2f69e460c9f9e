#include <variant>

#include "fuzz/fuzzer.h"
#include "game/replay/replay_text.h"
#include "game/replay/replayer.h"
#include "physics/solver.h"

// Recordings: they are read or refused with a line and a remedy, what is read is written as the
// same again, and those of a small level are replayed for a few ticks.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace carom;
    auto read = read_replay(fuzz::text_of(bytes, size));
    if (const auto* error = std::get_if<ReplayError>(&read)) {
        fuzz::check(error->line >= 1 && !error->message.empty() && !error->remedy.empty());
        return 0;
    }
    Replay& replay = std::get<Replay>(read);
    const std::string text = replay_text(replay);
    const auto again = read_replay(text);
    fuzz::check(std::holds_alternative<Replay>(again));
    fuzz::check(replay_text(std::get<Replay>(again)) == text);
    // The hash would refuse nearly every level that has been changed.
    auto scene = scene_of(replay);
    if (auto* loaded = std::get_if<Scene>(&scene); loaded && fuzz::is_small(loaded->world)) {
        if (!supports(replay.solver.kind, loaded->world.model())) return 0;
        Replayer replayer(std::move(replay), std::move(*loaded), 0);
        for (int tick = 0; tick < 5 && replayer.advance(1); ++tick)
            continue;
    }
    return 0;
}

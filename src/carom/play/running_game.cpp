#include "carom/play/running_game.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "carom/controllers/pool_controller.h"
#include "carom/files/files.h"
#include "carom/files/guest.h"
#include "game/session/save_level.h"

namespace carom {

bool RunningGame::autosave() {
    const Session& session = player.session();
    const std::uint64_t tick = session.world().tick();
    const std::size_t commands = session.commands().size();
    const auto setup = player.shot_setup();
    if (tick == saved_tick && commands == saved_commands && setup == saved_setup) return true;
    if (!session.is_complete() || player.is_watching()) return false;
    Replay replay = record(session, source.path, source.overrides);
    replay.opponent = player.opponent();
    replay.setup = setup;
    replay.time_left = player.shot_time_left();
    if (const auto problem = resume_file.save(replay)) {
        player.complain(*problem);
        return false;
    }
    saved_tick = tick;
    saved_commands = commands;
    saved_setup = setup;
    return true;
}

bool RunningGame::is_saved() const {
    const Session& session = player.session();
    return session.world().tick() == saved_tick && session.commands().size() == saved_commands;
}

bool RunningGame::leave() {
    if (is_in_match(player.session()) && player.session().is_complete()) {
        autosave();
        if (resume_file.put_aside()) return true;
    }
    resume_file.remove();
    return false;
}

void RunningGame::compare_marks() {
    const Session& session = player.session();
    if (session.fault())
        player.set_problem({"the recording cannot be followed " + *session.fault()});
    if (session.fingerprints().marks().size() == marks_compared) return;
    marks_compared = session.fingerprints().marks().size();
    const auto tick = first_difference(expected, session.fingerprints().marks());
    if (!tick) return;
    if (recorded_physics != physics_version)
        player.set_problem({fmt::format("recorded under physics {}; this is physics {}",
                                        recorded_physics, physics_version)});
    else
        player.set_problem({fmt::format(
            "this is not what was recorded: at tick {} the fingerprint differs", *tick)});
}

void RunningGame::save_level(double now, std::size_t most) {
    namespace fs = std::filesystem;
    const Session& session = player.session();
    if (!session.scene().table.is_empty())
        return player.complain("a table cannot be saved in play: record it, with --record");
    const std::string stem = fs::path(source.path).stem().string();
    const bool is_same_press = !saved_level.empty() && now - level_saved < 1.0;
    level_saved = now;
    std::string path = is_same_press ? saved_level : "";
    std::error_code error;
    for (int n = 1; !is_same_press && (path.empty() || fs::exists(path, error)); ++n)
        path = fmt::format("{}-{}.level", stem, n);
    if (const auto problem =
            write_file_atomically(path, level_text(session.scene(), session.world())))
        return player.complain(*problem);
    saved_level = path;
    const auto removed = most == unlimited ? std::nullopt : remove_oldest_levels(most);
    player.say(removed
                   ? fmt::format("saved as {}; {}, the oldest of {}, is gone", path, *removed, most)
                   : "saved as " + path);
}

}  // namespace carom

#include "carom/play/running_game.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "carom/controllers/pinball_controller.h"
#include "carom/controllers/pool_controller.h"
#include "carom/files/files.h"
#include "carom/files/guest.h"
#include "carom/files/high_scores.h"
#include "carom/files/kept_recordings.h"
#include "carom/files/level_files.h"
#include "carom/files/pool_record.h"
#include "carom/files/user_folders.h"
#include "carom/play/challenge.h"
#include "game/session/amend_level.h"
#include "game/session/save_level.h"

namespace carom {
namespace {

/// Why a level of this text does not start with the bodies of `world`, bit by bit; empty: it does.
std::string obstacle_to_reading_back(const std::string& text, const std::string& name,
                                     const World& world) {
    LoadOptions options;
    options.resolve_include = include_resolver();
    const LoadResult loaded = load_level(text, name + ".level", options);
    const auto error =
        std::ranges::find(loaded.diagnostics, Severity::error, &Diagnostic::severity);
    if (error != loaded.diagnostics.end()) return error->message;
    const bool is_same = loaded.scene && has_same_bodies(loaded.scene->world, world);
    return is_same ? "" : "it would read back otherwise";
}

}  // namespace

bool RunningGame::autosave() {
    const Session& session = player.session();
    const std::uint64_t tick = session.world().tick();
    const std::size_t commands = session.commands().size();
    const auto setup = player.shot_setup();
    if (tick == saved_tick && commands == saved_commands && setup == saved_setup) return true;
    if (!session.is_complete() || player.is_watching()) return false;
    Replay replay = record(session, source.path, source.overrides);
    replay.setup = setup;
    if (const PoolPlayers* const players = player.pool_players()) {
        replay.opponent = players->opponent();
        replay.time_left = players->time_left(session);
    }
    if (const PinballScores* const scores = player.pinball_scores())
        replay.is_unranked = scores->is_left_out();
    if (const auto problem = resume_file.save(replay)) {
        player.complain(*problem);
        return false;
    }
    saved_tick = tick;
    saved_commands = commands;
    saved_setup = setup;
    return true;
}

void RunningGame::keep() {
    const Session& session = player.session();
    const bool is_played = is_in_pinball_game(session) && !player.is_demonstrating();
    if (session.scene().table.is_game && !is_played) return resume_file.remove();
    autosave();
}

bool RunningGame::is_saved() const {
    const Session& session = player.session();
    return session.world().tick() == saved_tick && session.commands().size() == saved_commands;
}

bool RunningGame::leave() {
    const Session& session = player.session();
    const bool is_open =
        is_in_match(session) || (is_in_pinball_game(session) && !player.is_demonstrating());
    if (is_open && session.is_complete()) {
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

void RunningGame::ask_for_name() {
    namespace fs = std::filesystem;
    if (!player.session().scene().table.is_empty())
        return player.complain("A level has no place for scores. Keep a recording instead.");
    const std::string stem = fs::path(source.path).stem().string();
    std::string name;
    std::error_code error;
    for (int n = 1; name.empty() || fs::exists(name + ".level", error); ++n)
        name = fmt::format("{}-{}", stem, n);
    ask({SavePrompt::What::level, std::move(name)});
}

void RunningGame::ask_for_recording_name() {
    if (!recordings_folder())
        return player.complain(fmt::format("There is no folder: {}.", no_folder_reason()));
    if (!player.session().is_complete())
        return player.complain("This game is too long: its start is forgotten.");
    ask({SavePrompt::What::recording, free_recording_name(source.path)});
}

void RunningGame::ask(SavePrompt question) {
    prompt.emplace(std::move(question));
    wait_for_answer(prompt->text());
}

void RunningGame::wait_for_answer(const std::string& question) {
    was_paused = player.clock().is_paused();
    player.pause(true);
    player.set_prompt(question);
}

void RunningGame::ask_for_key() {
    const bool is_pinball = !player.session().scene().table.is_empty();
    key_prompt.emplace(is_pinball ? KeyLayer::pinball : KeyLayer::common);
    wait_for_answer(key_prompt->text());
}

std::optional<KeyPrompt::Changed> RunningGame::answer_key(const InputEvent& event,
                                                          const KeyMap& keys) {
    const auto result = key_prompt->handle(event, keys);
    if (std::holds_alternative<KeyPrompt::Open>(result)) {
        player.set_prompt(key_prompt->text());
        return std::nullopt;
    }
    key_prompt.reset();
    player.set_prompt({});
    player.pause(was_paused);
    const auto* const changed = std::get_if<KeyPrompt::Changed>(&result);
    return changed ? std::optional(*changed) : std::nullopt;
}

void RunningGame::answer(const InputEvent& event, std::size_t most) {
    const auto result = prompt->handle(event);
    if (std::holds_alternative<SavePrompt::Open>(result)) return player.set_prompt(prompt->text());
    const bool is_level = prompt->what() == SavePrompt::What::level;
    prompt.reset();
    player.set_prompt({});
    if (const auto* answered = std::get_if<SavePrompt::Answer>(&result)) {
        if (is_level)
            save_level(*answered, most);
        else
            keep_recording(answered->name, most);
    }
    player.pause(was_paused);
}

void RunningGame::keep_recording(const std::string& name, std::size_t most) {
    const std::string folder = recordings_folder().value_or(".");
    const std::string path = recording_path(name);
    std::error_code error;
    if (std::filesystem::exists(path, error))
        return player.complain("There is a recording " + name + ". Choose another name.");
    if (const auto problem = make_folder(folder)) return player.complain(*problem);
    const Recording recording(path, Existing::kept);
    if (const auto problem =
            recording.write(player.session(), source.path, source.overrides, opponent_of(player)))
        return player.complain(*problem);
    if (most != unlimited) remove_oldest(folder, ".replay", most);
    player.say("Kept as " + name + ". Watch it from the menu, in the group Yours.");
}

void RunningGame::save_level(const SavePrompt::Answer& answer, std::size_t most) {
    const Session& session = player.session();
    const Scene& scene = session.scene();
    const World world = answer.is_start ? edited_start(scene, session.world(), session.commands())
                                        : session.world();
    AmendedLevel amended = amended_level(scene, world);
    if (amended.text) {
        std::string why_not = obstacle_to_reading_back(*amended.text, answer.name, world);
        if (!why_not.empty()) amended = {std::nullopt, std::move(why_not)};
    }
    const std::string path = answer.name + (amended.text ? "" : "-flat") + std::string(".level");
    std::error_code error;
    if (std::filesystem::exists(path, error))
        return player.complain(path + " exists already. Choose another name.");
    if (const auto problem =
            write_file_atomically(path, amended.text ? *amended.text : level_text(scene, world),
                                  Access::everybody, Existing::kept))
        return player.complain(*problem);
    std::string done = "Saved as " + path + ". Play it from the menu, in the group Yours.";
    if (!amended.text) done = fmt::format("Saved flat as {}, since {}.", path, amended.obstacle);
    const auto removed = most == unlimited ? std::nullopt : remove_oldest(".", ".level", most);
    if (removed) done += fmt::format(" {}, the oldest of {}, is gone.", *removed, most);
    player.say(done);
}

void RunningGame::keep_pool_record(bool all) {
    PoolPlayers* const players = player.pool_players();
    const auto since = players ? players->take_record(all) : std::nullopt;
    if (!since) return;
    const PoolRecordText kept = carom::keep_pool_record(*since);
    if (kept.problem) player.complain(*kept.problem);
    const std::size_t before = rungs_climbed(players->record_before());
    players->set_record(kept.record);
    if (rungs_climbed(kept.record) == before) return;
    player.say(climb_text(kept.record));
    entry = next_challenge(kept.record);
}

void RunningGame::keep_stars() {
    const int reached = stars_of(player.session().game());
    const PoolPlayers* const players = player.pool_players();
    if (reached <= stars || (players && !players->keeps_stars(player.session()))) return;
    stars = reached;
    if (const auto problem =
            carom::keep_stars(stars_name.empty() ? source.path : stars_name, reached))
        player.complain(*problem);
}

}  // namespace carom

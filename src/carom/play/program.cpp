#include "carom/play/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "carom/controllers/pool_controller.h"
#include "carom/files/files.h"
#include "carom/files/high_scores.h"
#include "carom/files/pool_record.h"
#include "carom/files/user_folders.h"
#include "carom/pool/pool_status.h"
#include "carom/text/level_words.h"

namespace carom {
namespace {

std::string absolute(const std::string& path) {
    std::error_code error;
    const auto result = std::filesystem::weakly_canonical(path, error);
    return error ? path : result.string();
}

/// All files that a level was loaded from.
std::vector<std::string> files_of(const Scene& scene, const std::string& path) {
    std::vector<std::string> files{path};
    std::error_code error;
    for (const std::string& file : scene.files)
        if (std::filesystem::exists(file, error)) files.push_back(file);
    return files;
}

// Gives the player the high scores of the table, if it keeps any. They are for the level as it is:
// a statement or a solver of the player's own can make a table easier, and so can an earlier text.
void show_high_scores(Player& player, const LevelSource& source) {
    const PinballTable& table = player.session().scene().table;
    if (!table.is_game) return;
    const bool is_own = source.solver || !source.overrides.empty();
    const bool is_new = player.session().latest() == 0;  // else it has been said
    if (is_own && is_new && table.highscores > 0 && !player.is_watching())
        player.say("Changed by --set or --solver: no high scores here.");
    if (is_own || source.is_earlier || table.highscores == 0)
        return player.set_high_scores({.lines = {}, .most = 0});
    HighScoresText kept = load_high_scores(high_scores_name(source.path), table.highscores);
    if (kept.problem) player.complain(*kept.problem);
    player.set_high_scores(with_house_scores(std::move(kept.scores), table.replay));
}

// Gives a player at a game of pool the record of earlier matches.
void show_pool_record(Player& player) {
    PoolPlayers* const players = player.pool_players();
    if (!players || !pool_of(player.session())) return;
    PoolRecordText kept = load_pool_record();
    if (kept.problem) player.complain(*kept.problem);
    players->set_record(kept.record);
}

}  // namespace

Program::Program(PlayOptions options, PreferencesText preferences)
    : options_(std::move(options)),
      preferences_(std::move(preferences.preferences)),
      preference_problems_(std::move(preferences.problems)) {
    view_.renderer = options_.renderer.value_or(preferences_.renderer.value_or(nullptr));
    view_.color_by = preferences_.color_by;
    theme_ = options_.theme.value_or(preferences_.theme.value_or(ThemeChoice{}));
    view_.ball_style = preferences_.ball_style;
    view_.trails = preferences_.trails && !options_.low_bandwidth;
    if (options_.low_bandwidth && !options_.renderer) view_.renderer = &ascii_renderer();
    mouse_ = options_.mouse.value_or(preferences_.mouse.value_or(true));
}

ViewOptions Program::view() const {
    ViewOptions view = view_;
    view.look = {.colors = capabilities_.direct_color ? direct_colors : capabilities_.colors,
                 .utf8 = capabilities_.utf8,
                 .light_background = theme_.is_light.value_or(capabilities_.light_background),
                 .mosaic = capabilities_.mosaic,
                 .theme = theme_.name,
                 .ground = theme_.brings_own_ground(capabilities_.light_background)
                               ? std::nullopt
                               : capabilities_.background};
    return view;
}

void Program::set_capabilities(const Capabilities& capabilities) {
    capabilities_ = capabilities;
    if (auto* game = std::get_if<RunningGame>(&page_)) {
        ViewOptions changed = game->player.view();
        changed.look = view().look;
        game->player.set_view(changed);
        game->player.terminal().tells_key_release = capabilities.key_release;
    }
    if (auto* menu = std::get_if<Menu>(&page_)) menu->touch();
    if (auto* notice = std::get_if<Notice>(&page_)) notice->needs_draw = true;
    if (auto* resuming = std::get_if<Resuming>(&page_)) resuming->needs_draw = true;
}

std::optional<Problems> Program::start() {
    if (!options_.replay.empty()) return open_recording(options_.replay);
    if (!options_.record.empty()) {
        recording_.emplace(options_.record);
        if (const auto obstacle = recording_->obstacle()) return Problems{*obstacle};
    }
    const auto folder = resume_folder();
    std::vector<std::string> unreadable;
    if (options_.resume) {
        std::string path;
        if (!options_.level.empty()) {
            const FoundLevel found = find_level(options_.level);
            if (!found.path) return Problems{found.error};
            path = absolute(*found.path);
        }
        const auto games =
            folder ? interrupted_games(*folder, path) : std::vector<InterruptedGame>{};
        if (!games.empty()) {
            resume(games.front());
            return std::nullopt;
        }
        if (folder) unreadable = unreadable_games(*folder, path);
        if (options_.level.empty()) {
            unreadable.insert(unreadable.begin(), "there is no unfinished game");
            return unreadable;
        }
    }
    if (options_.level.empty()) {
        show_menu({});
        return std::nullopt;
    }
    const LevelSource source = carom::source_of(options_, options_.level);
    auto problems = open(source);
    auto* const game = std::get_if<RunningGame>(&page_);
    if (game && options_.resume && unreadable.empty())
        game->player.say("There is no unfinished game: a new one begins.");
    else if (game && options_.resume)
        game->player.complain(fmt::format(
            "The unfinished game cannot be read ({}): a new one begins.", unreadable[0]));
    if (problems && options_.watch && find_level(source.path).path) {
        open_or_tell(source);
        return std::nullopt;
    }
    return problems;
}

void Program::show_menu(std::string_view choose) {
    const auto folder = resume_folder();
    const auto interrupted = folder ? interrupted_games(*folder) : std::vector<InterruptedGame>{};
    const auto load_for_picture = [this](const MenuItem& item) {
        if (item.interrupted) return load(item.interrupted->replay, options_.rewind_bytes);
        return load(item.challenge ? source_of(options_, *item.challenge)
                                   : carom::source_of(options_, item.path));
    };
    page_.emplace<Menu>(menu_items(interrupted), load_for_picture, choose);
}

std::optional<Problems> Program::open(const LevelSource& source) {
    auto opened = open_game(source);
    if (auto* problems = std::get_if<Problems>(&opened)) return std::move(*problems);
    OpenedGame& game = std::get<OpenedGame>(opened);
    if (recording_) game.session.keep_all_commands();
    Player player(std::move(game.session), view(), preferences_.keys, game.solver_is_picked);
    // The lines below the table show the aim there, so the goal is shown once, at the start.
    if (shots_of(player.session())) player.say(words_of(player.session().scene().comment).goal);
    if (!game.warnings.empty()) player.say(game.warnings.front());
    if (!preference_problems_.empty()) player.complain(preference_problems_.front());
    preference_problems_.clear();

    LevelSource found = source;
    found.path = absolute(find_level(source.path).path.value_or(source.path));
    std::optional<InterruptedGame> offer;
    if (const auto folder = resume_folder()) {
        auto games = interrupted_games(*folder, found.path);
        const auto same = std::ranges::find_if(games, [&](const InterruptedGame& interrupted) {
            return interrupted.replay.level_hash == player.session().scene().text_hash;
        });
        if (same != games.end()) offer = std::move(*same);
    }
    if (offer) {
        const double seconds = static_cast<double>(offer->replay.position) / offer->replay.rate;
        player.say(fmt::format("Unfinished game at {:.1f} s. Press {} to resume.", seconds,
                               preferences_.keys.hint("take-up")));
    }
    enter(std::move(found), std::move(player), std::move(offer));
    return std::nullopt;
}

std::optional<Problems> Program::open_recording(const std::string& path) {
    auto opened = open_replay(path);
    if (const auto* error = std::get_if<std::string>(&opened)) return lines_of(*error);
    auto& [replay, scene] = std::get<OpenedReplay>(opened);
    Session session(std::move(scene), replay.solver, options_.rewind_bytes);
    session.follow(std::move(replay.commands), replay.end, replay.fingerprint_version);
    Player player(std::move(session), view(), preferences_.keys);
    player.watch_opponent(replay.opponent);
    LevelSource source = carom::source_of(options_, replay.level);
    enter(std::move(source), std::move(player), std::nullopt);
    auto& game = std::get<RunningGame>(page_);
    game.expected = std::move(replay.marks);
    game.recorded_physics = replay.physics_version;
    return std::nullopt;
}

void Program::enter(LevelSource source, Player player, std::optional<InterruptedGame> offer) {
    if (const auto left = views_.find(source.path); left != views_.end()) {
        ViewOptions options = left->second;
        options.look = view().look;
        player.set_view(options);
    }
    TerminalState& terminal = player.terminal();
    terminal.mouse_is_off = !mouse_;
    terminal.tells_key_release = capabilities_.key_release;
    terminal.rings = preferences_.bell;
    terminal.key_repeat = preferences_.key_repeat;
    if (PoolPlayers* const players = player.pool_players()) players->set_hand(preferences_.hand);
    player.set_keep_going(keep_going_);
    if (options_.paused) player.pause(true);
    show_high_scores(player, source);
    if (!player.is_watching()) show_pool_record(player);
    if (options_.demo) player.demonstrate();
    if (options_.opponent > 0 && !player.is_watching() &&
        !(player.pool_players() &&
          player.pool_players()->set_opponent(player.session(), options_.opponent)))
        player.complain("No game of pool is played here, so there is no opponent.");
    FileWatcher watch;
    if (options_.watch) watch = FileWatcher(files_of(player.session().scene(), source.path));
    ResumeFile resume_file;
    const auto folder = resume_folder();
    if (folder && !player.is_watching()) resume_file = ResumeFile(*folder, source.path);
    page_.emplace<RunningGame>(RunningGame{std::move(source), std::move(player), std::move(watch),
                                           std::move(resume_file), std::move(offer)});
}

void Program::open_or_tell(const LevelSource& source) {
    auto problems = open(source);
    if (!problems) return;
    tell("This level cannot be played", std::move(*problems));
    auto& notice = std::get<Notice>(page_);
    notice.source = source;
    if (options_.watch)
        notice.watch = FileWatcher({find_level(source.path).path.value_or(source.path)});
}

void Program::tell(std::string title, Problems problems) {
    page_.emplace<Notice>(Notice{std::move(title), std::move(problems)});
}

/// Writes the recording; false if it cannot be written. Then the game is kept, as an interrupted
/// one.
bool Program::end_game() {
    auto* game = std::get_if<RunningGame>(&page_);
    if (game && recording_ && !game->player.is_watching()) {
        const Recording recording = *std::exchange(recording_, std::nullopt);
        lost_recording_ = recording.write(game->player.session(), game->source.path,
                                          game->source.overrides, opponent_of(game->player));
        if (lost_recording_) {
            *lost_recording_ +=
                game->autosave()
                    ? "; carom play --resume --record FILE resumes the game and records all of it"
                    : "; the game could not be kept for carom play --resume either";
            return false;
        }
    }
    leave_game();
    return true;
}

void Program::leave_game() {
    auto* game = std::get_if<RunningGame>(&page_);
    if (!game) return;
    keep_key_repeat(game->player.terminal().key_repeat, preferences_, settings_);
    game->keep_pool_record(true);
    is_kept_ = game->leave();
}

void Program::interrupt() {
    auto* game = std::get_if<RunningGame>(&page_);
    if (!game) return;
    keep_key_repeat(game->player.terminal().key_repeat, preferences_, settings_);
    game->keep_pool_record(true);
    if (recording_)
        game->autosave();
    else
        game->keep();
    if (recording_ && !game->player.is_watching())
        lost_recording_ =
            recording_->write(game->player.session(), game->source.path, game->source.overrides);
}

void Program::reload(RunningGame& game) {
    auto opened = open_game(game.source);
    if (const auto* problems = std::get_if<Problems>(&opened)) {
        game.player.set_problem(problems->empty() ? Problems{"the level cannot be read"}
                                                  : *problems);
        return;
    }
    OpenedGame& fresh = std::get<OpenedGame>(opened);
    if (recording_) fresh.session.keep_all_commands();
    game.player = game.player.continued_with(std::move(fresh.session), fresh.solver_is_picked);
    game.source.is_earlier = false;
    game.player.say(fresh.warnings.empty() ? "The level has changed: restarted."
                                           : fresh.warnings.front());
    game.watch = FileWatcher(files_of(game.player.session().scene(), game.source.path));
}

}  // namespace carom

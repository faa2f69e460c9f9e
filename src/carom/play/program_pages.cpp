#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

#include "carom/context/page_keys.h"
#include "carom/files/files.h"
#include "carom/files/high_scores.h"
#include "carom/play/program.h"
#include "terminal/canvas/own_ground.h"
#include "terminal/panels/pages.h"

namespace carom {
namespace {

constexpr double autosave_interval = 5.0;  // s
constexpr double watch_interval = 0.2;     // s
constexpr double never = std::numeric_limits<double>::infinity();
/// Ticks between two looks at the clock while a game is being resumed.
constexpr std::uint64_t ticks_at_once = 16;

bool is_key_press(const InputEvent& event) {
    return event.kind == InputEvent::Kind::key && event.action != InputEvent::Action::release;
}

// Keeps a score once its initials are entered, or the time for them has passed.
void keep_score(Player& player, const std::string& path) {
    PinballScores* const scores = player.pinball_scores();
    const auto score = scores ? scores->take() : std::nullopt;
    if (!score) return;
    const PinballTable& table = player.session().scene().table;
    HighScoresText kept = keep_high_score(high_scores_name(path), table.highscores, *score);
    if (kept.problem) player.complain(*kept.problem);
    player.set_high_scores(with_house_scores(std::move(kept.scores), table.replay));
}

// Settings that keys of a game have changed.
void take_settings(const Player& player, Preferences& preferences, SettingsFile& file) {
    if (player.terminal().rings != preferences.bell) {
        preferences.bell = player.terminal().rings;
        file.keep("bell", preferences.bell ? "on" : "off");
    }
    if (const auto* const players = player.pool_players();
        players && players->hand() != preferences.hand) {
        preferences.hand = players->hand();
        file.keep("hand", std::to_string(players->hand()));
    }
}

}  // namespace

void Program::handle(const InputEvent& event, double now) {
    if (event.kind == InputEvent::Kind::hangup || event.kind == InputEvent::Kind::end) {
        interrupt();
        is_over_ = true;
    } else if (auto* game = std::get_if<RunningGame>(&page_)) {
        handle_game(*game, event, now);
    } else if (auto* menu = std::get_if<Menu>(&page_)) {
        handle_menu(*menu, event);
    } else if (auto* notice = std::get_if<Notice>(&page_)) {
        handle_notice(*notice, event);
    } else {
        handle_resuming(event);
    }
    auto* const game = std::get_if<RunningGame>(&page_);
    if (!game) return;
    if (const auto fault = settings_.take_fault()) game->player.say(*fault);
}

void Program::watch_or_tell(const std::string& recording) {
    if (auto problems = open_recording(recording)) {
        tell("This recording cannot be played", std::move(*problems));
        std::get<Notice>(page_).entry = recording;
        return;
    }
    std::get<RunningGame>(page_).entry = recording;
}

std::string_view Program::next_theme() {
    const std::string_view next = theme_after(theme_, capabilities_.light_background);
    theme_ = *theme_choice(next);
    set_capabilities(capabilities_);  // renews what is drawn
    settings_.keep("theme", next);
    return next;
}

void Program::handle_game(RunningGame& game, const InputEvent& event, double now) {
    const std::size_t most_saves =
        options_.guest ? options_.guest->most_saves : RunningGame::unlimited;
    if (game.prompt) return game.answer(event, most_saves);
    if (game.key_prompt) {
        if (const auto changed = game.answer_key(event, preferences_.keys)) {
            game.player.say(change_key(*changed, preferences_.keys, settings_));
            game.player.set_keys(preferences_.keys);
        }
        return;
    }
    const PlayRequest request = game.player.handle(event);
    keep_score(game.player, game.source.path);
    views_[game.source.path] = game.player.view();
    take_settings(game.player, preferences_, settings_);
    game.keep_pool_record(false);
    if (next_autosave_ < now) next_autosave_ = now + autosave_interval;
    switch (request) {
        case PlayRequest::quit:
            end_game();
            is_over_ = true;
            break;
        case PlayRequest::menu: {
            const std::string entry = game.entry.empty() ? game.source.path : game.entry;
            if (end_game())
                show_menu(entry);
            else
                tell("The recording is lost", {*lost_recording_});
            break;
        }
        case PlayRequest::save:
            game.ask_for_name();
            break;
        case PlayRequest::record:
            game.ask_for_recording_name();
            break;
        case PlayRequest::toggle_mouse:
            mouse_ = !mouse_;
            game.player.terminal().mouse_is_off = !mouse_;
            game.player.say(mouse_ ? "mouse on" : "mouse off: the terminal has it");
            settings_.keep("mouse", mouse_ ? "on" : "off");
            break;
        case PlayRequest::theme:
            game.player.say(fmt::format("theme: {}", next_theme()));
            break;
        case PlayRequest::change_key:
            game.ask_for_key();
            break;
        case PlayRequest::resume:
            if (game.offer)
                resume(*game.offer);
            else
                game.player.say("This level has no unfinished game.");
            break;
        case PlayRequest::none:
            break;
    }
}

void Program::handle_menu(Menu& menu, const InputEvent& event) {
    const Action* const action =
        is_key_press(event) ? preferences_.keys.action_of(key_of(event)) : nullptr;
    // A key with a character belongs to the search.
    if (action && action->name == "theme" && event.key >= key::f1)
        return menu.tell(fmt::format("theme: {}", next_theme()));
    const Menu::Choice choice = menu.handle(event);
    if (std::holds_alternative<Menu::Quit>(choice)) is_over_ = true;
    if (const auto* item = std::get_if<MenuItem>(&choice)) {
        if (item->interrupted)
            resume(*item->interrupted);
        else if (item->challenge)
            open_challenge(Challenge(*item->challenge));
        else if (item->is_recording)
            watch_or_tell(std::string(item->path));
        else
            open_or_tell(carom::source_of(options_, item->path));
    }
}

void Program::handle_notice(Notice& notice, const InputEvent& event) {
    if (!is_key_press(event)) return;
    notice.needs_draw = true;
    if (notice.scroll_with(event)) return;
    if (event.key == U'q') {
        is_over_ = true;
        return;
    }
    show_menu(notice.source ? notice.source->path : std::string(notice.entry));
}

bool Program::Notice::scroll_with(const InputEvent& event) {
    const auto rows = scroll_of(event);
    if (rows) scroll += *rows;
    return rows.has_value();
}

void Program::handle_resuming(const InputEvent& event) {
    if (!is_key_press(event)) return;
    if (event.key == U'q') is_over_ = true;
    if (event.key == key::escape) show_menu({});
}

void Program::tell_dropped_input(std::size_t events) {
    if (auto* game = std::get_if<RunningGame>(&page_))
        game->player.say(fmt::format("{} keys came too fast and were ignored", events));
}

void Program::set_keep_going(const KeepGoing& keep_going) {
    keep_going_ = keep_going;
    if (auto* game = std::get_if<RunningGame>(&page_)) game->player.set_keep_going(keep_going_);
}

bool Program::cancels_tick(const InputEvent& event) const {
    return !is_playing() || carom::cancels_tick(event, preferences_.keys);
}

void Program::advance(double seconds, double now, const MayGoOn& may_go_on) {
    if (auto* game = std::get_if<RunningGame>(&page_))
        advance_game(*game, seconds, now, may_go_on);
    else if (auto* menu = std::get_if<Menu>(&page_))
        menu->advance(seconds, may_go_on);
    else if (auto* notice = std::get_if<Notice>(&page_))
        advance_notice(*notice, now);
    else if (auto* resuming = std::get_if<Resuming>(&page_))
        advance_resuming(*resuming, may_go_on);
}

void Program::advance_game(RunningGame& game, double seconds, double now,
                           const MayGoOn& may_go_on) {
    if (options_.watch && now >= next_look_) {
        next_look_ = now + watch_interval;
        if (game.watch.has_changed()) reload(game);
    }
    // A pause may sleep for longer than one turn of the loop counts.
    const double faded = std::exchange(game.messages_faded, now);
    game.player.fade_messages(faded > 0.0 ? now - faded : seconds);
    game.player.advance(seconds, may_go_on);
    keep_score(game.player, game.source.path);
    if (game.player.is_watching())
        game.compare_marks();
    else
        game.keep_stars();
    if (now >= next_autosave_) {
        next_autosave_ = now + autosave_interval;
        game.keep();
    }
}

void Program::advance_notice(Notice& notice, double now) {
    if (!options_.watch || !notice.source || now < next_look_) return;
    next_look_ = now + watch_interval;
    if (!notice.watch.has_changed()) return;
    const LevelSource source = *notice.source;
    open_or_tell(source);
}

void Program::advance_resuming(Resuming& resuming, const MayGoOn& may_go_on) {
    resuming.needs_draw = true;
    do {
        if (!resuming.replayer.advance(ticks_at_once)) return finish_resuming();
    } while (may_go_on());
}

double Program::seconds_to_change(double now) const {
    if (std::holds_alternative<Resuming>(page_)) return 0.0;
    if (std::holds_alternative<Menu>(page_)) return 0.0;
    double seconds = never;
    if (options_.watch) seconds = std::max(0.0, next_look_ - now);
    if (const auto* game = std::get_if<RunningGame>(&page_)) {
        seconds = std::min(seconds, game->player.seconds_to_change());
        if (!game->is_saved()) seconds = std::min(seconds, std::max(0.0, next_autosave_ - now));
    }
    return seconds;
}

bool Program::take_bell() {
    auto* const game = std::get_if<RunningGame>(&page_);
    return game && game->player.take_bell();
}

bool Program::needs_draw() const {
    if (const auto* game = std::get_if<RunningGame>(&page_)) return game->player.needs_draw();
    if (const auto* menu = std::get_if<Menu>(&page_)) return menu->needs_draw();
    if (const auto* notice = std::get_if<Notice>(&page_)) return notice->needs_draw;
    if (const auto* resuming = std::get_if<Resuming>(&page_)) return resuming->needs_draw;
    return false;
}

void Program::draw(Canvas& canvas) {
    canvas.fill({});
    if (auto* game = std::get_if<RunningGame>(&page_))
        game->player.draw(canvas, capabilities_.cell_aspect);
    else if (auto* menu = std::get_if<Menu>(&page_))
        menu->draw(canvas, capabilities_.cell_aspect, view());
    else if (auto* notice = std::get_if<Notice>(&page_))
        notice->draw(canvas, view().look, notice->source && options_.watch);
    else if (auto* resuming = std::get_if<Resuming>(&page_))
        resuming->draw(canvas, view().look);
    if (theme_.brings_own_ground(capabilities_.light_background))
        paint_own_ground(canvas, view().look);
}

void Program::Notice::draw(Canvas& canvas, const Look& look, bool is_tried_again) {
    needs_draw = false;
    if (is_too_small(canvas.columns(), canvas.rows())) return draw_too_small(canvas);
    const std::string_view footer =
        is_tried_again ? "save the file to try again   q: quit   any other key: menu"
                       : "q: quit   any other key: menu";
    scroll = draw_text_page(canvas, title, lines, scroll, footer, look).scroll;
}

void Program::Resuming::draw(Canvas& canvas, const Look& look) {
    needs_draw = false;
    if (is_too_small(canvas.columns(), canvas.rows())) return draw_too_small(canvas);
    const std::string text[] = {game.replay.level,
                                fmt::format("{:.0f} % done", 100.0 * replayer.progress())};
    draw_text_page(canvas, "Resuming the unfinished game", text, 0, "esc: menu   q: quit", look);
}

ScreenRequests Program::screen_requests() const {
    const auto* game = std::get_if<RunningGame>(&page_);
    return {mouse_, game && game->player.wants_motion()};
}

}  // namespace carom

#include "carom/controllers/pinball_controller.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "carom/context/time_control.h"
#include "carom/pool/power_bar.h"
#include "game/pinball/pinball.h"

namespace carom {
namespace {

constexpr const char* demo_help = "carom plays: any key of the table takes over";
constexpr const char* attract_help = "carom plays: any key starts a game";

/// An action that costs a game something, so that one stray key must not perform it.
struct Risk {
    std::string_view action;
    const char* effect;
    bool costs_place;  ///< among the high scores, and nothing else
};
constexpr Risk risks[] = {
    {"restart", "end this game.", false},
    {"second-forward", "skip a second.", false},
    {"second-back", "go back: no high score then.", true},
    {"step-back", "go back: no high score then.", true},
    {"slower", "slow down: no high score then.", true},
    {"demo", "watch carom play: no high score then.", true},
};

/// Applies presses for which the table has a device.
void press_buttons(PlayContext& play, const std::vector<command::Press>& presses) {
    for (const command::Press& press : presses)
        if (has_button(play.session.scene(), press.button)) play.session.apply(press);
    if (!presses.empty()) play.needs_draw = true;
}

bool is_over(const Session& session) {
    return session.scene().table.is_game &&
           std::get<PinballState>(session.game()).phase == PinballState::Phase::over;
}

/// Whether nobody has begun to play, or a game is over.
bool waits_for_player(const Session& session) {
    return session.scene().table.is_game && !is_in_pinball_game(session);
}

bool has_flippers(const Scene& scene) {
    return has_button(scene, Button::left_flipper) || has_button(scene, Button::right_flipper);
}

}  // namespace

bool is_in_pinball_game(const Session& session) {
    const auto* const state = std::get_if<PinballState>(&session.game());
    if (!state || !session.scene().table.is_game || is_over(session)) return false;
    return state->games > 1 || state->players > 1 || state->ball > 1 || state->score > 0 ||
           state->is_launched;
}

void PinballController::learn_keys(PlayContext& play) {
    if (play.terminal.tells_key_release) input_.set_tells_release();
    if (play.terminal.key_repeat) input_.remember(*play.terminal.key_repeat);
}

/// A button of the table hands control back to the player.
void PinballController::end_demo(PlayContext& play) {
    if (!demo_) return;
    demo_.reset();
    say(play, "your game");
}

void PinballController::press_key(PlayContext& play, Button button, const InputEvent& event) {
    // The gauge of the plunger has the place of the message.
    const bool pulls = button == Button::plunger && event.action == InputEvent::Action::press;
    if (pulls && !demo_) play.messages.end_message();
    end_demo(play);
    const bool starts_game = button == Button::plunger && is_over(play.session);
    press_buttons(play, input_.take_key(button, event));
    // The key that starts a game does not pull the plunger under its first ball.
    if (starts_game) press_buttons(play, input_.let_go_of_plunger());
    play.terminal.key_repeat = input_.key_repeat();
}

void PinballController::attract(PlayContext& play, double seconds) {
    constexpr double patience = 20.0;  // s
    const bool waits = !demo_ && !play.clock.is_paused() && !feedback_.scores().initials() &&
                       waits_for_player(play.session);
    idle_ = waits ? idle_ + seconds : 0.0;
    if (idle_ < patience) return;
    demonstrate(play, true);
    attracts_ = true;
    say(play, attract_help);
}

void PinballController::end_attract(PlayContext& play) {
    attracts_ = false;
    demo_.reset();
    press_buttons(play, input_.release_all());
    restart(play);
    say(play, "your game");
}

bool PinballController::take(PlayContext& play, const InputEvent& event) {
    idle_ = 0.0;
    const bool ends_attract = attracts_ && event.action == InputEvent::Action::press;
    if (ends_attract) end_attract(play);
    if (event.kind == InputEvent::Kind::mouse) return take_mouse(play, event);
    if (event.kind != InputEvent::Kind::key) return false;
    learn_keys(play);
    // A key of the table that ends attract mode does nothing else.
    if (ends_attract && play.keys.button_of(key_of(event))) return true;
    // Initials take every key, but not the release of a button that was held when the game ended.
    if (feedback_.scores().initials() && event.action != InputEvent::Action::release) {
        feedback_.scores().type(event);
        play.needs_draw = true;
        return true;
    }
    const Key key = key_of(event);
    if (const auto button = play.keys.button_of(key)) {
        press_key(play, *button, event);
        return true;
    }
    input_.take_other_key(event);
    const Action* const action = play.keys.action_of(key, KeyLayer::pinball);
    if (!action) return false;
    if (event.action == InputEvent::Action::press) perform(play, *action);
    return true;
}

bool PinballController::take_mouse(PlayContext& play, const InputEvent& event) {
    const Camera& camera = play.view.camera;
    const Vec2 at = to_world(camera, {event.column, event.row});
    const double row = length(to_world(camera, {0.0, 1.0}) - to_world(camera, {0.0, 0.0}));
    if (const auto pull = input_.drag_plunger(event, at, row)) {
        play.session.apply(*pull);
        play.needs_draw = true;
        return true;
    }
    const auto presses = input_.take_mouse(event, at, play.session);
    if (!presses) return false;
    if (event.action == InputEvent::Action::press) end_demo(play);
    press_buttons(play, *presses);
    return true;
}

/// Returns true and asks, if the action would cost the game something, unless its key has just been
/// pressed before.
bool PinballController::asks_first(PlayContext& play, const Action& action) {
    const auto* const risk = std::ranges::find(risks, action.name, &Risk::action);
    if (risk == std::end(risks) || demo_ || !is_in_pinball_game(play.session)) return false;
    if (risk->costs_place && !feedback_.may_enter(play)) return false;
    confirmation_.press(action.name);
    confirmation_.ask();
    if (confirmation_.is_given()) return false;
    say(play, fmt::format("Press {} again to {}", play.keys.hint(action.name), risk->effect));
    return true;
}

void PinballController::perform(PlayContext& play, const Action& action) {
    if (action.where == Where::editing && play.session.scene().table.is_game)
        return say(play, "Disabled under rules.");
    if (asks_first(play, action)) return;
    using AtPinball = void (*)(PinballController&, PlayContext&);
    if (const auto* perform = std::get_if<AtPinball>(&action.perform))
        return (*perform)(*this, play);
    FreeController::perform(play, action);
}

void PinballController::pass(PlayContext& play, double seconds) {
    learn_keys(play);
    confirmation_.pass(seconds);
    press_buttons(play, input_.pass(seconds, play.clock.is_paused()));
    attract(play, seconds);
    feedback_.pass(play, seconds);
}

void PinballController::before_tick(PlayContext& play) {
    const Session& session = play.session;
    if (!demo_ || session.world().tick() < session.latest()) return;
    for (const command::Press& press :
         demo_->play(session.scene(), session.world(), std::get<PinballState>(session.game())))
        play.session.apply(press);
}

void PinballController::after_ticks(PlayContext& play, double seconds) {
    feedback_.after_ticks(play, seconds, is_demonstrating());
}

void PinballController::demonstrate(PlayContext& play, bool does) {
    attracts_ = false;
    if (!does) press_buttons(play, input_.release_all());
    demo_.reset();
    if (does) demo_.emplace();
    say(play, does ? demo_help : "your game");
}

void PinballController::next_flipper_mode(PlayContext& play) {
    say(play, input_.next_flipper_mode());
}

void PinballController::set_high_scores(HighScores scores) {
    feedback_.scores().set(std::move(scores));
}

void PinballController::continue_from(PlayContext& play, const Controller& before) {
    const auto* const table = dynamic_cast<const PinballController*>(&before);
    if (!table) return;
    input_ = table->input_;
    input_.release_all();
    feedback_.scores().continue_from(table->feedback_.scores(),
                                     play.session.scene().table.highscores);
}

void PinballController::cut_panel(const PlayContext& play, CellArea& area) {
    feedback_.cut_panel(play, area);
}

Camera PinballController::fit(const PlayContext& play, const CellArea& area, double aspect) {
    return feedback_.fit(play, area, aspect);
}

void PinballController::look(PlayContext& play) {
    learn_keys(play);
}

void PinballController::annotate(const PlayContext& play, Annotations& annotations) const {
    feedback_.annotate(play, annotations);
    FreeController::annotate(play, annotations);
}

void PinballController::draw_panel(const PlayContext& play, Canvas& canvas) const {
    feedback_.draw_panel(play, canvas, is_demonstrating());
}

void PinballController::add_status(const PlayContext& play, HudInfo& info) const {
    feedback_.add_score(play, info);
    info.message_in_line = true;
    if (is_over(play.session)) {
        info.goal = "GAME OVER";
        return;
    }
    const auto& state = std::get<PinballState>(play.session.game());
    // Its rules have not said what to shoot for: the goal would flicker up for a moment.
    if (state.rules.turn_is_new && is_in_pinball_game(play.session)) info.goal.clear();
    // Without the panel, the first line is for the score alone, which must not be cut.
    std::string task = info.goal;
    if (!feedback_.has_panel()) info.goal.clear();
    const double pull = state.pull;
    if (pull > 0.0) {
        info.game = fmt::format("plunger {} {:.0f} %", power_bar(pull, play.view.options.look),
                                100.0 * pull);
        return;
    }
    if (is_demonstrating()) {
        info.game = attracts_ ? attract_help : demo_help;
        return;
    }
    if (!feedback_.has_panel() && !task.empty()) {
        info.game = std::move(task);
        return;
    }
    if (!has_flippers(play.session.scene())) return;
    const std::string mouse = play.terminal.mouse_is_off ? "" : ", or mouse buttons";
    info.game = fmt::format("Flippers: {} and {}{}.  {}  {}: mode", play.keys.hint("left-flipper"),
                            play.keys.hint("right-flipper"), mouse, input_.flipper_mode(),
                            play.keys.hint("flipper-mode"));
}

void PinballController::add_hints(const PlayContext& play, std::vector<KeyHelp>& hints) const {
    if (!play.pointer.tool.is_empty()) return;
    if (feedback_.scores().initials()) {
        hints.push_back({"a-z 0-9", "your initials"});
        hints.push_back({"enter", "done"});
        hints.push_back({"esc", "none"});
        return;
    }
    if (play.clock.is_paused()) return;
    const Scene& scene = play.session.scene();
    const auto hint = [&](std::initializer_list<std::string_view> names, std::string what) {
        std::string keys;
        for (const std::string_view name : names) {
            const std::string key = play.keys.hint(name);
            if (!key.empty()) keys += (keys.empty() ? "" : " ") + key;
        }
        if (!keys.empty()) hints.push_back({keys, std::move(what)});
    };
    if (is_over(play.session)) {
        hint({"plunger"}, "start a game");
        hint({"keep-recording"}, "keep a recording");
        hint({"demo"}, is_demonstrating() ? "play yourself" : "watch carom play");
        return;
    }
    if (has_flippers(scene)) hint({"left-flipper", "right-flipper"}, "flippers");
    if (has_button(scene, Button::plunger)) hint({"plunger"}, "hold: plunger");
    if (has_button(scene, Button::nudge_up))
        hint({"nudge-left", "nudge-up", "nudge-right"}, "nudge");
    if (may_join(scene, std::get<PinballState>(play.session.game())))
        hint({"add-player"}, "add a player");
    hint({"demo"}, is_demonstrating() ? "play yourself" : "watch carom play");
}

}  // namespace carom

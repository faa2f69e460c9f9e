#include "carom/controllers/free_controller.h"

#include <fmt/format.h>

#include "carom/context/play_context.h"
#include "carom/context/view_control.h"
#include "carom/controllers/editing.h"

namespace carom {
namespace {

void press_cue(PlayContext& play, const InputEvent& event) {
    const auto ball = ball_at_pointer(play);
    if (!ball) return;
    play.pointer.cue_is_armed = false;
    play.view.selected = ball;
    play.pointer.tool.take_cue(*ball, play.pointer.at);
    play.pointer.pressed = event.button;
}

/// Grabs the object at the pointer; a press on empty space drags the view.
void press_left(PlayContext& play, const InputEvent& event) {
    Pointer& pointer = play.pointer;
    if (pointer.tool.take(play.session.world(), pointer.at, slack(play))) {
        pointer.pressed = event.button;
        play.view.selected = pointer.tool.has_ball() ? ball_at_pointer(play) : std::nullopt;
        return;
    }
    play.view.selected.reset();
    play.view.follows = false;
    // A near miss must not move the world.
    constexpr double miss = 2.0;
    if (ball_at(play.session.world(), pointer.at, miss * slack(play)))
        return say(play, "Missed: nothing under the pointer.", pointer.at);
    start_panning(play, event);
}

/// While a new edge is drawn, the keys of speed change its width. False: they do not now.
bool change_width(PlayContext& play, const Action& action) {
    constexpr double step = 1.25;
    PointerTool& tool = play.pointer.tool;
    const bool widens = action.name == "faster";
    if (!tool.has_new_edge() || (!widens && action.name != "slower")) return false;
    tool.widen_edge(widens ? step : 1.0 / step);
    say(play, fmt::format("width {:.3g}", tool.edge_width()));
    return true;
}

}  // namespace

void FreeController::perform(PlayContext& play, const Action& action) {
    if (action.where == Where::pool) return say(play, "That key is for pool tables.");
    if (change_width(play, action)) return;
    if (const auto* perform = std::get_if<void (*)(PlayContext&)>(&action.perform))
        (*perform)(play);
}

void FreeController::press(PlayContext& play, const InputEvent& event) {
    Pointer& pointer = play.pointer;
    if (pointer.tool.has_new_edge() || pointer.tool.has_cue()) {
        // A key started the action and the mouse takes it over.
        pointer.pressed = event.button;
        return;
    }
    if (!pointer.tool.is_empty() || take_press(play, event)) return;
    const bool is_cue = event.button == right_button || pointer.cue_is_armed ||
                        (event.button == left_button && (event.modifiers & (shift | control)));
    if (event.button == middle_button)
        start_panning(play, event);
    else if (is_cue)
        press_cue(play, event);
    else if (event.button == left_button)
        press_left(play, event);
}

void FreeController::release(PlayContext& play, const InputEvent& event) {
    Pointer& pointer = play.pointer;
    // Some terminals do not report which button was released; such a report counts for any.
    if (!pointer.pressed || (event.button != 0 && event.button != *pointer.pressed)) return;
    pointer.pressed.reset();
    if (take_release(play)) return;
    if (!play.view.follows) play.view.selected.reset();
    if (!open_hand(play) && pointer.tool.has_new_edge()) pointer.tool.cancel(play.session);
}

}  // namespace carom

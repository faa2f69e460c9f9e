#include "carom/controllers/free_controller.h"

#include "carom/context/play_context.h"

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
    pointer.panning_from = play.companion.in_first_half({event.column, event.row});
}

}  // namespace

void FreeController::perform(PlayContext& play, const Action& action) {
    if (action.where == Where::pool) return say(play, "that is for pool tables");
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
        pointer.panning_from = play.companion.in_first_half({event.column, event.row});
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
    if (const auto complaint = pointer.tool.open(play.session)) complain(play, *complaint);
    set_reference(play);
}

}  // namespace carom

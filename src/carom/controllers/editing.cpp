#include "carom/controllers/editing.h"

#include <fmt/format.h>

namespace carom {

void select_ball(PlayContext& play, bool backwards) {
    if (!play.pointer.tool.is_empty()) return;
    const World& world = play.session.world();
    play.view.selected = next_ball(world, play.view.selected, backwards);
    if (!play.view.selected) return say(play, "there are no balls");
    play.pointer.shows_cursor = true;
    play.pointer.at = world.balls().position[*index_of(world, *play.view.selected)];
}

void grab(PlayContext& play) {
    PointerTool& tool = play.pointer.tool;
    if (!tool.is_empty()) {
        if (const auto complaint = tool.open(play.session)) complain(play, *complaint);
        return set_reference(play);
    }
    play.pointer.shows_cursor = true;
    if (!tool.take(play.session.world(), play.pointer.at, slack(play)))
        say(play, "nothing to take here: move the cursor with the arrows, or press tab");
}

void use_cue(PlayContext& play) {
    Pointer& pointer = play.pointer;
    if (pointer.tool.has_cue() || pointer.cue_is_armed) {
        pointer.tool.cancel(play.session);
        pointer.cue_is_armed = false;
        return;
    }
    if (!pointer.tool.is_empty()) return;
    if (const auto ball = ball_at_pointer(play)) {
        play.view.selected = ball;
        pointer.tool.take_cue(*ball, pointer.at);
        say(play, "move away from the ball; enter shoots");
    } else {
        pointer.cue_is_armed = true;
        say(play, "press the left button on a ball, pull, let go");
    }
}

void add_ball_at_pointer(PlayContext& play) {
    const World& world = play.session.world();
    BallSpec spec;
    spec.position = play.pointer.at;
    const auto like = play.view.selected ? index_of(world, *play.view.selected) : std::nullopt;
    if (like) spec = spec_at_rest(world, *like, play.pointer.at);
    obey(play, command::AddBall{spec}, fmt::format("ball {} added", world.next_ball()));
}

void remove_at_pointer(PlayContext& play, bool only_edges) {
    const auto ball = only_edges ? std::nullopt : ball_at_pointer(play);
    const auto edge = edge_at(play.session.world(), play.pointer.at, slack(play));
    if (ball) {
        obey(play, command::RemoveBall{*ball}, fmt::format("ball {} removed", number(*ball)));
        if (play.view.selected == ball) play.view.selected.reset();
    } else if (edge) {
        obey(play, command::RemoveCapsule{*edge}, fmt::format("edge {} removed", number(*edge)));
    } else {
        say(play, only_edges ? "there is no edge here" : "there is nothing here");
    }
}

void draw_edge(PlayContext& play) {
    PointerTool& tool = play.pointer.tool;
    if (tool.has_new_edge()) return grab(play);
    if (!tool.is_empty()) return;
    const Capsules& capsules = play.session.world().capsules();
    const double radius = capsules.size() > 0 ? capsules.shape.back().radius
                                              : size(play.session.scene().view).y / 200.0;
    const ClassIndex material = capsules.size() > 0 ? capsules.material.back() : ClassIndex{0};
    tool.start_edge(play.pointer.at, radius, material);
    say(play, "move to the other end; e or enter makes the edge");
}

bool undo(PlayContext& play) {
    play.pointer.tool.forget();
    if (!play.session.undo()) {
        say(play, "nothing to undo");
        return false;
    }
    set_reference(play);
    say(play, "undone");
    return true;
}

}  // namespace carom

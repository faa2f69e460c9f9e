#include "carom/controllers/editing.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {

namespace {

/// The thinnest edge of the level, if it is thin enough to draw with; else a little of the view.
double width_of_new_edge(const PlayContext& play) {
    const double height = size(play.session.scene().view).y;
    double width = height / 75.0;
    for (const Capsule& shape : play.session.world().capsules().shape)
        if (shape.radius > 0.0) width = std::min(width, 2.0 * shape.radius);
    return width;
}

}  // namespace

void select_ball(PlayContext& play, bool backwards) {
    if (!play.pointer.tool.is_empty()) return;
    const World& world = play.session.world();
    play.view.selected = next_ball(world, play.view.selected, backwards);
    if (!play.view.selected) return say(play, "There are no balls.");
    play.pointer.shows_cursor = true;
    play.pointer.at = world.balls().position[*index_of(world, *play.view.selected)];
}

void grab(PlayContext& play) {
    PointerTool& tool = play.pointer.tool;
    if (!tool.is_empty()) {
        open_hand(play);
        return;
    }
    play.pointer.shows_cursor = true;
    if (!tool.take(play.session.world(), play.pointer.at, slack(play)))
        say(play, "Nothing to grab here. Move the cursor with the arrows, or press tab.");
}

bool open_hand(PlayContext& play) {
    const bool was_edge = play.pointer.tool.has_new_edge();
    const auto complaint = play.pointer.tool.open(play.session);
    set_reference(play);
    if (complaint)
        complain(play, *complaint);
    else if (was_edge)
        say(play, fmt::format("Edge added. {} removes it again.", play.keys.hint("undo")));
    return !complaint;
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
        say(play, "Move away from the ball; enter shoots.");
    } else {
        pointer.cue_is_armed = true;
        say(play, "Press the left button on a ball, pull, and let go.");
    }
}

void add_ball_at_pointer(PlayContext& play) {
    const World& world = play.session.world();
    BallSpec spec;
    spec.position = play.pointer.at;
    const auto like = play.view.selected ? index_of(world, *play.view.selected) : std::nullopt;
    if (like) spec = spec_at_rest(world, *like, play.pointer.at);
    obey(play, command::AddBall{spec}, fmt::format("Ball {} added.", world.next_ball()));
}

void remove_at_pointer(PlayContext& play, bool only_edges) {
    const auto ball = only_edges ? std::nullopt : ball_at_pointer(play);
    const auto edge = edge_at(play.session.world(), play.pointer.at, slack(play));
    if (ball) {
        obey(play, command::RemoveBall{*ball}, fmt::format("Removed {}.", name_of(play, *ball)));
        if (play.view.selected == ball) play.view.selected.reset();
    } else if (edge) {
        obey(play, command::RemoveCapsule{*edge}, fmt::format("Removed edge {}.", number(*edge)));
    } else {
        say(play, only_edges ? "No edge under the cursor." : "No ball under the cursor.");
    }
}

void draw_edge(PlayContext& play) {
    PointerTool& tool = play.pointer.tool;
    if (tool.has_new_edge()) return grab(play);
    if (!tool.is_empty()) return;
    const Capsules& capsules = play.session.world().capsules();
    const ClassIndex material = capsules.size() > 0 ? capsules.material.back() : ClassIndex{0};
    tool.start_edge(play.pointer.at, width_of_new_edge(play) / 2.0, material);
    say(play, "Move to the other end, + - change the width; enter makes the edge.");
}

bool undo(PlayContext& play) {
    play.pointer.tool.forget();
    if (!play.session.undo()) {
        say(play, "Nothing to undo.");
        return false;
    }
    set_reference(play);
    const World& world = play.session.world();
    say(play, fmt::format("Undone: back at {:.3f} s, before it happened.", world.time()));
    return true;
}

}  // namespace carom

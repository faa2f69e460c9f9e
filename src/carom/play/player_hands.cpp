#include <fmt/format.h>

#include "carom/play/player.h"

/// What a player does to balls and edges by keys; the mouse is in player_mouse.cpp.
namespace carom {

void Player::perform_by_hand(Action action) {
    if (perform_at_pool(action)) return;
    switch (action) {
        case Action::cursor_left:
            return move_cursor(-1.0, 0.0);
        case Action::cursor_right:
            return move_cursor(1.0, 0.0);
        case Action::cursor_up:
            return move_cursor(0.0, -1.0);
        case Action::cursor_down:
            return move_cursor(0.0, 1.0);
        case Action::next_ball:
            return jump_to_ball(false);
        case Action::previous_ball:
            return jump_to_ball(true);
        case Action::grab:
            return grab();
        case Action::cue:
            return use_cue();
        case Action::add_ball:
            return add_ball();
        case Action::remove:
            return remove_at_pointer(false);
        case Action::remove_edge:
            return remove_at_pointer(true);
        case Action::draw_edge:
            return draw_edge();
        default:
            return undo();
    }
}

void Player::jump_to_ball(bool backwards) {
    if (!tool_.is_empty()) return;
    selected_ = next_ball(session_.world(), selected_, backwards);
    if (!selected_) return say("there are no balls");
    shows_cursor_ = true;
    pointer_ = session_.world().balls.position[*index_of(session_.world(), *selected_)];
}

void Player::grab() {
    if (!tool_.is_empty()) {
        if (const auto complaint = tool_.open(session_)) complain(*complaint);
        set_reference();
        return;
    }
    shows_cursor_ = true;
    if (!tool_.take(session_.world(), pointer_, slack()))
        say("nothing to take here: move the cursor with the arrows, or press tab");
}

void Player::use_cue() {
    if (tool_.has_cue() || cue_is_armed_) {
        tool_.cancel(session_);
        cue_is_armed_ = false;
        return;
    }
    if (!tool_.is_empty()) return;
    if (const auto ball = ball_at_pointer()) {
        selected_ = ball;
        tool_.take_cue(*ball, pointer_);
        say("move away from the ball; enter shoots");
    } else {
        cue_is_armed_ = true;
        say("press the left button on a ball, pull, let go");
    }
}

void Player::add_ball() {
    const World& world = session_.world();
    BallSpec spec;
    spec.position = pointer_;
    if (selected_) {
        if (const auto index = index_of(world, *selected_)) {
            spec.kind = world.balls.kind[*index];
            spec.radius = world.balls.radius[*index];
            spec.mass = 1.0 / world.balls.inverse_mass[*index];
        }
    }
    obey(command::AddBall{spec}, fmt::format("ball {} added", world.next_ball));
}

void Player::remove_at_pointer(bool only_edges) {
    const World& world = session_.world();
    const auto ball = only_edges ? std::nullopt : ball_at_pointer();
    const auto edge = edge_at(world, pointer_, slack());
    if (ball) {
        obey(command::RemoveBall{*ball}, fmt::format("ball {} removed", number(*ball)));
        if (selected_ == ball) selected_.reset();
    } else if (edge) {
        obey(command::RemoveCapsule{*edge}, fmt::format("edge {} removed", number(*edge)));
    } else {
        say(only_edges ? "there is no edge here" : "there is nothing here");
    }
}

void Player::draw_edge() {
    if (tool_.has_new_edge()) return grab();
    if (!tool_.is_empty()) return;
    const Capsules& capsules = session_.world().capsules;
    const double radius =
        capsules.size() > 0 ? capsules.shape.back().radius : size(session_.scene().view).y / 200.0;
    const ClassIndex material = capsules.size() > 0 ? capsules.material.back() : ClassIndex{0};
    tool_.start_edge(pointer_, radius, material);
    say("move to the other end; e or enter makes the edge");
}

}  // namespace carom

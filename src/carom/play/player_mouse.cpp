#include <algorithm>
#include <cmath>

#include "carom/play/player.h"

namespace carom {
namespace {

/// How near something must be to be meant, in columns.
constexpr double reach = 1.5;
/// One step of the wheel.
constexpr double wheel_factor = 1.15;

constexpr std::uint8_t left_button = 1;
constexpr std::uint8_t middle_button = 2;
constexpr std::uint8_t right_button = 3;

}  // namespace

PlayRequest Player::handle(const InputEvent& event) {
    if (event.kind == InputEvent::Kind::mouse) {
        handle_mouse(event);
        return PlayRequest::none;
    }
    if (handle_at_table(event) || choose(event)) return PlayRequest::none;
    if (event.kind != InputEvent::Kind::key || event.action == InputEvent::Action::release)
        return PlayRequest::none;
    const auto action = keys_.action_of(key_of(event));
    if (page_ != Page::none && action != Action::quit) {
        scroll_page(event);
        return PlayRequest::none;
    }
    return action ? perform(*action) : PlayRequest::none;
}

void Player::scroll_page(const InputEvent& event) {
    needs_draw_ = true;
    switch (event.key) {
        case key::up:
            page_scroll_ -= 1;
            break;
        case key::down:
            page_scroll_ += 1;
            break;
        case key::page_up:
            page_scroll_ -= 10;
            break;
        case key::page_down:
        case key::space:
            page_scroll_ += 10;
            break;
        default:
            page_ = Page::none;
    }
}

double Player::slack() const {
    return reach / camera_.columns_per_length;
}

std::optional<BallId> Player::ball_at_pointer() const {
    if (const auto ball = ball_at(session_.world(), pointer_, slack())) return ball;
    return std::nullopt;
}

void Player::handle_mouse(const InputEvent& event) {
    using enum InputEvent::Action;
    if (page_ != Page::none) {
        if (event.action == press) page_ = Page::none;
        if (event.action == wheel_down) ++page_scroll_;
        if (event.action == wheel_up) --page_scroll_;
        needs_draw_ = true;
        return;
    }
    const CellPoint place = in_first_half({event.column, event.row});
    if (handle_table_mouse(event)) return;
    if (panning_from_ && event.action == move) {
        pan(panning_from_->column - place.column, panning_from_->row - place.row);
        panning_from_ = place;
        return;
    }
    if (is_aiming() && (event.action == wheel_up || event.action == wheel_down))
        return aim_by_key(0.0, event.action == wheel_up ? 0.1 : -0.1);
    if (event.action == wheel_up) return zoom(place, wheel_factor);
    if (event.action == wheel_down) return zoom(place, 1.0 / wheel_factor);
    shows_cursor_ = false;
    move_pointer(to_world(camera_, place));
    if (event.action == press) this->press(event);
    if (event.action == release) this->release(event);
}

void Player::press(const InputEvent& event) {
    needs_draw_ = true;
    const CellPoint place = in_first_half({event.column, event.row});
    if (tool_.has_new_edge() || tool_.has_cue()) {
        // A key began it, and the mouse goes on: from here, if it has not gone anywhere yet.
        pressed_ = event.button;
        return;
    }
    if (!tool_.is_empty()) return;
    if (is_watching()) {
        panning_from_ = place;
        return;
    }
    if (press_at_pool(event)) return;
    const bool is_cue = event.button == right_button || cue_is_armed_ ||
                        (event.button == left_button && (event.modifiers & (shift | control)));
    if (event.button == middle_button) {
        panning_from_ = place;
    } else if (is_cue) {
        const auto ball = ball_at_pointer();
        if (!ball) return;
        cue_is_armed_ = false;
        selected_ = ball;
        tool_.take_cue(*ball, pointer_);
        pressed_ = event.button;
    } else if (event.button == left_button) {
        if (tool_.take(session_.world(), pointer_, slack())) {
            pressed_ = event.button;
            selected_ = tool_.has_ball() ? ball_at_pointer() : std::nullopt;
        } else {
            selected_.reset();
            follows_ = false;
            panning_from_ = place;
        }
    }
}

void Player::release(const InputEvent& event) {
    needs_draw_ = true;
    panning_from_.reset();
    // Some terminals do not say which button was let go.
    if (!pressed_ || (event.button != 0 && event.button != *pressed_)) return;
    pressed_.reset();
    if (release_at_pool()) return;
    if (!follows_) selected_.reset();
    if (const auto complaint = tool_.open(session_)) complain(*complaint);
    set_reference();
}

void Player::move_pointer(Vec2 to) {
    if (to == pointer_) return;
    pointer_ = to;
    if (seat_ && (aims_by_mouse_ || tool_.has_cue())) {
        needs_draw_ = true;
        if (aims_by_mouse_) seat_->aim_at(session_, to);
        if (tool_.has_cue()) seat_->pull(session_, to);
    }
    if (tool_.is_empty()) return;
    needs_draw_ = true;
    if (const auto complaint = tool_.move(session_, to, stands_still())) complain(*complaint);
}

void Player::move_cursor(double columns, double rows) {
    if (!shows_cursor_ && tool_.is_empty() && !contains(visible_box(camera_), pointer_))
        pointer_ = camera_.center;
    shows_cursor_ = true;
    CellPoint place = to_cells(camera_, pointer_);
    place.column += columns;
    place.row += rows;
    const CellArea& area = camera_.area;
    place.column = std::clamp(place.column, area.column + 0.5, area.column + area.columns - 0.5);
    place.row = std::clamp(place.row, area.row + 0.5, area.row + area.rows - 0.5);
    move_pointer(to_world(camera_, place));
}

void Player::zoom(CellPoint fixed, double factor) {
    camera_ = zoomed(camera_, fixed, factor);
    is_fitted_ = false;
    needs_draw_ = true;
}

void Player::pan(double columns, double rows) {
    camera_ = panned(camera_, columns, rows);
    is_fitted_ = false;
    follows_ = false;
    needs_draw_ = true;
}

}  // namespace carom

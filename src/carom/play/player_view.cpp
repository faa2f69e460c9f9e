#include <fmt/format.h>

#include "carom/play/player.h"

/// Keys that change how the world is seen.
namespace carom {

void Player::perform_on_view(Action action) {
    if (move_tip(action)) return;
    const auto toggle = [this](bool& what, std::string_view name_text) {
        what = !what;
        say(fmt::format("{} {}", name_text, what ? "on" : "off"));
    };
    const CellPoint middle{camera_.area.column + camera_.area.columns / 2.0,
                           camera_.area.row + camera_.area.rows / 2.0};
    switch (action) {
        case Action::renderer: {
            constexpr std::string_view names[] = {"automatic", "ascii", "half blocks", "braille"};
            const auto current = renderer_in_force(view_);
            view_.renderer = !view_.look.utf8                   ? Renderer::ascii
                             : current == Renderer::ascii       ? Renderer::half_blocks
                             : current == Renderer::half_blocks ? Renderer::braille
                                                                : Renderer::ascii;
            if (!view_.look.utf8) return say("without UTF-8 there is only ascii");
            return say(std::string(names[static_cast<std::size_t>(view_.renderer)]));
        }
        case Action::colors: {
            constexpr std::string_view names[] = {"kind", "speed", "mass", "ball"};
            const auto next = (static_cast<std::size_t>(view_.color_by) + 1) % std::size(names);
            view_.color_by = static_cast<ColorBy>(next);
            return say(fmt::format("colour by {}", names[next]));
        }
        case Action::trails:
            return toggle(view_.trails, "trails");
        case Action::overlay:
            return next_overlay();
        case Action::velocities:
            return toggle(view_.velocities, "velocities");
        case Action::contacts:
            return toggle(view_.contacts, "contacts");
        case Action::broad_phase:
            return toggle(view_.broad_phase, "broad-phase cells");
        case Action::grid:
            return toggle(view_.grid, "coordinates");
        case Action::ids:
            view_.labels = view_.labels == Labels::all ? Labels::automatic : Labels::all;
            return say(view_.labels == Labels::all ? "numbers on" : "numbers off");
        case Action::outlines:
            view_.ball_style =
                view_.ball_style == BallStyle::filled ? BallStyle::outline : BallStyle::filled;
            return;
        case Action::split:
            return next_comparison();
        case Action::butterfly:
            return toggle_butterfly();
        case Action::explain:
            page_ = Page::explanation;
            page_scroll_ = 0;
            return;
        case Action::histogram:
            if (!has_histogram()) return say("this level shows no histogram");
            shows_histogram_ = !shows_histogram_;
            return;
        case Action::energy:
            shows_energy_ = !shows_energy_;
            return;
        case Action::zoom_in:
            return zoom(middle, 1.25);
        case Action::zoom_out:
            return zoom(middle, 0.8);
        case Action::pan_left:
            return pan(-4.0, 0.0);
        case Action::pan_right:
            return pan(4.0, 0.0);
        case Action::pan_up:
            return pan(0.0, -2.0);
        case Action::pan_down:
            return pan(0.0, 2.0);
        case Action::fit:
            if (table_ && is_fitted_) table_->toggle_whole();
            is_fitted_ = true;
            follows_ = false;
            return;
        default:
            if (!selected_) selected_ = ball_at_pointer();
            follows_ = !follows_ && selected_;
            return say(follows_    ? fmt::format("following ball {}", number(*selected_))
                       : selected_ ? "not following"
                                   : "press tab to choose a ball first");
    }
}

void Player::next_overlay() {
    bool* const overlays[] = {&view_.velocities, &view_.contacts, &view_.broad_phase, &view_.grid};
    constexpr std::string_view names[] = {"velocities", "contacts", "broad-phase cells",
                                          "coordinates"};
    std::size_t next = 0;
    for (std::size_t i = 0; i < std::size(overlays); ++i) {
        if (*overlays[i]) next = i + 1;
        *overlays[i] = false;
    }
    if (next == std::size(overlays)) return say("no overlay");
    *overlays[next] = true;
    say(std::string(names[next]));
}

}  // namespace carom

#include "carom/context/view_control.h"

#include <fmt/format.h>

#include <iterator>
#include <string_view>

#include "carom/context/solver_choice.h"
#include "physics/broad_phase/cell_frame.h"

namespace carom {
namespace {

// Where the overlay of cells shows nothing, says why.
void tell_why_no_cells(PlayContext& play) {
    const CellFrame& cells = play.session.cells();
    if (cells == CellFrame{})
        say(play, "No cells: the solver has none, or has not begun.");
    else if (!has_room_for_grid(play.view.camera, cells.cell.x))
        say(play, fmt::format("Cells too small to show: {} zooms in.", play.keys.hint("zoom-in")));
}

}  // namespace

void next_renderer(PlayContext& play) {
    ViewOptions& view = play.view.options;
    const Renderer& current = renderer_in_force(view);
    view.renderer = view.look.utf8 ? &renderer_after(current) : &ascii_renderer();
    say(play,
        view.look.utf8 ? std::string(view.renderer->title) : "without UTF-8 there is only ascii");
}

void next_colors(PlayContext& play) {
    constexpr std::string_view names[] = {"kind", "speed", "mass", "ball"};
    ColorBy& color_by = play.view.options.color_by;
    const auto next = (static_cast<std::size_t>(color_by) + 1) % std::size(names);
    color_by = static_cast<ColorBy>(next);
    say(play, fmt::format("colour by {}", names[next]));
}

void toggle(PlayContext& play, bool& what, std::string_view name) {
    what = !what;
    say(play, fmt::format("{} {}", name, what ? "on" : "off"));
}

void toggle_overlay(PlayContext& play, std::string_view name) {
    const std::size_t overlay = overlay_named(name);
    toggle(play, play.view.options.overlays[overlay], overlays()[overlay].title);
    if (name == "broad-phase" && play.view.options.overlays[overlay]) tell_why_no_cells(play);
}

void next_overlay(PlayContext& play) {
    OverlaySet& shown = play.view.options.overlays;
    std::size_t next = 0;
    for (std::size_t i = 0; i < overlays().size(); ++i)
        if (shown[i]) next = i + 1;
    shown = {};
    if (next == overlays().size()) return say(play, "overlays off");
    shown[next] = true;
    say(play, std::string(overlays()[next].title));
}

void toggle_trails(PlayContext& play) {
    toggle(play, play.view.options.trails, "trails");
}

void toggle_ids(PlayContext& play) {
    Labels& labels = play.view.options.labels;
    labels = labels == Labels::all ? Labels::automatic : Labels::all;
    say(play, labels == Labels::all ? "numbers on" : "numbers off");
}

void toggle_outlines(PlayContext& play) {
    BallStyle& style = play.view.options.ball_style;
    style = style == BallStyle::filled ? BallStyle::outline : BallStyle::filled;
}

void toggle_histogram(PlayContext& play) {
    if (Panels::has_histogram(play.session.scene())) return play.panels.toggle_histogram();
    if (play.panels.toggle_speeds()) play.observation->observe(Observable::speeds, play.session);
}

void toggle_energy(PlayContext& play) {
    play.panels.toggle_energy();
}

void toggle_following(PlayContext& play) {
    PlayView& view = play.view;
    if (!view.selected) view.selected = ball_at_pointer(play);
    view.follows = !view.follows && view.selected;
    say(play, view.follows    ? fmt::format("following ball {}", number(*view.selected))
              : view.selected ? "not following"
                              : "Press tab to choose a ball first.");
}

void reset_view(PlayContext& play) {
    play.view.reset();
    say(play, "View reset.");
}

void next_comparison(PlayContext& play) {
    if (!play.companion.next_comparison(play.session)) return say(play, "Split view off.");
    const SolverKind other = play.companion.comparison()->solver().kind;
    say(play, fmt::format("{}: {}", name(other), method_of(other)));
}

void toggle_ensemble(PlayContext& play) {
    switch (play.companion.toggle_ensemble(play.session)) {
        case Companion::EnsembleState::running:
            return;
        case Companion::EnsembleState::ended:
            return say(play, "Butterfly off.");
        case Companion::EnsembleState::too_large:
            return complain(play, "Too many balls for 200 copies.");
    }
}

void zoom(PlayContext& play, double factor) {
    play.view.zoom(play.view.middle(), factor);
}

void tell_way_back(PlayContext& play) {
    say(play, fmt::format("{} brings the whole view back.", play.keys.hint("fit")));
}

void pan(PlayContext& play, double columns, double rows) {
    play.view.pan(columns, rows);
    tell_way_back(play);
}

void start_panning(PlayContext& play, const InputEvent& event) {
    play.pointer.panning_from = play.companion.in_first_half({event.column, event.row});
    tell_way_back(play);
}

}  // namespace carom

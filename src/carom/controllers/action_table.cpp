#include <algorithm>
#include <cstdlib>
#include <iterator>

#include "carom/context/action.h"
#include "carom/context/time_control.h"
#include "carom/context/view_control.h"
#include "carom/controllers/editing.h"
#include "carom/controllers/pinball_controller.h"
#include "carom/controllers/pool_controller.h"
#include "carom/controllers/world_control.h"

/// The table of all actions. To add one, add a row, and its line in docs/command-line.md.
namespace carom {
namespace {

using enum Where;
using Pool = PoolController;
using Pinball = PinballController;
using Play = PlayContext;

constexpr double cursor_columns = 1.0;
constexpr double pan_columns = 4.0;
constexpr double pan_rows = 2.0;
constexpr double zoom_factor = 1.25;

/// In this order: cancels the tool, hides the cursor, leaves the game.
void escape(Play& play) {
    Pointer& pointer = play.pointer;
    if (!pointer.tool.is_empty() || pointer.cue_is_armed) {
        pointer.tool.cancel(play.session);
        pointer.cue_is_armed = false;
        pointer.pressed.reset();
    } else if (pointer.shows_cursor || play.view.selected) {
        pointer.shows_cursor = false;
        play.view.selected.reset();
        play.view.follows = false;
    } else {
        play.request = PlayRequest::menu;
    }
}

void toggle_bell(Pinball&, Play& play) {
    play.terminal.rings = !play.terminal.rings;
    play.terminal.bell_is_due = play.terminal.rings;
    say(play, play.terminal.rings ? "the terminal's bell rings for what kicks" : "no bell");
}

template <PlayRequest request>
void ask(Play& play) {
    play.request = request;
}

template <CoveringPage::Kind page>
void open_page(Play& play) {
    play.page.open(page);
}

// The columns: name, default keys, help, section of the help page, where it applies, effect, effect
// at a pool table instead.
constexpr Action rows[] = {
    {"pause", "space", "pause, go on", "Time", anywhere, toggle_pause},
    {"step-forward", ".", "one tick forward", "Time", anywhere, step_forward},
    {"step-back", ",", "one tick back", "Time", anywhere, step_back},
    {"next-collision", "n", "to the next collision", "Time", anywhere, seek_collision},
    {"second-back", "<", "a second back", "Time", anywhere, second_back},
    {"second-forward", ">", "a second forward", "Time", anywhere, second_forward},
    {"slower", "- [", "slower", "Time", anywhere, slower},
    {"faster", "+ = ]", "faster", "Time", anywhere, faster},
    {"normal-speed", "*", "normal speed", "Time", anywhere, normal_speed},
    {"restart", "r", "from the start", "Time", anywhere, restart},

    {"cursor-left", "left", "move the cursor", "Hands", anywhere,
     [](Play& play) { move_cursor(play, -cursor_columns, 0.0); },
     [](Pool& table, Play& play) { return table.turn_coarsely(play, 1); }},
    {"cursor-right", "right", "move the cursor", "Hands", anywhere,
     [](Play& play) { move_cursor(play, cursor_columns, 0.0); },
     [](Pool& table, Play& play) { return table.turn_coarsely(play, -1); }},
    {"cursor-up", "up", "move the cursor", "Hands", anywhere,
     [](Play& play) { move_cursor(play, 0.0, -1.0); },
     [](Pool& table, Play& play) { return table.change_speed(play, 1); }},
    {"cursor-down", "down", "move the cursor", "Hands", anywhere,
     [](Play& play) { move_cursor(play, 0.0, 1.0); },
     [](Pool& table, Play& play) { return table.change_speed(play, -1); }},
    {"next-ball", "tab", "to the next ball", "Hands", anywhere,
     [](Play& play) { select_ball(play, false); },
     [](Pool& table, Play& play) { return table.next_pot_under_rules(play, false); }},
    {"previous-ball", "backtab", "to the ball before", "Hands", anywhere,
     [](Play& play) { select_ball(play, true); },
     [](Pool& table, Play& play) { return table.next_pot_under_rules(play, true); }},
    {"grab", "enter", "take or drop what is there", "Hands", playing, grab,
     [](Pool& table, Play& play) { return table.shoot_with_key(play); }},
    {"cue", "k", "pull the cue; enter shoots", "Hands", playing, use_cue,
     [](Pool& table, Play& play) { return table.explain_cue(play); }},
    {"add-ball", "a", "add a ball", "Hands", playing, add_ball_at_pointer,
     [](Pool& table, Play& play) { return table.edit_nothing(play); }},
    {"remove", "x delete", "remove a ball", "Hands", playing,
     [](Play& play) { remove_at_pointer(play, false); },
     [](Pool& table, Play& play) { return table.edit_nothing(play); }},
    {"draw-edge", "e", "start, end an edge", "Hands", playing, draw_edge,
     [](Pool& table, Play& play) { return table.edit_nothing(play); }},
    {"remove-edge", "E", "remove an edge", "Hands", playing,
     [](Play& play) { remove_at_pointer(play, true); },
     [](Pool& table, Play& play) { return table.edit_nothing(play); }},
    {"undo", "u", "undo the last change", "Hands", playing, [](Play& play) { undo(play); },
     [](Pool& table, Play& play) { return table.undo_shot(play), true; }},

    {"aim-left", "; ctrl-left", "aim a hair to the left", "Pool", pool,
     [](Pool& table, Play& play) { table.turn_finely(play, 1); }},
    {"aim-right", "' ctrl-right", "aim a hair to the right", "Pool", pool,
     [](Pool& table, Play& play) { table.turn_finely(play, -1); }},
    {"next-pot", "}", "aim at the next pocket, easiest first", "Pool", pool,
     [](Pool& table, Play& play) { table.next_pot(play, false); }},
    {"previous-pot", "{", "aim at the one before", "Pool", pool,
     [](Pool& table, Play& play) { table.next_pot(play, true); }},
    {"call", "d", "declare a safety, or a push-out", "Pool", pool,
     [](Pool& table, Play& play) { table.next_call(play); }},
    {"place-cue-ball", "p", "take the ball in hand, put it down", "Pool", pool,
     [](Pool& table, Play& play) { table.place_cue_ball(play); }},
    {"aids", "A", "lines: none, ghost, full, 20 shots", "Pool", pool,
     [](Pool& table, Play& play) { table.next_aids(play); }},
    {"to-rest", "j", "skip until the balls rest", "Pool", pool,
     [](Pool& table, Play& play) { table.skip_to_rest(play); }},
    {"next-frame", "N", "rack the next frame", "Pool", pool,
     [](Pool&, Play& play) { obey(play, command::RackAgain{}, "the balls are racked"); }},
    {"opponent", "O", "play against carom: 1 to 4, nobody", "Pool", pool,
     [](Pool& table, Play& play) { table.next_opponent(play); }},
    {"hand", "M", "your hand in a match: 1 to 4", "Pool", pool,
     [](Pool& table, Play& play) { table.next_hand(play); }},
    {"record", "T", "your record against carom", "Pool", pool,
     [](Pool& table, Play& play) { table.tell_record(play); }},
    {"coach", "C", "what carom would shoot: its three best", "Pool", pool,
     [](Pool& table, Play& play) { table.ask_coach(play); }},

    {"solver", "s", "the next solver", "World", playing, next_solver},
    {"gravity", "g", "gravity on, off", "World", playing, toggle_gravity},
    {"turn-gravity", "G", "turn gravity", "World", playing, turn_gravity},
    {"save", "w", "save as a level", "World", anywhere, ask<PlayRequest::save>},

    {"renderer", "v", "the next way to draw", "View", anywhere, next_renderer},
    {"colors", "c", "colour by kind, speed, mass, ball", "View", anywhere, next_colors},
    {"trails", "t", "trails", "View", anywhere, toggle_trails},
    {"overlay", "o", "the next overlay", "View", anywhere, next_overlay},
    {"velocities", "1", "velocities", "View", anywhere,
     [](Play& play) { toggle_overlay(play, "velocities"); }},
    {"contacts", "2", "contacts of the last tick", "View", anywhere,
     [](Play& play) { toggle_overlay(play, "contacts"); }},
    {"broad-phase", "3", "broad-phase cells", "View", anywhere,
     [](Play& play) { toggle_overlay(play, "broad-phase"); }},
    {"ids", "4", "numbers of the balls", "View", anywhere, toggle_ids},
    {"grid", "5", "coordinates", "View", anywhere,
     [](Play& play) { toggle_overlay(play, "grid"); }},
    {"outlines", "6", "balls as outlines", "View", anywhere, toggle_outlines},
    {"histogram", "h", "the histogram", "View", anywhere, toggle_histogram},
    {"energy", "y", "the energy over time", "View", anywhere, toggle_energy},
    {"zoom-in", "z", "closer", "View", anywhere, [](Play& play) { zoom(play, zoom_factor); }},
    {"zoom-out", "Z", "farther", "View", anywhere, [](Play& play) { zoom(play, 0.8); }},
    {"pan-left", "shift-left H", "look left", "View", anywhere,
     [](Play& play) { pan(play, -pan_columns, 0.0); },
     [](Pool& table, Play& play) { return table.move_tip(play, -1, 0); }},
    {"pan-right", "shift-right L", "look right", "View", anywhere,
     [](Play& play) { pan(play, pan_columns, 0.0); },
     [](Pool& table, Play& play) { return table.move_tip(play, 1, 0); }},
    {"pan-up", "shift-up K", "look up", "View", anywhere,
     [](Play& play) { pan(play, 0.0, -pan_rows); },
     [](Pool& table, Play& play) { return table.move_tip(play, 0, 1); }},
    {"pan-down", "shift-down J", "look down", "View", anywhere,
     [](Play& play) { pan(play, 0.0, pan_rows); },
     [](Pool& table, Play& play) { return table.move_tip(play, 0, -1); }},
    {"fit", "0", "all of it", "View", anywhere, [](Play& play) { play.view.fit(); }},
    {"follow", "f", "follow the ball", "View", anywhere, toggle_following},
    {"split", "S", "beside it, another solver", "View", anywhere, next_comparison},
    {"butterfly", "b", "200 copies, a hair apart", "View", anywhere, toggle_ensemble},
    {"explain", "i", "which solver, which terms, why", "View", anywhere,
     open_page<CoveringPage::Kind::explanation>},

    {"mouse", "m", "give the mouse to the terminal", "Program", anywhere,
     ask<PlayRequest::toggle_mouse>},
    {"take-up", "R", "take up the game that was left", "Program", anywhere,
     ask<PlayRequest::resume>},
    {"help", "? f1", "this page", "Program", anywhere, open_page<CoveringPage::Kind::help>},
    {"menu", "escape", "let go; the menu", "Program", anywhere, escape,
     [](Pool& table, Play& play) { return table.give_up_stroke(play); }},
    {"quit", "q", "quit at once", "Program", anywhere, ask<PlayRequest::quit>},

    {"left-flipper", "z left", "the left flipper", "At pinball", pinball, Button::left_flipper},
    {"right-flipper", "/ right", "the right flipper", "At pinball", pinball, Button::right_flipper},
    {"plunger", "enter down", "hold and let go: the plunger", "At pinball", pinball,
     Button::plunger},
    {"nudge-left", "x", "nudge the table to the left", "At pinball", pinball, Button::nudge_left},
    {"nudge-up", "up", "nudge the table upwards", "At pinball", pinball, Button::nudge_up},
    {"nudge-right", ".", "nudge the table to the right", "At pinball", pinball,
     Button::nudge_right},
    {"flipper-mode", "k", "how flippers are held", "At pinball", pinball,
     [](Pinball& table, Play& play) { table.next_flipper_mode(play); }},
    {"bell", "l", "the terminal's bell, on, off", "At pinball", pinball, toggle_bell},
    {"demo", "d", "carom plays, you play", "At pinball", pinball,
     [](Pinball& table, Play& play) { table.demonstrate(play, !table.is_demonstrating()); }},
};

constexpr ActionGroup groups[] = {
    {"cursor-left", "cursor-down", "arrows", "move the cursor, or what it holds"},
    {"pan-left", "pan-down", "shift-arrows", "look elsewhere (or H J K L)"},
    {"left-flipper", "right-flipper", "z / <- ->", "flippers; also the mouse's buttons"},
    {"plunger", "plunger", "enter", "hold and let go: the plunger"},
    {"nudge-left", "nudge-right", "x up .", "nudge the table"},
};

constexpr HelpNote notes[] = {
    {"Mouse", "Program", "left", "", "drag a ball or an edge; the rest is the view"},
    {"Mouse", "Program", "right", "", "pull the cue and let it go (or shift, ctrl with left)"},
    {"Mouse", "Program", "right", "", "in a match of pool: pull it back, push it through"},
    {"Mouse", "Program", "middle", "", "drag the view"},
    {"Mouse", "Program", "wheel", "", "closer, farther"},
    {"At pinball", "", "", "fit", "all of the table, or after the ball"},
};

}  // namespace

std::span<const Action> actions() {
    return rows;
}

const Action* action_named(std::string_view name) {
    const Action* const row = std::ranges::find(rows, name, &Action::name);
    return row == std::end(rows) ? nullptr : row;
}

const Action& action(std::string_view name) {
    const Action* const row = action_named(name);
    if (!row) std::abort();
    return *row;
}

std::vector<std::string_view> action_names() {
    std::vector<std::string_view> names;
    for (const Action& row : rows)
        names.push_back(row.name);
    return names;
}

std::span<const ActionGroup> action_groups() {
    return groups;
}

std::span<const HelpNote> help_notes() {
    return notes;
}

}  // namespace carom

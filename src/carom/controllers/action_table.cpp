#include <algorithm>
#include <cstdlib>
#include <iterator>

#include "carom/context/action.h"
#include "carom/context/time_control.h"
#include "carom/context/view_control.h"
#include "carom/controllers/editing.h"
#include "carom/controllers/pinball_controller.h"
#include "carom/controllers/pool_actions.h"
#include "carom/controllers/world_control.h"

/// The table of all actions. To add one, add a row, and its line in docs/command-line.md. Other
/// words for the help pages, or a line that it shares with others, go to help_pages.cpp.
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
    say(play, play.terminal.rings ? "bell on" : "bell off");
}

template <PlayRequest request>
void ask(Play& play) {
    play.request = request;
}

template <CoveringPage::Kind page>
void open_page(Play& play) {
    play.page.open(page);
}

/// The errors of a level under --watch come before what it says about itself.
void open_about(Play& play) {
    using enum CoveringPage::Kind;
    play.page.open(play.messages.problem().empty() ? about : problems);
}

// The columns: name, default keys, help, where it applies, effect, effect at a pool table instead.
constexpr Action rows[] = {
    {"pause", "space", "pause, resume", anywhere, toggle_pause},
    {"step-forward", ".", "one tick forward", anywhere, step_forward},
    {"step-back", ",", "one tick back", anywhere, step_back},
    {"next-collision", "n", "to the next collision", anywhere, seek_collision},
    {"second-back", "<", "one second back", anywhere, second_back},
    {"second-forward", ">", "one second forward", anywhere, second_forward},
    {"slower", "- [", "slower", anywhere, slower},
    {"faster", "+ = ]", "faster", anywhere, faster},
    {"normal-speed", "*", "normal speed", anywhere, normal_speed},
    {"restart", "r", "restart", anywhere, restart,
     [](Pool& table, Play& play) { return pool_actions::keep_frame(table, play); }},

    {"cursor-left", "left", "move the cursor", anywhere,
     [](Play& play) { move_cursor(play, -cursor_columns, 0.0); },
     [](Pool& table, Play& play) { return pool_actions::turn_coarsely(table, play, 1); }},
    {"cursor-right", "right", "move the cursor", anywhere,
     [](Play& play) { move_cursor(play, cursor_columns, 0.0); },
     [](Pool& table, Play& play) { return pool_actions::turn_coarsely(table, play, -1); }},
    {"cursor-up", "up", "move the cursor", anywhere,
     [](Play& play) { move_cursor(play, 0.0, -1.0); },
     [](Pool& table, Play& play) { return pool_actions::change_speed(table, play, 1); }},
    {"cursor-down", "down", "move the cursor", anywhere,
     [](Play& play) { move_cursor(play, 0.0, 1.0); },
     [](Pool& table, Play& play) { return pool_actions::change_speed(table, play, -1); }},
    {"next-ball", "tab", "select the next ball", anywhere,
     [](Play& play) { select_ball(play, false); },
     [](Pool& table, Play& play) {
         return pool_actions::next_pot_under_rules(table, play, false);
     }},
    {"previous-ball", "backtab", "select the previous ball", anywhere,
     [](Play& play) { select_ball(play, true); },
     [](Pool& table, Play& play) { return pool_actions::next_pot_under_rules(table, play, true); }},
    {"grab", "enter", "grab, release; shoot", editing, grab,
     [](Pool& table, Play& play) { return pool_actions::shoot(table, play); }},
    {"cue", "k", "put the cue on a ball", editing, use_cue,
     [](Pool& table, Play& play) { return pool_actions::explain_cue(table, play); }},
    {"add-ball", "a", "add a ball", editing, add_ball_at_pointer,
     [](Pool&, Play& play) { return pool_actions::edit_nothing(play); }},
    {"remove", "x delete", "remove a ball", editing,
     [](Play& play) { remove_at_pointer(play, false); },
     [](Pool&, Play& play) { return pool_actions::edit_nothing(play); }},
    {"draw-edge", "e", "start, end a new edge", editing, draw_edge,
     [](Pool&, Play& play) { return pool_actions::edit_nothing(play); }},
    {"remove-edge", "E", "remove an edge", editing,
     [](Play& play) { remove_at_pointer(play, true); },
     [](Pool&, Play& play) { return pool_actions::edit_nothing(play); }},
    {"undo", "u", "undo the last change", editing, [](Play& play) { undo(play); },
     [](Pool& table, Play& play) { return pool_actions::undo_shot(table, play), true; }},

    {"aim-left", "; ctrl-left", "aim slightly left", pool,
     [](Pool& table, Play& play) { pool_actions::turn_finely(table, play, 1); }},
    {"aim-right", "' ctrl-right", "aim slightly right", pool,
     [](Pool& table, Play& play) { pool_actions::turn_finely(table, play, -1); }},
    {"next-pot", "}", "aim at the next pot, easiest first", pool,
     [](Pool& table, Play& play) { pool_actions::next_pot(table, play, false); }},
    {"previous-pot", "{", "aim at the previous pot", pool,
     [](Pool& table, Play& play) { pool_actions::next_pot(table, play, true); }},
    {"call", "d", "declare a safety, or a push-out", pool,
     [](Pool& table, Play& play) { pool_actions::next_call(table, play); }},
    {"place-cue-ball", "p", "pick up, put down the ball in hand", pool,
     [](Pool& table, Play& play) { pool_actions::place_cue_ball(table, play); }},
    {"aids", "A", "aiming aid: ghost, full, 20 shots, off", pool,
     [](Pool& table, Play& play) { pool_actions::next_aids(table, play); }},
    {"to-rest", "j", "skip until the balls rest", pool,
     [](Pool& table, Play& play) { pool_actions::skip_to_rest(table, play); }},
    {"next-frame", "N", "next frame; in a match, concede", pool,
     [](Pool& table, Play& play) { pool_actions::rack_again(table, play); }},
    {"opponent", "O", "opponent: off, 1 to 4; practice", pool,
     [](Pool& table, Play& play) { pool_actions::next_opponent(table, play); }},
    {"hand", "M", "your skill in a match: 1 to 4", pool,
     [](Pool& table, Play& play) { pool_actions::next_hand(table, play); }},
    {"record", "T", "your record, and the ladder", pool,
     [](Pool&, Play& play) { pool_actions::open_record(play); }},
    {"coach", "C", "coach: the three best shots", pool,
     [](Pool& table, Play& play) { pool_actions::ask_coach(table, play); }},

    {"solver", "s", "next solver", editing, next_solver,
     [](Pool& table, Play& play) { return pool_actions::keep_solver(table, play); }},
    {"gravity", "g", "gravity on, off", editing, toggle_gravity},
    {"turn-gravity", "G", "turn gravity", editing, turn_gravity},
    {"save", "w", "save as a level", anywhere, ask<PlayRequest::save>},
    {"keep-recording", "W", "keep a recording of the game", playing, ask<PlayRequest::record>},

    {"renderer", "v", "next renderer", anywhere, next_renderer},
    {"colors", "c", "colour by kind, speed, mass, ball", anywhere, next_colors},
    {"trails", "t", "trails", anywhere, toggle_trails},
    {"overlay", "o", "next overlay", anywhere, next_overlay},
    {"velocities", "1", "velocities", anywhere,
     [](Play& play) { toggle_overlay(play, "velocities"); }},
    {"contacts", "2", "contacts of the last tick", anywhere,
     [](Play& play) { toggle_overlay(play, "contacts"); }},
    {"broad-phase", "3", "broad-phase cells", anywhere,
     [](Play& play) { toggle_overlay(play, "broad-phase"); }},
    {"ids", "4", "numbers of the balls", anywhere, toggle_ids},
    {"grid", "5", "coordinates", anywhere, [](Play& play) { toggle_overlay(play, "grid"); }},
    {"outlines", "6", "balls as outlines", anywhere, toggle_outlines},
    {"histogram", "h", "the histogram, or the speeds", anywhere, toggle_histogram},
    {"energy", "y", "energy, momentum, drift over time", anywhere, toggle_energy},
    {"zoom-in", "z", "zoom in", anywhere, [](Play& play) { zoom(play, zoom_factor); },
     [](Pool& table, Play& play) { return pool_actions::zoom_on_aim(table, play, zoom_factor); }},
    {"zoom-out", "Z", "zoom out", anywhere, [](Play& play) { zoom(play, 1.0 / zoom_factor); },
     [](Pool& table, Play& play) {
         return pool_actions::zoom_on_aim(table, play, 1.0 / zoom_factor);
     }},
    {"pan-left", "shift-left H", "pan left", anywhere,
     [](Play& play) { pan(play, -pan_columns, 0.0); },
     [](Pool& table, Play& play) { return pool_actions::move_tip(table, play, -1, 0); }},
    {"pan-right", "shift-right L", "pan right", anywhere,
     [](Play& play) { pan(play, pan_columns, 0.0); },
     [](Pool& table, Play& play) { return pool_actions::move_tip(table, play, 1, 0); }},
    {"pan-up", "shift-up K", "pan up", anywhere, [](Play& play) { pan(play, 0.0, -pan_rows); },
     [](Pool& table, Play& play) { return pool_actions::move_tip(table, play, 0, 1); }},
    {"pan-down", "shift-down J", "pan down", anywhere, [](Play& play) { pan(play, 0.0, pan_rows); },
     [](Pool& table, Play& play) { return pool_actions::move_tip(table, play, 0, -1); }},
    {"fit", "0", "fit view", anywhere, [](Play& play) { play.view.fit(); }},
    {"follow", "f", "follow the ball", anywhere, toggle_following},
    {"split", "S", "split screen: compare solvers", anywhere, next_comparison},
    {"butterfly", "b", "butterfly: 200 perturbed copies", anywhere, toggle_ensemble},
    {"reset-view", "V", "reset view", anywhere, reset_view},
    {"explain", "i", "solver and model details", anywhere,
     open_page<CoveringPage::Kind::explanation>},

    {"mouse", "m", "mouse on, off", anywhere, ask<PlayRequest::toggle_mouse>},
    {"theme", "f2", "next theme of colours", anywhere, ask<PlayRequest::theme>},
    {"change-key", "f3", "change a key", anywhere, ask<PlayRequest::change_key>},
    {"take-up", "R", "resume the unfinished game", anywhere, ask<PlayRequest::resume>},
    {"help", "?", "help: the keys", anywhere, open_page<CoveringPage::Kind::help>},
    {"about", "f1", "about this level", anywhere, open_about},
    {"menu", "escape", "cancel / menu", anywhere, escape,
     [](Pool& table, Play& play) { return pool_actions::give_up_stroke(table, play); }},
    {"quit", "q", "quit", anywhere, ask<PlayRequest::quit>},

    {"left-flipper", "z left", "left flipper", pinball, Button::left_flipper},
    {"right-flipper", "/ right", "right flipper", pinball, Button::right_flipper},
    {"plunger", "enter down", "hold and release: plunger", pinball, Button::plunger},
    {"nudge-left", "x", "nudge the table to the left", pinball, Button::nudge_left},
    {"nudge-up", "up", "nudge the table upwards", pinball, Button::nudge_up},
    {"nudge-right", ".", "nudge the table to the right", pinball, Button::nudge_right},
    {"add-player", "p", "another player joins, during ball 1", pinball, Button::add_player},
    {"flipper-mode", "k", "how flippers are held", pinball,
     [](Pinball& table, Play& play) { table.next_flipper_mode(play); }},
    {"bell", "l", "bell on, off", pinball, toggle_bell},
    {"demo", "d", "demo on, off", pinball,
     [](Pinball& table, Play& play) { table.demonstrate(play, !table.is_demonstrating()); }},
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

}  // namespace carom

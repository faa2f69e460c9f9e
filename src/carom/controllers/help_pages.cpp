#include "carom/context/help_page.h"

#include <algorithm>

/// The lines of the help pages.
namespace carom {
namespace {

constexpr std::uint8_t in_free = help_bit(PlayKind::free);
constexpr std::uint8_t at_pool = help_bit(PlayKind::pool);
constexpr std::uint8_t at_cue = help_bit(PlayKind::cue);
constexpr std::uint8_t at_table = at_pool | at_cue;
constexpr std::uint8_t at_pinball = help_bit(PlayKind::pinball);
constexpr std::uint8_t watched = help_bit(PlayKind::watching);
constexpr std::uint8_t in_lab = in_free | watched;
constexpr std::uint8_t in_all = in_free | at_table | at_pinball | watched;
constexpr std::uint8_t seen_above = in_free | at_table | watched;

// At 80 columns a help text has room for 23 characters.
constexpr HelpLine lines[] = {
    {at_table, "Shot", "grab", "", "shoot"},
    {at_table, "Shot", "cursor-left cursor-right", "left right", "aim"},
    {at_table, "Shot", "aim-left aim-right", "", "aim finely"},
    {at_table, "Shot", "cursor-up cursor-down", "up down", "power"},
    {at_table, "Shot", "pan-left pan-right pan-up pan-down", "shift-arrows",
     "tip: side, follow, draw"},
    {at_pool, "Shot", "next-pot previous-pot", "", "next pot; match: ball"},
    {at_cue, "Shot", "next-pot previous-pot", "", "next, previous target"},
    {at_pool, "Shot", "call", "", "safety, or push-out"},
    {at_table, "Shot", "place-cue-ball", "", "place the cue ball"},
    {at_table, "Shot", "aids", "", "aiming aid"},
    {at_pool, "Shot", "coach", "", "coach: three best shots"},
    {at_table, "Shot", "undo", "", "undo the shot"},
    {at_pool, "Game", "next-frame", "", "next frame, or concede"},
    {at_cue, "Game", "next-frame", "", "a new game"},
    {at_pool, "Game", "opponent", "", "opponent: off, 1 to 4"},
    {at_pool, "Game", "hand", "", "your skill in a match"},
    {at_pool, "Game", "record", "", "your record"},
    {at_pool, "Mouse", "", "left", "aim; call a pocket"},
    {at_cue, "Mouse", "", "left", "aim; pick your ball"},
    {at_table, "Mouse", "", "drag the cue", "pull it and shoot"},
    {at_table, "Mouse", "", "wheel", "power"},

    {at_pinball, "Table", "left-flipper", "z or left", "left flipper"},
    {at_pinball, "Table", "right-flipper", "/ or right", "right flipper"},
    {at_pinball, "Table", "plunger", "enter", "hold, release: plunger"},
    {at_pinball, "Table", "nudge-left nudge-up nudge-right", "", "nudge left, up, right"},
    {at_pinball, "Table", "add-player", "", "another player joins"},
    {at_pinball, "Table", "flipper-mode", "", "how flippers are held"},
    {at_pinball, "Table", "demo", "", "demo on, off"},
    {at_pinball, "Table", "bell", "", "bell on, off"},
    {at_pinball, "Mouse", "", "left, right", "flippers"},
    {at_pinball, "Mouse", "", "drag plunger", "pull it and let go"},

    {in_free, "Mouse", "", "drag", "move a ball or an edge"},
    {in_free, "Mouse", "", "right drag", "cue: pull, let go"},
    {in_lab, "Mouse", "", "middle drag", "pan"},
    {in_lab, "Mouse", "", "wheel", "zoom"},

    {in_free, "Edit", "cursor-left cursor-right cursor-up cursor-down", "arrows",
     "move the cursor"},
    {in_free, "Edit", "next-ball previous-ball", "tab", "next ball"},
    {in_free, "Edit", "grab", "", "grab, release"},
    {in_free, "Edit", "cue", "", "cue; enter shoots"},
    {in_free, "Edit", "add-ball remove", "a x", "add, remove a ball"},
    {in_free, "Edit", "draw-edge remove-edge", "", "draw, remove an edge"},
    {in_free, "Edit", "undo", "", "undo"},
    {in_free, "Edit", "gravity turn-gravity", "", "gravity: on/off, turn"},

    {in_all, "Time", "pause", "", "pause, resume"},
    {at_table, "Time", "to-rest", "", "skip until they rest"},
    {seen_above, "Time", "step-forward step-back", "", "step forward, back"},
    {in_lab, "Time", "next-collision", "", "to the next collision"},
    {in_lab, "Time", "second-forward second-back", "", "1 s forward, back"},
    {at_pinball, "Time", "second-back", "", "1 s back"},
    {in_all, "Time", "faster slower normal-speed", "", "faster, slower, normal"},
    {in_all, "Time", "restart", "", "restart"},

    {in_all, "View", "renderer", "", "renderer: next"},
    {in_lab, "View", "colors", "", "colour by kind, speed"},
    {in_all, "View", "trails", "", "trails"},
    {in_lab, "View", "velocities contacts broad-phase", "", "speeds, contacts, cells"},
    {in_lab, "View", "ids grid outlines", "", "numbers, grid, outlines"},
    {in_lab, "View", "overlay", "", "next overlay"},
    {in_lab, "View", "histogram energy", "", "histogram, energy"},
    {seen_above, "View", "zoom-in zoom-out fit", "", "zoom in, out, fit view"},
    {in_lab, "View", "pan-left pan-right pan-up pan-down", "shift-arrows", "pan"},
    {at_pinball, "View", "fit", "", "whole table / follow"},
    {in_lab, "View", "follow", "", "follow the ball"},
    {in_lab, "View", "split", "", "split: compare solvers"},
    {in_lab, "View", "butterfly", "", "200 perturbed copies"},
    {in_all, "View", "reset-view", "", "reset view"},

    {in_all, "Program", "about", "f1", "about this level"},
    {in_free, "Program", "solver explain", "", "solver: next, details"},
    {at_table | at_pinball | watched, "Program", "explain", "", "solver and model"},
    {in_free | at_table, "Program", "save keep-recording", "", "save level, recording"},
    {watched, "Program", "save", "", "save as a level"},
    {at_pinball, "Program", "keep-recording", "", "keep a recording"},
    {in_all, "Program", "mouse", "", "mouse on, off"},
    {in_all, "Program", "theme change-key", "", "theme, change a key"},
    {in_free | at_table | at_pinball, "Program", "take-up", "", "resume unfinished game"},
    {in_all, "Program", "menu quit", "", "cancel or menu, quit"},
};

std::uint8_t pages_of(Where where) {
    switch (where) {
        case Where::anywhere:
            return in_all;
        case Where::playing:
            return in_all & ~watched;
        case Where::editing:
            return in_free | at_table;
        case Where::pool:
            return at_table;
        case Where::pinball:
            return at_pinball;
    }
    return 0;
}

// Whether a line names the action, among others.
bool is_named(const Action& action, const HelpLine& line) {
    std::string_view rest = line.actions;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == action.name) return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

}  // namespace

std::vector<HelpLine> unnamed_lines(std::span<const Action> actions) {
    std::vector<HelpLine> unnamed;
    for (const Action& action : actions) {
        if (action.name == "help") continue;  // the page itself
        const bool has_line = std::ranges::any_of(
            lines, [&](const HelpLine& line) { return is_named(action, line); });
        if (!has_line)
            unnamed.push_back({pages_of(action.where), "More", action.name, "", action.help});
    }
    return unnamed;
}

std::span<const HelpLine> help_lines() {
    return lines;
}

}  // namespace carom

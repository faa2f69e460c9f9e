#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vec2.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

/// The status lines below the world.
namespace carom {

/// A key and its action, for hints and for the help screen.
struct KeyHelp {
    std::string keys;    ///< "space", "<- ->"
    std::string what;    ///< "pause"
    bool stays = false;  ///< of a hint: other hints make room for it
};

/// A quantity with the value that the level expects, and its value now.
struct HudCheck {
    std::string quantity;              ///< "collisions"
    std::string_view relation = "of";  ///< between the values: "of", "<"
    double measured = 0.0;
    double value = 0.0;
    bool is_exact = false;  ///< it must have this very value, so all digits count
    bool holds = false;     ///< now
};

struct HudInfo {
    std::string title;
    std::string name;        ///< of the level, before the title where both fit; empty: not wanted
    std::string short_name;  ///< in place of `name` where only that fits; may be empty
    /// The title is the state of a game: other fields give way to it.
    bool title_comes_first = false;
    /// Pool or pinball: the numbers of the laboratory are left out.
    bool is_game = false;
    std::string goal;               ///< what to do in this level; may be empty
    std::string solver;             ///< with its settings, such as "substep 4x15"
    bool solver_is_picked = false;  ///< chosen by carom, not by level or player
    std::string reason;             ///< why it was chosen; shown where there is room
    std::string beside;  ///< the comparison run or ensemble, and how it compares; may be empty
    double time = 0.0;   ///< s
    std::uint64_t tick = 0;
    std::uint64_t latest_tick = 0;   ///< more than `tick` after a step back
    double ticks_per_second = 0.0;   ///< the measured speed of play
    double rate = 0.0;               ///< ticks a second in the level's own time
    std::vector<std::string> terms;  ///< the model in force
    std::size_t balls = 0;
    std::size_t clustered = 0;     ///< balls of dense clusters, which `contact` steps
    std::uint64_t collisions = 0;  ///< since the start
    std::vector<HudCheck> checks;  ///< the most important first
    /// Shown in place of energy and momentum; may be empty. Two blanks divide it into parts, the
    /// most important first: what does not fit is left out from the end.
    std::string game;
    double kinetic_energy = 0.0;
    std::optional<double> potential_energy;  ///< under gravity
    Vec2 momentum;
    /// Relative change of the energy since the start; none where the model does not conserve it.
    std::optional<double> energy_drift;
    /// Relative change of the momentum since the start; none where it is not conserved.
    std::optional<double> momentum_drift;
    double speed = 1.0;  ///< of play, relative to the level's own time
    bool is_paused = false;
    std::string mode;     ///< settings in force, such as "ascii" or "mouse off"; may be empty
    std::string message;  ///< shown above the status lines, over the world
    bool message_is_error = false;
    /// A message that fits is shown in the line of the game instead, where there is one: it must
    /// not hide what moves in the world.
    bool message_in_line = false;
    std::string message_more;  ///< where to read all of a message that has too many lines
    /// The player must make one of these: they come before the hints or, where the last line has
    /// no room for all of them, over the world.
    std::vector<KeyHelp> choices;
    std::vector<KeyHelp> hints;  ///< the most useful first
};

/// The number of rows that the status lines take at the bottom of a window, 1 to 3.
int hud_rows(int columns, int rows);

/// The area above the status lines, which shows the world.
CellArea world_area(int columns, int rows);

/// Fills the rows below world_area(canvas.columns(), canvas.rows()). Fields that do not fit are
/// left out, the least important first. A message covers the last rows of the world,
/// unless it is shown in a line (HudInfo::message_in_line).
void draw_hud(Canvas& canvas, const HudInfo& info, const Look& look);

}  // namespace carom

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physics/solver.h"
#include "terminal/canvas/renderer.h"

namespace carom {

/// How many colours are used; `automatic` asks the terminal and honours NO_COLOR.
enum class ColorChoice : std::uint8_t { automatic, mono, c8, c16, c256 };

/// What the command line says. An absent value leaves the choice to the preferences file, and after
/// it to carom.
struct PlayOptions {
    std::string level;  ///< a file, or the name of a level that ships; empty: the menu
    std::optional<SolverSettings> solver;
    std::optional<double> rate;  ///< ticks a second
    std::optional<std::uint64_t> seed;
    std::vector<std::string> overrides;  ///< level statements, from --set

    std::optional<RendererChoice> renderer;
    std::optional<ColorChoice> colors;
    std::optional<double> fps;   ///< frames a second, > 0; 60 when absent
    std::optional<bool> mouse;   ///< false: the mouse is left to the terminal
    bool low_bandwidth = false;  ///< 15 frames a second, ASCII, no trails

    std::string record;  ///< a file for the recording; empty: none
    std::string replay;  ///< a recording, to be watched instead of playing a level; empty: none
    std::string cast;    ///< a file for a film of the screen; empty: none

    bool demo = false;    ///< at pinball, carom plays until somebody presses a button
    bool watch = false;   ///< load the level again whenever its files are saved
    bool paused = false;  ///< start paused
    int opponent = 0;     ///< at pool, how well carom plays the second player, 1..4; 0: a person
    /// Take up the session that was cut off or left, without asking; with no level, the last one.
    bool resume = false;
    std::size_t rewind_bytes = std::size_t{64} << 20;  ///< most memory for the way back
};

}  // namespace carom

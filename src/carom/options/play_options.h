#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/options/guest_options.h"
#include "physics/solver.h"
#include "terminal/canvas/renderer.h"
#include "terminal/canvas/theme.h"

namespace carom {

/// The number of colours; `automatic` asks the terminal and respects NO_COLOR.
enum class ColorChoice : std::uint8_t { automatic, mono, c8, c16, c256, direct };

/// The options of the command line. An absent value leaves the choice to the preferences file, and
/// then to carom.
struct PlayOptions {
    std::string level;  ///< a file, or the name of a level that ships; empty: the menu
    std::optional<SolverSettings> solver;
    std::optional<double> rate;  ///< ticks a second
    std::optional<std::uint64_t> seed;
    std::vector<std::string> overrides;  ///< level statements, from --set

    std::optional<RendererChoice> renderer;
    std::optional<ColorChoice> colors;
    std::optional<ThemeChoice> theme;
    std::optional<double> fps;   ///< frames a second, > 0; 60 when absent
    std::optional<bool> mouse;   ///< false: the mouse is left to the terminal
    bool low_bandwidth = false;  ///< 15 frames a second, ASCII, no trails

    std::string record;  ///< file for the recording; empty: none
    std::string replay;  ///< recording to watch instead of playing a level; empty: none
    std::string cast;    ///< file for an asciinema recording of the screen; empty: none

    bool demo = false;    ///< pinball: carom plays until somebody presses a button
    bool watch = false;   ///< reload the level whenever its files are saved
    bool paused = false;  ///< start paused
    int opponent = 0;     ///< pool: the skill of the AI player as second player, 1..4; 0: a person
    /// Resume the unfinished game without asking; without a level, the last one.
    bool resume = false;
    std::optional<GuestOptions> guest;  ///< plays as a guest of the account, from the menu
    std::size_t rewind_bytes = std::size_t{64} << 20;  ///< memory limit for the history
};

}  // namespace carom

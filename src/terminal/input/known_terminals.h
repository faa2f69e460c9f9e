#pragma once

#include <string_view>

#include "terminal/canvas/mosaic.h"

/// What is known of terminals by the name and version that they answer with (XTVERSION).
namespace carom {

struct TerminalTraits {
    /// The finest mosaic that the terminal draws itself, whatever its font.
    Mosaic mosaic = Mosaic::halves;
    bool has_direct_colors = false;  ///< certainly shows 24-bit colours
    /// Blocks come from its font, and may cover pixels of the cells around them.
    bool has_overhang = false;
};

/// `version`: the text of the answer, such as "kitty(0.40.1)", "ghostty 1.2.0" or "VTE(7803)".
/// Terminals that are not known, multiplexers, and versions before those in the table have no
/// traits.
TerminalTraits traits_of(std::string_view version);

}  // namespace carom

#pragma once

#include <string>

#include "terminal/canvas/palette.h"

namespace carom {

/// A gauge of twelve cells, as wide in ASCII: "▕█████░░░░░░░▏" for a share of 0.4. `share`: 0..1.
std::string power_bar(double share, const Look& look);

}  // namespace carom

#pragma once

#include <optional>

#include "terminal/input/input.h"
#include "terminal/input/input_sequence.h"

/// Mouse reports, decoded.
namespace carom {

/// The size of a cell in the unit that reports count in: 1 by 1 where they count cells, its size in
/// pixels under mode 1016.
struct MouseUnit {
    double wide = 1.0;
    double high = 1.0;
};

/// An SGR report (mode 1006 or 1016): CSI < buttons ; x ; y, then M (press, motion, wheel) or m
/// (release). None for the buttons that carom has no use for (wheel to the sides, 8 and up) and for
/// what is no report.
std::optional<InputEvent> mouse_event(const ControlSequence& sequence, const MouseUnit& unit = {});

/// The old report, CSI M and three bytes, for terminals without SGR reports: it does not say which
/// button was let go, so `held` is the one last pressed.
std::optional<InputEvent> old_mouse_event(int buttons, int x, int y, std::uint8_t held);

}  // namespace carom

#pragma once

#include <optional>

#include "terminal/input/input.h"
#include "terminal/input/input_sequence.h"

/// Decodes mouse reports.
namespace carom {

/// The size of a cell in the unit of mouse reports: 1 by 1 where reports count cells, the size in
/// pixels under mode 1016.
struct MouseUnit {
    double wide = 1.0;
    double high = 1.0;
};

/// Decodes an SGR report (mode 1006 or 1016): CSI < buttons ; x ; y, then M (press, motion, wheel)
/// or m (release). None for buttons that carom does not use (horizontal wheel, 8 and up) and for
/// other sequences.
std::optional<InputEvent> mouse_event(const ControlSequence& sequence, const MouseUnit& unit = {});

/// Decodes an X10 report, CSI M and three bytes, for terminals without SGR reports. It does not say
/// which button was released, so `held` is the last one pressed.
std::optional<InputEvent> old_mouse_event(int buttons, int x, int y, std::uint8_t held);

}  // namespace carom

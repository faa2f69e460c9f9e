#pragma once

#include <optional>

#include "terminal/input/input.h"

namespace carom {

/// The rows by which a key scrolls a page, downwards; none: it does not scroll. The arrows, the
/// page keys, space, `j` and `k`; home and end by more than any page has.
std::optional<int> scroll_of(const InputEvent& key);

}  // namespace carom

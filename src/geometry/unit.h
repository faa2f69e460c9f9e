#pragma once

#include "geometry/vec2.h"

namespace carom {

/// The unit vector along `v`. Pre: the length of `v` neither is 0 nor over- or underflows.
inline Vec2 unit(Vec2 v) {
    return v / length(v);
}

}  // namespace carom

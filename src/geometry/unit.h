#pragma once

#include "geometry/vec2.h"

namespace carom {

/// `v` at length 1. Pre: its length is neither 0 nor infinite.
inline Vec2 unit(Vec2 v) {
    return v / length(v);
}

}  // namespace carom

#pragma once

#include <cstddef>
#include <vector>

#include "geometry/shapes.h"

/// What a picture shows of a pinball table beside its edges.
namespace carom {

/// A lamp under the glass, or an edge that lights up, as a target does.
struct TableLight {
    Capsule shape;
    bool is_edge = false;    ///< drawn over the edge that it is; else under all of them
    bool is_lit = false;     ///< edges: those that are not lit look as edges do
    std::size_t family = 0;  ///< lights of one family have one colour
};

struct TableMarks {
    std::vector<TableLight> lights;
    std::vector<Capsule> plungers;  ///< as pulled
};

}  // namespace carom

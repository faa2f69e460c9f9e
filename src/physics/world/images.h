#pragma once

#include "geometry/shapes.h"
#include "physics/world/model.h"

namespace carom {

/// Whether solvers know all images of an edge that a ball may meet; true on a plane.
///
/// On a torus they know the images in it and in the eight around it. A ball reaches out of the
/// torus by a quarter of its side at most, since its centre is within and no ball may be larger; so
/// an edge may reach out by the other three quarters.
bool has_all_images(const Model& model, const Capsule& edge);

}  // namespace carom

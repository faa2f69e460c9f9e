#include "physics/swept/kinematics.h"

#include "physics/world/solver_access.h"

namespace carom {

void SweptKinematics::finish(World& world, double duration) const {
    for (const HeldEdge& edge : edges_)
        SolverAccess(world).capsules().shape[edge.capsule] = carom::shape_at(edge, world, duration);
}

}  // namespace carom

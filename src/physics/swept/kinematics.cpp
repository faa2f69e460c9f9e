#include "physics/swept/kinematics.h"

namespace carom {

void SweptKinematics::finish(World& world, double duration) const {
    for (const HeldEdge& edge : edges_)
        carom::finish(edge, world, duration);
}

}  // namespace carom

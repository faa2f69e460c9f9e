#pragma once

#include "physics/world/world.h"

namespace carom {

/// Write access for solvers: to the columns that a tick moves, to edges, and to what solvers
/// remember. Only `src/physics` includes this.
///
/// balls() gives no stamp, so it costs nothing in an inner loop: a solver that has written through
/// it calls stamp_motion() before its tick ends, and changes no column that a tick does not move
/// (Stamps::roster). memory() gives none either: see stamp_memory(). capsules() gives one on every
/// call, since edges move in few ticks only.
class SolverAccess {
  public:
    explicit SolverAccess(World& world) : world_(world) {}

    Balls& balls() const { return world_.balls_; }
    Capsules& capsules() const { return world_.edit_capsules(); }
    SolverMemory& memory() const { return world_.memory_; }

    void stamp_motion() const { world_.stamps_.motion = new_stamp(); }
    void stamp_memory() const { world_.stamps_.memory = new_stamp(); }

  private:
    World& world_;
};

}  // namespace carom

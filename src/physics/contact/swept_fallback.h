#pragma once

#include "physics/world/world.h"

/// Where the solver `contact` has nothing to press: there it goes by `swept`.
///
/// In a scene without gravity and drag, where every restitution is 1 and nobody holds anything, no
/// pair can ever press: whatever meets, bounces at that instant. Between impacts all fly straight,
/// on paths that are exact however long they are, so cutting a tick into substeps changes nothing
/// but the last digits. That is just what `swept` does, in less memory and in one piece. It takes
/// up to swept_tolerance::most_impacts a ball one by one, so a jam of elastic balls costs more.
namespace carom {

/// Whether the next tick of this world is such a one. Depends on the model and on who holds what.
bool is_flight_only(const World& world);

/// Into how many pieces `swept` cuts such a tick: as many as keep the typical way of a ball in one,
/// by the mean of the squares, under 0.3 radii, `most` at most. More are not more accurate, but
/// where balls go far in a tick they look at fewer others. Pre: most >= 1.
int flight_substeps(const World& world, int most);

}  // namespace carom

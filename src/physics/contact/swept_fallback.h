#pragma once

#include "physics/world/world.h"

/// Scenes in which nothing can press: there `swept` stands in for the solver `contact`.
///
/// Without gravity and drag, where every restitution is 1 and nothing is held, no pair can press:
/// every impact bounces at once. Between impacts all balls fly straight, on paths that are exact
/// however long they are, so substeps would change only the last digits. `swept` gives that result
/// in as few substeps as it needs, and with less memory. But it resolves impacts one by one, up to
/// its budget of work (tick/work_budget.h), so a jam of elastic balls costs more.
namespace carom {

/// Whether the next tick is such a one. Depends on the model and on what is held.
bool is_flight_only(const World& world);

/// Number of substeps in which `swept` computes such a tick: as many as keep the typical
/// displacement of a ball (the root of the mean square) under 0.3 radii in each, but at most
/// `most`. More are not more accurate, but where balls go far in a tick, each search meets fewer
/// other balls. Pre: most >= 1.
int flight_substeps(const World& world, int most);

}  // namespace carom

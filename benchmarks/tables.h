#pragma once

#include <string>
#include <vector>

#include "goals.h"
#include "own.h"
#include "runs.h"

/// The results as text tables and as CSV.
namespace carom::bench {

/// One line an engine, with a bar proportional to its time.
std::string scene_table(const SceneResults& scene);

std::string goals_table(const std::vector<GoalLine>& lines);
std::string cost_table(const OwnFigures& own);
std::string events_table(const OwnFigures& own);

/// A header, then a line for each engine's median, and for each of carom's own figures.
std::string csv(const std::vector<SceneResults>& scenes, const OwnFigures& own);

}  // namespace carom::bench

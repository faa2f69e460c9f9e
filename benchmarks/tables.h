#pragma once

#include <string>
#include <vector>

#include "goals.h"
#include "own.h"
#include "runs.h"

/// The results, as text in columns and as CSV.
namespace carom::bench {

/// An engine a line, with a bar as long as its time.
std::string scene_table(const SceneResults& scene);

std::string goals_table(const std::vector<GoalLine>& lines);
std::string cost_table(const OwnFigures& own);
std::string events_table(const OwnFigures& own);

/// A line for each run's median, and for each of carom's own figures; the head first.
std::string csv(const std::vector<SceneResults>& scenes, const OwnFigures& own);

}  // namespace carom::bench

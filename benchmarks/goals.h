#pragma once

#include <string>
#include <vector>

#include "own.h"
#include "runs.h"

/// carom's targets against other engines, and how far it meets them.
namespace carom::bench {

enum class Verdict : std::uint8_t { target_met, required_met, missed };

struct GoalLine {
    std::string scene;
    std::string what;  ///< what is compared, with its unit
    double measured = 0.0;
    double required = 0.0;
    double target = 0.0;  ///< equal to `required` where nothing more is aimed at
    bool more_is_better = false;

    Verdict verdict() const;
};

/// A line for each goal for which the results have figures. Box2D 3's native time is not measured
/// here: it is Chipmunk's time in the same run, multiplied by BenchScene::box2d3_by_chipmunk. Its
/// overlap and residual speed in piles are those of its node build in the same run, or, without
/// node, those of an earlier measurement.
std::vector<GoalLine> goal_lines(const std::vector<SceneResults>& scenes, const OwnFigures& own);

}  // namespace carom::bench

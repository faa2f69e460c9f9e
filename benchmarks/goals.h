#pragma once

#include <string>
#include <vector>

#include "own.h"
#include "runs.h"

/// What carom must reach against its peers, and how far it is.
namespace carom::bench {

enum class Verdict : std::uint8_t { wanted, least, short_of_it };

struct GoalLine {
    std::string scene;
    std::string what;  ///< what is compared, with its unit
    double measured = 0.0;
    double least = 0.0;
    double wanted = 0.0;  ///< the same as `least` where nothing more is wanted
    bool more_is_better = false;

    Verdict verdict() const;
};

/// A line for each goal that the results have figures for. Box2D 3's native times are not measured
/// here: they are Chipmunk's in the same run times BenchScene::box2d3_by_chipmunk. Its overlap and
/// residual speed in piles are those of its build for node in the same run, or where that is not
/// there what was measured of it once.
std::vector<GoalLine> goal_lines(const std::vector<SceneResults>& scenes, const OwnFigures& own);

}  // namespace carom::bench

#pragma once

#include <optional>
#include <vector>

#include "frames.h"
#include "physics/world/world.h"
#include "scene_list.h"

/// What an engine got wrong, by what it wrote down. carom's own formulas judge all engines alike.
namespace carom::bench {

struct Accuracy {
    /// Change of the energy from the first frame to the last, relative. None where the scene itself
    /// takes energy away.
    std::optional<double> energy_drift;
    double deepest_overlap = 0.0;  ///< a length, over the frames that count
    double residual_speed = 0.0;   ///< root mean square over the frames that count, length/s
    /// Root mean square distance from the reference at its tick, in radii. None without one.
    std::optional<double> error;
};

/// `world` is the scene at its start. `reference`: a frame of the solver `event`, or none.
Accuracy judge(const World& world, const SceneList& list, const std::vector<Frame>& frames,
               const std::optional<Frame>& reference);

}  // namespace carom::bench

#pragma once

#include <optional>
#include <vector>

#include "frames.h"
#include "physics/world/world.h"
#include "scene_list.h"

/// The errors of an engine, computed from its frames. The same formulas judge all engines.
namespace carom::bench {

struct Accuracy {
    /// Relative change of the energy from the first frame to the last. None where the scene itself
    /// loses energy.
    std::optional<double> energy_drift;
    double deepest_overlap = 0.0;  ///< length, over the measured frames
    double residual_speed = 0.0;   ///< root mean square over the measured frames, length/s
    /// Root mean square distance from the reference at its tick, in radii. None without a
    /// reference.
    std::optional<double> error;
};

/// `world` is the scene at its start. `reference`: a frame of the solver `event`, or none.
Accuracy judge(const World& world, const SceneList& list, const std::vector<Frame>& frames,
               const std::optional<Frame>& reference);

}  // namespace carom::bench

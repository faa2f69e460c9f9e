#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// A scene as a plain list of numbers that any engine can read, and what is to be measured in it.
///
/// As text, one thing a line, in this order and all in the units of the level:
///
///     rate TICKS_A_SECOND
///     gravity X Y
///     restitution E                        of every contact
///     friction MU                          of every contact
///     run TICKS MEASURED_FROM SAMPLE_EVERY
///     landed HEIGHT                        may be left out
///     capsule X0 Y0 X1 Y1 RADIUS           an edge that rests; ends that coincide make a peg
///     ball TICK X Y VX VY RADIUS MASS      comes at the beginning of that tick, from 0
namespace carom::bench {

struct ListedCapsule {
    double start_x = 0.0;
    double start_y = 0.0;
    double end_x = 0.0;
    double end_y = 0.0;
    double radius = 0.0;
};

struct ListedBall {
    std::int64_t tick = 0;
    double x = 0.0;
    double y = 0.0;
    double vx = 0.0;
    double vy = 0.0;
    double radius = 1.0;
    double mass = 1.0;
};

/// What is run, what of it counts, and when the engine's state is written down (off the clock).
struct RunPlan {
    std::int64_t ticks = 0;
    std::int64_t measured_from = 0;  ///< ticks before it do not count
    std::int64_t sample_every = 1;   ///< ticks
    /// The run ends early once all balls are there and below this height.
    std::optional<double> landed;
};

struct SceneList {
    double rate = 60.0;
    double gravity_x = 0.0;
    double gravity_y = 0.0;
    double restitution = 1.0;
    double friction = 0.0;
    RunPlan plan;
    std::vector<ListedCapsule> capsules;
    std::vector<ListedBall> balls;  ///< by tick
};

std::string scene_list_text(const SceneList& scene);

/// None when a line is not understood: the text comes from `scene_list_text`.
std::optional<SceneList> parse_scene_list(const std::string& text);

/// The file's scene. Ends the process with a message where there is none.
SceneList read_scene_list(const std::string& path);

}  // namespace carom::bench

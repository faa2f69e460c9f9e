#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// A scene as a plain list of numbers that any engine can read, and the plan of its measurement.
///
/// As text, one item a line, in this order and in the units of the level:
///
///     rate TICKS_A_SECOND
///     gravity X Y
///     restitution E                        of every contact
///     friction MU                          of every contact
///     run TICKS MEASURED_FROM SAMPLE_EVERY
///     landed HEIGHT                        optional
///     capsule X0 Y0 X1 Y1 RADIUS           a fixed edge; coinciding ends make a peg
///     ball TICK X Y VX VY RADIUS MASS      appears at the beginning of that tick, from 0
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

/// What is run, which ticks are measured, and when the state is sampled (off the clock).
struct RunPlan {
    std::int64_t ticks = 0;
    std::int64_t measured_from = 0;  ///< earlier ticks are not measured
    std::int64_t sample_every = 1;   ///< ticks
    /// The run ends early once all balls have appeared and are below this height.
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

/// Reads what scene_list_text wrote. None where a line is malformed.
std::optional<SceneList> parse_scene_list(const std::string& text);

/// The file's scene. Ends the process with a message where the file cannot be read.
SceneList read_scene_list(const std::string& path);

}  // namespace carom::bench

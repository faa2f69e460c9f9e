#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <string>
#include <utility>

#include "frames.h"
#include "scene_list.h"

/// The run that every engine performs, and its clock.
namespace carom::bench {

/// What an engine must provide. `add` is called for each ball in the order of the list, before the
/// tick at which the ball appears; `state` uses the same order.
template <typename E>
concept Engine = requires(E engine, const E& seen, const ListedBall& ball, std::size_t index) {
    engine.add(ball);
    engine.step();
    { seen.size() } -> std::convertible_to<std::size_t>;
    { seen.state(index) } -> std::same_as<BallState>;
};

/// Processor time of this process, s: other processes do not affect it.
inline double processor_seconds() {
    std::timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <Engine E>
Frame frame_of(const E& engine, std::int64_t tick) {
    Frame frame{.tick = tick, .balls = std::vector<BallState>(engine.size())};
    for (std::size_t i = 0; i < frame.balls.size(); ++i)
        frame.balls[i] = engine.state(i);
    return frame;
}

struct Driven {
    std::int64_t ticks = 0;     ///< in total
    std::int64_t measured = 0;  ///< ticks on the clock
    double seconds = 0.0;       ///< processor time of `measured`
};

/// Runs the plan; frames go to `path`, or nowhere where it is "-".
template <Engine E>
Driven drive(E& engine, const SceneList& scene, const std::string& path) {
    const RunPlan& plan = scene.plan;
    std::ofstream file;
    if (path != "-") file.open(path, std::ios::binary);
    Driven driven;
    std::size_t born = 0;
    for (std::int64_t tick = 0; tick < plan.ticks;) {
        const std::int64_t next_sample = (tick / plan.sample_every + 1) * plan.sample_every;
        std::int64_t stop = std::min(plan.ticks, next_sample);
        if (tick < plan.measured_from) stop = std::min(stop, plan.measured_from);
        const bool on_the_clock = tick >= plan.measured_from;
        const std::int64_t count = stop - tick;
        const double start = processor_seconds();
        for (; tick < stop; ++tick) {
            for (; born < scene.balls.size() && scene.balls[born].tick <= tick; ++born)
                engine.add(scene.balls[born]);
            engine.step();
        }
        const double seconds = processor_seconds() - start;
        if (on_the_clock) {
            driven.seconds += seconds;
            driven.measured += count;
        }
        const Frame frame = frame_of(engine, tick);
        if (file.is_open()) write_frame(file, frame);
        if (!plan.landed || frame.balls.size() < scene.balls.size()) continue;
        const auto is_below = [&plan](const BallState& ball) { return ball.y < *plan.landed; };
        if (std::ranges::all_of(frame.balls, is_below)) {
            driven.ticks = tick;
            return driven;
        }
    }
    driven.ticks = plan.ticks;
    return driven;
}

/// Prints what the benchmark reads: the engine's name, and the figures.
inline void report(const std::string& engine, const Driven& driven) {
    fmt::print("engine {}\nticks {}\nmeasured {}\nseconds {}\n", engine, driven.ticks,
               driven.measured, driven.seconds);
}

}  // namespace carom::bench

#include "judge.h"

#include <algorithm>
#include <cmath>

#include "physics/tick/totals.h"

namespace carom::bench {
namespace {

// The scene with the balls at the positions of the frame.
World world_at(const World& start, const SceneList& list, const Frame& frame) {
    World world = start;
    world.edit_balls() = {};
    for (std::size_t i = 0; i < frame.balls.size(); ++i) {
        const BallState& ball = frame.balls[i];
        add_ball(world, {.position = {ball.x, ball.y},
                         .velocity = {ball.vx, ball.vy},
                         .radius = list.balls[i].radius,
                         .mass = list.balls[i].mass});
    }
    return world;
}

double energy(const World& world) {
    const Totals sums = totals(world);
    return sums.kinetic_energy + sums.potential_energy;
}

double mean_square_speed(const Frame& frame) {
    double sum = 0.0;
    for (const BallState& ball : frame.balls)
        sum += ball.vx * ball.vx + ball.vy * ball.vy;
    return frame.balls.empty() ? 0.0 : sum / static_cast<double>(frame.balls.size());
}

double error_in_radii(const SceneList& list, const Frame& frame, const Frame& reference) {
    double sum = 0.0;
    for (std::size_t i = 0; i < frame.balls.size(); ++i) {
        const double x = (frame.balls[i].x - reference.balls[i].x) / list.balls[i].radius;
        const double y = (frame.balls[i].y - reference.balls[i].y) / list.balls[i].radius;
        sum += x * x + y * y;
    }
    return std::sqrt(sum / static_cast<double>(frame.balls.size()));
}

}  // namespace

Accuracy judge(const World& world, const SceneList& list, const std::vector<Frame>& frames,
               const std::optional<Frame>& reference) {
    Accuracy accuracy;
    if (frames.empty()) return accuracy;
    double squares = 0.0;
    int counted = 0;
    for (const Frame& frame : frames) {
        if (reference && frame.tick == reference->tick)
            accuracy.error = error_in_radii(list, frame, *reference);
        if (frame.tick < list.plan.measured_from) continue;
        accuracy.deepest_overlap =
            std::max(accuracy.deepest_overlap, deepest_overlap(world_at(world, list, frame)));
        squares += mean_square_speed(frame);
        ++counted;
    }
    if (counted > 0) accuracy.residual_speed = std::sqrt(squares / counted);
    if (list.restitution == 1.0) {
        const double before = energy(world);
        accuracy.energy_drift = energy(world_at(world, list, frames.back())) / before - 1.0;
    }
    return accuracy;
}

}  // namespace carom::bench

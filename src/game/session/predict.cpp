#include "game/session/predict.h"

namespace carom {

std::vector<Vec2> predicted_path(const World& world, const SolverSettings& solver, BallId ball,
                                 Vec2 velocity, std::uint64_t ticks) {
    World ahead = world;
    const auto struck = index_of(ahead, ball);
    if (!struck) return {};
    ahead.edit_balls().velocity[*struck] = velocity;
    std::vector<Vec2> path{ahead.balls().position[*struck]};
    Solver engine(solver);
    for (; ticks > 0; --ticks) {
        engine.tick(ahead);
        const auto index = index_of(ahead, ball);
        if (!index) break;
        path.push_back(ahead.balls().position[*index]);
    }
    return path;
}

}  // namespace carom

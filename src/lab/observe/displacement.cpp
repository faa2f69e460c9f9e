#include "lab/observe/displacement.h"

#include "physics/broad_phase/cell_frame.h"

namespace carom {

DisplacementMeter::DisplacementMeter(const World& start) : start_tick_(start.tick()) {
    const Balls& balls = start.balls();
    for (std::size_t i = 0; i < balls.size(); ++i)
        starts_.push_back({balls.id[i], balls.position[i], balls.velocity[i], {}});
    measure(start);
}

void DisplacementMeter::note_tick(const World& world) {
    measure(world);
}

void DisplacementMeter::measure(const World& world) {
    const Balls& balls = world.balls();
    const auto& torus = world.model().wrap;
    double squares = 0.0;
    double products = 0.0;
    double own_products = 0.0;
    std::size_t still_there = 0;
    std::size_t i = 0;
    for (Start& start : starts_) {
        while (i < balls.size() && balls.id[i] < start.id)
            ++i;
        if (i == balls.size()) break;
        if (balls.id[i] != start.id) continue;
        Vec2 moved = balls.position[i] - start.position;
        if (torus) {
            start.moved += nearest_image(moved, size(*torus));
            start.position = balls.position[i];
            moved = start.moved;
        }
        squares += length_squared(moved);
        products += dot(balls.velocity[i], start.velocity);
        own_products += length_squared(start.velocity);
        ++still_there;
    }
    msd_ =
        still_there > 0 ? std::optional(squares / static_cast<double>(still_there)) : std::nullopt;
    vacf_ = own_products > 0.0 ? std::optional(products / own_products) : std::nullopt;
    const double time = static_cast<double>(world.tick() - start_tick_) * world.tick_length();
    if (msd_) msd_series_.add(world.tick(), {time, *msd_, {}});
    if (vacf_) vacf_series_.add(world.tick(), {time, *vacf_, {}});
}

}  // namespace carom

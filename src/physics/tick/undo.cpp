#include "physics/tick/undo.h"

namespace carom {

void TickUndo::note(const World& world) {
    balls_ = world.balls;
    lossy_ = world.model.lossy;
    next_ball_ = world.next_ball;
    emitters_ = world.emitters;
    held_capsules_ = world.held_capsules;
    moves_edges_ = !world.held_capsules.empty() || !world.flippers.empty();
    if (moves_edges_) shapes_ = world.capsules.shape;
}

void TickUndo::take_back(World& world) const {
    world.balls = balls_;
    world.model.lossy = lossy_;
    world.next_ball = next_ball_;
    world.emitters = emitters_;
    world.held_capsules = held_capsules_;
    if (moves_edges_) world.capsules.shape = shapes_;
}

}  // namespace carom

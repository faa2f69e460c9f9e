#include "physics/tick/undo.h"

namespace carom {

void TickUndo::note(const World& world) {
    balls_ = world.balls();
    inelastic_ = world.model().inelastic;
    rough_ = world.model().rough;
    next_ball_ = world.next_ball();
    emitters_ = world.emitters();
    held_balls_ = world.held_balls();
    held_capsules_ = world.held_capsules();
    hands_ = world.hands();
    seesaws_ = world.seesaws();
    moves_edges_ = !world.held_capsules().empty() || !world.flippers().empty() ||
                   !world.movers().empty() || !world.seesaws().empty();
    if (moves_edges_) shapes_ = world.capsules().shape;
}

void TickUndo::take_back(World& world) const {
    world.edit_balls() = balls_;
    world.edit_definition().model.inelastic = inelastic_;
    world.edit_definition().model.rough = rough_;
    world.edit_ids().next_ball = next_ball_;
    world.edit_emitters() = emitters_;
    if (!held_balls_.empty()) world.edit_held_balls() = held_balls_;
    world.edit_held_capsules() = held_capsules_;
    world.edit_hands() = hands_;
    world.edit_seesaws() = seesaws_;
    if (moves_edges_) world.edit_capsules().shape = shapes_;
}

}  // namespace carom

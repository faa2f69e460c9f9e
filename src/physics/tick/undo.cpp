#include "physics/tick/undo.h"

namespace carom {

void TickUndo::note(const World& world) {
    const Balls& balls = world.balls;
    balls_ = balls.size();
    lossy_ = world.model.lossy;
    next_ball_ = world.next_ball;
    position_ = balls.position;
    velocity_ = balls.velocity;
    spin_ = balls.spin;
    roll_ = balls.roll;
    edge_contacts_ = balls.edge_contacts;
    emitters_ = world.emitters;
    held_capsules_ = world.held_capsules;
    shapes_.clear();
    if (!world.held_capsules.empty() || !world.flippers.empty()) shapes_ = world.capsules.shape;
}

void TickUndo::take_back(World& world) const {
    Balls& balls = world.balls;
    balls.id.resize(balls_);
    balls.radius.resize(balls_);
    balls.inverse_mass.resize(balls_);
    balls.kind.resize(balls_);
    balls.restitution.resize(lossy_ ? balls_ : 0);
    balls.position = position_;
    balls.velocity = velocity_;
    balls.spin = spin_;
    balls.roll = roll_;
    balls.edge_contacts = edge_contacts_;
    world.model.lossy = lossy_;
    world.next_ball = next_ball_;
    world.emitters = emitters_;
    world.held_capsules = held_capsules_;
    if (!shapes_.empty()) world.capsules.shape = shapes_;
}

}  // namespace carom

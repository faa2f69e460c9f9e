#pragma once

#include "physics/world/world.h"

/// A pool table for tests, in SI units: the balls and the cloth of levels/eight-ball.level.
namespace carom::scenes {

constexpr double pool_ball = 0.028575;  ///< its radius
constexpr double solid = 0.4;           ///< inertia / (m r^2) of a ball
constexpr Vec2 half_table{1.27, 0.635};

/// No balls and no cushions, 240 ticks a second. `restitution` and `friction` are for pairs of
/// balls.
World cloth_table(double restitution, double friction, const Cloth& cloth = {});

/// A ball that slides without spin, unless a roll is given.
void put(World& world, Vec2 position, Vec2 velocity = {}, Vec2 roll = {}, double spin = 0.0);

/// Four edges without pockets, around the origin.
void put_cushions(World& world);

/// A rack of 15 with `gap` between its balls, and a cue ball moving towards it, `off` its axis.
World break_shot(double gap, Vec2 velocity, Vec2 roll, double spin, double off);

}  // namespace carom::scenes

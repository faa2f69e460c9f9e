#include "carom/pool/cue_pull.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

/// A shorter pull, in radii of the ball, does not shoot.
constexpr double least_pull = 1.5;
/// Where the window ends close behind, this share of the room is enough.
constexpr double least_share = 0.5;

/// How far a point can go back, against the unit vector `way`, before it leaves the box. Zero for
/// a point outside.
double room_behind(const Box& box, Vec2 from, Vec2 way) {
    double room = length(box.high - box.low);
    if (way.x != 0.0)
        room = std::min(room, (from.x - (way.x > 0.0 ? box.low : box.high).x) / way.x);
    if (way.y != 0.0)
        room = std::min(room, (from.y - (way.y > 0.0 ? box.low : box.high).y) / way.y);
    return std::max(0.0, room);
}

}  // namespace

CuePull grip(const Session& session, const PoolAim& aim, const Camera& camera, Vec2 from) {
    const World& world = session.world();
    const double radius = world.balls().radius[*index_of(world, *aim.cue_ball(session))];
    const Vec2 velocity = aim.strike(session).velocity;
    CuePull pull{from, velocity / length(velocity), 0.0, 0.0, aim.setup()};
    const Vec2 half_a_cell = Vec2{1.0, camera.aspect} * (0.5 / camera.columns_per_length);
    Box window = visible_box(camera);
    window = {window.low + half_a_cell, window.high - half_a_cell};
    pull.room = room_behind(window, pull.from, pull.way);
    pull.least = std::min(least_pull * radius, least_share * pull.room);
    return pull;
}

double pulled(const CuePull& pull, Vec2 at) {
    return std::clamp(dot(pull.from - at, pull.way), 0.0, pull.room);
}

MouseStroke push_of(const CuePull& pull, const Camera& camera, double time) {
    const Vec2 way = pull.way;
    const Vec2 cell = to_world(camera, {1.0, 1.0}) - to_world(camera, {0.0, 0.0});
    const double grain = 0.5 * (std::abs(way.x * cell.y) + std::abs(way.y * cell.x));
    return {pull.from, way, pull.least, grain, time};
}

}  // namespace carom

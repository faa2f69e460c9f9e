#include "game/pool/spotting.h"

#include <algorithm>
#include <array>
#include <vector>

#include "game/pool/table_places.h"
#include "game/referees/referee.h"
#include "geometry/closest.h"
#include "level/scene/racking.h"

namespace carom {
namespace {

std::optional<BallId>& slot(PoolPlay& play, int ball) {
    return play.balls[static_cast<std::size_t>(ball)];
}

double radius_of(const Scene& scene, int ball) {
    return scene.world.balls().radius[*index_of(scene.world, first_ball(scene, ball))];
}

void take_off(World& world, PoolPlay& play, int ball) {
    if (const auto id = std::exchange(slot(play, ball), std::nullopt)) remove_ball(world, *id);
}

// At rest. Pre: the ball is off the table.
void put(const Scene& scene, World& world, PoolPlay& play, int ball, Vec2 place) {
    const std::size_t like = *index_of(scene.world, first_ball(scene, ball));
    slot(play, ball) = add_ball(world, spec_at_rest(scene.world, like, place));
}

// The place of a ball with a spot of its own.
Vec2 own_place(const Scene& scene, const World& world, const PoolPlay& play, int ball) {
    constexpr int most_steps = 4000;
    const double radius = radius_of(scene, ball);
    const Vec2 home = home_of(scene, ball);
    if (is_free(world, home, radius)) return home;
    for (int other = object_balls(scene); other > cue_ball; --other)
        if (play.rules.referee->has_own_spot(other) &&
            is_free(world, home_of(scene, other), radius))
            return home_of(scene, other);
    const Vec2 step = rack_of(scene).toward * (0.05 * radius);
    for (const double sign : {1.0, -1.0})
        for (int i = 1; i < most_steps; ++i) {
            const Vec2 place = home + step * (sign * i);
            if (!is_on_table(scene, world, place, radius)) break;
            if (is_free(world, place, radius)) return place;
        }
    return home;
}

Vec2 cue_place(const Scene& scene, const World& world, const PoolPlay& play) {
    const bool in_d = play.rules.in_hand == CueInHand::in_d;
    const Vec2 start = in_d ? home_of(scene, cue_ball) : head_spot(scene);
    return free_place(world, start, -rack_of(scene).toward, radius_of(scene, cue_ball));
}

// The triangle around the centres of the racked balls.
bool is_in_triangle(const Rack& rack, const std::array<Vec2, 3>& corners, Vec2 place,
                    double radius) {
    // Balls overlap its outline, which is a radius outside of the centres.
    const double reach = 2.0 * radius + rack.gap;
    bool is_inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 from = corners[i];
        const Vec2 side = corners[(i + 1) % 3] - from;
        if (separation({place, reach}, {from, corners[(i + 1) % 3], 0.0}) <= 0.0) return true;
        if (cross(side, place - from) < 0.0) is_inside = false;
    }
    return is_inside;
}

// The ball that stayed on the table when the others are racked again; none: all are racked.
std::optional<int> last_object_ball(const Scene& scene, PoolPlay& play) {
    std::optional<int> last;
    for (int ball = 1; ball <= object_balls(scene); ++ball)
        if (slot(play, ball)) last = ball;
    return last;
}

// Moves the cue ball and the last object ball out of the triangle, as straight pool has it: the
// object ball to the head spot or, if the cue ball blocks it, to the middle; the cue ball to the
// head spot or behind the head string. If both are in the way, the object ball is racked with the
// others. Returns whether it stays on the table, so that the apex remains free.
bool clear_triangle(const Scene& scene, World& world, PoolPlay& play,
                    const std::vector<RackedBall>& places) {
    const Rack& rack = rack_of(scene);
    const double radius = radius_of(scene, 1);
    const double pitch = 2.0 * radius + rack.gap;
    const auto rows = static_cast<std::size_t>(rack.layout->rows.size());
    const auto size = static_cast<std::size_t>(object_balls(scene));
    // Counter-clockwise: the apex, and the rear corners right and left.
    const std::array<Vec2, 3> corners{rack.foot, rack.foot + places[size - 1].grid * pitch,
                                      rack.foot + places[size - rows].grid * pitch};
    const auto position = [&](int ball) {
        return world.balls().position[*index_of(world, *slot(play, ball))];
    };
    const auto is_in_the_way = [&](int ball) {
        return is_in_triangle(rack, corners, position(ball), radius);
    };
    const Vec2 head = head_spot(scene);
    const Vec2 middle = (head + rack.foot) * 0.5;
    const auto blocks = [&](int ball, Vec2 spot) {
        return length(position(ball) - spot) < 2.0 * radius;
    };

    std::optional<int> last = last_object_ball(scene, play);
    const bool cue_in_the_way = is_in_the_way(cue_ball);
    std::optional<Vec2> cue_to;
    if (last && is_in_the_way(*last)) {
        const Vec2 to = blocks(cue_ball, head) ? middle : head;
        take_off(world, play, *last);
        if (cue_in_the_way)
            last.reset();
        else
            put(scene, world, play, *last, to);
    } else if (last && cue_in_the_way) {
        if (blocks(*last, head))
            cue_to = middle;
        else if (!is_beyond_string(scene, position(*last)))
            cue_to = head;
    }
    if (cue_in_the_way) {
        take_off(world, play, cue_ball);
        if (!cue_to) play.rules.in_hand = CueInHand::behind_head_string;
        put(scene, world, play, cue_ball, cue_to.value_or(cue_place(scene, world, play)));
    }
    return last.has_value();
}

}  // namespace

void put_on_spot(const Scene& scene, World& world, PoolPlay& play, int ball) {
    take_off(world, play, ball);
    const Rack& rack = rack_of(scene);
    const Vec2 place = ball == cue_ball ? cue_place(scene, world, play)
                       : play.rules.referee->has_own_spot(ball)
                           ? own_place(scene, world, play, ball)
                           : free_place(world, rack.foot, rack.toward, radius_of(scene, ball));
    put(scene, world, play, ball, place);
}

void put_back(const Scene& scene, World& world, PoolPlay& play) {
    for (int ball = 0; ball <= object_balls(scene); ++ball)
        take_off(world, play, ball);
    for (const PoolPlay::Lay& lay : play.lay)
        put(scene, world, play, lay.ball, lay.place);
}

void rack_rest(const Scene& scene, World& world, PoolPlay& play) {
    const Rack& rack = rack_of(scene);
    ++play.racks;
    const std::vector<RackedBall> places =
        racked({rack.layout, rack.toward, rack.gap, rack.seed}, play.racks);
    const bool leaves_last = clear_triangle(scene, world, play, places);
    std::size_t next = leaves_last ? 1 : 0;
    for (int ball = 1; ball <= object_balls(scene); ++ball) {
        if (slot(play, ball)) continue;
        const RackedBall& to = places[next++];
        const double pitch = 2.0 * radius_of(scene, 1) + to.gap;
        put(scene, world, play, ball, rack.foot + to.shift + to.grid * pitch);
    }
}

}  // namespace carom

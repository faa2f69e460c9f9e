#include "game/pool/sight.h"

#include <cmath>
#include <utility>
#include <vector>

#include "game/pool/table_places.h"
#include "game/referees/referee.h"
#include "geometry/impact.h"

namespace carom {
namespace {

struct Placed {
    int ball = 0;
    Vec2 place;
    double radius = 0.0;
};

// Where the cue ball touches the target's side, at the end of a line that grazes it.
Vec2 grazing_end(Vec2 from, Vec2 target, double reach, double side) {
    const Vec2 way = target - from;
    const double apart = length(way);
    const double share = reach / apart;  // sine of the angle between the line and the centres
    const double cosine = std::sqrt(1.0 - share * share);
    const Vec2 along = way * (cosine / apart);
    const Vec2 across = perpendicular(way) * (side * share / apart);
    return from + (along + across) * (apart * cosine);
}

class Looker {
  public:
    Looker(double radius, std::vector<Placed> on, std::vector<Placed> others)
        : radius_(radius), on_(std::move(on)), others_(std::move(others)) {}

    // Whether a ball on is free on both sides, if this ball were not there.
    bool sees_both_sides(Vec2 from, std::optional<int> without) const {
        for (const Placed& target : on_) {
            const double reach = radius_ + target.radius;
            if (length(target.place - from) <= reach) return true;
            if (is_clear(from, grazing_end(from, target.place, reach, 1.0), without) &&
                is_clear(from, grazing_end(from, target.place, reach, -1.0), without))
                return true;
        }
        return false;
    }
    bool sees_full(Vec2 from) const {
        for (const Placed& target : on_)
            if (is_clear(from, target.place, std::nullopt)) return true;
        return false;
    }

  private:
    bool is_clear(Vec2 from, Vec2 to, std::optional<int> without) const {
        for (const Placed& other : others_)
            if (other.ball != without &&
                first_impact(Disc{from, radius_}, to - from, Disc{other.place, other.radius}, 1.0))
                return false;
        return true;
    }

    double radius_;
    std::vector<Placed> on_;
    std::vector<Placed> others_;
};

// Places of the cue ball in the D, where it overlaps nothing.
std::vector<Vec2> places_in_d(const Scene& scene, const World& world, double radius, BallId cue) {
    constexpr int steps = 6;
    const auto [middle, reach] = *scene.pool.d;
    const Vec2 toward = rack_of(scene).toward;
    std::vector<Vec2> places;
    for (int back = 0; back <= steps; ++back)
        for (int side = -steps; side <= steps; ++side) {
            const Vec2 place = middle - toward * (reach * back / steps) +
                               perpendicular(toward) * (reach * side / steps);
            if (!is_in_hand_area(scene, CueInHand::in_d, place)) continue;
            bool is_taken = false;
            for (std::size_t i = 0; i < world.balls().size(); ++i)
                is_taken = is_taken || (world.balls().id[i] != cue &&
                                        length(world.balls().position[i] - place) <
                                            radius + world.balls().radius[i]);
            if (!is_taken) places.push_back(place);
        }
    return places;
}

}  // namespace

PoolSight sight_of(const Scene& scene, const World& world, const PoolPlay& play,
                   const PoolState& rules, std::optional<int> called) {
    const auto& cue_id = play.balls[cue_ball];
    if (!cue_id) return {.sees_one_full = true};
    const std::size_t cue = *index_of(world, *cue_id);
    std::vector<Placed> on;
    std::vector<Placed> others;
    for (int ball = 1; ball <= object_balls(scene); ++ball) {
        const auto& id = play.balls[static_cast<std::size_t>(ball)];
        if (!id) continue;
        const std::size_t index = *index_of(world, *id);
        (rules.referee->may_hit_first(rules, ball) ? on : others)
            .push_back({ball, world.balls().position[index], world.balls().radius[index]});
    }
    const double radius = world.balls().radius[cue];
    const Looker looker(radius, std::move(on), std::move(others));
    std::vector<Vec2> places{world.balls().position[cue]};
    if (rules.in_hand == CueInHand::in_d) places = places_in_d(scene, world, radius, *cue_id);
    PoolSight sight{.is_snookered = true};
    for (const Vec2 from : places) {
        if (looker.sees_both_sides(from, std::nullopt)) sight.is_snookered = false;
        if (called && looker.sees_both_sides(from, called)) sight.is_by_called = true;
        if (looker.sees_full(from)) sight.sees_one_full = true;
        if (!sight.is_snookered && sight.sees_one_full) break;
    }
    sight.is_by_called = sight.is_by_called && sight.is_snookered;
    return sight;
}

}  // namespace carom

#pragma once

#include <cstdint>

#include "geometry/vector.h"
#include "physics/event/motion/edge_impact.h"
#include "physics/event/motion/trajectory.h"
#include "physics/laws/bounce.h"
#include "physics/world/world.h"

namespace carom {

/// What all parts of the solver `event` see of a tick: the world, the field, the clock, and the
/// questions that these alone answer. EventEngine sets it; the parts read it.
template <typename Real>
struct EventScene {
    const World* world = nullptr;  ///< during a tick
    Field<Real> field;
    Vec2 period;  ///< of the torus; 0 where there is none
    Real now{};   ///< s: the time of the event that is being handled
    Real end{};   ///< s: the end of the tick

    /// Whether the two balls, or a ball and an edge, collide at all.
    bool balls_collide(std::uint32_t a, std::uint32_t b) const {
        return !world->model().filtered ||
               kinds_meet(*world, world->balls().kind[a], world->balls().kind[b]);
    }
    bool ball_collides_with(std::uint32_t ball, std::uint32_t capsule) const {
        return !world->model().filtered || kind_meets_material(*world, world->balls().kind[ball],
                                                               world->capsules().material[capsule]);
    }
    /// Whether the edge, moved by `shift`, is solid for a ball at this position: one-way edges are
    /// so on one side.
    bool is_solid(std::uint32_t capsule, const Vector<Real>& position, Vec2 shift) const {
        if (!world->model().one_way) return true;
        return is_on_solid_side(world->capsules().shape[capsule], world->capsules().side[capsule],
                                Vec2(position) - shift);
    }
    /// Whether that image of the edge supports a ball on this trajectory.
    bool is_supported_by(const Trajectory<Real>& trajectory, std::uint32_t capsule, int across,
                         int along) const {
        const auto is = [&](const SupportId& support) {
            return support.kind == SupportId::Kind::edge && support.across == across &&
                   support.along == along &&
                   support.number == number(world->capsules().id[capsule]);
        };
        return trajectory.motion != Motion::free &&
               (is(trajectory.support) || is(trajectory.second_support));
    }
    /// The edge that supports a ball, in its periodic image. Pre: it is an edge, and exists.
    Edge<Real> supporting_edge(const SupportId& support) const {
        const auto capsule = index_of(*world, CapsuleId{support.number});
        return Edge<Real>(world->capsules().shape[*capsule],
                          Vec2(image_shift(support.across, support.along)));
    }
    /// The displacement of a periodic image.
    Vector<Real> image_shift(int across, int along) const {
        return {Real(period.x) * Real(double(across)), Real(period.y) * Real(double(along))};
    }
};

}  // namespace carom

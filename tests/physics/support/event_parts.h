#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "physics/event/impact/impact_cluster.h"
#include "physics/event/impact/response.h"
#include "physics/event/motion/kinematic_bodies.h"
#include "physics/event/motion/spatial_index.h"
#include "physics/event/motion/trajectories.h"
#include "physics/event/motion/work_meter.h"
#include "physics/event/rest/cloth_phases.h"
#include "physics/event/rest/collapse_guard.h"
#include "physics/event/rest/resting_contact.h"
#include "physics/event/rest/side_friction.h"
#include "physics/event/rest/supports.h"
#include "physics/event/schedule/predictor.h"
#include "physics/event/schedule/schedule.h"
#include "physics/event/schedule/transitions.h"

namespace carom {

/// The parts of the solver `event` on a world, connected as in EventEngine, for tests of a single
/// part. All balls are in free flight from the world's time on, and in their cells.
struct EventParts {
    using Real = double;

    explicit EventParts(const World& start) : world(start) {
        scene.world = &world;
        scene.field = field_of<Real>(world.model());
        scene.period = world.model().wrap ? size(*world.model().wrap) : Vec2{};
        scene.now = world.time();
        scene.end = static_cast<double>(world.tick() + 1) / world.rate();
        const auto count = static_cast<std::uint32_t>(world.balls().size());
        balls.resize(count, may_curve(world.model()));
        for (std::uint32_t i = 0; i < count; ++i) {
            balls.set_trajectory(i, {});
            balls.plan(i).inverse_mass = world.balls().inverse_mass[i];
            balls[i].radius = world.balls().radius[i];
        }
        if (world.model().spin) trajectories.spins().assign(count, {});
        kinematic.take();
        space.rebuild();
        cluster.reset(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            const bool is_held = balls.plan(i).inverse_mass == 0.0;
            const Vector<Real> velocity =
                is_held ? balls[i].line.velocity : Vector<Real>(world.balls().velocity[i]);
            if (world.model().spin)
                trajectories.spin(i) = {scene.now, world.balls().spin[i], 0.0, false};
            trajectories.start(i, scene.now, Vector<Real>(world.balls().position[i]), velocity);
            if (is_held) trajectories.hold(i);
            if (world.model().cloth) balls.curve(i).center = Vector<Real>(world.balls().roll[i]);
        }
    }
    EventParts(const EventParts&) = delete;
    EventParts& operator=(const EventParts&) = delete;

    World world;
    EventScene<Real> scene;
    WorkMeter<Real> work;
    BallTable<Real> balls;
    SpatialIndex<Real> space{scene, balls};
    Trajectories<Real> trajectories{scene, balls, space};
    KinematicBodies<Real> kinematic{scene, balls, trajectories};
    Supports<Real> supports{scene, balls, space, trajectories};
    SideFriction<Real> friction{scene, balls, supports, trajectories, work.search()};
    ClothPhases<Real> cloth{scene, balls, trajectories, supports};
    RestingContact<Real> rest{scene, balls, space, trajectories, supports, friction, cloth};
    CollapseGuard<Real> guard{scene, balls, trajectories};
    Transitions<Real> transitions{scene, balls, space, trajectories, friction,
                                  rest,  cloth, guard, work.search()};
    Predictor<Real> predictor{scene, balls, space, kinematic, transitions, work.search()};
    Schedule<Real> schedule{balls, space.cells()};
    ImpactCluster<Real> cluster{scene, balls, space, trajectories, kinematic};
    std::vector<std::uint32_t> scatter_counts;
    Response<Real> response{{scene, balls, space, trajectories, kinematic, cluster, rest, friction,
                             guard, work, scatter_counts}};
};

}  // namespace carom

#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "physics/event/impact/impact_cluster.h"
#include "physics/event/impact/response.h"
#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/kinematic_bodies.h"
#include "physics/event/motion/scene.h"
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
#include "physics/event/standstill.h"
#include "physics/event/uniform_motion.h"
#include "physics/event/world_sync.h"
#include "physics/world/contact.h"

namespace carom {

/// How a tick of the solver `event` ended.
enum class EventOutcome : std::uint8_t {
    done,
    cancelled,  ///< asked to stop: the world is as it was before the tick
};

/// The solver `event`: event-driven simulation on exact trajectories. README.md in this folder is
/// its manual; this class is the loop over its parts.
///
/// Real: double, or DoubleDouble, the reference with about 32 digits.
template <typename Real>
class EventEngine {
  public:
    EventEngine() = default;
    /// Its parts refer to one another.
    EventEngine(const EventEngine&) = delete;
    EventEngine& operator=(const EventEngine&) = delete;

    /// Advances the world by one tick, and appends its impacts to `contacts`, with bodies by index.
    /// `touched`, by ball, is set where an impact changed the ball. `keep_going`, which may be
    /// empty, is asked now and then (work_meter.h); false cancels the tick. `is_repeated`: the tick
    /// has been computed before, in another trial (TickWork::is_repeated).
    EventOutcome tick(World& world, std::vector<Contact>& contacts,
                      std::vector<std::uint8_t>& touched, const std::function<bool()>& keep_going,
                      bool is_repeated = false);

    /// A new tick: trials before it do not count.
    void forget_trials() { work_.forget_trials(); }

    const CellFrame& cells() const { return space_.cells().frame(); }
    /// The balls for which time stood still in a part of the last tick, by index.
    std::span<const std::uint32_t> standing() const { return standstill_.balls(); }
    /// How many iterations the searches for times of impact took in the last tick.
    std::uint64_t iterations() const { return work_.search().iterations; }

  private:
    void begin(World& world, const std::function<bool()>& keep_going, bool is_repeated);
    void handle(std::uint32_t ball, const BallEvent<Real>& event, const ImpactRecord& record);
    void transfer(std::uint32_t ball, std::uint32_t what);
    void impact(std::uint32_t ball, const BallEvent<Real>& event, const ImpactRecord& record);
    void predict(std::uint32_t ball);
    void predict_all();
    Real end_of_events() const;
    bool turn_back_at_stop();
    void stop_untimed();
    void charge(std::uint32_t ball, const BallEvent<Real>& event);

    EventScene<Real> scene_;
    WorkMeter<Real> work_;
    BallTable<Real> balls_;
    SpatialIndex<Real> space_{scene_, balls_};
    Trajectories<Real> trajectories_{scene_, balls_, space_};
    KinematicBodies<Real> kinematic_{scene_, balls_, trajectories_};
    Supports<Real> supports_{scene_, balls_, space_, trajectories_};
    SideFriction<Real> friction_{scene_, balls_, supports_, trajectories_, work_.search()};
    ClothPhases<Real> cloth_{scene_, balls_, trajectories_, supports_};
    RestingContact<Real> rest_{scene_, balls_, space_, trajectories_, supports_, friction_, cloth_};
    CollapseGuard<Real> guard_{scene_, balls_, trajectories_};
    Transitions<Real> transitions_{scene_, balls_, space_, trajectories_, friction_,
                                   rest_,  cloth_, guard_, work_.search()};
    Predictor<Real> predictor_{scene_, balls_, space_, kinematic_, transitions_, work_.search()};
    Schedule<Real> schedule_{balls_, space_.cells()};
    ImpactCluster<Real> cluster_{scene_, balls_, space_, trajectories_, kinematic_};
    std::vector<std::uint32_t> scatter_counts_;  ///< by ball: World::balls.edge_contacts
    Response<Real> response_{{scene_, balls_, space_, trajectories_, kinematic_, cluster_, rest_,
                              friction_, guard_, work_, scatter_counts_}};
    Standstill<Real> standstill_{scene_, balls_, trajectories_, cloth_};
    UniformMotion<Real> uniform_{scene_, balls_, space_, trajectories_, predictor_, schedule_};
    WorldSync<Real> sync_{{scene_, balls_, space_, trajectories_, kinematic_, rest_, cloth_, guard_,
                           uniform_, work_.search(), scatter_counts_}};
};

}  // namespace carom

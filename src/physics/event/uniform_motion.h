#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "physics/event/impact/response.h"
#include "physics/event/motion/ball_impact.h"
#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/scene.h"
#include "physics/event/motion/spatial_index.h"
#include "physics/event/motion/trajectories.h"
#include "physics/event/schedule/predictor.h"
#include "physics/event/schedule/schedule.h"

namespace carom {

/// Handles the events of a gas: a scene in which every ball moves uniformly and collides with every
/// other. Events and bits are those that the general parts would give; only the cost is lower.
///
///   cell transfer, void prediction      Predictor, compiled for MotionTerms::uniform: without
///                                       tests for gravity, filters, tori and rest
///   impact of two balls that touch      `collide`: without a cluster, supports or a search for
///   nothing else, as nearly all do      what else approaches
///   anything else                       left to the general parts
///
/// Impacts have code of their own because it saves whole steps of the general code, not only tests:
/// one walk over the neighbours finds both whether anything else touches, and which neighbours the
/// ball approaches at its new velocity.
template <typename Real>
class UniformMotion {
  public:
    UniformMotion(const EventScene<Real>& scene, BallTable<Real>& balls, SpatialIndex<Real>& space,
                  Trajectories<Real>& trajectories, Predictor<Real>& predictor,
                  Schedule<Real>& schedule)
        : scene_(scene),
          balls_(balls),
          space_(space),
          trajectories_(trajectories),
          predictor_(predictor),
          schedule_(schedule) {}

    /// Whether the scene is such a gas.
    bool applies(const KinematicBodies<Real>& kinematic) const;

    /// Handles the event and schedules the balls that it changed. False: nothing has changed, and
    /// the general parts must handle it. Pre: the scene is one of this kind.
    bool handle(std::uint32_t ball, const BallEvent<Real>& event, const ImpactRecord& record);

  private:
    /// The two balls of an impact, the lower one first.
    struct Pair {
        std::array<std::uint32_t, 2> ball;
        std::array<ImpactBody<Real>, 2> motion;
        std::array<Vector<Real>, 2> position;
        std::array<std::uint32_t, 2> collisions;  ///< recent ones, after this
        Vector<Real> offset;
    };

    bool find_near(std::uint32_t ball, std::uint32_t partner, const Vector<Real>& position,
                   const Vector<Real>& velocity, NearBalls<Real>& near) const;
    bool is_off_edges(std::uint32_t ball, const Vector<Real>& position) const;
    bool collide(std::uint32_t ball, const BallEvent<Real>& event, const ImpactRecord& record);
    bool pass_impulse(Pair& pair, const ImpactRecord& record);

    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    SpatialIndex<Real>& space_;
    Trajectories<Real>& trajectories_;
    Predictor<Real>& predictor_;
    Schedule<Real>& schedule_;
    std::array<NearBalls<Real>, 2> near_;
};

}  // namespace carom

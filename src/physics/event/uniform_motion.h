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

/// The events of a scene in which every ball moves uniformly and collides with every other: a gas.
/// The same events and the same bits as the general parts give, without their tests for gravity,
/// friction, tori and rest.
///
/// It handles cell transfers, void predictions, and impacts of two balls that touch nothing else,
/// which nearly all do. Anything else it leaves to the general parts.
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

    /// Whether the scene is one of this kind.
    bool applies(const KinematicBodies<Real>& kinematic) const;

    /// Handles the event and schedules the balls that it changed. False: nothing has changed, and
    /// the general parts must handle it. Pre: the scene is one of this kind.
    bool handle(std::uint32_t ball, const BallEvent<Real>& event, const ImpactRecord& record);

  private:
    /// The ball that a ball meets first. Passed by value, in registers: a value that was written to
    /// memory in parts and is read as a whole stalls the processor.
    struct FirstCollision {
        Real time{std::numeric_limits<double>::infinity()};
        std::uint32_t other = BallRecord<Real>::none;
        std::uint32_t version = 0;
    };
    /// The balls near another, and which of them it approaches so as to meet.
    struct Near {
        static constexpr std::size_t most = 64;
        std::array<std::uint32_t, most> other;
        std::array<Vector<Real>, most> offset;  ///< from its centre, now
        std::array<StraightApproach<Real>, most> approach;
        std::array<std::uint32_t, most> approached;  ///< indices
        std::size_t approached_count = 0;
    };

    /// The two balls of an impact, the lower one first.
    struct Pair {
        std::array<std::uint32_t, 2> ball;
        std::array<ImpactBody<Real>, 2> motion;
        std::array<Vector<Real>, 2> position;
        std::array<std::uint32_t, 2> collisions;  ///< recent ones, after this
        Vector<Real> offset;
    };

    void predict(std::uint32_t ball);
    void transfer(std::uint32_t ball, std::uint32_t side);
    FirstCollision earlier(std::uint32_t ball, std::uint32_t other,
                           const StraightApproach<Real>& approach, const Real& begin,
                           const Vector<Real>& offset, FirstCollision best) const;
    FirstCollision earlier(std::uint32_t ball, std::uint32_t other, FirstCollision best) const;
    void choose_next(std::uint32_t ball, FirstCollision first);
    bool find_near(std::uint32_t ball, std::uint32_t partner, const Vector<Real>& position,
                   const Vector<Real>& velocity, Near& near) const;
    bool is_off_edges(std::uint32_t ball, const Vector<Real>& position) const;
    bool collide(std::uint32_t ball, const BallEvent<Real>& event, const ImpactRecord& record);
    bool pass_impulse(Pair& pair, const ImpactRecord& record);

    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    SpatialIndex<Real>& space_;
    Trajectories<Real>& trajectories_;
    Predictor<Real>& predictor_;
    Schedule<Real>& schedule_;
    std::array<Near, 2> near_;
};

}  // namespace carom

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/event/impact/impact_cluster.h"
#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/kinematic_bodies.h"
#include "physics/event/motion/scene.h"
#include "physics/event/motion/spatial_index.h"
#include "physics/event/schedule/cell_transfers.h"
#include "physics/event/schedule/foreseen_collision.h"
#include "physics/event/schedule/transitions.h"

namespace carom {

/// Predicts a ball's next event, the first of: an impact with a ball, an edge or a kinematic edge,
/// a transition, a cell transfer. Writes it into BallPlan; the caller updates the Schedule.
///
/// Two kinds of knowledge about collisions with balls:
///
///   foreseen   Balls in free flight without drag see each other move uniformly. The first ball
///              that such a ball will meet is then known however far ahead (BallPlan::collision),
///              and stays known from cell to cell: a transfer only tests the new neighbours.
///   searched   Other pairs are searched no further than the ball's next event, and again after
///              it. BallPlan::collision is unknown.
///
/// A prediction with a partner whose trajectory has changed since is void: the version differs. The
/// loop notices when the event's turn comes, and predicts again. A ball that changes tests all its
/// neighbours itself, so no impact is missed.
///
/// Predictions depend on the trajectories alone, not on which of the two balls is predicted: pairs
/// are computed as seen from the lower ball. There are two exceptions. An impact with a one-way
/// edge depends also on when it is predicted: a contact in the trajectory's past counts as one now,
/// if the ball is now on the solid side. An impact with a kinematic edge depends also on how far
/// ahead the search looks (edge_impact.h).
///
/// Functions with `terms` are compiled for scenes of uniform motion too, without the tests that
/// such a scene does not need (foreseen_collision.h).
template <typename Real>
class Predictor {
  public:
    Predictor(const EventScene<Real>& scene, BallTable<Real>& balls, SpatialIndex<Real>& space,
              const KinematicBodies<Real>& kinematic, Transitions<Real>& transitions,
              ToiSearch<Real>& search)
        : scene_(scene),
          balls_(balls),
          space_(space),
          kinematic_(kinematic),
          transfers_(scene, balls, space.cells()),
          foreseen_(scene, balls, space),
          transitions_(transitions),
          search_(search) {}

    /// Predicts everything anew: the trajectory has changed, or a prediction was void.
    template <MotionTerms terms = MotionTerms::any>
    void predict(std::uint32_t ball);
    /// `predict` right after an impact, from the neighbours that the impact found around the ball.
    void predict_among(std::uint32_t ball, std::span<const Neighbour<Real>> neighbours);
    /// `predict_among` in uniform motion. `partner`: one more ball to test, or `none`.
    void predict_among_near(std::uint32_t ball, const NearBalls<Real>& near, std::uint32_t partner);
    /// The ball goes to the adjacent cell on that side, or just predicts again: see cell_transfer.
    template <MotionTerms terms = MotionTerms::any>
    void transfer(std::uint32_t ball, std::uint32_t side);

  private:
    void choose_next(std::uint32_t ball);
    void choose_next_of_still(std::uint32_t ball);
    void choose_next_of_uniform(std::uint32_t ball, FirstCollision<Real> first);
    void predict_edges(std::uint32_t ball, BallEvent<Real>& best);
    void predict_kinematic_edges(std::uint32_t ball, BallEvent<Real>& best);
    void predict_pair(std::uint32_t ball, std::uint32_t other, int across, int along,
                      BallEvent<Real>& best);
    bool may_meet(std::uint32_t ball, std::uint32_t other) const;
    void resume_searches(std::uint32_t ball, BallEvent<Real>& best) const;

    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    SpatialIndex<Real>& space_;
    const KinematicBodies<Real>& kinematic_;
    CellTransfers<Real> transfers_;
    ForeseenCollisions<Real> foreseen_;
    Transitions<Real>& transitions_;
    ToiSearch<Real>& search_;
    std::vector<std::uint32_t> selected_;  ///< scratch: neighbours by index
};

}  // namespace carom

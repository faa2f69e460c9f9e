#pragma once

#include <cmath>
#include <cstdint>

#include "physics/broad_phase/capsule_cells.h"
#include "physics/event/motion/ball_cells.h"
#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/scene.h"
#include "physics/event/motion/tolerances.h"
#include "physics/event/motion/trajectory.h"

namespace carom {

/// Which balls and which fixed edges may be near a ball: two grids of the same frame, one of balls
/// (BallCells) and one of edges (CapsuleCells). Kinematic edges are few, and no grid holds them.
///
/// The answer is a superset of what the ball can reach within its cell, in no defined order. A
/// caller whose result would depend on that order must sort.
template <typename Real>
class SpatialIndex {
  public:
    /// Both must outlive this.
    SpatialIndex(const EventScene<Real>& scene, BallTable<Real>& balls)
        : scene_(scene), balls_(balls) {}

    /// Lays out both grids anew for the scene's world. Cost: O(balls log balls + cells of edges).
    void rebuild() {
        cells_.reset(*scene_.world, balls_);
        if (scene_.world->model().ball_edge)
            edges_.update(*scene_.world, cells_.frame(), edge_reach * cells_.largest());
    }

    BallCells<Real>& cells() { return cells_; }
    const BallCells<Real>& cells() const { return cells_; }
    const CapsuleCells& edges() const { return edges_; }

    /// Whether no edge is near the ball's cell.
    bool is_off_edges(std::uint32_t ball) const {
        return !scene_.world->model().ball_edge || edges_.is_empty(balls_.plan(ball).place.cell);
    }

    /// Calls visit(other, across, along) for every other ball that may be near, with the periodic
    /// image that is near.
    template <typename Visit>
    void for_each_ball_near(std::uint32_t ball, Visit&& visit) const;

    /// Calls visit(capsule, shift, across, along) for every fixed edge that may be near and with
    /// which the ball collides; `shift` is the displacement of the image.
    template <typename Visit>
    void for_each_edge_near(std::uint32_t ball, Visit&& visit) const {
        const LinearPart<Real>& line = balls_[ball].line;
        for_each_edge_around(ball, {balls_.plan(ball).place.cell, line.across, line.along}, visit);
    }
    /// Calls visit(capsule, shift, across, along) as if the ball stood in the cell `spot`.
    template <typename Visit>
    void for_each_edge_around(std::uint32_t ball, CellSpot spot, Visit&& visit) const;

  private:
    const EventScene<Real>& scene_;
    BallTable<Real>& balls_;
    BallCells<Real> cells_;
    CapsuleCells edges_;
};

template <typename Real>
template <typename Visit>
void SpatialIndex<Real>::for_each_ball_near(std::uint32_t ball, Visit&& visit) const {
    if (!scene_.world->model().ball_ball) return;
    const bool is_oversized = cells_.is_oversized(balls_, ball);
    if (!is_oversized) cells_.for_each_near(balls_, ball, visit);
    if (cells_.oversized().empty()) return;
    // An oversized ball reaches beyond cells. On a torus: the nearest image and those around it.
    const auto with_images = [&](std::uint32_t other) {
        if (other == ball) return;
        if (!scene_.world->model().wrap) return visit(other, 0, 0);
        const Vec2 offset(state_at(balls_.trajectory(ball), scene_.field, scene_.now).position -
                          state_at(balls_.trajectory(other), scene_.field, scene_.now).position);
        const int across = static_cast<int>(std::floor(offset.x / scene_.period.x + 0.5));
        const int along = static_cast<int>(std::floor(offset.y / scene_.period.y + 0.5));
        for (int i = across - oversized_images; i <= across + oversized_images; ++i)
            for (int j = along - oversized_images; j <= along + oversized_images; ++j)
                visit(other, i, j);
    };
    if (is_oversized)
        for (std::uint32_t other = 0; other < balls_.size(); ++other)
            with_images(other);
    else
        for (const std::uint32_t other : cells_.oversized())
            with_images(other);
}

template <typename Real>
template <typename Visit>
void SpatialIndex<Real>::for_each_edge_around(std::uint32_t ball, CellSpot spot,
                                              Visit&& visit) const {
    const World& world = *scene_.world;
    if (!world.model().ball_edge) return;
    const auto at_image = [&](std::uint32_t capsule, int across, int along) {
        if (!scene_.ball_collides_with(ball, capsule)) return;
        visit(capsule, Vec2{scene_.period.x * across, scene_.period.y * along}, across, along);
    };
    if (!cells_.is_oversized(balls_, ball)) {
        if (edges_.is_empty(spot.cell)) return;
        for (const CapsuleEntry entry : edges_.in_cell(spot.cell))
            at_image(entry.index, entry.across + spot.across, entry.along + spot.along);
        return;
    }
    int across = 0;
    int along = 0;
    if (world.model().wrap) {
        const Vec2 offset(state_at(balls_.trajectory(ball), scene_.field, scene_.now).position -
                          Vector<Real>(world.model().wrap->low));
        across = static_cast<int>(std::floor(offset.x / scene_.period.x));
        along = static_cast<int>(std::floor(offset.y / scene_.period.y));
    }
    const int reach = world.model().wrap ? 1 : 0;
    for (std::uint32_t capsule = 0; capsule < world.capsules().size(); ++capsule) {
        if (is_held(world, world.capsules().id[capsule])) continue;
        for (int i = across - reach; i <= across + reach; ++i)
            for (int j = along - reach; j <= along + reach; ++j)
                at_image(capsule, i, j);
    }
}

}  // namespace carom

#pragma once

#include <limits>
#include <span>
#include <vector>

#include "physics/tick/kinematic.h"

namespace carom {

/// The held and driven edges of the solver `swept`, and those of seesaws, within a substep. Each
/// moves straight towards its target; one that meets a frozen ball stops for the rest of the
/// substep. Held balls are not here: SweptPaths has them, with inverse mass 0.
class SweptKinematics {
  public:
    /// Begins a substep: each edge gets the velocity that covers the rest of its displacement in
    /// 1 / `per_second` seconds.
    void begin(const World& world, double per_second) {
        list_kinematic_edges(world, edges_);
        for (HeldEdge& edge : edges_)
            aim(edge, world, per_second);
    }
    /// Moves the edges in the world to where they are `duration` s into the substep.
    void finish(World& world, double duration) const;

    /// The seesaw with this edge is now as `hit`. Predictions of impacts become void. Pre: it is
    /// one.
    void turn(std::uint32_t capsule, const Seesaw& hit, double now) {
        find_edge(std::span<HeldEdge>(edges_), capsule)->turn(hit, now);
    }
    /// When the first seesaw comes to its stop, s into the substep; infinite if none does.
    double first_stop() const { return edges_.empty() ? never : carom::first_stop(edges_); }
    void bounce_at_stops(double now) { carom::bounce_at_stops(edges_, now); }

    bool is_empty() const { return edges_.empty(); }
    std::span<const HeldEdge> edges() const { return edges_; }
    /// Null for an edge that is fixed.
    const HeldEdge* find(std::uint32_t capsule) const { return find_edge(edges(), capsule); }
    /// Where any edge is, kinematic or fixed.
    Capsule shape_at(const World& world, std::uint32_t capsule, double now) const {
        const HeldEdge* const edge = find(capsule);
        return edge ? carom::shape_at(*edge, world, now) : world.capsules().shape[capsule];
    }
    /// Stops the edge. Predictions of impacts with it become void. Pre: it is kinematic.
    void stop(std::uint32_t capsule, double now) {
        find_edge(std::span<HeldEdge>(edges_), capsule)->stop(now);
    }

  private:
    static constexpr double never = std::numeric_limits<double>::infinity();

    std::vector<HeldEdge> edges_;
};

}  // namespace carom

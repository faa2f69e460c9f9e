#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/vec2.h"
#include "level/scene/scene.h"
#include "physics/solver.h"

/// A flipper and the inlane that leads to it, on any table: what is there, and one ball to try it.
///
/// Metres and seconds. Angles are in degrees from straight up, positive towards the far side (to
/// the right for a flipper that points to the right), so that mirrored flippers give equal numbers.
namespace carom::test {

/// The guide of an inlane: a chain of edges from behind the pivot upwards.
struct Inlane {
    std::size_t flipper = 0;         ///< index into World::flippers
    std::vector<std::size_t> guide;  ///< indices of its edges, from the flipper upwards
    std::vector<Vec2> starts;        ///< centres of a ball that fits in the lane, from low to high
};

/// The inlanes of all flippers that have one: a flipper behind whose pivot a chain of edges of at
/// least four ball radii begins. The starts lie everywhere between it and the wall above it.
std::vector<Inlane> inlanes_of(const Scene& scene);

/// One ball, one flipper; the other flippers rest, and no rules apply.
class FlipperBench {
  public:
    FlipperBench(const Scene& scene, const Inlane& lane, Vec2 at, Vec2 velocity = {});
    /// From the same state, with a solver of its own, to try what a press would do.
    FlipperBench fork() const;
    /// Puts the flipper at rest at its upper or lower stop, with its button pressed or released.
    void settle_flipper(bool is_up);
    void press(bool is_down);
    void press_other(bool is_down);
    void run(double seconds);
    void tick();

    Vec2 at() const { return world_.balls().position[0]; }
    Vec2 velocity() const { return world_.balls().velocity[0]; }
    double time() const { return time_; }
    const World& world() const { return world_; }
    void place(Vec2 at, Vec2 velocity = {});

    /// How far along the flipper the ball is: 0 at the pivot, 1 at the end.
    double along() const;
    /// Gap between ball and flipper.
    double gap() const;
    /// Gap between ball and the nearest of the flipper and the guide.
    double gap_to_lane() const;
    bool is_above_flipper() const;
    /// Degrees from straight up to the far side.
    double direction() const;
    /// The middle of the flipper as it stands now, this far along it.
    Vec2 flipper_at(double along) const;
    /// Where a ball touches the flipper at rest, this far along it.
    Vec2 rest_at(double along) const;
    /// Whether it touches the upper face of the other flipper of the pair: the one that is nearest.
    bool is_on_other() const;

  private:
    FlipperBench(const Inlane& lane, World world, double time);
    const Flipper& flipper() const { return world_.flippers()[lane_->flipper]; }
    Capsule shape_of(std::size_t flipper) const;
    std::size_t other() const;

    const Inlane* lane_;
    World world_;
    Solver solver_;
    double time_ = 0.0;
};

}  // namespace carom::test

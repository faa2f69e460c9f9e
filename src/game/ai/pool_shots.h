#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/shapes.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// Candidate shots by geometry alone: lines on which a ball can be pocketed, or at least hit.
namespace carom {

/// The cloth between the noses of the cushions; none where the level has no pockets. For a
/// rectangular table with upright sides.
std::optional<Box> cloth_box(const Scene& scene);

/// Where to aim a ball to pocket it: the centre of the pocket's mouth.
Vec2 mouth(const Scene& scene, const Box& cloth, int pocket);

/// A line on which the struck ball sends another into a pocket.
struct PotLine {
    enum class Way : std::uint8_t {
        direct,
        bank,  ///< the object ball hits a cushion first
        kick   ///< the cue ball hits a cushion first
    };
    Way way = Way::direct;
    BallId object{};
    int pocket = 0;
    Vec2 direction;           ///< unit: the direction of the strike
    Vec2 ghost;               ///< where the struck ball hits the object
    double cut_cosine = 1.0;  ///< of the angle between the paths of the two balls
    double distance = 0.0;    ///< of both paths together, length
    /// The admissible error of the aim, radians: the larger, the easier. Only for comparison.
    double tolerance = 0.0;
};

/// All lines that no other ball obstructs, with the struck ball at `from`; the easiest first, ties
/// by object and pocket. Cost: objects times pockets times balls.
std::vector<PotLine> pot_lines(const Scene& scene, const World& world, const Box& cloth,
                               BallId struck, Vec2 from, std::span<const BallId> objects);

/// Directions in which the struck ball hits the object, full and at some thicknesses: directly, or
/// off one cushion where no direct line is free.
std::vector<Vec2> hit_directions(const Scene& scene, const World& world, const Box& cloth,
                                 BallId struck, Vec2 from, BallId object);

/// Whether a ball of `radius` can go straight from one place to the other without hitting a ball
/// other than `one` and `other`.
bool is_clear(const World& world, Vec2 from, Vec2 to, double radius, BallId one, BallId other);

}  // namespace carom

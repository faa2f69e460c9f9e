#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/shapes.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// Ways to pocket a ball, or to meet one, by geometry alone: what a player sees before trying.
namespace carom {

/// The cloth between the noses of the cushions; none where the level has no pockets. For a table
/// whose sides are straight and upright.
std::optional<Box> cloth_box(const Scene& scene);

/// Where to aim a ball for it to fall: the middle of the pocket's mouth.
Vec2 mouth(const Scene& scene, const Box& cloth, int pocket);

/// A line on which the struck ball sends another into a pocket.
struct PotLine {
    enum class Way : std::uint8_t {
        direct,
        bank,  ///< the object ball by way of a cushion
        kick   ///< the struck ball by way of a cushion
    };
    Way way = Way::direct;
    BallId object{};
    int pocket = 0;
    Vec2 direction;           ///< unit: which way to strike
    Vec2 ghost;               ///< where the struck ball meets the object
    double cut_cosine = 1.0;  ///< of the angle between its way and the object's
    double distance = 0.0;    ///< of both ways together, length
    /// Share of an angle that may be off, relative to others: the larger, the easier. Radians.
    double tolerance = 0.0;
};

/// All that no other ball hinders, from where the struck ball would be at `from`; the easiest
/// first, ties by object and pocket.
std::vector<PotLine> pot_lines(const Scene& scene, const World& world, const Box& cloth,
                               BallId struck, Vec2 from, std::span<const BallId> objects);

/// Directions in which the struck ball meets the object, full and at some thicknesses, directly or
/// by way of one cushion where nothing is direct.
std::vector<Vec2> hit_directions(const Scene& scene, const World& world, const Box& cloth,
                                 BallId struck, Vec2 from, BallId object);

/// Whether a ball of `radius` can go straight from one place to another without meeting a ball
/// other than these two.
bool is_clear(const World& world, Vec2 from, Vec2 to, double radius, BallId one, BallId other);

}  // namespace carom

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/world/world.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/palette.h"
#include "terminal/canvas/raster.h"

/// The trails of balls: each picture fades the existing trails and adds new pieces.
namespace carom {

struct Trails {
    struct Place {
        BallId id{};
        Vec2 position;
    };
    Camera camera;                     ///< for which the levels were drawn
    std::uint64_t tick = 0;            ///< the world's tick when they were drawn
    int across = 0;                    ///< samples across camera.area
    int down = 0;                      ///< samples down
    std::vector<std::uint8_t> levels;  ///< row by row; 255 is fresh, 0 is none
    std::vector<Ink> inks;             ///< of each sample
    std::vector<Place> places;         ///< last position of every ball, ascending by id
};

/// Fades the trails and adds each ball's path since the last call; `inks` has the ink of each ball
/// by index. Nothing fades while the world is paused. A change of camera or renderer clears the
/// trails.
void add_to_trails(Trails& trails, const Camera& camera, const Raster& raster, const World& world,
                   std::span<const Ink> inks);

/// Pre: the raster has the renderer and size of the last call of add_to_trails.
void paint_trails(Raster& raster, const Trails& trails, const Look& look);

}  // namespace carom

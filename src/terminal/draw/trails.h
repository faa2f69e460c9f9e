#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/world/world.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/palette.h"
#include "terminal/canvas/raster.h"

/// The trails of balls: each picture fades the trails of the one before and adds to them.
namespace carom {

struct Trails {
    struct Place {
        BallId id{};
        Vec2 position;
    };
    Camera camera;                     ///< that the levels were drawn for
    std::uint64_t tick = 0;            ///< of the world, when they were
    int across = 0;                    ///< samples across camera.area
    int down = 0;                      ///< samples down
    std::vector<std::uint8_t> levels;  ///< row by row; 255 is fresh, 0 is none
    std::vector<Ink> inks;             ///< of each sample
    std::vector<Place> places;         ///< of every ball, ascending by id
};

/// Fades the trails and adds the path of each ball since the last call. Nothing fades while the
/// world stands still. With another camera or another renderer, trails start anew.
///
/// `inks` has the ink of each ball by index.
void add_to_trails(Trails& trails, const Camera& camera, const Raster& raster, const World& world,
                   std::span<const Ink> inks);

/// Pre: the raster has the renderer and size of the last call of add_to_trails.
void paint_trails(Raster& raster, const Trails& trails);

}  // namespace carom

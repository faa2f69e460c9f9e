#pragma once

#include <cstdint>
#include <vector>

#include "physics/world.h"
#include "terminal/camera.h"
#include "terminal/canvas.h"

/// What balls leave behind: each new picture fades what the last one drew.
namespace carom {

struct Trails {
    /// One point of a trail: how fresh it is, and whose.
    struct Place {
        BallId id{};
        Vec2 position;
    };
    Camera camera;                     ///< that the levels were drawn for
    std::uint64_t tick = 0;            ///< of the world, when they were
    int columns = 0;                   ///< samples across camera.area
    int rows = 0;                      ///< samples down
    std::vector<std::uint8_t> levels;  ///< row by row; 255 is fresh, 0 is none
    std::vector<Color> colors;         ///< of each sample
    std::vector<Place> places;         ///< of every ball, ascending by id
};

}  // namespace carom

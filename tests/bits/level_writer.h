#pragma once

#include <string>

#include "bits/scene_random.h"

/// Writes random levels: small scenes that together use every term of the model, every solver with
/// its settings, ready-made parts, and radii, masses and speeds over orders of magnitude.
namespace carom::bits {

/// A level, and the data that a command writer needs. Lengths are the level's.
struct Level {
    std::string text;
    int ticks = 0;
    double rate = 120.0;
    double width = 0.0;  ///< the scene lies between 0,0 and width,height
    double height = 0.0;
    double radius = 0.0;  ///< of a typical ball
    double time = 0.0;    ///< of the whole run
    int balls = 0;        ///< at the start; some of them may have been left out
    int edges = 0;
    bool has_cloth = false;
    bool has_buttons = false;
};

/// Balls of exceptional size have radii down to this power of ten of the usual one.
inline constexpr double usual_least_decade = -3.0;
inline constexpr double grain_decade = -17.0;

/// Most of these levels load. The caller must handle those that do not: they cost little.
Level write_level(Random& random, double least_decade = usual_least_decade);

}  // namespace carom::bits

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/vec2.h"
#include "level/scene/games.h"

/// Where the balls of a rack lie: in the first frame as the level says, and in later ones as a
/// person racks them again.
namespace carom {

/// How a rack is laid out, as a level states it.
struct RackPlan {
    const RackLayout* layout = nullptr;
    Vec2 toward{1.0, 0.0};                ///< unit vector from the apex towards the back row
    double gap = 0.0;                     ///< between neighbours, length
    std::optional<std::uint64_t> seed{};  ///< none: no ball is shifted, and all frames are alike
};

/// The place of a ball: apex + grid * (diameter + gap) + shift. The sums are left to the caller,
/// who knows the diameter.
struct RackedBall {
    Vec2 grid;   ///< in distances between neighbours
    Vec2 shift;  ///< length
    double gap = 0.0;
};

/// The balls by number, ball n at n - 1, in frame number `frame`; 0 is the first. The seed shuffles
/// the numbers, except where the rules place them, and shifts each ball by up to a quarter of the
/// gap. A later frame has draws of its own: the gaps are half to twice as wide, and the rack is
/// turned about its apex by up to half a degree. With gap=0 every rack is perfect.
std::vector<RackedBall> racked(const RackPlan& plan, std::uint32_t frame);

}  // namespace carom

#pragma once

#include "carom/pool/mouse_stroke.h"
#include "carom/pool/pool_aim.h"
#include "game/pool/shot_setup.h"
#include "terminal/canvas/camera.h"

namespace carom {

/// The mouse pulls the cue. Only what it goes back along the shot counts, so the aim stays.
struct CuePull {
    Vec2 from;           ///< where the mouse took the cue
    Vec2 way;            ///< of the shot, a unit vector
    double room = 0.0;   ///< how far the mouse can go back before the window ends, length
    double least = 0.0;  ///< a shorter pull does not shoot, length
    ShotSetup before;    ///< the aim, if no shot comes of it
};

/// The mouse takes the cue at `from`. Pre: aim.may_aim().
CuePull grip(const Session& session, const PoolAim& aim, const Camera& camera, Vec2 from);

/// How far the cue is pulled while the mouse is at `at`: between 0 and its room, length.
double pulled(const CuePull& pull, Vec2 at);

/// The stroke of a match that begins with this pull at `time`, s of the player's time.
MouseStroke push_of(const CuePull& pull, const Camera& camera, double time);

}  // namespace carom

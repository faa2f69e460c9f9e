#pragma once

#include "physics/world/seesaw.h"

/// Numbers as a saved level must write them, so that the loader turns them into exactly what they
/// were.
namespace carom {

/// The mass with this inverse. Exact, since the inverse came from some mass: 1/(1/(1/m)) has the
/// bits of 1/m.
double mass_of(double inverse_mass);

/// Of the bar that a seesaw is in a level.
double mass_of_seesaw(const Seesaw& seesaw);

/// In degrees; the loader converts to radians.
double degrees_of(double radians);

/// In rad/s; the loader converts through degrees.
double spin_of(double spin);

}  // namespace carom

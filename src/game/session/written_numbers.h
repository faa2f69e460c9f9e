#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "physics/world/seesaw.h"
#include "physics/world/world.h"

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

/// Writes quantities with their units, or bare in a level without units.
class UnitWriter {
  public:
    explicit UnitWriter(bool has_units) : has_units_(has_units) {}

    std::string text(double value, std::string_view unit) const;
    std::string text(Vec2 value, std::string_view unit) const;
    /// Of a rate of turning in rad/s.
    std::string spin_text(double spin) const;

  private:
    bool has_units_;
};

/// The keys of a ball's statement that not every scene has, where they differ from their defaults:
/// " e=0.5 w=2". Every saved ball has them from here.
std::string written_properties(const World& world, std::size_t ball, const UnitWriter& units);

}  // namespace carom

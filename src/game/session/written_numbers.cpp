#include "game/session/written_numbers.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "geometry/elementary.h"

namespace carom {
namespace {

/// The number that the loader, modelled by `read`, turns into exactly `wanted`. Searches within a
/// few units in the last place of the guess.
template <typename Read>
double unread(double guess, double wanted, Read read) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double below = guess;
    double above = guess;
    for (int i = 0; i < 8; ++i) {
        if (read(below) == wanted) return below;
        if (read(above) == wanted) return above;
        below = std::nextafter(below, -infinity);
        above = std::nextafter(above, infinity);
    }
    return guess;
}

}  // namespace

double mass_of(double inverse_mass) {
    return 1.0 / inverse_mass;
}

double mass_of_seesaw(const Seesaw& seesaw) {
    const double of_one = bar_inertia(seesaw.home, seesaw.pivot);
    return unread(seesaw.inertia / of_one, seesaw.inertia, [&](double x) { return x * of_one; });
}

double degrees_of(double radians) {
    return unread(radians * 180.0 / pi, radians, [](double x) { return x * pi / 180.0; });
}

double spin_of(double spin) {
    constexpr double degrees = 180.0 / pi;
    return unread(spin, spin, [](double x) { return x * degrees / degrees; });
}

std::string UnitWriter::text(double value, std::string_view unit) const {
    return fmt::format("{}{}", value, has_units_ ? unit : "");
}

std::string UnitWriter::text(Vec2 value, std::string_view unit) const {
    return text(value.x, unit) + "," + text(value.y, unit);
}

std::string UnitWriter::spin_text(double spin) const {
    return text(has_units_ ? spin_of(spin) : spin, "rad/s");
}

std::string written_properties(const World& world, std::size_t ball, const UnitWriter& units) {
    const Balls& balls = world.balls();
    const Kind& kind = world.kinds()[balls.kind[ball]];
    std::string keys;
    if (!balls.restitution.empty() && balls.restitution[ball] != kind.restitution)
        keys += fmt::format(" e={}", balls.restitution[ball]);
    if (!balls.spin.empty() && balls.spin[ball] != 0.0)
        keys += " w=" + units.spin_text(balls.spin[ball]);
    if (!balls.roll.empty() && !(balls.roll[ball] == balls.velocity[ball]))
        keys += " roll=" + units.text(balls.roll[ball], "m/s");
    return keys;
}

}  // namespace carom

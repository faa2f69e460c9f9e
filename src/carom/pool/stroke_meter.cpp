#include "carom/pool/stroke_meter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

// s from one end to the other, for the softest and the hardest shot.
constexpr double slowest_swing = 1.1;
constexpr double fastest_swing = 0.5;
constexpr double most_swings = 8.0;
constexpr int half_width = 12;  // cells

}  // namespace

StrokeMeter::StrokeMeter(double speed, double most)
    : speed_(speed),
      swing_(slowest_swing + (fastest_swing - slowest_swing) * std::clamp(speed / most, 0.0, 1.0)) {
}

double StrokeMeter::mark(double seconds) const {
    const double swings = std::fmod((gone_ + seconds) / swing_, 2.0);
    return swings < 1.0 ? 1.0 - 2.0 * swings : 2.0 * swings - 3.0;
}

bool StrokeMeter::is_over() const {
    return gone_ > most_swings * swing_;
}

std::string StrokeMeter::text(const std::string& key, const Look& look) const {
    std::string scale;
    const int at = static_cast<int>(std::lround(-mark() * half_width));
    for (int cell = -half_width; cell <= half_width; ++cell)
        scale += cell == at  ? (look.utf8 ? "●" : "O")
                 : cell == 0 ? (look.utf8 ? "┼" : "|")
                             : (look.utf8 ? "─" : "-");
    return fmt::format("stroke {}{}{} press {} in the middle", look.utf8 ? "▕" : "[", scale,
                       look.utf8 ? "▏" : "]", key);
}

}  // namespace carom

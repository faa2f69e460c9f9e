#include "carom/pool/mouse_stroke.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"

namespace carom {
namespace {

// The speed is that of the last part of the push, s.
constexpr double speed_window = 0.08;
constexpr double least_time = 0.004;  // s, between two reports
constexpr double full_miss = 20.0;    // degrees off the line
constexpr double slowest_push = 0.1;  // of a ball, length/s
constexpr double least_way = 0.25;    // of the pull that the push must at least undo for a slope

}  // namespace

MouseStroke::MouseStroke(Vec2 at, Vec2 way, double least_pull, double grain, double time)
    : start_(at), way_(way), least_pull_(least_pull), grain_(grain), push_{{0.0, 0.0, time}} {}

double MouseStroke::pull() const {
    return std::max(0.0, -push_.back().along);
}

std::optional<Stroke> MouseStroke::move(Vec2 to, double time) {
    const Vec2 off = to - start_;
    const Point now{dot(off, way_), cross(way_, off), time};
    // Going back further starts the push anew.
    if (now.along <= push_.front().along) {
        push_ = {now};
        return std::nullopt;
    }
    push_.push_back(now);
    const Point turned = push_.front();
    if (now.along < 0.0 || -turned.along < least_pull_) return std::nullopt;
    auto from = push_.end() - 2;
    while (from != push_.begin() && now.time - from->time < speed_window)
        --from;
    const double speed = (now.along - from->along) / std::max(now.time - from->time, least_time);
    const double way = std::max(now.along - turned.along, least_way * least_pull_);
    const double aside = now.across - turned.across;
    const double certain = std::max(0.0, std::abs(aside) - grain_);
    const double degrees = std::atan2(certain, way) * 180.0 / pi;
    return Stroke{std::max(speed, slowest_push),
                  std::copysign(std::min(1.0, degrees / full_miss), aside)};
}

}  // namespace carom

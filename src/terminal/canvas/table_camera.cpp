#include "terminal/canvas/table_camera.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

// The view shows at least this share of the table: less would hide too much of what lies ahead.
constexpr double least_share = 0.6;
// A view that would be hardly closer than the whole table shows all of it.
constexpr double least_zoom = 1.3;
// A critically damped spring that settles in about half a second.
constexpr double stiffness = 7.0;   // 1/s
constexpr double foresight = 0.15;  // s; the camera aims at where the ball will be after this time
// Of the visible height; the ball moves freely this far to either side of the centre.
constexpr double calm = 0.15;
constexpr double longest_step = 0.02;
constexpr double approach_time = 0.4;  // s

}  // namespace

void TableCamera::follow(double ball, double speed, double seconds) {
    if (!(highest_ > lowest_)) return;
    const double ahead = ball + foresight * speed;
    const double slack = calm * seen_;
    const double wanted = std::clamp(height_, ahead - slack, ahead + slack);
    const double target = std::clamp(wanted, lowest_, highest_);
    for (double left = std::min(seconds, 0.5); left > 0.0; left -= longest_step) {
        const double step = std::min(left, longest_step);
        speed_ += (stiffness * stiffness * (target - height_) - 2.0 * stiffness * speed_) * step;
        height_ = std::clamp(height_ + speed_ * step, lowest_, highest_);
    }
}

void TableCamera::approach(bool near, double seconds) {
    const double way = seconds / approach_time;
    share_ = std::clamp(near ? share_ + way : share_ - way, 0.0, 1.0);
}

Camera TableCamera::look(const Box& table, double ball_radius, double ball_rows,
                         const CellArea& area, double aspect) {
    Camera camera = fit_camera(table, area, aspect);
    const double all = camera.columns_per_length;
    const double across = 2.0 * ball_radius / camera.aspect;  // rows at one column a length
    const double wide = area.columns / std::max(size(table).x, 1e-12);
    const double wanted = across > 0.0 ? ball_rows / across : all;
    const double near = std::min({wanted, all / least_share, wide});
    if (near > least_zoom * all) camera.columns_per_length = all + share_ * (near - all);
    const double seen = area.rows * camera.aspect / camera.columns_per_length;
    const double low = table.low.y + 0.5 * seen;
    const double high = table.high.y - 0.5 * seen;
    if (!(high > low)) {
        seen_ = lowest_ = highest_ = speed_ = 0.0;
        return camera;
    }
    // The first view is at the flippers.
    height_ = seen_ > 0.0 ? std::clamp(height_, low, high) : low;
    seen_ = seen;
    lowest_ = low;
    highest_ = high;
    camera.center.y = height_;
    return camera;
}

}  // namespace carom

#include "lab/measure/growth.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace carom {
namespace {

struct Line {
    double slope = 0.0;
    double misfit = 0.0;  // sum of the squared residuals
};

Line fit(const std::vector<double>& x, const std::vector<double>& y) {
    const auto count = static_cast<double>(x.size());
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / count;
        mean_y += y[i] / count;
    }
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
        yy += (y[i] - mean_y) * (y[i] - mean_y);
    }
    if (xx == 0.0) return {0.0, yy};
    return {xy / xx, yy - xy * xy / xx};
}

}  // namespace

std::optional<Growth> exponential_growth(std::span<const GrowthPoint> points, double saturation) {
    std::vector<double> time;
    std::vector<double> age_log;
    std::vector<double> difference_log;
    double birth = points.empty() ? 0.0 : points.front().time;
    for (const GrowthPoint& point : points) {
        if (!std::isfinite(point.difference) || point.difference > saturation) break;
        // A difference that vanishes again has not grown.
        if (point.difference <= 0.0) {
            time.clear();
            age_log.clear();
            difference_log.clear();
            birth = point.time;
            continue;
        }
        // At its start a difference has age 0, which has no logarithm.
        if (point.time <= birth) continue;
        time.push_back(point.time);
        age_log.push_back(std::log2(point.time - birth));
        difference_log.push_back(std::log2(point.difference));
    }
    if (time.size() < 5) return std::nullopt;
    const Line exponential = fit(time, difference_log);
    const Line power = fit(age_log, difference_log);
    const double doublings = exponential.slope * (time.back() - time.front());
    if (doublings < 3.0 || power.misfit <= exponential.misfit) return std::nullopt;
    return Growth{1.0 / exponential.slope, time.front(), time.back()};
}

}  // namespace carom

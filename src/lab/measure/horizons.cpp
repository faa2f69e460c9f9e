#include "lab/measure/horizons.h"

#include <algorithm>

namespace carom {

std::vector<std::uint64_t> spread(std::uint64_t last, std::optional<std::uint64_t> extra) {
    std::vector<std::uint64_t> points;
    for (std::uint64_t power = 1; power < last; power *= 2) {
        points.push_back(power);
        if (power > 1 && power + power / 2 < last) points.push_back(power + power / 2);
    }
    if (last > 0) points.push_back(last);
    if (extra && *extra > 0 && *extra <= last) points.push_back(*extra);
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

}  // namespace carom

#include "lab/measure/faults.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

double error_share(const Measurement& measurement, const Measured& row) {
    if (!measurement.headline) return 0.0;
    return std::max(headline_error(measurement, row), measurement.doubts[*measurement.headline]) /
           measurement.tolerance;
}

// A share that is NaN, as of a run that blew up, is the worst there is.
double share_of(double value, double promise) {
    const double share = value / promise;
    return share >= 0.0 ? share : std::numeric_limits<double>::infinity();
}

}  // namespace

std::array<Fault, 6> faults(const Measurement& measurement, const Measured& row) {
    const auto value = [&](std::string_view key) { return figure_of(row, key).value_or(0.0); };
    return {{{"error", share_of(error_share(measurement, row), 1.0)},
             {"overlap", share_of(value("max_overlap"), promised_overlap)},
             {"energy", share_of(value("energy_drift"), promised_drift)},
             {"escapes", never * value("escaped")},
             {"standstill", never * static_cast<double>(row.stood_still)},
             {"refused", never * static_cast<double>(row.refused)}}};
}

Fault worst_fault(const Measurement& measurement, const Measured& row) {
    const auto all = faults(measurement, row);
    return *std::ranges::max_element(all, {}, &Fault::share);
}

}  // namespace carom

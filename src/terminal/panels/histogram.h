#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

/// Counts beside what they are expected to be.
namespace carom {

struct Histogram {
    std::string title;
    std::vector<std::uint64_t> counts;  ///< left to right
    std::vector<double> expected;       ///< share of each; empty: nothing to compare with
    std::string against;                ///< what is expected, in words: "binomial(12,0.5)"
};

/// How counts compare with what is expected. The value of bin i is i.
struct HistogramFit {
    std::uint64_t total = 0;
    double mean = 0.0;                     ///< 0 when there is nothing
    double variance = 0.0;                 ///< of the values, about their mean
    std::optional<double> mean_expected;   ///< as the others below: none without expected shares
    std::optional<double> variance_ratio;  ///< to the variance of what is expected
    /// Pearson's, over bins joined from the left until each expects 5 or more; none while fewer
    /// than two are left.
    std::optional<double> chi_square;
    int degrees_of_freedom = 0;
    std::optional<double> p_value;  ///< chance of a chi-square at least this large
};

/// Pre: expected is empty or as long as counts. Shares need not sum to 1: they are scaled.
HistogramFit fit_of(const Histogram& histogram);

/// P(chi-square with `degrees` degrees of freedom >= x), to 1e-9. Pre: degrees >= 1.
double chi_square_tail(double x, int degrees);

/// Fills `area`: a title, bars with the expected curve over them, and the numbers. A small area
/// gets less; one below 12 x 4 stays as it is.
void draw_histogram(Canvas& canvas, const CellArea& area, const Histogram& histogram,
                    const Look& look);

}  // namespace carom

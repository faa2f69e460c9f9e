#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

/// Observed counts compared with expected ones.
namespace carom {

struct Histogram {
    std::string title;
    std::vector<std::uint64_t> counts;  ///< left to right
    std::vector<double> expected;       ///< expected share of each bin; empty: no expectation
    std::string against;                ///< the expected distribution in words: "binomial(12,0.5)"
};

/// How well counts match their expectation. The value of bin i is i.
struct HistogramFit {
    std::uint64_t total = 0;
    double mean = 0.0;                     ///< 0 without counts
    double variance = 0.0;                 ///< of the values, about their mean
    std::optional<double> mean_expected;   ///< none without expected shares, like all below
    std::optional<double> variance_ratio;  ///< observed over expected variance
    /// Pearson's statistic, over bins joined from the left until each expects 5 or more; none if
    /// fewer than two classes remain.
    std::optional<double> chi_square;
    int degrees_of_freedom = 0;
    std::optional<double> p_value;  ///< the probability of a chi-square at least this large
};

/// Pre: `expected` is empty or as long as `counts`. Shares are scaled, so they need not sum to 1.
HistogramFit fit_of(const Histogram& histogram);

/// P(chi-square with `degrees` degrees of freedom >= x), to 1e-9. Pre: degrees >= 1.
double chi_square_tail(double x, int degrees);

/// Draws into `area` a title, bars with the expected curve over them, and the numbers. A small area
/// gets less of this; one below 12 x 4 stays untouched.
void draw_histogram(Canvas& canvas, const CellArea& area, const Histogram& histogram,
                    const Look& look);

/// Whether bars between these borders, in columns of the canvas, are wide enough to be told apart.
/// `borders` has one more than there are counts.
bool fits_below(const Histogram& histogram, std::span<const double> borders);

/// Draws into `area`, which is below the bins themselves, the numbers, a bar under each bin with
/// the expected curve, an axis, and the counts. Pre: fits_below. An area below 5 rows stays
/// untouched.
void draw_histogram_below(Canvas& canvas, const CellArea& area, const Histogram& histogram,
                          std::span<const double> borders, const Look& look);

}  // namespace carom

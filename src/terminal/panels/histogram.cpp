#include "terminal/panels/histogram.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <string_view>

#include "game/statistics.h"

namespace carom {

namespace {

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

// One class of the chi-square test.
struct JoinedBin {
    double count = 0.0;
    double expected = 0.0;
};

// Neighbours are joined from the left until each class expects enough; the remainder at the right
// joins the last class.
std::vector<JoinedBin> joined_bins(const Histogram& histogram, double total) {
    constexpr double enough = 5.0;
    const double shares = sum_of(histogram.expected);
    std::vector<JoinedBin> classes;
    JoinedBin open;
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        open.count += static_cast<double>(histogram.counts[i]);
        open.expected += total * histogram.expected[i] / shares;
        if (open.expected < enough) continue;
        classes.push_back(open);
        open = {};
    }
    if (!classes.empty()) {
        classes.back().count += open.count;
        classes.back().expected += open.expected;
    }
    return classes;
}

// P(a, x), the regularised lower incomplete gamma function, by its series: best for x < a + 1.
double lower_gamma_series(double a, double x) {
    double term = 1.0 / a;
    double sum = term;
    for (double n = a + 1.0; term > sum * 1e-16; n += 1.0) {
        term *= x / n;
        sum += term;
    }
    return sum * std::exp(a * std::log(x) - x - std::lgamma(a));
}

// Q(a, x) = 1 - P(a, x), by its continued fraction (modified Lentz): best for x >= a + 1.
double upper_gamma_fraction(double a, double x) {
    constexpr double tiny = 1e-300;
    double b = x + 1.0 - a;
    double c = 1.0 / tiny;
    double d = 1.0 / b;
    double product = d;
    for (int i = 1; i < 10000; ++i) {
        const double numerator = -i * (i - a);
        b += 2.0;
        d = numerator * d + b;
        if (std::abs(d) < tiny) d = tiny;
        c = b + numerator / c;
        if (std::abs(c) < tiny) c = tiny;
        d = 1.0 / d;
        product *= d * c;
        if (std::abs(d * c - 1.0) < 1e-15) break;
    }
    return product * std::exp(a * std::log(x) - x - std::lgamma(a));
}

}  // namespace

double chi_square_tail(double x, int degrees) {
    if (!(x > 0.0)) return 1.0;
    const double a = 0.5 * degrees;
    const double half = 0.5 * x;
    return half < a + 1.0 ? 1.0 - lower_gamma_series(a, half) : upper_gamma_fraction(a, half);
}

HistogramFit fit_of(const Histogram& histogram) {
    HistogramFit fit;
    fit.total = std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0});
    const Moments counted = moments_of(std::span(histogram.counts));
    fit.mean = counted.mean;
    fit.variance = counted.variance;
    if (!(sum_of(histogram.expected) > 0.0)) return fit;

    const Moments expected = moments_of(std::span(histogram.expected));
    fit.mean_expected = expected.mean;
    if (fit.total == 0) return fit;
    if (expected.variance > 0.0) fit.variance_ratio = counted.variance / expected.variance;
    const auto classes = joined_bins(histogram, static_cast<double>(fit.total));
    if (classes.size() < 2) return fit;
    double chi_square = 0.0;
    for (const JoinedBin& bin : classes) {
        const double off = bin.count - bin.expected;
        chi_square += off * off / bin.expected;
    }
    fit.chi_square = chi_square;
    fit.degrees_of_freedom = static_cast<int>(classes.size()) - 1;
    fit.p_value = chi_square_tail(chi_square, fit.degrees_of_freedom);
    return fit;
}

}  // namespace carom

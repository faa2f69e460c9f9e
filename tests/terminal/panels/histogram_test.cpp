#include "terminal/panels/histogram.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace carom;

namespace {

Histogram binomial(int tosses, double total) {
    Histogram histogram{"bins", {}, {}, "binomial"};
    double share = std::pow(0.5, tosses);
    for (int i = 0; i <= tosses; ++i) {
        histogram.expected.push_back(share);
        histogram.counts.push_back(static_cast<std::uint64_t>(total * share + 0.5));
        share = share * (tosses - i) / (i + 1);
    }
    return histogram;
}

std::string drawn(const Histogram& histogram, int columns, int rows, const Look& look) {
    Canvas canvas(columns, rows);
    draw_histogram(canvas, {0, 0, columns, rows}, histogram, look);
    return "\n" + canvas.text();
}

}  // namespace

TEST_CASE("the tail of chi-square, against published values") {
    // Abramowitz and Stegun, table 26.8: the quantiles for 5 % and 1 %.
    CHECK(chi_square_tail(3.841458821, 1) == doctest::Approx(0.05).epsilon(1e-7));
    CHECK(chi_square_tail(18.307038053, 10) == doctest::Approx(0.05).epsilon(1e-7));
    CHECK(chi_square_tail(23.209251159, 10) == doctest::Approx(0.01).epsilon(1e-7));
    CHECK(chi_square_tail(124.342113404, 100) == doctest::Approx(0.05).epsilon(1e-7));
    // Two degrees: exactly e^(-x/2).
    for (const double x : {0.1, 1.0, 2.0, 7.5, 60.0}) {
        CHECK(chi_square_tail(x, 2) == doctest::Approx(std::exp(-0.5 * x)).epsilon(1e-11));
    }
    CHECK(chi_square_tail(0.0, 5) == 1.0);
    CHECK(chi_square_tail(1e6, 5) == doctest::Approx(0.0));
}

TEST_CASE("counts that match their expectation fit") {
    const HistogramFit fit = fit_of(binomial(12, 4096.0));
    CHECK(fit.total == 4096);
    CHECK(fit.mean == doctest::Approx(6.0));
    CHECK(fit.variance == doctest::Approx(3.0));
    CHECK(fit.mean_expected == doctest::Approx(6.0));
    CHECK(fit.variance_ratio == doctest::Approx(1.0));
    CHECK(fit.chi_square == doctest::Approx(0.0));
    // The outermost bins expect one each, so each is joined with its neighbour.
    CHECK(fit.degrees_of_freedom == 10);
    CHECK(fit.p_value == doctest::Approx(1.0));
}

TEST_CASE("chi-square is Pearson's statistic") {
    // Mendel's peas: 315, 101, 108, 32 against 9:3:3:1 give 0.470.
    const Histogram peas{"peas", {315, 101, 108, 32}, {9, 3, 3, 1}, "Mendel"};
    const HistogramFit fit = fit_of(peas);
    CHECK(fit.chi_square == doctest::Approx(0.470).epsilon(0.001));
    CHECK(fit.degrees_of_freedom == 3);
    CHECK(fit.p_value == doctest::Approx(0.9254).epsilon(0.001));
}

TEST_CASE("with too little data, statistics are absent") {
    const HistogramFit empty = fit_of(binomial(12, 0.0));
    CHECK(empty.total == 0);
    CHECK(empty.mean_expected == doctest::Approx(6.0));
    CHECK_FALSE(empty.variance_ratio);
    CHECK_FALSE(empty.chi_square);

    const HistogramFit alone = fit_of({"bins", {1, 2, 3}, {}, ""});
    CHECK(alone.mean == doctest::Approx(4.0 / 3.0));
    CHECK_FALSE(alone.mean_expected);
    CHECK_FALSE(alone.p_value);

    const HistogramFit few = fit_of({"bins", {1, 2, 1}, {1, 2, 1}, ""});
    CHECK(few.variance_ratio == doctest::Approx(1.0));
    CHECK_FALSE(few.chi_square);

    CHECK_FALSE(fit_of({"bins", {3}, {0.0}, ""}).mean_expected);
    CHECK(fit_of({}).total == 0);
}

TEST_CASE("bars and the expected curve, with blocks") {
    Histogram histogram = binomial(6, 640.0);
    histogram.counts[3] = 120;
    CHECK(drawn(histogram, 30, 12, {256, true, false}) == R"(
bins / binomial
            ▔▔▔
        ▁▁▁     ▁▁▁
        ███ ▄▄▄ ███
        ███ ███ ███
        ███ ███ ███
    ─── ███ ███ ███ ───
    ███ ███ ███ ███ ███
─── ███ ███ ███ ███ ███ ───
N 560  mean 3.000 (3.000)
variance x1.143
χ² 25.1/6 p 0.000
)");
}

TEST_CASE("bars and the expected curve, in ASCII") {
    Histogram histogram = binomial(6, 640.0);
    histogram.counts[3] = 120;
    CHECK(drawn(histogram, 30, 12, {0, false, false}) == R"(
bins / binomial
            """
        ___     ___
        ### ... ###
        ### ### ###
        ### ### ###
    --- ### ### ### ---
    ### ### ### ### ###
--- ### ### ### ### ### ---
N 560  mean 3.000 (3.000)
variance x1.143
chi2 25.1/6 p 0.000
)");
}

TEST_CASE("more bins than columns share bars") {
    Histogram histogram{"many", {}, {}, ""};
    histogram.counts.assign(50, 1);
    const std::string text = drawn(histogram, 20, 8, {0, false, false});
    CHECK(text.find(std::string(16, '#')) != std::string::npos);
    CHECK(text.find(std::string(18, '#')) == std::string::npos);
}

TEST_CASE("under its bins a histogram has a bar, an axis and a count for each") {
    const Histogram histogram{"bins", {1, 4, 2}, {1, 4, 2}, "binomial"};
    const std::vector<double> borders{4.0, 8.0, 12.0, 16.0};
    REQUIRE(fits_below(histogram, borders));
    Canvas canvas(40, 7);
    draw_histogram_below(canvas, {0, 0, 40, 7}, histogram, borders, {0, false, false});
    CHECK("\n" + canvas.text() == R"(
bins / binomial  N 7  mean 1.143 (1.143)
        """
        ### ___
    ___ ### ###
    ### ### ###
    ------------
     1   4   2
)");
}

TEST_CASE("the words over bars below their bins begin where the bars do, if they fit there") {
    const Histogram histogram{"bins", {1, 4, 2}, {}, ""};
    const std::vector<double> borders{30.0, 34.0, 38.0, 42.0};
    for (const int columns : {100, 60, 44}) {
        CAPTURE(columns);
        Canvas canvas(columns, 7);
        draw_histogram_below(canvas, {0, 0, columns, 7}, histogram, borders, {0, false, false});
        const std::string words = "bins  N 7  mean 1.143  variance 0.408";
        const std::string line = canvas.text().substr(0, canvas.text().find('\n'));
        const auto room = static_cast<std::size_t>(columns) - words.size();
        CHECK(line.find(words) == std::min<std::size_t>(30, room));
    }
}

TEST_CASE("bins too narrow to have bars below them do not fit") {
    const Histogram histogram{"bins", {1, 2}, {}, ""};
    CHECK(fits_below(histogram, std::vector{0.0, 2.0, 4.0}));
    CHECK_FALSE(fits_below(histogram, std::vector{0.0, 1.9, 4.0}));
    CHECK_FALSE(fits_below(histogram, std::vector{4.0, 2.0, 0.0}));
    CHECK_FALSE(fits_below(histogram, std::vector{0.0, 2.0}));
    CHECK_FALSE(fits_below(histogram, std::vector{0.0, 2.0, std::nan("")}));
    CHECK_FALSE(fits_below(histogram, std::vector{-1e9, 2.0, 4.0}));
}

TEST_CASE("a panel too small for a histogram stays untouched") {
    for (const auto& [columns, rows] : {std::pair{11, 20}, {40, 3}, {0, 0}}) {
        Canvas canvas(columns, rows);
        canvas.fill({U'x'});
        draw_histogram(canvas, {0, 0, columns, rows}, binomial(12, 100.0), {});
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                REQUIRE(canvas.at(column, row).glyph == U'x');
            }
        }
    }
}

TEST_CASE("nothing is drawn outside the panel") {
    for (const CellArea area : {CellArea{5, 3, 12, 4}, CellArea{5, 3, 25, 7}}) {
        Canvas canvas(40, 14);
        canvas.fill({U'x'});
        draw_histogram(canvas, area, binomial(40, 1e9), {});
        for (int row = 0; row < 14; ++row) {
            for (int column = 0; column < 40; ++column) {
                const bool is_inside = column >= area.column && row >= area.row &&
                                       column < area.column + area.columns &&
                                       row < area.row + area.rows;
                if (!is_inside) REQUIRE(canvas.at(column, row).glyph == U'x');
            }
        }
    }
}

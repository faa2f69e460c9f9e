#include "terminal/canvas/glyph.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <vector>

#include "terminal/canvas/raster.h"
#include "terminal/support/font.h"

using namespace carom;
using carom::test::font_columns;
using carom::test::font_ink;
using carom::test::font_rows;

namespace {

// A picture in pixels, 0 to 1, of a window of cells.
constexpr int window_columns = 24;
constexpr int window_rows = 12;
constexpr int width = window_columns * font_columns;
constexpr int height = window_rows * font_rows;
constexpr double aspect = 2.0;
using Picture = std::vector<double>;

std::size_t pixel(int x, int y) {
    return static_cast<std::size_t>(y * width + x);
}

// Signed distance to a shape, in columns; negative inside.
using Shape = std::function<double(double x, double y)>;

Picture picture_of(const Shape& shape) {
    Picture picture(static_cast<std::size_t>(width * height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double d = shape((x + 0.5) / font_columns, (y + 0.5) / font_rows * aspect);
            picture[pixel(x, y)] = std::clamp(0.5 - d * font_columns, 0.0, 1.0);
        }
    }
    return picture;
}

Picture picture_of(const Canvas& canvas) {
    Picture picture(static_cast<std::size_t>(width * height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto glyph = static_cast<char>(canvas.at(x / font_columns, y / font_rows).glyph);
            picture[pixel(x, y)] = font_ink(glyph, x % font_columns, y % font_rows);
        }
    }
    return picture;
}

// Blurs as if seen from a distance: a Gaussian with a deviation of half the width of a cell.
Picture blurred(const Picture& sharp) {
    constexpr double deviation = font_columns / 2.0;
    constexpr int reach = 12;
    std::vector<double> weights;
    double sum = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        weights.push_back(std::exp(-i * i / (2.0 * deviation * deviation)));
        sum += weights.back();
    }
    const auto pass = [&](const Picture& from, int dx, int dy) {
        Picture to(from.size());
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                double value = 0.0;
                for (int i = -reach; i <= reach; ++i) {
                    const int fx = x + i * dx;
                    const int fy = y + i * dy;
                    if (fx < 0 || fx >= width || fy < 0 || fy >= height) continue;
                    value += weights[static_cast<std::size_t>(i + reach)] * from[pixel(fx, fy)];
                }
                to[pixel(x, y)] = value / sum;
            }
        }
        return to;
    };
    return pass(pass(sharp, 1, 0), 0, 1);
}

// The error of the drawn picture, at its best brightness: 0 is identical to the true one, 1 is no
// better than an empty one.
double error_of(const Picture& truth, const Canvas& drawn) {
    const Picture a = blurred(truth);
    const Picture b = blurred(picture_of(drawn));
    double aa = 0.0;
    double ab = 0.0;
    double bb = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += a[i] * a[i];
        ab += a[i] * b[i];
        bb += b[i] * b[i];
    }
    const double gain = bb > 0.0 ? ab / bb : 0.0;
    return std::sqrt(std::max(0.0, aa - 2.0 * gain * ab + gain * gain * bb) / aa);
}

// The usual method: a character as dense as the cell's coverage.
Canvas density_ramp(const Picture& truth) {
    constexpr std::string_view ramp = " .:-=+*#%@";
    Canvas canvas(window_columns, window_rows);
    for (int row = 0; row < window_rows; ++row) {
        for (int column = 0; column < window_columns; ++column) {
            double sum = 0.0;
            for (int y = 0; y < font_rows; ++y) {
                for (int x = 0; x < font_columns; ++x) {
                    sum += truth[pixel(column * font_columns + x, row * font_rows + y)];
                }
            }
            const double share = sum / (font_columns * font_rows);
            const auto step = static_cast<std::size_t>(share * 9.0 + 0.5);
            canvas.put(column, row, {static_cast<unsigned char>(ramp[step])});
        }
    }
    return canvas;
}

Canvas shown(const Raster& raster) {
    Canvas canvas(window_columns, window_rows);
    raster.show(canvas, 0, 0);
    return canvas;
}

struct Errors {
    double ours = 0.0;
    double ramp = 0.0;
};

// Circles of 24 sizes at 24 places, none of them aligned with the cells.
template <class Draw, class Distance>
Errors errors_of(Draw draw, Distance distance) {
    Errors errors;
    for (int i = 0; i < 24; ++i) {
        const RasterPoint center{12.0 + 0.37 * (i % 7) - 1.1, 12.0 + 0.29 * (i % 5) - 0.6};
        const double radius = 1.1 + 0.23 * i;
        Raster raster(ascii_renderer(), window_columns, window_rows, aspect);
        draw(raster, center, radius);
        const Picture truth = picture_of([&](double x, double y) {
            return distance(std::hypot(x - center.x, y - center.y), radius);
        });
        errors.ours += error_of(truth, shown(raster)) / 24.0;
        errors.ramp += error_of(truth, density_ramp(truth)) / 24.0;
    }
    return errors;
}

}  // namespace

TEST_CASE("the table of ink agrees with the font") {
    double worst = 0.0;
    for (int i = 0; i < printable_count; ++i) {
        // The font's 16 rows do not divide by 3: compare halves, and the whole.
        double left = 0.0;
        double right = 0.0;
        for (int y = 0; y < font_rows; ++y) {
            for (int x = 0; x < font_columns; ++x) {
                (x < font_columns / 2 ? left : right) +=
                    font_ink(static_cast<char>(first_printable + i), x, y);
            }
        }
        const RegionInk& ink = region_ink()[static_cast<std::size_t>(i)];
        const double scale = 255.0 * 3.0 / (0.5 * font_columns * font_rows);
        worst = std::max(worst, std::abs(left * scale - ink[0] - ink[2] - ink[4]));
        worst = std::max(worst, std::abs(right * scale - ink[1] - ink[3] - ink[5]));
    }
    CHECK(worst < 8.0);  // 1 % of a half's 765: the font's pixels have 16 levels
}

TEST_CASE("an empty cell is blank and a full one is not") {
    CHECK(glyph_for(0) == ' ');
    CHECK(glyph_for(pattern_count - 1) == '@');
}

TEST_CASE("a single region is drawn where it is") {
    const auto only = [](int region) { return glyph_for(static_cast<Pattern>(3 << (2 * region))); };
    CHECK(std::string_view("`'^\"").find(only(0)) != std::string_view::npos);
    CHECK(std::string_view("`'^\"").find(only(1)) != std::string_view::npos);
    CHECK(std::string_view(".,_").find(only(4)) != std::string_view::npos);
    CHECK(std::string_view(".,_").find(only(5)) != std::string_view::npos);
    for (int region = 0; region < 6; ++region)
        CHECK(only(region) != ' ');
}

TEST_CASE("the mirror image of a pattern gets the mirror image of its character") {
    for (int i = 0; i < pattern_count; ++i) {
        const auto pattern = static_cast<unsigned>(i);
        unsigned mirrored = 0;
        for (unsigned region = 0; region < 6; ++region) {
            mirrored |= ((pattern >> (2 * region)) & 3u) << (2 * (region ^ 1u));
        }
        const char here = glyph_for(static_cast<Pattern>(pattern));
        const char there = glyph_for(static_cast<Pattern>(mirrored));
        const auto shapes = shape_glyphs();
        const bool is_pair = std::any_of(shapes.begin(), shapes.end(), [&](const ShapeGlyph& s) {
            return s.glyph == here && s.mirrored == there;
        });
        CAPTURE(here);
        CAPTURE(there);
        REQUIRE(is_pair);
    }
}

TEST_CASE("circles are drawn with at most 65 % of a density ramp's error") {
    const Errors discs = errors_of(
        [](Raster& raster, RasterPoint center, double radius) {
            raster.disc(center, radius, 0.0, {{}, 255, '\0'});
        },
        [](double distance, double radius) { return distance - radius; });
    const Errors rings = errors_of(
        [](Raster& raster, RasterPoint center, double radius) {
            raster.disc(center, radius, 2.0 * raster.hairline(), {{}, 0, ' '});
        },
        [](double distance, double radius) {
            constexpr double half = 0.13;  // the raster's hairline for shapes
            return std::abs(distance - radius + half) - half;
        });
    MESSAGE("discs " << discs.ours << " of " << discs.ramp << ", rings " << rings.ours << " of "
                     << rings.ramp << ": "
                     << (discs.ours + rings.ours) / (discs.ramp + rings.ramp));
    CHECK(discs.ours + rings.ours <= 0.65 * (discs.ramp + rings.ramp));
    CHECK(discs.ours < discs.ramp);
    CHECK(rings.ours < 0.65 * rings.ramp);
}

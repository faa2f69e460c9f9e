#include "terminal/canvas/oklab.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace carom {
namespace {

struct Linear {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
};

std::array<double, 256> make_linear() {
    std::array<double, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double x = static_cast<double>(i) / 255.0;
        table[i] = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    }
    return table;
}

double linear_of(int channel) {
    static const std::array<double, 256> table = make_linear();
    return table[static_cast<std::size_t>(channel)];
}

int channel_of(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    return static_cast<int>(encoded * 255.0 + 0.5);
}

Linear linear_of(const Lab& lab) {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lab.lightness + 0.3963377774 * lab.a + 0.2158037573 * lab.b);
    const double m = cube(lab.lightness - 0.1055613458 * lab.a - 0.0638541728 * lab.b);
    const double s = cube(lab.lightness - 0.0894841775 * lab.a - 1.2914855480 * lab.b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool can_be_shown(const Linear& c) {
    constexpr double hair = 0.0005;
    return std::min({c.red, c.green, c.blue}) >= -hair &&
           std::max({c.red, c.green, c.blue}) <= 1.0 + hair;
}

}  // namespace

Lab lab_of(const Rgb& rgb) {
    const double red = linear_of(rgb.red);
    const double green = linear_of(rgb.green);
    const double blue = linear_of(rgb.blue);
    const double l = std::cbrt(0.4122214708 * red + 0.5363325363 * green + 0.0514459929 * blue);
    const double m = std::cbrt(0.2119034982 * red + 0.6806995451 * green + 0.1073969566 * blue);
    const double s = std::cbrt(0.0883024619 * red + 0.2817188376 * green + 0.6299787005 * blue);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Lab lab_of(const Lch& lch) {
    const double angle = lch.hue * 3.14159265358979 / 180.0;
    return {lch.lightness, lch.chroma * std::cos(angle), lch.chroma * std::sin(angle)};
}

Rgb rgb_of(const Lab& lab) {
    const Linear linear = linear_of(lab);
    return {channel_of(linear.red), channel_of(linear.green), channel_of(linear.blue)};
}

Rgb rgb_of(const Lch& lch) {
    if (can_be_shown(linear_of(lab_of(lch)))) return rgb_of(lab_of(lch));
    double shown = 0.0;
    double beyond = lch.chroma;
    for (int i = 0; i < 12; ++i) {
        const double middle = 0.5 * (shown + beyond);
        const bool is_shown = can_be_shown(linear_of(lab_of(Lch{lch.lightness, middle, lch.hue})));
        (is_shown ? shown : beyond) = middle;
    }
    return rgb_of(lab_of(Lch{lch.lightness, shown, lch.hue}));
}

double squared_distance(const Lab& a, const Lab& b) {
    const auto square = [](double x) { return x * x; };
    return square(a.lightness - b.lightness) + square(a.a - b.a) + square(a.b - b.b);
}

double reduction_error(const Lab& shown, const Lab& wanted, int colors) {
    const double lightness_weight = colors >= 256 ? 0.6 : colors >= 16 ? 0.3 : 0.15;
    const double difference = shown.lightness - wanted.lightness;
    return squared_distance(shown, wanted) - (1.0 - lightness_weight) * difference * difference;
}

}  // namespace carom

#include "terminal/canvas/surface_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "terminal/canvas/oklab.h"

namespace carom {
namespace {

constexpr Color first_known = 16;  // a terminal's theme may change those before it
constexpr std::size_t color_count = 240;

double chroma_of(const Lab& lab) {
    return std::hypot(lab.a, lab.b);
}

// 0 for what looks grey, 1 for what has a hue.
double vividness(double chroma) {
    constexpr double grey = 0.05;
    constexpr double vivid = 0.08;
    return std::clamp((chroma - grey) / (vivid - grey), 0.0, 1.0);
}

// The cosine of the angle between the hues. A colour that is nearly grey has none.
double likeness_of_hue(const Lab& shown, const Lab& wanted) {
    constexpr double least_chroma = 0.02;
    const double shown_chroma = chroma_of(shown);
    const double wanted_chroma = chroma_of(wanted);
    if (shown_chroma < least_chroma || wanted_chroma < least_chroma) return 0.0;
    return (shown.a * wanted.a + shown.b * wanted.b) / (shown_chroma * wanted_chroma);
}

// The weights were chosen by eye, on pool and pinball tables.
double error_of(const Lab& shown, const Lab& wanted) {
    constexpr double lightness_weight = 0.2;
    constexpr double paler_weight = 0.5;
    constexpr double richer_weight = 0.25;
    constexpr double hue_weight = 0.06;
    const auto square = [](double x) { return x * x; };
    const double hued = vividness(chroma_of(wanted));
    const double richer = chroma_of(shown) - chroma_of(wanted);
    return lightness_weight * square(shown.lightness - wanted.lightness) +
           hued * ((richer > 0.0 ? richer_weight : paler_weight) * square(richer) +
                   hue_weight * (1.0 - likeness_of_hue(shown, wanted))) +
           (1.0 - hued) * (square(shown.a - wanted.a) + square(shown.b - wanted.b));
}

// How two neighbours misrepresent their difference: 1 where they lose all of it, or gain several
// times as much, as where two dark colours become a dark and a pale one.
double distortion(const Lab& shown, const Lab& other_shown, const Lab& wanted,
                  const Lab& other_wanted) {
    constexpr double alike = 0.02;
    const double difference = std::sqrt(squared_distance(wanted, other_wanted));
    if (difference < alike) return 0.0;
    const double kept = std::sqrt(squared_distance(shown, other_shown)) / difference;
    constexpr double most_kept = 2.0;
    const double wrong = std::min(1.0, std::max(1.0 - kept, kept - most_kept));
    return wrong > 0.0 ? wrong * wrong : 0.0;
}

constexpr double distortion_weight = 0.003;  // of the mean over the neighbours

struct Candidates {
    std::array<Lab, color_count> labs;
};

Candidates make_candidates() {
    Candidates candidates;
    for (std::size_t i = 0; i < color_count; ++i)
        candidates.labs[i] = lab_of(rgb_of(first_known + static_cast<Color>(i)));
    return candidates;
}

std::vector<std::size_t> chosen(std::span<const Lab> wanted,
                                std::span<const Neighbours> neighbours) {
    static const Candidates candidates = make_candidates();
    const std::array<Lab, color_count>& labs = candidates.labs;
    std::vector<std::size_t> choice(wanted.size());
    const auto best_for = [&](std::size_t area, std::span<const Neighbours> touching) {
        std::size_t best = 0;
        double least = HUGE_VAL;
        for (std::size_t i = 0; i < color_count; ++i) {
            double distorted = 0.0;
            double count = 0.0;
            for (const auto& [first, second] : touching) {
                if (first != area && second != area) continue;
                const std::size_t other = first == area ? second : first;
                distorted += distortion(labs[i], labs[choice[other]], wanted[area], wanted[other]);
                count += 1.0;
            }
            const double error = error_of(labs[i], wanted[area]) +
                                 distortion_weight * distorted / std::max(1.0, count);
            if (error >= least) continue;
            least = error;
            best = i;
        }
        return best;
    };
    for (std::size_t area = 0; area < wanted.size(); ++area)
        choice[area] = best_for(area, {});
    constexpr int most_rounds = 20;  // two or three are enough
    bool changed = true;
    for (int round = 0; changed && round < most_rounds; ++round) {
        changed = false;
        for (std::size_t area = 0; area < wanted.size(); ++area) {
            const std::size_t best = best_for(area, neighbours);
            changed |= best != choice[area];
            choice[area] = best;
        }
    }
    return choice;
}

}  // namespace

std::vector<Color> surface_colors(std::span<const Rgb> wanted,
                                  std::span<const Neighbours> neighbours, const Look& look) {
    std::vector<Color> colors;
    const bool is_reduced = look.has_shades() && look.colors < direct_colors;
    if (!is_reduced) {
        for (const Rgb& rgb : wanted)
            colors.push_back(ink_of_color(rgb, look).color);
        return colors;
    }
    std::vector<Lab> labs;
    for (const Rgb& rgb : wanted)
        labs.push_back(lab_of(rgb));
    for (const std::size_t i : chosen(labs, neighbours))
        colors.push_back(first_known + static_cast<Color>(i));
    return colors;
}

}  // namespace carom

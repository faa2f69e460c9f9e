#include "terminal/canvas/renderer.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "terminal/canvas/glyph.h"

namespace carom {
namespace {

Cell show_regions(const CellSamples& samples, const Look&) {
    unsigned pattern = 0;
    for (unsigned region = 0; region < 6; ++region) {
        const unsigned level = (samples.levels[region] * 3u + 127u) / 255u;
        pattern |= level << (2 * region);
    }
    const char glyph =
        samples.fill != '\0' ? samples.fill : glyph_for(static_cast<Pattern>(pattern));
    const Ink ink = samples.ink();
    return {static_cast<unsigned char>(glyph), ink.color, default_color, ink.attributes};
}

// Braille numbers its dots down the left column, down the right one, and then the bottom row.
constexpr std::array<unsigned, 8> dot_bits = {0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80};

Cell show_dots(const CellSamples& samples, const Look&) {
    unsigned dots = 0;
    for (std::size_t i = 0; i < dot_bits.size(); ++i)
        if (samples.levels[i] >= 128) dots |= dot_bits[i];
    const char32_t glyph = dots == 0 ? U' ' : static_cast<char32_t>(0x2800 + dots);
    const Ink ink = samples.ink();
    return {glyph, ink.color, default_color, ink.attributes};
}

constexpr int mixture_steps = 4;
constexpr std::uint8_t least_lit = 112;  // where colours have no shades

int squared_distance(const Rgb& a, const Rgb& b) {
    const auto square = [](int x) { return x * x; };
    return 2 * square(a.red - b.red) + 4 * square(a.green - b.green) + 3 * square(a.blue - b.blue);
}

// The colours of a cell's pixels, each once.
struct PixelColors {
    std::array<Color, most_samples> each{};          // by pixel
    std::array<Color, most_samples> colors{};        // in the order of their first pixels
    std::array<int, most_samples> uses{};            // of each of `colors`
    std::array<std::uint8_t, most_samples> index{};  // of each pixel's colour in `colors`
    std::size_t count = 0;
};

PixelColors colors_of(const CellSamples& samples, std::size_t pixels, const Look& look) {
    PixelColors found;
    for (std::size_t i = 0; i < pixels; ++i) {
        const Color color = pixel_color(samples, i, look);
        std::size_t at = 0;
        while (at < found.count && found.colors[at] != color)
            ++at;
        if (at == found.count) found.colors[found.count++] = color;
        ++found.uses[at];
        found.each[i] = color;
        found.index[i] = static_cast<std::uint8_t>(at);
    }
    return found;
}

// Which two of three or more colours a cell keeps, and which of the two each colour becomes.
struct KeptColors {
    std::size_t first = 0;
    std::size_t second = 0;
    std::array<bool, most_samples> becomes_second{};
};

// The two with the least error over the pixels. They are colours that are really there, never
// means of them, so equal cells stay equal, and borders clean.
KeptColors least_error(const PixelColors& found, const Look& look) {
    std::array<Rgb, most_samples> rgb{};
    for (std::size_t i = 0; i < found.count; ++i)
        rgb[i] = rgb_of(found.colors[i] < 0 ? ground_color(look) : found.colors[i]);
    std::array<std::array<int, most_samples>, most_samples> error{};
    for (std::size_t i = 0; i < found.count; ++i)
        for (std::size_t j = 0; j < i; ++j)
            error[i][j] = error[j][i] = squared_distance(rgb[i], rgb[j]);
    KeptColors best;
    int least = std::numeric_limits<int>::max();
    for (std::size_t a = 0; a < found.count; ++a) {
        for (std::size_t b = a + 1; b < found.count; ++b) {
            int sum = 0;
            for (std::size_t i = 0; i < found.count; ++i)
                sum += found.uses[i] * std::min(error[i][a], error[i][b]);
            if (sum >= least) continue;
            least = sum;
            best.first = a;
            best.second = b;
        }
    }
    for (std::size_t i = 0; i < found.count; ++i)
        best.becomes_second[i] = error[i][best.second] < error[i][best.first];
    return best;
}

unsigned lit_pattern(const CellSamples& samples, std::size_t pixels) {
    unsigned pattern = 0;
    for (std::size_t i = 0; i < pixels; ++i)
        if (samples.levels[i] >= least_lit) pattern |= 1u << i;
    return pattern;
}

using Glyph = char32_t (*)(unsigned pattern);

template <std::size_t pixels, Glyph glyph>
Cell show_pixels(const CellSamples& samples, const Look& look) {
    const unsigned lit = lit_pattern(samples, pixels);
    const std::size_t first_lit = lit == 0 ? 0 : static_cast<std::size_t>(std::countr_zero(lit));
    const std::uint8_t attributes = samples.attributes[first_lit];
    if (!look.has_colors()) return {glyph(lit), default_color, default_color, attributes};

    const PixelColors found = colors_of(samples, pixels, look);
    if (found.count == 1) {
        if (found.colors[0] < 0) return {};
        // The background has the colour too: in many fonts a block leaves a seam at the edge of
        // its cell.
        return {full_block, found.colors[0], found.colors[0], attributes};
    }
    KeptColors pair{0, 1, {}};
    pair.becomes_second[1] = true;
    if (found.count > 2) pair = least_error(found, look);
    // The terminal's own background cannot be a foreground.
    const bool is_swapped = found.colors[pair.first] < 0;
    unsigned pattern = 0;
    for (std::size_t i = 0; i < pixels; ++i)
        if (pair.becomes_second[found.index[i]] == is_swapped) pattern |= 1u << i;
    const Color first = found.colors[pair.first];
    const Color second = found.colors[pair.second];
    return {glyph(pattern), is_swapped ? second : first, is_swapped ? first : second, attributes};
}

constexpr std::string_view automatic = "auto";

constexpr std::array table{Renderer{.name = "ascii",
                                    .title = "ascii",
                                    .needs_utf8 = false,
                                    .samples = Renderer::Samples::regions,
                                    .across = 2,
                                    .down = 3,
                                    .hairline = 0.13,  // the stroke of a font
                                    .gap = 0.28,
                                    .least_rimmed = 1.9,
                                    .level_of_dot = 0.7,
                                    .show = show_regions},
                           Renderer{.name = "half",
                                    .title = "half blocks",
                                    .samples = Renderer::Samples::pixels,
                                    .across = 1,
                                    .down = 2,
                                    .hairline = 0.45,
                                    .least_rimmed = 2.5,
                                    .level_of_dot = 0.75,
                                    .show = show_pixels<2, half_block>},
                           Renderer{.name = "quadrants",
                                    .title = "quadrants",
                                    .samples = Renderer::Samples::pixels,
                                    .across = 2,
                                    .down = 2,
                                    .hairline = 0.3,
                                    .least_rimmed = 1.8,
                                    .is_sharp = true,
                                    .mosaic = Mosaic::quadrants,
                                    .show = show_pixels<4, quadrant>},
                           Renderer{.name = "sextants",
                                    .title = "sextants",
                                    .samples = Renderer::Samples::pixels,
                                    .across = 2,
                                    .down = 3,
                                    .hairline = 0.27,
                                    .least_rimmed = 1.4,
                                    .is_sharp = true,
                                    .mosaic = Mosaic::sextants,
                                    .show = show_pixels<6, sextant>},
                           Renderer{.name = "octants",
                                    .title = "octants",
                                    .samples = Renderer::Samples::pixels,
                                    .across = 2,
                                    .down = 4,
                                    .hairline = 0.26,
                                    .least_rimmed = 1.2,
                                    .is_sharp = true,
                                    .mosaic = Mosaic::octants,
                                    .show = show_pixels<8, octant>},
                           Renderer{.name = "braille",
                                    .title = "braille",
                                    .samples = Renderer::Samples::dots,
                                    .across = 2,
                                    .down = 4,
                                    .hairline = 0.27,
                                    .least_rimmed = 1.2,
                                    .show = show_dots}};

}  // namespace

Color pixel_color(const CellSamples& samples, std::size_t pixel, const Look& look) {
    const std::uint8_t level = samples.levels[pixel];
    if (level == 255) return samples.colors[pixel];
    if (level == 0) return samples.grounds[pixel];
    if (!look.has_shades())
        return level >= least_lit ? samples.colors[pixel] : samples.grounds[pixel];
    const int steps = (level * mixture_steps + 127) / 255;
    return blended(samples.colors[pixel], samples.grounds[pixel],
                   static_cast<double>(steps) / mixture_steps, look);
}

std::span<const Renderer> renderers() {
    return table;
}

const Renderer& ascii_renderer() {
    return table[0];
}
const Renderer& half_block_renderer() {
    return table[1];
}
const Renderer& quadrant_renderer() {
    return table[2];
}
const Renderer& sextant_renderer() {
    return table[3];
}
const Renderer& octant_renderer() {
    return table[4];
}
const Renderer& braille_renderer() {
    return table[5];
}

std::optional<RendererChoice> renderer_choice(std::string_view name) {
    if (name == automatic) return nullptr;
    const auto found = std::ranges::find(table, name, &Renderer::name);
    if (found == table.end()) return std::nullopt;
    return &*found;
}

std::string_view name_of(RendererChoice choice) {
    return choice == nullptr ? automatic : choice->name;
}

std::vector<std::string_view> renderer_choice_names() {
    std::vector<std::string_view> names{automatic};
    for (const Renderer& renderer : table)
        names.push_back(renderer.name);
    return names;
}

const Renderer& renderer_after(const Renderer& renderer) {
    const Renderer* const next = &renderer + 1;
    return next == table.data() + table.size() ? table.front() : *next;
}

const Renderer& renderer_for(RendererChoice choice, const Look& look) {
    if (!look.utf8 && (choice == nullptr || choice->needs_utf8)) return ascii_renderer();
    if (choice != nullptr) return *choice;
    if (!look.has_colors()) return braille_renderer();
    switch (look.mosaic) {
        case Mosaic::octants:
            return octant_renderer();
        case Mosaic::sextants:
            return sextant_renderer();
        case Mosaic::quadrants:
            return quadrant_renderer();
        case Mosaic::halves:
            break;
    }
    return half_block_renderer();
}

}  // namespace carom

#include "terminal/canvas/renderer.h"

#include <algorithm>

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

// Where a colour has no shades, a pixel is either lit or not.
int shade_of_level(std::uint8_t level, const Look& look) {
    return look.colors >= 256 ? (level * 3 + 127) / 255 : (level >= 112 ? 3 : 0);
}

// The upper half is drawn in the foreground and the lower in the background, unless one is empty.
Cell show_halves(const CellSamples& samples, const Look& look) {
    const Ink upper = samples.ink(0);
    const Ink lower = samples.ink(1);
    const int above = shade_of_level(samples.levels[0], look);
    const int below = shade_of_level(samples.levels[1], look);
    if (above == 0 && below == 0) return {};
    if (!look.has_colors()) {
        const char32_t glyph = above == 0 ? U'▄' : below == 0 ? U'▀' : U'█';
        return {glyph, default_color, default_color,
                above == 0 ? lower.attributes : upper.attributes};
    }
    const Color top = shade(upper.color, above, look);
    const Color bottom = shade(lower.color, below, look);
    if (above == 0) return {U'▄', bottom, default_color, lower.attributes};
    if (below == 0) return {U'▀', top, default_color, upper.attributes};
    // The background has the colour too: in many fonts a block leaves a seam at the edge of its
    // cell.
    if (top == bottom) return {U'█', top, top, upper.attributes};
    return {U'▀', top, bottom, upper.attributes};
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
                                    .show = show_halves},
                           Renderer{.name = "braille",
                                    .title = "braille",
                                    .samples = Renderer::Samples::dots,
                                    .across = 2,
                                    .down = 4,
                                    .hairline = 0.27,
                                    .least_rimmed = 1.2,
                                    .show = show_dots}};

}  // namespace

std::span<const Renderer> renderers() {
    return table;
}

const Renderer& ascii_renderer() {
    return table[0];
}
const Renderer& half_block_renderer() {
    return table[1];
}
const Renderer& braille_renderer() {
    return table[2];
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
    return look.has_colors() ? half_block_renderer() : braille_renderer();
}

}  // namespace carom

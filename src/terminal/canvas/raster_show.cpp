#include <algorithm>
#include <bit>

#include "terminal/canvas/glyph.h"
#include "terminal/canvas/raster.h"

/// The samples of a raster into characters.
namespace carom {

namespace {

using Levels = std::array<std::uint8_t, 8>;

bool is_empty(const Levels& levels) {
    return std::bit_cast<std::uint64_t>(levels) == 0;
}

Pattern pattern_of(const Levels& levels) {
    unsigned pattern = 0;
    for (unsigned region = 0; region < 6; ++region) {
        const unsigned level = (levels[region] * 3u + 127u) / 255u;
        pattern |= level << (2 * region);
    }
    return static_cast<Pattern>(pattern);
}

// Braille numbers its dots down the left column, down the right one, and then the bottom row.
constexpr std::array<unsigned, 8> dot_bits = {0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80};

char32_t braille_of(const Levels& levels) {
    unsigned dots = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        if (levels[i] >= 128) dots |= dot_bits[i];
    }
    return dots == 0 ? U' ' : static_cast<char32_t>(0x2800 + dots);
}

int shade_level(std::uint8_t level) {
    return (level * 3 + 127) / 255;
}

// The upper half is drawn in the foreground, the lower in the background, unless one is empty.
Cell halves_of(const Levels& levels, Ink upper, Ink lower, const Look& look) {
    // Without shades of a colour, a pixel is lit or it is not.
    const auto lit = [&](std::uint8_t level) {
        return look.colors >= 256 ? shade_level(level) : (level >= 112 ? 3 : 0);
    };
    const int above = lit(levels[0]);
    const int below = lit(levels[1]);
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
    // The ground has the colour too: in many fonts a block leaves a seam at the edge of its cell.
    if (top == bottom) return {U'█', top, top, upper.attributes};
    return {U'▀', top, bottom, upper.attributes};
}

}  // namespace

void Raster::show(Canvas& canvas, int column, int row, const Look& look) const {
    for (int r = 0; r < rows_; ++r) {
        for (int c = 0; c < columns_; ++c) {
            const RasterCell& from = cell_at(c, r);
            if (is_empty(from.levels) && from.fill == '\0') continue;
            const Ink ink{from.colors[0], from.attributes[0]};
            Cell to{U' ', ink.color, default_color, ink.attributes};
            switch (sampling_) {
                case Sampling::shapes:
                    to.glyph = static_cast<unsigned char>(
                        from.fill != '\0' ? from.fill : glyph_for(pattern_of(from.levels)));
                    break;
                case Sampling::halves:
                    to = halves_of(from.levels, ink, {from.colors[1], from.attributes[1]}, look);
                    break;
                case Sampling::dots:
                    to.glyph = braille_of(from.levels);
                    break;
            }
            if (to.glyph != U' ') canvas.put(column + c, row + r, to);
        }
    }
}

}  // namespace carom

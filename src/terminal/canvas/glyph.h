#pragma once

#include <array>
#include <cstdint>
#include <span>

/// Characters chosen by shape: the printable ASCII character that looks most like a given pattern
/// of light and dark within one cell.
///
/// A cell is divided into six regions, 3 rows of 2 columns: region 2 * row + column, rows from the
/// top. Each region has one of four levels, from 0 (empty) to 3 (full).
namespace carom {

inline constexpr char first_printable = ' ';
inline constexpr int printable_count = 95;

/// The share of each region that a character's ink covers: 0 none, 255 all of it.
using RegionInk = std::array<std::uint8_t, 6>;

/// The ink of the character `first_printable + i` in a typical terminal font.
std::span<const RegionInk, printable_count> region_ink();

/// A character that may be drawn as a shape, and the character that looks like its mirror image.
/// All other characters, such as digits, are used in text only.
struct ShapeGlyph {
    char glyph;
    char mirrored;
};
std::span<const ShapeGlyph> shape_glyphs();

/// The levels of six regions in one number: the level of region i is in bits 2i and 2i + 1.
using Pattern = std::uint16_t;
inline constexpr int pattern_count = 4096;

/// The character whose ink comes nearest to the pattern, and whose mirror image comes nearest to
/// the mirrored pattern, so that the left side of a circle looks like its right side. Pre: pattern
/// < pattern_count.
char glyph_for(Pattern pattern);

}  // namespace carom

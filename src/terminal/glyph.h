#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

/// Characters chosen by their shape: which printable ASCII character looks most like a given
/// pattern of light and dark within one cell.
///
/// A cell is seen as six regions, 3 rows of 2 columns: region 2 * row + column, rows from the top.
/// Each region has one of four levels, from 0 (empty) to 3 (full).
namespace carom {

inline constexpr char first_printable = ' ';
inline constexpr int printable_count = 95;

/// How much of each region a character's ink covers: 0 none, 255 all of it.
using RegionInk = std::array<std::uint8_t, 6>;

/// The ink of the character `first_printable + i` in a typical terminal font.
std::span<const RegionInk, printable_count> region_ink();

/// Characters that never stand for a shape: digits are labels, and $ and & look like noise.
inline constexpr std::string_view not_shapes = "0123456789$&";

/// The levels of six regions in one number: that of region i in bits 2i and 2i + 1.
using Pattern = std::uint16_t;
inline constexpr int pattern_count = 4096;

/// The character whose ink comes nearest to the pattern. Pre: pattern < pattern_count.
char glyph_for(Pattern pattern);

}  // namespace carom

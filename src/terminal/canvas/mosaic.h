#pragma once

#include <cstdint>
#include <optional>

/// Block mosaics: the characters that divide a cell into equal parts, each filled or empty.
///
/// A pattern has one bit a part, row by row from the top left; the lowest bit is the top left part.
namespace carom {

inline constexpr char32_t full_block = U'█';

/// How finely a terminal's cells can be divided, coarse to fine. Each includes those before it.
enum class Mosaic : std::uint8_t {
    halves,     ///< 1 x 2: U+2580, U+2584
    quadrants,  ///< 2 x 2: U+2596 to U+259F
    sextants,   ///< 2 x 3: U+1FB00 to U+1FB3B (Unicode 13)
    octants     ///< 2 x 4: U+1CD00 to U+1CDE5 (Unicode 16), and older characters
};

char32_t half_block(unsigned pattern);  ///< Pre: pattern < 4
char32_t quadrant(unsigned pattern);    ///< Pre: pattern < 16
char32_t sextant(unsigned pattern);     ///< Pre: pattern < 64
char32_t octant(unsigned pattern);      ///< Pre: pattern < 256

/// The character whose filled parts are the empty ones of `character`; none if it is no mosaic.
std::optional<char32_t> complement_of(char32_t character);

}  // namespace carom

#include "terminal/canvas/glyph.h"

#include <cmath>
#include <string_view>

namespace carom {

namespace {

// Measurement: DejaVu Sans Mono at 400 points, one character a label. Each label's box (advance by
// line height) is reduced to 24 x 48 pixels with a box filter, and the ink of each of the six
// regions is averaged; 255 is a region that is all ink:
//   convert -font DejaVu-Sans-Mono -pointsize 400 label:X -filter box -resize '24x48!' gray:-
constexpr std::array<RegionInk, printable_count> measured_ink = {{
    {0, 0, 0, 0, 0, 0},          //
    {21, 20, 32, 30, 14, 13},    // !
    {35, 35, 15, 15, 0, 0},      // "
    {26, 34, 129, 127, 28, 22},  // #
    {31, 42, 66, 80, 40, 57},    // $
    {53, 3, 85, 87, 4, 50},      // %
    {46, 21, 99, 75, 49, 58},    // &
    {18, 17, 8, 7, 0, 0},        // '
    {9, 32, 72, 8, 17, 35},      // (
    {33, 8, 11, 69, 37, 16},     // )
    {33, 32, 41, 39, 0, 0},      // *
    {3, 3, 75, 72, 9, 8},        // +
    {0, 0, 0, 0, 44, 24},        // ,
    {0, 0, 23, 22, 0, 0},        // -
    {0, 0, 0, 0, 21, 19},        // .
    {0, 37, 40, 39, 48, 0},      // /
    {48, 48, 97, 96, 40, 40},    // 0
    {39, 33, 15, 68, 33, 53},    // 1
    {43, 50, 28, 61, 56, 38},    // 2
    {39, 49, 20, 92, 44, 44},    // 3
    {11, 54, 94, 108, 0, 31},    // 4
    {56, 30, 50, 78, 44, 41},    // 5
    {46, 33, 106, 79, 40, 43},   // 6
    {42, 61, 18, 65, 32, 1},     // 7
    {52, 51, 91, 91, 46, 45},    // 8
    {53, 47, 72, 106, 34, 37},   // 9
    {0, 0, 21, 19, 21, 19},      // :
    {0, 0, 21, 19, 44, 24},      // ;
    {0, 1, 83, 77, 0, 18},       // <
    {0, 0, 94, 93, 0, 0},        // =
    {1, 0, 78, 82, 18, 0},       // >
    {33, 52, 24, 53, 17, 9},     // ?
    {32, 40, 111, 97, 65, 74},   // @
    {34, 33, 99, 98, 32, 33},    // A
    {62, 51, 104, 98, 53, 46},   // B
    {44, 41, 85, 0, 37, 41},     // C
    {64, 43, 82, 86, 55, 34},    // D
    {59, 41, 101, 38, 50, 42},   // E
    {56, 43, 98, 38, 31, 0},     // F
    {47, 39, 85, 64, 39, 50},    // G
    {40, 40, 107, 107, 31, 32},  // H
    {48, 47, 44, 40, 44, 42},    // I
    {22, 51, 0, 82, 48, 35},     // J
    {40, 47, 128, 63, 31, 38},   // K
    {40, 0, 82, 0, 49, 45},      // L
    {63, 63, 116, 117, 29, 30},  // M
    {65, 39, 111, 118, 30, 50},  // N
    {50, 50, 85, 85, 43, 42},    // O
    {59, 56, 100, 69, 31, 0},    // P
    {51, 50, 85, 86, 42, 68},    // Q
    {64, 50, 106, 93, 31, 34},   // R
    {51, 35, 59, 69, 43, 45},    // S
    {62, 61, 43, 41, 17, 16},    // T
    {40, 40, 82, 82, 44, 43},    // U
    {40, 41, 77, 76, 26, 25},    // V
    {38, 38, 127, 127, 39, 39},  // W
    {42, 41, 76, 76, 34, 33},    // X
    {41, 42, 61, 59, 17, 15},    // Y
    {39, 70, 43, 44, 54, 47},    // Z
    {37, 24, 65, 12, 47, 26},    // [
    {37, 0, 51, 28, 0, 48},      // (backslash)
    {25, 35, 14, 62, 28, 45},    // ]
    {38, 37, 16, 16, 0, 0},      // ^
    {0, 0, 0, 0, 26, 26},        // _
    {28, 7, 0, 0, 0, 0},         // `
    {4, 3, 80, 105, 47, 50},     // a
    {43, 4, 97, 90, 50, 43},     // b
    {1, 5, 84, 32, 35, 37},      // c
    {4, 43, 89, 97, 43, 49},     // d
    {2, 3, 109, 89, 40, 38},     // e
    {23, 47, 72, 50, 20, 9},     // f
    {4, 2, 89, 97, 71, 94},      // g
    {43, 4, 93, 87, 28, 28},     // h
    {12, 14, 50, 45, 38, 43},    // i
    {5, 21, 29, 68, 43, 51},     // j
    {43, 2, 100, 78, 29, 35},    // k
    {61, 5, 68, 8, 15, 37},      // l
    {5, 4, 122, 117, 39, 40},    // m
    {2, 4, 93, 87, 28, 29},      // n
    {3, 3, 89, 89, 42, 42},      // o
    {3, 4, 98, 89, 90, 43},      // p
    {3, 2, 89, 98, 43, 91},      // q
    {1, 5, 85, 42, 29, 0},       // r
    {3, 4, 77, 69, 34, 39},      // s
    {34, 3, 96, 27, 21, 33},     // t
    {1, 1, 74, 75, 44, 48},      // u
    {1, 1, 76, 77, 26, 26},      // v
    {1, 1, 102, 102, 39, 39},    // w
    {1, 1, 77, 76, 33, 33},      // x
    {1, 2, 77, 77, 70, 31},      // y
    {3, 3, 54, 73, 48, 32},      // z
    {14, 44, 67, 29, 23, 54},    // {
    {21, 20, 37, 34, 37, 34},    // |
    {45, 13, 32, 64, 56, 20},    // }
    {0, 0, 46, 46, 0, 0},        // ~
}};

// Punctuation only: letters read as text, not as shapes.
constexpr std::array shapes = std::to_array<ShapeGlyph>({
    {' ', ' '},   {'.', '.'}, {':', ':'},  {';', ';'},  {'-', '-'},  {'=', '='}, {'_', '_'},
    {'"', '"'},   {'^', '^'}, {'~', '~'},  {'@', '@'},  {'#', '#'},  {'*', '*'}, {'+', '+'},
    {'\'', '\''}, {',', '.'}, {'.', ','},  {'`', '\''}, {'\'', '`'}, {'(', ')'}, {')', '('},
    {'[', ']'},   {']', '['}, {'/', '\\'}, {'\\', '/'},
});

// The ink that a level asks for. No character fills a region: the densest region of all is half
// ink, so that is the scale for a full region. Scale and exponent were chosen by trying some sixty
// pairs on discs, rings and lines and comparing the blurred pictures (see the test).
constexpr double ink_of_full_region = 0.7 * 129.0;
constexpr double bend = 0.7;

const RegionInk& ink_of_glyph(char glyph) {
    return measured_ink[static_cast<std::size_t>(glyph - first_printable)];
}

Pattern mirrored(Pattern pattern) {
    constexpr unsigned left = 0x333;  // the levels of the regions of the left column
    return static_cast<Pattern>((pattern & left) << 2 | (pattern >> 2 & left));
}

char nearest_glyph(Pattern pattern, const std::array<double, 4>& ink_of_level) {
    char nearest = first_printable;
    double least = HUGE_VAL;
    const bool is_own_mirror = pattern == mirrored(pattern);
    for (const ShapeGlyph& shape : shapes) {
        if (is_own_mirror && shape.glyph != shape.mirrored) continue;
        double error = 0.0;
        for (std::size_t region = 0; region < 6; ++region) {
            const double wanted = ink_of_level[(pattern >> (2 * region)) & 3u];
            const std::size_t opposite = region ^ 1u;
            const double here = ink_of_glyph(shape.glyph)[region] - wanted;
            const double there = ink_of_glyph(shape.mirrored)[opposite] - wanted;
            error += here * here + there * there;
        }
        if (error < least) {
            least = error;
            nearest = shape.glyph;
        }
    }
    return nearest;
}

// Dots lie in the corners of a cell. They are points above or below, a colon, and the denser the
// more corners have some: grains look alike wherever they lie.
void dots_above_and_below(std::array<char, pattern_count>& table) {
    constexpr std::array<unsigned, 4> corners = {0, 1, 4, 5};
    constexpr std::string_view by_corners = " .:*@";
    for (unsigned levels = 1; levels < 256; ++levels) {
        unsigned pattern = 0;
        std::size_t count = 0;
        for (unsigned i = 0; i < 4; ++i) {
            const unsigned level = levels >> (2 * i) & 3U;
            pattern |= level << (2 * corners[i]);
            count += level != 0 ? 1 : 0;
        }
        const bool is_above = (pattern & 0xfU) == pattern;
        const bool is_below = (pattern & 0xf00U) == pattern;
        if (is_above || is_below)
            table[pattern] = is_below ? '.' : count == 1 ? '\'' : '"';
        else
            table[pattern] = by_corners[count];
    }
}

std::array<char, pattern_count> make_table() {
    std::array<double, 4> ink_of_level{};
    for (std::size_t level = 1; level < 4; ++level) {
        ink_of_level[level] = ink_of_full_region * std::pow(static_cast<double>(level) / 3.0, bend);
    }
    std::array<char, pattern_count> table{};
    for (int pattern = 0; pattern < pattern_count; ++pattern) {
        table[static_cast<std::size_t>(pattern)] =
            nearest_glyph(static_cast<Pattern>(pattern), ink_of_level);
    }
    dots_above_and_below(table);
    return table;
}

}  // namespace

std::span<const RegionInk, printable_count> region_ink() {
    return measured_ink;
}

std::span<const ShapeGlyph> shape_glyphs() {
    return shapes;
}

char glyph_for(Pattern pattern) {
    static const std::array<char, pattern_count> table = make_table();  // 2 ms, once
    return table[pattern];
}

}  // namespace carom

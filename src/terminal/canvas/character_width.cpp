#include "terminal/canvas/character_width.h"

#include <algorithm>
#include <array>

#include "level/text/utf8.h"

namespace carom {

namespace {

struct Range {
    char32_t first;
    char32_t last;
};

// Control characters, combining marks, invisible and bidirectional formatting, and wide characters.
// The ranges follow the blocks of Unicode, which is coarser than wcwidth() but equal on every
// system.
constexpr std::array not_one_column = std::to_array<Range>({
    {0x0000, 0x001F},   {0x007F, 0x009F},   {0x00AD, 0x00AD},   {0x0300, 0x036F},
    {0x0483, 0x0489},   {0x0591, 0x05C7},   {0x0600, 0x0605},   {0x0610, 0x061C},
    {0x064B, 0x065F},   {0x06D6, 0x06DD},   {0x0900, 0x0DFF},   {0x0E31, 0x0E31},
    {0x0E34, 0x0E3A},   {0x0E47, 0x0E4E},   {0x0EB1, 0x0EBC},   {0x0F00, 0x109F},
    {0x1100, 0x11FF},   {0x1AB0, 0x1AFF},   {0x1DC0, 0x1DFF},   {0x200B, 0x200F},
    {0x2028, 0x202E},   {0x2060, 0x206F},   {0x20D0, 0x20FF},   {0x231A, 0x231B},
    {0x23E9, 0x23F3},   {0x25FD, 0x25FE},   {0x2614, 0x2615},   {0x2648, 0x2653},
    {0x26AA, 0x26FF},   {0x2705, 0x2728},   {0x274C, 0x2757},   {0x2795, 0x27BF},
    {0x2E80, 0x303E},   {0x3041, 0xA4CF},   {0xA960, 0xA97F},   {0xAC00, 0xD7FF},
    {0xD800, 0xDFFF},   {0xF900, 0xFAFF},   {0xFE00, 0xFE6F},   {0xFEFF, 0xFEFF},
    {0xFF00, 0xFF60},   {0xFFE0, 0xFFE6},   {0xFFF0, 0xFFFB},   {0xFFFE, 0xFFFF},
    {0x16FE0, 0x18DFF}, {0x1B000, 0x1B2FF}, {0x1F000, 0x1FAFF}, {0x20000, 0x10FFFF},
});

}  // namespace

bool is_one_column(char32_t character) {
    if (character >= 0x20 && character < 0x7F) return true;
    const auto range = std::lower_bound(not_one_column.begin(), not_one_column.end(), character,
                                        [](const Range& r, char32_t c) { return r.last < c; });
    return range == not_one_column.end() || character < range->first;
}

int columns_of(std::string_view text) {
    int columns = 0;
    while (!text.empty()) {
        text.remove_prefix(decode_utf8(text).bytes);
        ++columns;
    }
    return columns;
}

}  // namespace carom

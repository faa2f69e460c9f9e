#include "terminal/canvas/mosaic.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

namespace carom {
namespace {

constexpr std::array<char32_t, 4> half_blocks = {U' ', U'▀', U'▄', U'█'};
constexpr std::array<char32_t, 16> quadrants = {U' ', U'▘', U'▝', U'▀', U'▖', U'▌', U'▞', U'▛',
                                                U'▗', U'▚', U'▐', U'▜', U'▄', U'▙', U'▟', U'█'};

// The patterns of sextants and octants that other characters show; all others follow each other in
// the order of their patterns (Unicode 16, chapter 22.7, and the names of the characters).
struct OlderCharacter {
    unsigned pattern;
    char32_t character;
};
constexpr std::array<OlderCharacter, 4> older_sextants = {
    {{0, U' '}, {21, U'▌'}, {42, U'▐'}, {63, U'█'}}};
constexpr std::array<OlderCharacter, 26> older_octants = {
    {{0, U' '},   {1, 0x1CEA8},  {2, 0x1CEAB},  {3, 0x1FB82},   {5, U'▘'},     {10, U'▝'},
     {15, U'▀'},  {20, 0x1FBE6}, {40, 0x1FBE7}, {63, 0x1FB85},  {64, 0x1CEA3}, {80, U'▖'},
     {85, U'▌'},  {90, U'▞'},    {95, U'▛'},    {128, 0x1CEA0}, {160, U'▗'},   {165, U'▚'},
     {170, U'▐'}, {175, U'▜'},   {192, U'▂'},   {240, U'▄'},    {245, U'▙'},   {250, U'▟'},
     {252, U'▆'}, {255, U'█'}}};

template <std::size_t count, std::size_t older_count>
constexpr std::array<char32_t, count> table_of(
    char32_t first, const std::array<OlderCharacter, older_count>& older) {
    std::array<char32_t, count> table{};
    std::size_t next_older = 0;
    for (std::size_t pattern = 0; pattern < count; ++pattern) {
        if (next_older < older_count && older[next_older].pattern == pattern) {
            table[pattern] = older[next_older++].character;
        } else {
            table[pattern] = first++;
        }
    }
    return table;
}

constexpr std::array sextants = table_of<64>(0x1FB00, older_sextants);
constexpr std::array octants = table_of<256>(0x1CD00, older_octants);
static_assert(sextants[62] == 0x1FB3B && octants[254] == 0x1CDE5);

struct Complement {
    char32_t character = 0;
    char32_t complement = 0;
};

// Sorted by character. Characters in more than one family have the same complement in each.
constexpr auto make_complements() {
    std::array<Complement, sextants.size() + octants.size()> pairs{};
    for (std::size_t i = 0; i < sextants.size(); ++i)
        pairs[i] = {sextants[i], sextants[sextants.size() - 1 - i]};
    for (std::size_t i = 0; i < octants.size(); ++i)
        pairs[sextants.size() + i] = {octants[i], octants[octants.size() - 1 - i]};
    std::ranges::sort(pairs, {}, &Complement::character);
    return pairs;
}

}  // namespace

char32_t half_block(unsigned pattern) {
    assert(pattern < half_blocks.size());
    return half_blocks[pattern];
}

char32_t quadrant(unsigned pattern) {
    assert(pattern < quadrants.size());
    return quadrants[pattern];
}

char32_t sextant(unsigned pattern) {
    assert(pattern < sextants.size());
    return sextants[pattern];
}

char32_t octant(unsigned pattern) {
    assert(pattern < octants.size());
    return octants[pattern];
}

std::optional<char32_t> complement_of(char32_t character) {
    static const auto pairs = make_complements();
    if (character != U' ' && character < U'▀') return std::nullopt;
    const auto found = std::ranges::lower_bound(pairs, character, {}, &Complement::character);
    if (found == pairs.end() || found->character != character) return std::nullopt;
    return found->complement;
}

}  // namespace carom

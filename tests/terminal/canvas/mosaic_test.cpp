#include "terminal/canvas/mosaic.h"

#include <doctest/doctest.h>

#include <set>

#include "terminal/canvas/character_width.h"

using namespace carom;

TEST_CASE("mosaics are the characters of Unicode 16") {
    CHECK(half_block(1) == U'▀');
    CHECK(half_block(2) == U'▄');
    CHECK(quadrant(0b0110) == U'▞');
    CHECK(quadrant(0b1110) == U'▟');
    CHECK(sextant(1) == 0x1FB00);
    CHECK(sextant(0b010101) == U'▌');
    CHECK(sextant(0b010110) == 0x1FB14);  // BLOCK SEXTANT-235
    CHECK(sextant(62) == 0x1FB3B);        // BLOCK SEXTANT-23456
    // Names and code points from UnicodeData.txt of Unicode 16.
    CHECK(octant(0b00000100) == 0x1CD00);  // BLOCK OCTANT-3
    CHECK(octant(0b00000110) == 0x1CD01);  // BLOCK OCTANT-23
    CHECK(octant(0b00000111) == 0x1CD02);  // BLOCK OCTANT-123
    CHECK(octant(0b00001011) == 0x1CD05);  // BLOCK OCTANT-124
    CHECK(octant(0b00011011) == 0x1CD13);  // BLOCK OCTANT-1245
    CHECK(octant(0b11111110) == 0x1CDE5);  // BLOCK OCTANT-2345678
    CHECK(octant(0b00000001) == 0x1CEA8);  // LEFT HALF UPPER ONE QUARTER BLOCK
    CHECK(octant(0b00000010) == 0x1CEAB);  // RIGHT HALF UPPER ONE QUARTER BLOCK
    CHECK(octant(0b01000000) == 0x1CEA3);  // LEFT HALF LOWER ONE QUARTER BLOCK
    CHECK(octant(0b10000000) == 0x1CEA0);  // RIGHT HALF LOWER ONE QUARTER BLOCK
    CHECK(octant(0b00000011) == 0x1FB82);  // UPPER ONE QUARTER BLOCK
    CHECK(octant(0b00111111) == 0x1FB85);  // UPPER THREE QUARTERS BLOCK
    CHECK(octant(0b00010100) == 0x1FBE6);  // MIDDLE LEFT ONE QUARTER BLOCK
    CHECK(octant(0b00101000) == 0x1FBE7);  // MIDDLE RIGHT ONE QUARTER BLOCK
    CHECK(octant(0b11000000) == U'▂');
    CHECK(octant(0b11111100) == U'▆');
    CHECK(octant(0b01011010) == U'▞');
}

TEST_CASE("each pattern has a character of one column of its own, and a complement") {
    std::set<char32_t> seen;
    for (unsigned pattern = 0; pattern < 256; ++pattern) {
        CHECK(seen.insert(octant(pattern)).second);
        CHECK(is_one_column(octant(pattern)));
        CHECK(complement_of(octant(pattern)) == octant(255 - pattern));
    }
    CHECK(seen.size() == 256);
    for (unsigned pattern = 0; pattern < 64; ++pattern) {
        CHECK(is_one_column(sextant(pattern)));
        CHECK(complement_of(sextant(pattern)) == sextant(63 - pattern));
    }
    for (unsigned pattern = 0; pattern < 16; ++pattern)
        CHECK(complement_of(quadrant(pattern)) == quadrant(15 - pattern));
    CHECK(complement_of(U'▀') == U'▄');
    CHECK_FALSE(complement_of(U'a'));
    CHECK_FALSE(complement_of(U'─'));
}

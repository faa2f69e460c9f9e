#include "terminal/canvas/character_width.h"

#include <doctest/doctest.h>

#include <string>

#include "terminal/canvas/canvas.h"

using namespace carom;

TEST_CASE("octants, sextants, quadrants and braille are one column wide on every system") {
    for (const char32_t character :
         {U'\u2596', U'\u28ff', U'\U0001FB00', U'\U0001CD00', U'\U0001CDE5'})
        CHECK(is_one_column(character));
}

TEST_CASE("columns_of agrees with write") {
    for (const std::string text : {"", "abc", "é█", "\xff\xe2\x82"}) {
        Canvas canvas(20, 1);
        CHECK(canvas.write(0, 0, text) == columns_of(text));
    }
}

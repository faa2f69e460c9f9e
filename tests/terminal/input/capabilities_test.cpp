#include "terminal/input/capabilities.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("COLORFGBG") {
    CHECK(light_background_from("15;0") == false);
    CHECK(light_background_from("0;15") == true);
    CHECK(light_background_from("0;default;15") == true);
    CHECK(light_background_from("15;8") == false);
    CHECK(light_background_from("0;7") == true);
    for (const auto text : {"", "7", "15;default", "15;", "0;99", "0;x", "0;-1"}) {
        CHECK_FALSE(light_background_from(text));
    }
}

TEST_CASE("the aspect of a cell, from whole pixels") {
    CHECK(cell_aspect_from(800, 480, 80, 24) == 2.0);
    CHECK(cell_aspect_from(725, 360, 80, 24) == doctest::Approx(15.0 / 9.0));  // padding is ignored
    CHECK_FALSE(cell_aspect_from(0, 0, 80, 24));
    CHECK_FALSE(cell_aspect_from(800, 480, 0, 0));
    CHECK_FALSE(cell_aspect_from(80, 24, 80, 24));
    CHECK_FALSE(cell_aspect_from(160, 4800, 80, 24));
}

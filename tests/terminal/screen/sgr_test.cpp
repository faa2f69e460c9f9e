#include "terminal/screen/sgr.h"

#include <doctest/doctest.h>

#include <string>

using namespace carom;

namespace {

std::string change(const std::optional<SgrStyle>& from, const SgrStyle& to,
                   bool has_own_colors = true) {
    return std::string(style_change(from, to, has_own_colors).text());
}

}  // namespace

TEST_CASE("the style in force costs nothing") {
    CHECK(change(SgrStyle{3, 200, bold}, {3, 200, bold}) == "");
}

TEST_CASE("only changes are sent") {
    CHECK(change(SgrStyle{3, 4, plain}, {5, 4, plain}) == "\033[35m");
    CHECK(change(SgrStyle{3, 4, plain}, {3, 12, plain}) == "\033[104m");
    CHECK(change(SgrStyle{3, 4, plain}, {94, 20, plain}) == "\033[38;5;94;48;5;20m");
    CHECK(change(SgrStyle{3, 4, plain}, {3, 4, bold | underline}) == "\033[1;4m");
    CHECK(change(SgrStyle{}, {direct_color({1, 20, 255}), default_color, dim | reverse}) ==
          "\033[2;7;38;2;1;20;255m");
}

TEST_CASE("an attribute that ends, and an unknown style, start afresh") {
    CHECK(change(SgrStyle{3, 4, bold}, {3, 4, plain}) == "\033[0;33;44m");
    CHECK(change(SgrStyle{3, 4, bold}, {}) == "\033[m");
    CHECK(change(std::nullopt, {}) == "\033[m");
    CHECK(change(std::nullopt, {1, default_color, plain}) == "\033[0;31m");
}

TEST_CASE("the terminal's own colours are restored the shorter way") {
    CHECK(change(SgrStyle{3, 4, plain}, {3, default_color, plain}) == "\033[49m");
    CHECK(change(SgrStyle{3, 4, plain}, {}) == "\033[m");
    CHECK(change(SgrStyle{91, 4, plain}, {91, default_color, plain}) == "\033[49m");
    CHECK(change(SgrStyle{3, 4, plain}, {3, default_color, plain}, false) == "\033[0;33m");
}

TEST_CASE("the longest change fits") {
    const Color widest = direct_color({255, 255, 255});
    CHECK(style_change(std::nullopt, {widest, widest, bold | dim | underline | reverse}, true)
              .size() == 46);
}

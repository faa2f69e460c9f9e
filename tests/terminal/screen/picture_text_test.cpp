#include "terminal/screen/picture_text.h"

#include <doctest/doctest.h>

#include <string>

#include "terminal/canvas/mosaic.h"

using namespace carom;

namespace {

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("ansi: colours change where they do, and each line ends in the terminal's own") {
    Canvas canvas(3, 2);
    canvas.write(0, 0, "ab", 196, default_color, bold);
    CHECK(ansi_of(canvas) ==
          "\x1b[1;38;5;196mab\x1b[m \n"
          "   \n");
}

TEST_CASE("svg: mosaics are shapes, and other characters are text") {
    const Look look{direct_colors, true, false};
    Canvas canvas(4, 1);
    canvas.put(0, 0, {half_block(1), direct_color({255, 0, 0})});
    canvas.put(1, 0, {quadrant(2), direct_color({0, 255, 0})});  // the upper right
    canvas.put(2, 0, {U'<', direct_color({0, 0, 255}), direct_color({1, 2, 3}), bold});
    const std::string svg = svg_of(canvas, look);
    CHECK(has(svg, "viewBox=\"0 0 40 20\""));
    CHECK(has(svg, "<path fill=\"#ff0000\" d=\"M0 0h10v10h-10z\"/>"));
    CHECK(has(svg, "<path fill=\"#00ff00\" d=\"M15 0h5v10h-5z\"/>"));
    CHECK(has(svg, "<path fill=\"#010203\" d=\"M20 0h10v20h-10z\"/>"));
    CHECK(has(svg, "fill=\"#0000ff\" font-weight=\"bold\">&lt;</text>"));
    CHECK_FALSE(has(svg, "▀"));
}

TEST_CASE("svg: braille is dots, and reverse swaps the colours") {
    const Look look{256, true, false};
    Canvas canvas(2, 1);
    canvas.put(0, 0, {0x2881, 21, default_color, plain});  // dots 1 and 8
    canvas.put(1, 0, {U' ', 21, default_color, reverse});
    const std::string svg = svg_of(canvas, look);
    CHECK(has(svg, "<circle cx=\"2.5\" cy=\"2.5\" r=\"1.8\" fill=\"#0000ff\"/>"));
    CHECK(has(svg, "<circle cx=\"7.5\" cy=\"17.5\" r=\"1.8\" fill=\"#0000ff\"/>"));
    CHECK(has(svg, "<path fill=\"#0000ff\" d=\"M10 0h10v20h-10z\"/>"));
}

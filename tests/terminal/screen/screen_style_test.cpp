#include "terminal/screen/screen_style.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "support/emulator.h"

using carom::StyleFilter;
using carom::test::Emulator;

namespace {

// A filter for a terminal that is known to be in no style.
StyleFilter fresh() {
    StyleFilter filter;
    filter.filtered("\033[m.");
    return filter;
}

std::string filtered(std::string_view bytes) {
    return fresh().filtered(bytes);
}

}  // namespace

TEST_CASE("colours are said where they show, and once") {
    CHECK(filtered("\033[38;5;94mx\033[38;5;94my") == "\033[38;5;94mxy");
    CHECK(filtered("\033[38;5;94m\033[48;5;20mx") == "\033[38;5;94;48;5;20mx");
    CHECK(filtered("\033[31mx\033[39m\033(B\033[m   \033[31my") == "\033[31mx   y");
    CHECK(filtered("\033[31mx\033[39m\033(B\033[my") == "\033[31mx\033[my");
    CHECK(filtered("\033[31mx\033[1m\033[39m\033(B\033[m\033[5;5H\033[31my") ==
          "\033[31mx\033[5;5Hy");
    CHECK(filtered("\033[1mx\033(B\033[my") == "\033[1mx\033[my");
    CHECK(filtered("\033[91;104mx\033[91;49my") == "\033[91;104mx\033[49my");
    CHECK(filtered("\033[38:2::1:2:3mx\033[38:2::1:2:3my") == "\033[38:2::1:2:3mxy");
}

TEST_CASE("a style lasts from frame to frame") {
    StyleFilter filter = fresh();
    CHECK(filter.filtered("\033[31mx\033[m") == "\033[31mx");
    CHECK(filter.filtered("\033[31my\033[m") == "y");
    filter.forget();
    CHECK(filter.filtered("\033[31mz\033[m") == "\033[0;31mz");
}

TEST_CASE("what is blanked takes the background that was asked for") {
    CHECK(filtered("\033[41mx\033[m\033[K") == "\033[41mx\033[m\033[K");
    CHECK(filtered("\033[31mx\033[m\033[K") == "\033[31mx\033[K");
    CHECK(filtered("\033[41m\033[5X") == "\033[41m\033[5X");
    CHECK(filtered("\033[7mx\033[m\033[K") == "\033[7mx\033[m\033[K");
}

TEST_CASE("what scrolls in takes the background that was asked for") {
    for (const std::string scroll :
         {"\033[3;9r\033[9;1H\n\033[1;24r", "\033[3;9r\033[3;1H\033M\033[1;24r", "\033D", "\033E",
          "\033[2S", "\033[2T"}) {
        const std::string after = filtered("\033[41mx\033[m" + scroll);
        CAPTURE(after);
        CHECK(after.find("\033[m") < after.find_first_of("\nMDEST"));
    }
}

TEST_CASE("blanks that do show something") {
    CHECK(filtered("\033[4m ") == "\033[4m ");
    CHECK(filtered("\033[7m ") == "\033[7m ");
    CHECK(filtered("\033[4mx\033[m ") == "\033[4mx\033[m ");
}

TEST_CASE("twins") {
    CHECK(filtered("\033[31;42m\u2580\033[32;41m\u2584") == "\033[31;42m\u2580\u2580");
    CHECK(filtered("\033[31m\u2588\033[31;41m\u2588") == "\033[41m  ");
    CHECK(filtered("\033[31;42mx\033[32;49m\u2588") == "\033[31;42mx ");
    // A block may leave a seam where a blank does not.
    CHECK(filtered("\033[31;42mx\033[33;41m ") == "\033[31;42mx\033[41m ");
    // With the terminal's own colour there is no exchange.
    CHECK(filtered("\033[31m\u2580\033[39;41m\u2584") == "\033[31m\u2580\033[0;41m\u2584");
}

TEST_CASE("what is not understood passes through, and is not relied on") {
    CHECK(filtered("\033[3mx") == "\033[3m\033[mx");
    CHECK(filtered("\033[31mx\033[58;5;1my") == "\033[31mx\033[58;5;1m\033[0;31my");
    CHECK(filtered("\033]0;title\007x\033)0\033=") == "\033]0;title\007x\033)0\033=");
    CHECK(filtered("a\r\n\bb\033[3;4Hc\033[5b") == "a\r\n\bb\033[3;4Hc\033[5b");
}

TEST_CASE("a terminal without 39 and 49 is reset instead") {
    StyleFilter filter(false);
    CHECK(filter.filtered("\033[31;42mx\033[31;49my") == "\033[0;31;42mx\033[0;31my");
}

TEST_CASE("random styles look the same, filtered or not") {
    std::uint64_t state = 3;
    const auto random = [&](int below) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<int>((state >> 33) % static_cast<std::uint64_t>(below));
    };
    const std::string_view glyphs[] = {" ", " ", "x", "\u2588", "\u2580", "\u2584", "\u28ff"};
    const auto nothing = [](std::string_view) {};
    Emulator plain(40, 10, {}, nothing);
    Emulator thrifty(40, 10, {}, nothing);
    StyleFilter filter;
    std::size_t bytes_before = 0;
    std::size_t bytes_after = 0;
    for (int frame = 0; frame < 300; ++frame) {
        std::string bytes;
        for (int i = 0; i < 60; ++i) {
            switch (random(12)) {
                case 0:
                    bytes += fmt::format("\033[{};{}H", 1 + random(10), 1 + random(40));
                    break;
                case 1:
                    bytes += fmt::format("\033[38;5;{}m", 16 + random(3));
                    break;
                case 2:
                    bytes += fmt::format("\033[48;5;{}m", 16 + random(3));
                    break;
                case 3:
                    bytes += fmt::format("\033[{}m", 31 + random(2));
                    break;
                case 4:
                    bytes += fmt::format("\033[{}m", 101 + random(2));
                    break;
                case 5:
                    bytes += "\033[39;49m\033(B\033[m";
                    break;
                case 6:
                    bytes += random(4) == 0 ? "\033[7m" : "\033[49m";
                    break;
                case 7:
                    bytes += random(4) == 0 ? "\033[1m" : "\033[39m";
                    break;
                case 8:
                    bytes += random(4) == 0 ? "\033[K" : random(2) == 0 ? "\033[3X" : "";
                    break;
                default:
                    bytes += glyphs[random(7)];
                    break;
            }
        }
        bytes += "\033[39;49m\033(B\033[m";
        const std::string fewer = filter.filtered(bytes);
        bytes_before += bytes.size();
        bytes_after += fewer.size();
        plain.write(bytes);
        thrifty.write(fewer);
    }
    CHECK(bytes_after < bytes_before * 3 / 4);
    for (int row = 0; row < 10; ++row) {
        for (int column = 0; column < 40; ++column) {
            CHECK(described(plain.look(column, row)) == described(thrifty.look(column, row)));
        }
    }
}

#include "terminal/input/known_terminals.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("a terminal draws the mosaics of its version") {
    const auto mosaic = [](std::string_view version) { return traits_of(version).mosaic; };
    CHECK(mosaic("kitty(0.40.1)") == Mosaic::octants);
    CHECK(mosaic("kitty(0.39.0)") == Mosaic::sextants);
    CHECK(mosaic("ghostty 1.2.0") == Mosaic::octants);
    CHECK(mosaic("ghostty 1.1.3") == Mosaic::sextants);
    CHECK(mosaic("foot(1.20.2-g1234)") == Mosaic::octants);
    CHECK(mosaic("foot(1.13.1)") == Mosaic::sextants);
    CHECK(mosaic("VTE(7803)") == Mosaic::octants);
    CHECK(mosaic("VTE(7006)") == Mosaic::sextants);
    CHECK(mosaic("WezTerm 20240203-110809-5046fc22") == Mosaic::sextants);
    CHECK(mosaic("XTerm(379)") == Mosaic::halves);
    CHECK(mosaic("Konsole 22.12.3") == Mosaic::halves);
    for (const std::string_view unknown : {"", "tmux 3.6", "kitty", "kitty 0", "footnote(9.9)"})
        CHECK(mosaic(unknown) == Mosaic::halves);
    CHECK(traits_of("Konsole 22.12.3").has_direct_colors);
    CHECK_FALSE(traits_of("tmux 3.4").has_direct_colors);
    CHECK(traits_of("XTerm(379)").has_overhang);
    CHECK_FALSE(traits_of("kitty(0.40.1)").has_overhang);
}

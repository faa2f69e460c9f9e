#include "terminal/panels/energy.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace carom;

TEST_CASE("a history covers all of the time in a bounded number of samples") {
    EnergyHistory history;
    for (std::uint64_t tick = 0; tick < 100000; ++tick) {
        history.add({tick, static_cast<double>(tick), 0.0});
        REQUIRE(history.samples().size() < EnergyHistory::capacity);
    }
    const auto& samples = history.samples();
    CHECK(samples.size() >= EnergyHistory::capacity / 4);
    CHECK(samples.front().tick == 0);
    CHECK(samples.back().tick > 99000);
    for (std::size_t i = 1; i < samples.size(); ++i) {
        CHECK(samples[i].tick > samples[i - 1].tick);
    }
}

TEST_CASE("a rewind drops later samples") {
    EnergyHistory history;
    for (std::uint64_t tick = 0; tick <= 100; ++tick)
        history.add({tick, 1.0, 0.0});
    history.add({40, 2.0, 0.0});
    CHECK(history.samples().back().tick == 40);
    history.clear();
    CHECK(history.samples().empty());
    history.add({7, 1.0, 0.0});
    CHECK(history.samples().size() == 1);
}

TEST_CASE("a falling ball turns potential into kinetic energy, in ASCII") {
    EnergyHistory history;
    for (std::uint64_t tick = 0; tick <= 100; ++tick) {
        const double share = static_cast<double>(tick) / 100.0;
        history.add({tick, 50.0 * share, 50.0 - 50.0 * share});
    }
    Canvas canvas(40, 10);
    draw_energy(canvas, {0, 0, 40, 10}, history, 0.01, {0, false, false});
    CHECK("\n" + canvas.text() == R"(
energy  kinetic  potential  total
50 `-----------------------------------'
       `--._                   _.-''
            `--__         _.-''
                ``-.__.--'
                _.--'``-._
            _--''         `--._
       _.-''                   `--._
0  .-''                            ``--.
   0 s                               1 s
)");
}

TEST_CASE("empty histories, small panels and numbers that are not finite do no harm") {
    EnergyHistory history;
    Canvas canvas(40, 10);
    draw_energy(canvas, {0, 0, 40, 10}, history, 0.01, {});
    history.add({0, std::nan(""), 1.0});
    history.add({1, HUGE_VAL, 1.0});
    history.add({2, 1.0, -1e300});
    for (const CellArea area :
         {CellArea{0, 0, 40, 10}, CellArea{0, 0, 16, 4}, CellArea{0, 0, 3, 3}}) {
        draw_energy(canvas, area, history, 0.01, {});
    }
    CHECK(canvas.text().find("energy") != std::string::npos);
}

#include "terminal/input/key_repeat.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

using namespace carom;
using enum KeyRepeat::Meaning;

namespace {

/// A keyboard at a terminal, and the link that its keys come through.
struct Terminal {
    std::string name;
    double delay = 0.5;
    double period = 1.0 / 30.0;
    double jitter = 0.0;  ///< the most by which an arrival is late, s
};

const Terminal terminals[] = {
    {"macOS, Windows", 0.25, 1.0 / 30.0},       {"GNOME", 0.5, 1.0 / 30.0},
    {"xterm, Xvfb", 0.66, 1.0 / 25.0},          {"Linux console", 0.25, 1.0 / 10.9},
    {"GNOME over SSH", 0.5, 1.0 / 30.0, 0.03},  {"macOS over SSH", 0.25, 1.0 / 30.0, 0.03},
    {"xterm over SSH", 0.66, 1.0 / 25.0, 0.04},
};

/// The arrivals of a key that is held from `start` for `length` s, in order.
std::vector<double> arrivals(const Terminal& terminal, double start, double length) {
    std::vector<double> times{start};
    std::uint32_t dice = 12345;
    for (int i = 0; terminal.delay + i * terminal.period < length; ++i) {
        dice = dice * 1664525U + 1013904223U;
        const double late = terminal.jitter * (dice >> 8) / 16777216.0;
        const double time = start + terminal.delay + i * terminal.period + late;
        times.push_back(std::max(time, times.back()));
    }
    return times;
}

}  // namespace

TEST_CASE("a key that is held is not let go before a repeat can have come") {
    for (const Terminal& terminal : terminals) {
        CAPTURE(terminal.name);
        KeyRepeat keys;
        double start = 0.0;
        for (int hold = 0; hold < 4; ++hold, start += 5.0) {
            CAPTURE(hold);
            const std::vector<double> times = arrivals(terminal, start, 3.0);
            CHECK(keys.take(U'z', times.front()) == press);
            for (std::size_t i = 1; i < times.size(); ++i) {
                CAPTURE(i);
                CHECK(keys.may_be_held_until() > times[i]);
                CHECK(keys.take(U'z', times[i]) == repeat);
            }
        }
    }
}

TEST_CASE("one hold teaches the delay and the period") {
    for (const Terminal& terminal : terminals) {
        CAPTURE(terminal.name);
        KeyRepeat keys;
        CHECK_FALSE(keys.times().has_value());
        for (const double time : arrivals(terminal, 1.0, 2.0))
            keys.take(U'z', time);
        REQUIRE(keys.times().has_value());
        CHECK(std::abs(keys.times()->delay - terminal.delay) <= terminal.jitter + 1e-9);
        CHECK(std::abs(keys.times()->period - terminal.period) <= terminal.jitter / 4.0 + 1e-9);
        // So a tap is up little longer than it must be, and a hold ends soon after its last repeat.
        keys.take(U'/', 100.0);
        CHECK(keys.tap_length() < terminal.delay + 0.05 + 3.0 * terminal.jitter);
        double last = 0.0;
        for (const double time : arrivals(terminal, 200.0, 2.0))
            keys.take(U'/', last = time);
        CHECK(keys.may_be_held_until() - last < terminal.period + 0.05 + 3.0 * terminal.jitter);
    }
}

TEST_CASE("once the terminal is known, quick taps are presses") {
    for (const Terminal& terminal : terminals) {
        CAPTURE(terminal.name);
        KeyRepeat keys;
        keys.remember({terminal.delay, terminal.period});
        double time = 10.0;
        for (const double gap : {0.12, 0.15, 0.11, 0.17, 0.12, 0.14, 0.12, 0.13, 0.12}) {
            CHECK(keys.take(U'z', time) == press);
            time += gap;
        }
        REQUIRE(keys.times().has_value());
        CHECK(keys.times()->delay == terminal.delay);
    }
}

TEST_CASE("a key that was held and is pressed again 0.2 s later may be held as long as any") {
    const Terminal xterm{"xterm", 0.66, 1.0 / 25.0};
    KeyRepeat keys;
    const std::vector<double> times = arrivals(xterm, 1.0, 2.0);
    for (const double time : times)
        keys.take(U'z', time);
    const double again = times.back() + 0.2;
    CHECK(keys.take(U'z', again) == press);
    CHECK(keys.may_be_held_until() > again + xterm.delay);
    // A repeat that is late by a period is none.
    CHECK(keys.take(U'z', again + xterm.delay) == repeat);
    CHECK(keys.take(U'z', again + xterm.delay + 2.0 * xterm.period) == repeat);
}

TEST_CASE("what was remembered of another terminal is replaced after one hold") {
    for (const Terminal& before : terminals)
        for (const Terminal& now : terminals) {
            CAPTURE(before.name);
            CAPTURE(now.name);
            KeyRepeat keys;
            keys.remember({before.delay, before.period});
            int presses = 0;
            for (const double time : arrivals(now, 1.0, 2.0))
                presses += keys.take(U'z', time) == press ? 1 : 0;
            CHECK(presses <= 2);  // the first, and the first repeat at most
            CHECK(std::abs(keys.times()->delay - now.delay) <= now.jitter + 1e-9);
            // What is remembered does not replace what was observed.
            keys.remember({9.0, 9.0});
            CHECK(keys.times()->delay < 1.0);
        }
}

TEST_CASE("a key that comes again after another one was pressed anew") {
    KeyRepeat keys;
    CHECK(keys.take(U'z', 0.0) == press);
    CHECK(keys.take(U'/', 0.02) == press);
    CHECK(keys.take(U'/', 0.52) == repeat);
    CHECK(keys.take(U'z', 0.55) == press);
    // Before the first key nothing is held.
    CHECK(KeyRepeat().may_be_held_until() < 0.0);
}

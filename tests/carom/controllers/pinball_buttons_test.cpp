#include "carom/controllers/pinball_buttons.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "carom/context/key_map.h"

using namespace carom;

namespace {

InputEvent typed(char32_t code, InputEvent::Action action = InputEvent::Action::press) {
    InputEvent event;
    event.key = code;
    event.action = action;
    return event;
}

std::optional<Button> button_of(const InputEvent& event) {
    return KeyMap().button_of(key_of(event));
}

/// The buttons of the default keys.
struct Keyboard : PinballButtons {
    using PinballButtons::take;
    std::vector<command::Press> take(const InputEvent& event) {
        const auto button = button_of(event);
        return button ? take(*button, event) : std::vector<command::Press>{};
    }
};

}  // namespace

TEST_CASE("with key releases, a flipper is up exactly while its key is down") {
    Keyboard keys;
    // The first release shows that releases are reported.
    keys.take(typed(U'z'));
    keys.take(typed(U'z', InputEvent::Action::release));
    REQUIRE(keys.tells_release());
    const auto pressed = keys.take(typed(U'/'));
    REQUIRE(pressed.size() == 1);
    CHECK(pressed[0].button == Button::right_flipper);
    CHECK(pressed[0].is_down);
    CHECK(keys.pass(5.0).empty());
    CHECK(keys.take(typed(U'/', InputEvent::Action::repeat)).empty());
    const auto released = keys.take(typed(U'/', InputEvent::Action::release));
    REQUIRE(released.size() == 1);
    CHECK_FALSE(released[0].is_down);
}

namespace {

/// Plays keys in real time at a terminal without key releases, and notes what the buttons do.
struct Script {
    struct Change {
        double time;
        Button button;
        bool is_down;
    };
    double delay;
    double period;
    Keyboard keys{};
    std::vector<Change> changes{};
    double now = 0.0;
    bool is_paused = false;

    void note(const std::vector<command::Press>& presses) {
        for (const command::Press& press : presses)
            changes.push_back({now, press.button, press.is_down});
    }
    void arrive(char32_t key) { note(keys.take(typed(key))); }
    /// Lets time pass in frames of 1/60 s or less.
    void pass(double seconds) {
        for (const double end = now + seconds; now < end - 1e-9;) {
            const double step = std::min(end - now, 1.0 / 60.0);
            now += step;
            note(keys.pass(step, is_paused));
        }
    }
    /// Holds a key: its press and its repeats.
    void hold(char32_t key, double seconds) {
        arrive(key);
        double at = delay;
        double passed = 0.0;
        for (; at < seconds; at += period) {
            pass(at - passed);
            passed = at;
            arrive(key);
        }
        pass(seconds - passed);
    }
    /// The terminal is known, and nothing is held.
    Script& learn() {
        keys.remember({delay, period});
        pass(1.0);
        changes.clear();
        return *this;
    }
};

const Script terminals[] = {{0.25, 1.0 / 30.0}, {0.5, 1.0 / 30.0}, {0.66, 1.0 / 25.0}};

}  // namespace

TEST_CASE("issue 20: a held flipper does not drop while the terminal waits to repeat") {
    for (const Script& terminal : terminals) {
        CAPTURE(terminal.delay);
        for (const bool is_known : {false, true}) {
            Script script = terminal;
            if (is_known) script.learn();
            const double start = script.now;
            script.hold(U'z', 3.0);
            script.pass(1.0);
            REQUIRE(script.changes.size() == 2);
            CHECK(script.changes[0].time == start);
            CHECK(script.changes[1].time > start + 3.0 - script.period);
            CHECK(script.changes[1].time < start + 3.15);
        }
    }
}

TEST_CASE("issue 20: a held plunger is not let go while the terminal waits to repeat") {
    Script script{0.66, 1.0 / 25.0};
    script.hold(key::enter, 2.0);
    script.pass(1.0);
    REQUIRE(script.changes.size() == 2);
    CHECK(script.changes[1].button == Button::plunger);
    CHECK(script.changes[1].time > 1.9);
}

TEST_CASE("a frame that is still to come does not let a key go early") {
    Keyboard keys;
    keys.remember({0.5, 0.03});
    InputEvent event = typed(U'z');
    event.after = 0.1;  // frames of a tenth of a second
    CHECK(keys.take(event).size() == 1);
    CHECK(keys.pass(0.1).empty());
    CHECK(keys.pass(0.5).empty());
    CHECK(keys.pass(0.1).size() == 1);
}

TEST_CASE("both flippers stay up while the later key is held, and come down together") {
    for (const double between : {0.0, 0.02, 0.3, 1.5}) {
        CAPTURE(between);
        Script script{0.5, 1.0 / 30.0};
        script.learn();
        script.hold(U'z', between);
        const double start = script.now;
        script.hold(U'/', 2.0);
        script.pass(1.0);
        REQUIRE(script.changes.size() == 4);
        CHECK(script.changes[1].is_down);
        CHECK(script.changes[2].time > start + 1.9);
        CHECK(script.changes[2].time == script.changes[3].time);
    }
}

TEST_CASE("a nudge does not drop the flipper that holds a ball") {
    Script script{0.5, 1.0 / 30.0};
    script.learn();
    script.hold(U'z', 1.0);
    script.arrive(U'x');
    script.pass(0.4);
    REQUIRE(script.changes.size() == 2);
    CHECK(script.changes[1].button == Button::nudge_left);
    script.pass(1.0);
    CHECK(script.changes.size() == 4);
}

TEST_CASE("a flipper that is pressed while it is up drops for a moment and flips again") {
    Script script{0.66, 1.0 / 25.0};
    script.learn();
    const double start = script.now;
    for (int tap = 0; tap < 3; ++tap) {
        script.arrive(U'z');
        script.pass(0.2);
    }
    REQUIRE(script.changes.size() == 5);
    for (std::size_t i = 0; i < script.changes.size(); ++i)
        CHECK(script.changes[i].is_down == (i % 2 == 0));
    CHECK(script.changes[1].time == doctest::Approx(start + 0.2));
    CHECK(script.changes[2].time < start + 0.28);
    // Another flipper that is pressed does not drop it.
    script.arrive(U'/');
    CHECK(script.changes.size() == 6);
}

TEST_CASE("a flipper that holds a ball outlasts a pause, and its key takes it over") {
    Script script{0.5, 1.0 / 30.0};
    script.learn();
    script.hold(U'z', 1.0);
    REQUIRE(script.changes.size() == 1);
    script.arrive(U' ');
    script.is_paused = true;
    script.pass(5.0);
    script.is_paused = false;
    script.arrive(U' ');
    script.pass(3.0);
    CHECK(script.changes.size() == 1);
    script.hold(U'z', 1.0);
    CHECK(script.changes.size() == 1);
    script.pass(1.0);
    REQUIRE(script.changes.size() == 2);
    CHECK_FALSE(script.changes[1].is_down);
    // A tap does not hold anything.
    script.arrive(U'/');
    script.pass(0.2);
    script.is_paused = true;
    script.arrive(U' ');
    script.pass(2.0);
    CHECK(script.changes.size() == 4);
}

TEST_CASE("a second tap lets the plunger go, and its repeats do nothing") {
    Script script{0.66, 1.0 / 25.0};
    script.learn();
    script.arrive(key::enter);
    script.pass(0.3);
    script.hold(key::enter, 2.0);
    script.pass(1.0);
    REQUIRE(script.changes.size() == 2);
    CHECK_FALSE(script.changes[1].is_down);
    CHECK(script.changes[1].time - script.changes[0].time == doctest::Approx(0.3));
    // A nudge nudges again.
    script.arrive(U'x');
    script.pass(0.2);
    script.arrive(U'x');
    CHECK(script.changes.size() == 5);
}

TEST_CASE("other keys do not belong to the table") {
    Keyboard keys;
    CHECK(keys.take(typed(U'q')).empty());
    CHECK_FALSE(button_of(typed(U'?')).has_value());
    InputEvent shifted = typed(key::left);
    shifted.modifiers = shift;
    CHECK_FALSE(button_of(shifted).has_value());
    CHECK(button_of(typed(key::enter)) == Button::plunger);
}

TEST_CASE("in toggle mode, a press raises a flipper and the next lowers it") {
    Keyboard keys;
    keys.set_toggles(true);
    CHECK(keys.take(typed(U'z')).size() == 1);
    CHECK(keys.take(typed(U'z', InputEvent::Action::repeat)).empty());
    CHECK(keys.take(typed(U'z', InputEvent::Action::release)).empty());
    CHECK(keys.pass(9.0).empty());
    const auto lowered = keys.take(typed(U'z'));
    REQUIRE(lowered.size() == 1);
    CHECK_FALSE(lowered[0].is_down);
    // The plunger does not toggle.
    CHECK(keys.take(typed(key::enter)).size() == 1);
}

TEST_CASE("a mouse button holds until it is released, whatever the keys do") {
    Keyboard keys;
    CHECK(keys.press_mouse(1, Button::left_flipper).size() == 1);
    CHECK(keys.press_mouse(3, Button::right_flipper).size() == 1);
    CHECK(keys.has_mouse());
    CHECK(keys.pass(9.0).empty());
    const auto released = keys.release_mouse(3);
    REQUIRE(released.size() == 1);
    CHECK(released[0].button == Button::right_flipper);
    // A terminal that does not report which button.
    CHECK(keys.release_mouse(0).size() == 1);
    CHECK_FALSE(keys.has_mouse());
}

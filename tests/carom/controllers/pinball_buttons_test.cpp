#include "carom/controllers/pinball_buttons.h"

#include <doctest/doctest.h>

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

/// The buttons under the default keys.
struct Keyboard : PinballButtons {
    using PinballButtons::take;
    std::vector<command::Press> take(const InputEvent& event) {
        const auto button = button_of(event);
        return button ? take(*button, event) : std::vector<command::Press>{};
    }
};

}  // namespace

TEST_CASE("where keys tell their release, a flipper is up exactly as long as its key is down") {
    Keyboard keys;
    // The first key teaches that releases are told.
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

TEST_CASE("elsewhere a press holds for a set time, and repeats hold on") {
    Keyboard keys;
    CHECK(keys.take(typed(key::left)).size() == 1);
    CHECK(keys.pass(0.1).empty());
    CHECK(keys.pass(0.11).size() == 1);
    // The terminal begins to repeat, 30 times a second.
    CHECK(keys.take(typed(key::left)).size() == 1);
    for (int i = 0; i < 30; ++i) {
        CHECK(keys.pass(0.033).empty());
        CHECK(keys.take(typed(key::left)).empty());
    }
    CHECK(keys.pass(0.1).empty());
    CHECK(keys.pass(0.1).size() == 1);
}

TEST_CASE("other keys are not the table's") {
    Keyboard keys;
    CHECK(keys.take(typed(U'q')).empty());
    CHECK_FALSE(button_of(typed(U'?')).has_value());
    InputEvent shifted = typed(key::left);
    shifted.modifiers = shift;
    CHECK_FALSE(button_of(shifted).has_value());
    CHECK(button_of(typed(key::enter)) == Button::plunger);
}

TEST_CASE("where flippers toggle, a press raises one and the next lowers it") {
    Keyboard keys;
    keys.set_toggles(true);
    CHECK(keys.take(typed(U'z')).size() == 1);
    CHECK(keys.take(typed(U'z', InputEvent::Action::repeat)).empty());
    CHECK(keys.take(typed(U'z', InputEvent::Action::release)).empty());
    CHECK(keys.pass(9.0).empty());
    const auto lowered = keys.take(typed(U'z'));
    REQUIRE(lowered.size() == 1);
    CHECK_FALSE(lowered[0].is_down);
    // The plunger does not.
    CHECK(keys.take(typed(key::enter)).size() == 1);
}

TEST_CASE("a button of the mouse holds until it is let go, whatever keys do") {
    Keyboard keys;
    CHECK(keys.press_mouse(1, Button::left_flipper).size() == 1);
    CHECK(keys.press_mouse(3, Button::right_flipper).size() == 1);
    CHECK(keys.has_mouse());
    CHECK(keys.pass(9.0).empty());
    const auto released = keys.release_mouse(3);
    REQUIRE(released.size() == 1);
    CHECK(released[0].button == Button::right_flipper);
    // A terminal that does not say which.
    CHECK(keys.release_mouse(0).size() == 1);
    CHECK_FALSE(keys.has_mouse());
}

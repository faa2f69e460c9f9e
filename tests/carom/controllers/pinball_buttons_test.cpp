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

TEST_CASE("without key releases, a press holds for a set time, and repeats extend it") {
    Keyboard keys;
    CHECK(keys.take(typed(key::left)).size() == 1);
    CHECK(keys.pass(0.1).empty());
    CHECK(keys.pass(0.11).size() == 1);
    // The terminal starts to repeat, 30 times a second.
    CHECK(keys.take(typed(key::left)).size() == 1);
    for (int i = 0; i < 30; ++i) {
        CHECK(keys.pass(0.033).empty());
        CHECK(keys.take(typed(key::left)).empty());
    }
    CHECK(keys.pass(0.1).empty());
    CHECK(keys.pass(0.1).size() == 1);
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

#include "terminal/input/mouse.h"

namespace carom {
namespace {

constexpr int shift_bit = 4;
constexpr int alt_bit = 8;
constexpr int control_bit = 16;
constexpr int motion_bit = 32;
constexpr int wheel_bit = 64;
constexpr int extra_bit = 128;

std::uint8_t modifiers_of_buttons(int buttons) {
    int modifiers = no_modifier;
    if ((buttons & shift_bit) != 0) modifiers |= shift;
    if ((buttons & alt_bit) != 0) modifiers |= alt;
    if ((buttons & control_bit) != 0) modifiers |= control;
    return static_cast<std::uint8_t>(modifiers);
}

// 1 left, 2 middle, 3 right, 0 none.
std::uint8_t button_in(int buttons) {
    return static_cast<std::uint8_t>(((buttons & 3) + 1) % 4);
}

std::optional<InputEvent> event_in(int buttons, bool is_release) {
    using enum InputEvent::Action;
    if ((buttons & extra_bit) != 0) return std::nullopt;
    InputEvent event;
    event.kind = InputEvent::Kind::mouse;
    event.modifiers = modifiers_of_buttons(buttons);
    if ((buttons & wheel_bit) != 0) {
        if (is_release || (buttons & 3) > 1) return std::nullopt;
        event.action = (buttons & 3) == 0 ? wheel_up : wheel_down;
        return event;
    }
    event.button = button_in(buttons);
    event.action = (buttons & motion_bit) != 0 ? move : is_release ? release : press;
    return event;
}

}  // namespace

std::optional<InputEvent> mouse_event(const ControlSequence& sequence, const MouseUnit& unit) {
    const bool is_report =
        sequence.prefix == '<' && (sequence.final == 'M' || sequence.final == 'm');
    const int x = sequence.number(1, -1);
    const int y = sequence.number(2, -1);
    const int buttons = sequence.number(0, -1);
    if (!is_report || buttons < 0 || x < 0 || y < 0) return std::nullopt;
    auto event = event_in(buttons, sequence.final == 'm');
    if (!event) return std::nullopt;
    event->column = (x - 0.5) / unit.wide;
    event->row = (y - 0.5) / unit.high;
    return event;
}

std::optional<InputEvent> old_mouse_event(int buttons, int x, int y, std::uint8_t held) {
    constexpr int offset = 32;
    const int bits = buttons - offset;
    if (bits < 0 || x <= offset || y <= offset) return std::nullopt;
    const bool is_release = (bits & 3) == 3 && (bits & (motion_bit | wheel_bit)) == 0;
    auto event = event_in(bits, is_release);
    if (!event) return std::nullopt;
    if (is_release) event->button = held;
    event->column = x - offset - 0.5;
    event->row = y - offset - 0.5;
    return event;
}

}  // namespace carom

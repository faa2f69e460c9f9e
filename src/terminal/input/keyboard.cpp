#include "terminal/input/keyboard.h"

#include <algorithm>

namespace carom {
namespace {

// Modifiers are encoded as 1 plus a sum: 1 Shift, 2 Alt, 4 Ctrl, 8 Super, 16 Hyper, 32 Meta, 64 and
// 128 the locks.
std::uint8_t modifiers_in(int parameter) {
    const int bits = std::max(0, parameter - 1);
    int modifiers = no_modifier;
    if ((bits & 1) != 0) modifiers |= shift;
    if ((bits & (2 | 8 | 16 | 32)) != 0) modifiers |= alt;
    if ((bits & 4) != 0) modifiers |= control;
    return static_cast<std::uint8_t>(modifiers);
}

InputEvent::Action action_in(int parameter) {
    using enum InputEvent::Action;
    return parameter == 3 ? release : parameter == 2 ? repeat : press;
}

// CSI or SS3 followed by a letter.
char32_t key_of_letter(char final) {
    switch (final) {
        case 'A':
            return key::up;
        case 'B':
            return key::down;
        case 'C':
            return key::right;
        case 'D':
            return key::left;
        case 'F':
            return key::end;
        case 'H':
            return key::home;
        case 'P':
            return key::f1;
        case 'Q':
            return key::f1 + 1;
        case 'R':
            return key::f1 + 2;
        case 'S':
            return key::f1 + 3;
        default:
            return 0;
    }
}

// CSI number ~
char32_t key_of_number(int number) {
    switch (number) {
        case 1:
        case 7:
            return key::home;
        case 2:
            return key::insert;
        case 3:
            return key::remove;
        case 4:
        case 8:
            return key::end;
        case 5:
            return key::page_up;
        case 6:
            return key::page_down;
        default:
            break;
    }
    const auto function = [&](int first, int name) {
        return key::f1 + static_cast<char32_t>(name - 1 + number - first);
    };
    if (number >= 11 && number <= 15) return function(11, 1);
    if (number >= 17 && number <= 21) return function(17, 6);
    if (number == 23 || number == 24) return function(23, 11);
    return 0;
}

// The codes of the kitty protocol for keys without a character and for the keypad.
char32_t key_of_code(int code) {
    constexpr std::u32string_view keypad = U"0123456789./*-+\r=,";
    constexpr int keypad_start = 57399;
    constexpr char32_t keypad_moves[] = {key::left,    key::right,     key::up,   key::down,
                                         key::page_up, key::page_down, key::home, key::end,
                                         key::insert,  key::remove};
    constexpr int moves_start = 57417;
    constexpr int f13 = 57376;
    if (code >= keypad_start && code < moves_start) {
        return keypad[static_cast<std::size_t>(code - keypad_start)];
    }
    if (code >= moves_start && code < moves_start + 10) return keypad_moves[code - moves_start];
    if (code >= f13 && code <= f13 + 22) return key::f1 + 12 + static_cast<char32_t>(code - f13);
    if (code >= 57344 && code <= 63743) return 0;  // locks, media keys, modifiers alone
    if (code == 127) return key::backspace;
    return static_cast<char32_t>(code);
}

std::optional<InputEvent> key_event(char32_t key, const ControlSequence& sequence) {
    if (key == 0) return std::nullopt;
    InputEvent event;
    event.key = key;
    event.modifiers = modifiers_in(sequence.number(1, 1));
    event.action = action_in(sequence.number(1, 1, 1));
    return event;
}

bool is_letter(char32_t character) {
    return character >= U'a' && character <= U'z';
}

// Whether a code point types itself: it is neither a control character nor one of key::.
bool is_text(char32_t character) {
    return character >= U' ' && character != 0x7f && !(character >= 0x80 && character < 0xa0) &&
           character < key::up;
}

void drop_shift(InputEvent& event) {
    event.modifiers &= static_cast<std::uint8_t>(~shift);
}

}  // namespace

void KeyTable::add(std::string_view sequence, char32_t key, std::uint8_t modifiers) {
    if (sequence.size() < 2 || sequence.front() != '\033') return;
    const auto place = std::ranges::lower_bound(entries_, sequence, {}, &Entry::sequence);
    if (place != entries_.end() && place->sequence == sequence) return;
    entries_.insert(place, Entry{std::string(sequence), key, modifiers});
}

std::optional<InputEvent> KeyTable::find(std::string_view sequence) const {
    const auto place = std::ranges::lower_bound(entries_, sequence, {}, &Entry::sequence);
    if (place == entries_.end() || place->sequence != sequence) return std::nullopt;
    InputEvent event;
    event.key = place->key;
    event.modifiers = place->modifiers;
    return event;
}

std::optional<InputEvent> Keyboard::from_sequence(const ControlSequence& sequence) {
    if (sequence.prefix != 0 || !sequence.intermediates.empty()) return std::nullopt;
    if (sequence.final == 'u') return from_code(sequence);
    if (sequence.final == 'Z') {
        InputEvent event;
        event.key = key::backtab;
        return event;
    }
    if (sequence.final == '~' && sequence.number(0) == 27) {  // xterm's modifyOtherKeys
        ControlSequence other;
        other.final = 'u';
        other.parameters =
            std::to_string(sequence.number(2)) + ';' + std::to_string(sequence.number(1, 1));
        return from_code(other);
    }
    if (sequence.final == '~') return key_event(key_of_number(sequence.number(0)), sequence);
    return key_event(key_of_letter(sequence.final), sequence);
}

std::optional<InputEvent> Keyboard::from_code(const ControlSequence& sequence) {
    const int code = sequence.number(0);
    auto event = key_event(key_of_code(code), sequence);
    if (!event) return std::nullopt;
    if (event->key == key::tab && (event->modifiers & shift) != 0) {
        event->key = key::backtab;
        drop_shift(*event);
    }
    if (!is_text(event->key)) return event;

    const auto held = std::ranges::find(made_, code, &std::pair<int, char32_t>::first);
    if (event->action == InputEvent::Action::release) {
        if (held == made_.end()) return event;
        event->key = held->second;
        made_.erase(held);
        drop_shift(*event);
        return event;
    }
    const auto text = static_cast<char32_t>(sequence.number(2));
    if (is_text(text) && (event->modifiers & (alt | control)) == 0) {
        event->key = text;
    } else if (is_letter(event->key) && (event->modifiers & ~alt) == shift) {
        event->key -= U'a' - U'A';
    } else {
        return event;
    }
    drop_shift(*event);
    constexpr std::size_t most_held = 32;  // bounded, since releases may be lost with the focus
    if (held != made_.end()) made_.erase(held);
    if (made_.size() == most_held) made_.erase(made_.begin());
    made_.emplace_back(code, event->key);
    return event;
}

std::optional<InputEvent> key_from_ss3(char final) {
    constexpr std::string_view keypad = "jklmnopqrstuvwxyX";
    constexpr std::string_view shown = "*+,-./0123456789=";
    InputEvent event;
    event.key = key_of_letter(final);
    const std::size_t place = keypad.find(final);
    if (final == 'M') event.key = key::enter;
    if (place != std::string_view::npos) event.key = static_cast<unsigned char>(shown[place]);
    if (event.key == 0) return std::nullopt;
    return event;
}

InputEvent key_from_character(char32_t character) {
    InputEvent event;
    event.key = character;
    if (character == '\n') event.key = key::enter;
    if (character == '\b' || character == 0x7f) event.key = key::backspace;
    if (character >= U' ' || character == '\r' || character == '\n' || character == '\t' ||
        character == '\b' || character == key::escape) {
        return event;
    }
    event.modifiers = control;
    event.key = character == 0 ? key::space : character + (character < 27 ? U'a' - 1 : U'@');
    return event;
}

}  // namespace carom

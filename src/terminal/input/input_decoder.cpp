#include "terminal/input/input_decoder.h"

#include <utility>

#include "level/text/utf8.h"

namespace carom {
namespace {

constexpr unsigned char escape_byte = 0x1b;
constexpr unsigned char delete_byte = 0x7f;
// Bytes of a command whose text is kept; the rest is discarded.
constexpr std::size_t longest_command = 256;
constexpr std::size_t longest_csi = 128;
constexpr std::string_view paste_end = "\033[201~";

bool is_control(unsigned char byte) {
    return byte < 0x20;
}

}  // namespace

InputDecoder::InputDecoder(bool utf8, KeyTable keys) : keys_(std::move(keys)), is_utf8_(utf8) {}

DecodedInput InputDecoder::feed(std::string_view bytes) {
    for (const char byte : bytes) {
        take(static_cast<unsigned char>(byte));
    }
    return std::exchange(decoded_, {});
}

InputDecoder::Pending InputDecoder::pending() const {
    if (state_ == State::ground) return Pending::nothing;
    return state_ == State::escape ? Pending::escape : Pending::sequence;
}

DecodedInput InputDecoder::flush() {
    const bool is_escape = state_ == State::escape;
    const bool is_character = bytes_.size() == 2 && bytes_[0] == '\033' && state_ != State::paste;
    const bool was_alt = is_alt_;
    const unsigned char character = is_character ? static_cast<unsigned char>(bytes_[1]) : 0;
    begin(State::ground);
    if (was_alt) emit(key_from_character(key::escape));
    if (is_escape) emit(key_from_character(key::escape));
    if (is_character) {
        InputEvent event = key_from_character(character);
        event.modifiers |= alt;
        emit(event);
    }
    return std::exchange(decoded_, {});
}

void InputDecoder::take(unsigned char byte) {
    if (state_ == State::ground) return take_ground(byte);
    if (state_ == State::utf8) return take_utf8(byte);
    if (state_ == State::paste) return take_paste(byte);
    bytes_ += static_cast<char>(byte);
    if (take_from_table()) return;
    switch (state_) {
        case State::escape:
            return take_escape(byte);
        case State::csi:
            return take_csi(byte);
        case State::command:
            return take_command(byte);
        case State::old_mouse:
            return take_old_mouse();
        case State::ss3: {
            if (is_control(byte)) {
                begin(State::ground);
                return take_ground(byte);
            }
            const auto event = key_from_ss3(static_cast<char>(byte));
            if (event) emit(*event);
            return begin(State::ground);
        }
        default:
            return;
    }
}

void InputDecoder::take_ground(unsigned char byte) {
    if (byte == escape_byte) {
        begin(State::escape);
        bytes_ = '\033';
    } else if (byte <= delete_byte) {
        emit(key_from_character(byte));
    } else if (!is_utf8_) {
        if (byte >= 0xa0) emit(key_from_character(byte));
    } else if (sequence_length(static_cast<char>(byte)) > 1) {
        begin(State::utf8);
        bytes_ = static_cast<char>(byte);
    }
}

void InputDecoder::take_utf8(unsigned char byte) {
    if (!continues_sequence(
            static_cast<char>(byte))) {  // interrupted: drop it, and start afresh with this byte
        begin(State::ground);
        return take_ground(byte);
    }
    bytes_ += static_cast<char>(byte);
    const std::string_view character = std::string_view(bytes_).substr(bytes_[0] == '\033' ? 1 : 0);
    if (character.size() < sequence_length(character[0])) return;
    const char32_t decoded = decode_utf8(character).character;
    const bool is_valid = character_length(character) > 0;
    InputEvent event = key_from_character(decoded);
    if (bytes_[0] == '\033') event.modifiers |= alt;
    if (is_valid && decoded >= 0xa0) emit(event);
    begin(State::ground);
}

void InputDecoder::take_escape(unsigned char byte) {
    const auto go_to = [&](State state) { state_ = state; };
    switch (byte) {
        case '[':
            return go_to(State::csi);
        case 'O':
            return go_to(State::ss3);
        case ']':
        case 'P':
        case 'X':
        case '^':
        case '_':
            return go_to(State::command);
        default:
            break;
    }
    if (byte == escape_byte) {
        emit_escape_before();
        is_alt_ = true;
        bytes_ = '\033';
        return;
    }
    if (byte > delete_byte) {
        if (is_utf8_ && sequence_length(static_cast<char>(byte)) > 1) return go_to(State::utf8);
        return begin(State::ground);
    }
    InputEvent event = key_from_character(byte);
    event.modifiers |= alt;
    emit(event);
    begin(State::ground);
}

void InputDecoder::take_csi(unsigned char byte) {
    if (is_control(byte) || byte >= delete_byte) {  // interrupted
        begin(State::ground);
        if (byte < 0x80) take_ground(byte);
        return;
    }
    if (bytes_ == "\033[M") {
        state_ = State::old_mouse;
        return;
    }
    if (bytes_ == "\033[[") return;  // the Linux console's function keys have one more letter
    const bool is_final = byte >= 0x40;
    if (is_final) return finish_csi();
    if (bytes_.size() > longest_csi) bytes_.resize(longest_csi);
}

void InputDecoder::finish_csi() {
    const ControlSequence sequence = parse_control_sequence(std::string_view(bytes_).substr(2));
    const bool was_cut = bytes_.size() > longest_csi;
    if (sequence.prefix == 0 && sequence.final == '~' && sequence.number(0) == 200) {
        return begin(State::paste);
    }
    if (const auto key = was_cut ? std::nullopt : keyboard_.from_sequence(sequence)) {
        emit(*key);
        return begin(State::ground);
    }
    emit_escape_before();
    if (was_cut) {
        // Longer than any known sequence.
    } else if (const auto answer = answer_in(sequence)) {
        decoded_.answers.push_back(*answer);
    } else if (const auto mouse = mouse_event(sequence, mouse_unit_)) {
        emit(*mouse);
    }
    begin(State::ground);
}

// OSC, DCS and similar strings, up to ST (ESC and a backslash) or BEL.
void InputDecoder::take_command(unsigned char byte) {
    constexpr unsigned char bell = 7;
    constexpr unsigned char cancel = 0x18;
    const bool was_escape = bytes_.size() > 3 && bytes_[bytes_.size() - 2] == '\033';
    if (byte == bell || (was_escape && byte == '\\')) return finish_command();
    if (byte == cancel) return begin(State::ground);
    if (was_escape) {  // not ST: another sequence has begun
        begin(State::escape);
        bytes_ = '\033';
        return take(byte);
    }
    if (bytes_.size() > longest_command) bytes_.erase(longest_command - 2, 1);
}

void InputDecoder::finish_command() {
    emit_escape_before();
    const std::size_t terminator = bytes_.back() == '\\' ? 2 : 1;
    if (bytes_.size() < longest_command) {
        const auto body = std::string_view(bytes_).substr(2, bytes_.size() - 2 - terminator);
        const auto answer = bytes_[1] == ']'   ? answer_in_command(body)
                            : bytes_[1] == 'P' ? answer_in_device_control(body)
                                               : std::nullopt;
        if (answer) decoded_.answers.push_back(*answer);
    }
    begin(State::ground);
}

void InputDecoder::take_old_mouse() {
    constexpr std::size_t whole = 6;
    if (bytes_.size() < whole) return;
    emit_escape_before();
    const auto value = [&](std::size_t i) { return int{static_cast<unsigned char>(bytes_[i])}; };
    const auto event = old_mouse_event(value(3), value(4), value(5), held_button_);
    if (event) emit(*event);
    begin(State::ground);
}

void InputDecoder::take_paste(unsigned char byte) {
    bytes_ += static_cast<char>(byte);
    if (bytes_.size() > paste_end.size()) bytes_.erase(0, 1);
    if (bytes_ == paste_end) begin(State::ground);
}

bool InputDecoder::take_from_table() {
    if (state_ == State::command || state_ == State::old_mouse) return false;
    auto event = keys_.find(bytes_);
    if (!event) return false;
    emit(*event);
    begin(State::ground);
    return true;
}

// An ESC right before an answer or a report, which are not keys, was the Escape key.
void InputDecoder::emit_escape_before() {
    if (std::exchange(is_alt_, false)) emit(key_from_character(key::escape));
}

void InputDecoder::begin(State state) {
    state_ = state;
    bytes_.clear();
    is_alt_ = false;
}

void InputDecoder::emit(InputEvent event) {
    if (is_alt_ && event.kind == InputEvent::Kind::key) event.modifiers |= alt;
    if (event.kind == InputEvent::Kind::mouse && event.action == InputEvent::Action::press) {
        held_button_ = event.button;
    }
    decoded_.events.push_back(event);
}

}  // namespace carom

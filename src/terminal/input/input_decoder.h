#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "terminal/input/input.h"
#include "terminal/input/input_answer.h"
#include "terminal/input/keyboard.h"
#include "terminal/input/mouse.h"

/// Decodes the terminal's bytes into events, however the bytes are split between reads.
///
/// A sequence that is not understood is dropped whole: no part of it is ever taken for keys.
/// Bracketed pastes are dropped too.
namespace carom {

struct DecodedInput {
    std::vector<InputEvent> events;
    std::vector<Answer> answers;
};

class InputDecoder {
  public:
    /// The state of an unfinished sequence.
    enum class Pending : std::uint8_t {
        nothing,
        escape,   ///< the byte ESC alone: the Escape key, or the start of a sequence
        sequence  ///< longer: the rest is on its way, or will never come
    };

    /// `utf8` false: each byte from 0xa0 up is a character of Latin-1.
    explicit InputDecoder(bool utf8 = true, KeyTable keys = {});

    DecodedInput feed(std::string_view bytes);
    Pending pending() const;
    /// Call it when no more bytes have come for a while. ESC alone becomes the Escape key, ESC and
    /// one character become that character with Alt, and any other unfinished sequence is dropped.
    DecodedInput flush();

    /// Sets the unit of coordinates in the mouse reports that follow.
    void set_mouse_unit(const MouseUnit& unit) { mouse_unit_ = unit; }

  private:
    enum class State : std::uint8_t { ground, utf8, escape, csi, ss3, command, old_mouse, paste };

    void take(unsigned char byte);
    void take_ground(unsigned char byte);
    void take_utf8(unsigned char byte);
    void take_escape(unsigned char byte);
    void take_csi(unsigned char byte);
    void take_command(unsigned char byte);
    void take_old_mouse();
    void take_paste(unsigned char byte);
    bool take_from_table();
    void finish_csi();
    void finish_command();
    void begin(State state);
    void emit(InputEvent event);
    void emit_escape_before();

    KeyTable keys_;
    Keyboard keyboard_;
    MouseUnit mouse_unit_;
    bool is_utf8_;
    State state_ = State::ground;
    std::string bytes_;    // of the unfinished sequence
    bool is_alt_ = false;  // an ESC came before the ESC of this sequence
    std::uint8_t held_button_ = 0;
    DecodedInput decoded_;
};

}  // namespace carom

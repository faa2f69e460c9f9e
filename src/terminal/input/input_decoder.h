#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "terminal/input/input.h"
#include "terminal/input/input_answer.h"
#include "terminal/input/keyboard.h"
#include "terminal/input/mouse.h"

/// Decodes the terminal's bytes into events, however reads split them.
///
/// A sequence that is not understood is dropped whole: no part of it is ever taken for keys. A
/// bracketed paste is dropped too.
namespace carom {

struct DecodedInput {
    std::vector<InputEvent> events;
    std::vector<Answer> answers;
};

class InputDecoder {
  public:
    /// Whether a sequence has begun and not ended.
    enum class Pending : std::uint8_t {
        nothing,
        escape,   ///< the byte ESC alone: the key, or the start of a sequence
        sequence  ///< more than that: the rest is on its way, or will never come
    };

    /// `utf8`: else each byte from 0xa0 up is a character of Latin-1.
    explicit InputDecoder(bool utf8 = true, KeyTable keys = {});

    DecodedInput feed(std::string_view bytes);
    Pending pending() const;
    /// Nothing more has come for a while: ESC alone is the Escape key, ESC and one character are
    /// that character with Alt, and any other beginning is dropped.
    DecodedInput flush();

    /// What the terminal's mouse reports count in from now on.
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
    std::string bytes_;    // of what is pending
    bool is_alt_ = false;  // an ESC came before the ESC of this sequence
    std::uint8_t held_button_ = 0;
    DecodedInput decoded_;
};

}  // namespace carom

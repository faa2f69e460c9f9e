#pragma once

#include <sys/ioctl.h>
#include <termios.h>

#include <optional>
#include <string_view>
#include <vector>

#include "terminal/input/input_decoder.h"
#include "terminal/screen/curses_session.h"
#include "terminal/screen/frame_differ.h"
#include "terminal/screen/modes.h"
#include "terminal/screen/output.h"
#include "terminal/screen/screen.h"
#include "terminal/screen/signals.h"

/// The state of an open screen, and the operations of Screen on it.
namespace carom {

/// What was asked of the terminal, and what it has answered.
struct Queries {
    unsigned asked = 0;         // for its status
    unsigned answered = 0;      // at most `asked`
    bool has_answered = false;  // any other query
    bool is_done = false;       // the answer to the last of the first queries has come
};

struct Screen::State {
    SignalPipe signals;  // before ncurses, which leaves signals alone that are already caught
    TerminalOutput terminal;
    std::optional<CursesSession> curses;
    FrameDiffer differ;
    TerminalModes modes;
    InputDecoder decoder;
    Capabilities capabilities;
    termios modes_before{};
    std::optional<int> chosen_colors;  // by the player; none: as many as the terminal has
    int described_most = 256;          // colours, by the description and the environment
    int columns_unmeasured = 80;       // the size of a window whose size the system does not know
    int rows_unmeasured = 24;
    std::vector<InputEvent> waiting;  // for the next wait()
    std::vector<int> deferred;        // signals that arrived during send()
    std::string_view frame;           // the last one sent
    double idle = 0.0;                // s waited without input for the rest of a sequence
    Queries queries;
    bool is_open = false;
    bool is_gone = false;

    // state.cpp: entering and leaving the terminal, sending
    void enter();
    void leave();
    void suspend();
    void repair();
    void arm() const;
    bool send(std::string_view bytes);
    winsize read_size();  // into `capabilities`
    void measure();
    void set_mouse();
    void choose_colors();
    void hang_up();

    // state_input.cpp: input and signals
    void take(const DecodedInput& input);
    void take(const Answer& answer);
    void take(const InputEvent& event);
    void take_signal(int signal);
    void take_signals();
    void take_input();
    bool wait_once(double seconds, int also = -1);
};

/// An event of that kind, without further data.
InputEvent event_of(InputEvent::Kind kind);

}  // namespace carom

#pragma once

#include <sys/types.h>
#include <termios.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/emulator.h"

/// A program on a pseudo-terminal, with an emulator at the other end.
namespace carom::test {

struct ProgramOptions {
    int columns = 80;  ///< 0: the system knows no size; the emulator has 80x24
    int rows = 24;
    int pixels_wide = 0;  ///< of the window
    int pixels_high = 0;
    /// Added to the environment of the test; an empty value removes the variable. By default TERM
    /// is xterm-256color and the locale C.UTF-8; NO_COLOR, COLORFGBG and the variables of SSH are
    /// removed.
    std::map<std::string, std::string> environment;
    EmulatorOptions emulator;
};

class TerminalProgram {
  public:
    /// The program gets a pipe as file descriptor 3; log() returns what it writes there.
    explicit TerminalProgram(const std::vector<std::string>& arguments,
                             const ProgramOptions& options = {});
    TerminalProgram(const TerminalProgram&) = delete;
    TerminalProgram& operator=(const TerminalProgram&) = delete;
    ~TerminalProgram();  ///< kills the program if it still runs

    /// Sends keys or mouse reports: any bytes that a terminal sends.
    void send(std::string_view bytes);
    void resize(int columns, int rows);
    /// Tells the program a size that the emulator does not have.
    void claim_size(int columns, int rows);
    void signal(int number) const;
    /// Closes the terminal, as when a connection is lost.
    void hang_up();

    /// Runs the terminal until `is_so` holds; false if it does not within `seconds`.
    bool wait_until(const std::function<bool()>& is_so, double seconds = 10.0);
    bool wait_for_text(std::string_view text, double seconds = 10.0);
    bool wait_for_log(std::string_view text, double seconds = 10.0);
    /// Runs the terminal until nothing has come for so long.
    void settle(double seconds = 0.1);
    /// The status of waitpid(); none: it still runs.
    std::optional<int> wait_for_end(double seconds = 10.0);
    /// Waits while the terminal reads nothing, as if it were stuck.
    std::optional<int> wait_for_end_unread(double seconds);
    std::optional<int> exit_status();  ///< of a program that has exited

    const Emulator& screen() const { return emulator_; }
    const std::string& log() const { return log_; }
    /// All bytes that the program has written to the terminal.
    const std::string& output() const { return output_; }
    pid_t process() const { return process_; }

    termios modes() const;  ///< of the terminal, now
    const termios& modes_at_start() const { return modes_at_start_; }
    /// What the program has left changed in the terminal, in words; empty if everything is as
    /// before.
    std::string what_is_left_dirty() const;

  private:
    bool pump(double seconds);
    void flush_input();
    bool has_ended();

    int terminal_ = -1;
    int log_pipe_ = -1;
    pid_t process_ = -1;
    std::optional<int> end_;
    termios modes_at_start_{};
    std::string to_send_;
    std::string output_;
    std::string log_;
    Emulator emulator_;
};

/// An SGR mouse report for a cell (from 0): button 0 left, 1 middle, 2 right, plus 32 for motion.
std::string mouse_press(int button, int column, int row);
std::string mouse_release(int button, int column, int row);
std::string mouse_drag(int button, int column, int row);

}  // namespace carom::test

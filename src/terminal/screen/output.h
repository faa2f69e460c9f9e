#pragma once

/// The terminal as a file that can be written to without waiting.
namespace carom {

/// A handle of its own for the terminal on standard output, in which a write never blocks: a signal
/// that arrives just before a write could not end that. The shell's own handle, which other
/// processes share, keeps its mode.
///
/// Where the terminal cannot be opened again, as after `su`, the handle is standard output itself.
/// A write then blocks until the terminal reads, or a signal interrupts it.
class TerminalOutput {
  public:
    TerminalOutput();
    TerminalOutput(const TerminalOutput&) = delete;
    TerminalOutput& operator=(const TerminalOutput&) = delete;
    ~TerminalOutput();

    int handle() const;

  private:
    int own_ = -1;
};

}  // namespace carom

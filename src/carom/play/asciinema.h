#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "carom/files/files.h"

/// `--cast`: a recording of the screen for asciinema and compatible players, in the format
/// asciicast v2 (https://docs.asciinema.org/manual/asciicast/v2/). A line of JSON about the whole,
/// then one for each event: [seconds, "o", bytes for the terminal] or [seconds, "r",
/// "COLUMNSxROWS"].
namespace carom {

struct AsciinemaHeader {
    int columns = 0;
    int rows = 0;
    std::string title;
    std::string terminal;  ///< TERM; empty: not said
};

/// The first line, with its line end. No date: the same game gives the same file but for its times.
std::string asciinema_header(const AsciinemaHeader& header);

/// One event, with its line end. `data` in UTF-8, never a part of a character.
std::string asciinema_event(double seconds, char code, std::string_view data);

/// A recording that is being made. It is written as it goes, into a temporary file beside `path`,
/// so that an hour of it takes no memory. The file appears under its name when it is finished; what
/// stood there before stays until then.
///
/// It holds the pictures alone, for a terminal in no special mode: neither the alternate screen nor
/// mouse reports nor queries, so that the last picture stays when it has ended.
class AsciinemaRecording {
  public:
    AsciinemaRecording(const std::string& path, std::string title, std::string terminal);

    /// Why nothing can be written there, so that a player learns of it before the game.
    std::optional<std::string> obstacle() const;

    /// A picture, as the bytes that turn the one before into it (Screen::last_frame), in a window
    /// of this size. The first one, and each one of a new size, starts from an empty screen. `now`:
    /// s on a clock that does not go back.
    void add(double now, int columns, int rows, std::string_view bytes);

    /// The recording ends `now`, or never began. What went wrong, if anything.
    std::optional<std::string> finish(double now);

  private:
    std::string path_;
    OutputFile file_;
    AsciinemaHeader header_;  // with the present size
    std::optional<double> start_;
};

}  // namespace carom

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "carom/files/files.h"

/// `--cast`: a recording of the screen for asciinema and compatible players, in the format
/// asciicast v2 (https://docs.asciinema.org/manual/asciicast/v2/): a line of JSON as the header,
/// then one line for each event: [seconds, "o", bytes for the terminal] or [seconds, "r",
/// "COLUMNSxROWS"].
namespace carom {

struct AsciinemaHeader {
    int columns = 0;
    int rows = 0;
    std::string title;
    std::string terminal;  ///< TERM; empty: left out
};

/// The header, with its line end. It has no date, so files of the same game differ only in event
/// times.
std::string asciinema_header(const AsciinemaHeader& header);

/// One event, with its line end. `data`: UTF-8, whole characters only.
std::string asciinema_event(double seconds, char code, std::string_view data);

/// A recording in progress. It is written as it goes, into a temporary file beside `path`, so that
/// an hour of it takes no memory. The file appears under its name when the recording is finished;
/// until then an existing file stays.
///
/// It holds only the pictures, for a terminal in no special mode: no alternate screen, mouse
/// reports or queries. So the last picture remains after playback.
class AsciinemaRecording {
  public:
    AsciinemaRecording(const std::string& path, std::string title, std::string terminal);

    /// The reason why nothing can be written there, for the player to learn before the game.
    std::optional<std::string> obstacle() const;

    /// Adds a picture, as the bytes that change the previous picture into it (Screen::last_frame),
    /// in a window of this size. The first picture, and each one of a new size, starts from an
    /// empty screen. `now`: s on a monotonic clock.
    void add(double now, int columns, int rows, std::string_view bytes);

    /// Ends the recording, if it ever began. Returns the error, if any.
    std::optional<std::string> finish(double now);

  private:
    std::string path_;
    OutputFile file_;
    AsciinemaHeader header_;  // with the current size
    std::optional<double> start_;
};

}  // namespace carom

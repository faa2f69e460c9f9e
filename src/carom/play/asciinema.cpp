#include "carom/play/asciinema.h"

#include <fmt/format.h>

#include <utility>

#include "lab/json.h"

namespace carom {
namespace {

constexpr std::string_view hide_cursor = "\033[?25l";
constexpr std::string_view plain_style = "\033[m";
constexpr std::string_view show_cursor = "\033[?25h";

}  // namespace

std::string asciinema_header(const AsciinemaHeader& header) {
    std::string line = fmt::format(R"({{"version": 2, "width": {}, "height": {}, "title": {})",
                                   header.columns, header.rows, json_string(header.title));
    if (!header.terminal.empty())
        line += fmt::format(R"(, "env": {{"TERM": {}}})", json_string(header.terminal));
    return line + "}\n";
}

std::string asciinema_event(double seconds, char code, std::string_view data) {
    return fmt::format("[{:.6f}, \"{}\", {}]\n", seconds, code, json_string(data));
}

AsciinemaRecording::AsciinemaRecording(const std::string& path, std::string title,
                                       std::string terminal)
    : path_(path),
      file_(path),
      header_{.title = std::move(title), .terminal = std::move(terminal)} {}

std::optional<std::string> AsciinemaRecording::obstacle() const {
    if (path_ == "-") return "a cast is a file: standard output is the screen's";
    if (file_.error().empty()) return std::nullopt;
    return file_.error();
}

void AsciinemaRecording::add(double now, int columns, int rows, std::string_view bytes) {
    const bool has_size = columns == header_.columns && rows == header_.rows;
    header_.columns = columns;
    header_.rows = rows;
    if (!start_) {
        start_ = now;
        file_.write(asciinema_header(header_));
        file_.write(asciinema_event(0.0, 'o', hide_cursor));
    } else if (!has_size) {
        file_.write(asciinema_event(now - *start_, 'r', fmt::format("{}x{}", columns, rows)));
    }
    file_.write(asciinema_event(now - *start_, 'o', bytes));
}

std::optional<std::string> AsciinemaRecording::finish(double now) {
    if (!start_) return std::nullopt;
    const std::string last_row = fmt::format("\033[{};1H", header_.rows);
    file_.write(asciinema_event(now - *start_, 'o',
                                fmt::format("{}{}{}", plain_style, last_row, show_cursor)));
    file_.commit();
    if (file_.error().empty()) return std::nullopt;
    return file_.error();
}

}  // namespace carom

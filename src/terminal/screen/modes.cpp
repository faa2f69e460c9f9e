#include "terminal/screen/modes.h"

#include <algorithm>

#include "terminal/input/known_terminals.h"

namespace carom {
namespace {

constexpr int synchronized_output = 2026;
constexpr int pixel_reports = 1016;

// Distinguish all keys, report repeats and releases, and send all keys as sequences with their
// text.
constexpr std::string_view keys_on = "\033[>27u";
constexpr std::string_view keys_off = "\033[<u";
constexpr std::string_view paste_on = "\033[?2004h";
constexpr std::string_view paste_off = "\033[?2004l";
constexpr std::string_view mouse_off = "\033[?1003l\033[?1002l\033[?1016l\033[?1006l";
constexpr std::string_view begin_frame = "\033[?2026h";
constexpr std::string_view end_frame = "\033[?2026l";

}  // namespace

std::string TerminalModes::on() const {
    std::string bytes(paste_on);
    bytes += mouse();
    if (has_key_protocol_) bytes += keys_on;
    return bytes;
}

std::string TerminalModes::off() const {
    std::string bytes(after_frame());
    bytes += mouse_off;
    bytes += paste_off;
    if (has_key_protocol_) bytes += keys_off;
    return bytes;
}

std::string TerminalModes::mouse() const {
    std::string bytes(mouse_off);
    if (options_.mouse == MouseMode::off) return bytes;
    bytes += "\033[?1002h";
    if (options_.mouse == MouseMode::motion) bytes += "\033[?1003h";
    bytes += "\033[?1006h";
    if (has_mouse_pixels()) bytes += "\033[?1016h";
    return bytes;
}

bool TerminalModes::has_mouse_pixels() const {
    return options_.mouse_pixels && has_pixel_reports_ && cell_wide_ > 0 &&
           options_.mouse != MouseMode::off;
}

MouseUnit TerminalModes::mouse_unit() const {
    if (!has_mouse_pixels()) return {};
    return {static_cast<double>(cell_wide_), static_cast<double>(cell_high_)};
}

std::string_view TerminalModes::before_frame() const {
    return has_synchronized_output_ ? begin_frame : std::string_view();
}

std::string_view TerminalModes::after_frame() const {
    return has_synchronized_output_ ? end_frame : std::string_view();
}

bool TerminalModes::measure(int pixels_wide, int pixels_high, int columns, int rows) {
    const bool has_cells = columns > 0 && rows > 0;
    does_window_tell_pixels_ = has_cells && learn_cell(pixels_wide / columns, pixels_high / rows);
    return !does_window_tell_pixels_;
}

// Integer division, because a window is not always a whole number of cells.
bool TerminalModes::learn_cell(int wide, int high) {
    if (!cell_aspect_from(wide, high, 1, 1)) return false;
    cell_wide_ = wide;
    cell_high_ = high;
    return true;
}

std::string TerminalModes::learn(const Answer& answer) {
    using enum Answer::Kind;
    switch (answer.kind) {
        case attributes:
        case status:
            return {};
        case background:
            background_ = answer.color;
            return {};
        case version: {
            const TerminalTraits traits = traits_of(answer.text);
            mosaic_ = traits.mosaic;
            has_overhang_ = traits.has_overhang;
            if (traits.has_direct_colors) colors_promised_ = direct_colors;
            return {};
        }
        case colors:
            colors_promised_ = std::max(colors_promised_, answer.colors);
            return {};
        case key_flags:
            if (!options_.key_release || has_key_protocol_) return {};
            has_key_protocol_ = true;
            return std::string(keys_on);
        case cell_size:
            if (does_window_tell_pixels_ || !learn_cell(answer.pixels_wide, answer.pixels_high)) {
                return {};
            }
            return has_mouse_pixels() ? mouse() : std::string();
        case mode:
            if (answer.number == synchronized_output) has_synchronized_output_ = answer.is_offered;
            if (answer.number != pixel_reports) return {};
            has_pixel_reports_ = answer.is_offered;
            return has_mouse_pixels() ? mouse() : std::string();
    }
    return {};
}

void TerminalModes::tell(Capabilities& capabilities) const {
    capabilities.mouse_pixels = has_mouse_pixels();
    capabilities.key_release = has_key_protocol_;
    capabilities.cell_aspect = cell_aspect_from(cell_wide_, cell_high_, 1, 1).value_or(2.0);
    capabilities.mosaic = mosaic_;
    capabilities.background = background_;
    if (options_.light_background) {
        capabilities.light_background = *options_.light_background;
    } else if (background_) {
        capabilities.light_background = luminance(*background_) > 0.5;
    }
}

}  // namespace carom

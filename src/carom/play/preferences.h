#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/context/key_map.h"
#include "carom/options/play_options.h"
#include "terminal/draw/draw.h"
#include "terminal/input/key_repeat.h"

/// The player's preferences, kept in a small text file that may be edited. Its grammar is one
/// statement a line; `#` starts a comment:
///
///     p = pause               a key and the action that it does; `none` for nothing
///     ctrl-up = zoom-in
///     renderer = braille      auto, ascii, half, quadrants, sextants, octants, braille
///     colors = 16             auto, mono, 8, 16, 256, truecolor
///     theme = contrast        auto, dark, light, contrast, color-blind
///     background = light      auto, dark, light
///     fps = 30                frames a second, 1..1000
///     mouse = off             on, off
///     color-by = speed        kind, speed, mass, ball
///     balls = outline         filled, outline
///     trails = on             on, off
///     bell = on               on, off
///     hand = 2                the hand in a match of pool, 1..4
///     key-repeat = 660 40     ms from a press to its first repeat, and between repeats, as learnt
namespace carom {

struct Preferences {
    KeyMap keys;
    std::optional<RendererChoice> renderer;
    std::optional<ColorChoice> colors;
    std::optional<ThemeChoice> theme;
    std::optional<bool> light_background;
    std::optional<double> fps;
    std::optional<bool> mouse;
    ColorBy color_by = ColorBy::kind;
    BallStyle ball_style = BallStyle::filled;
    bool trails = false;
    bool bell = false;
    int hand = 2;
    std::optional<KeyRepeatTimes> key_repeat;
};

/// A line with an error has no effect; all others do.
struct PreferencesText {
    Preferences preferences;
    std::vector<std::string> problems;  ///< "file:line:col: error: ..."
};
PreferencesText read_preferences(std::string_view text, std::string_view file);

/// The text with the value of `name` replaced, or with `name = value` appended. Everything else,
/// including comments, stays.
std::string with_setting(std::string_view text, std::string_view name, std::string_view value);

std::string_view text_of(ColorBy by);
std::string_view text_of(BallStyle style);
std::string text_of(const KeyRepeatTimes& times);

/// carom/preferences in the user's configuration folder ($XDG_CONFIG_HOME, else ~/.config). None:
/// the user has no such folder.
std::optional<std::string> preferences_path();

/// The user's preferences. A file that cannot be read is a problem, and none at all is not.
PreferencesText load_preferences();

/// Writes one setting into the user's file and returns the error, if any. A file that cannot be
/// read is left alone. A user without such a folder is an error too.
std::optional<std::string> write_preference(std::string_view name, std::string_view value);

}  // namespace carom

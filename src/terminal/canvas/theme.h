#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "terminal/canvas/oklab.h"

/// Themes: all colours of carom, in one table (theme.cpp), written in OKLab. The palette
/// (palette.h) derives from them what a terminal with fewer colours shows.
namespace carom {

/// Parts of the picture that are not balls.
enum class Role : std::uint8_t {
    edge,
    zone,
    counter,  ///< numbers over bins
    grid,     ///< coordinates and broad-phase cells
    contact,  ///< lines between bodies that collided
    velocity,
    cue,
    selected,
    cursor,
    text,
    faint,   ///< labels of the status line
    strong,  ///< titles
    good,    ///< a check that passes
    warning,
    error,
    expected,     ///< a curve of expected values
    cloth,        ///< of a pool table
    stripe_white  ///< of a striped pool ball
};
inline constexpr std::size_t role_count = 18;

/// What a player chooses. Each exists for dark and for light backgrounds.
enum class ThemeName : std::uint8_t {
    standard,
    contrast,    ///< vivid colours far from the background
    color_blind  ///< colours that protanopes, deuteranopes and tritanopes tell apart
};

struct Theme {
    ThemeName name = ThemeName::standard;
    bool is_light = false;
    Rgb ground;  ///< the background, where the terminal does not tell
    std::array<Lch, role_count> roles;
    std::array<Lch, 14> classes;   ///< kinds of balls; neighbours differ most
    std::array<Lch, 6> materials;  ///< of edges: quieter than balls
    std::array<Lch, 5> scale;      ///< from slow to fast: lightness changes steadily
    std::array<Lch, 9> pool;       ///< the cue ball, then the balls 1 to 8
};

const Theme& theme_for(ThemeName name, bool is_light);

/// A player's choice, by name: auto, dark, light, contrast or color-blind.
struct ThemeChoice {
    ThemeName name = ThemeName::standard;
    std::optional<bool> is_light;  ///< none: as the terminal's background

    /// Whether it is for the other kind of background than the terminal's.
    bool brings_own_ground(bool is_terminal_light) const {
        return is_light && *is_light != is_terminal_light;
    }
    friend bool operator==(const ThemeChoice&, const ThemeChoice&) = default;
};
std::optional<ThemeChoice> theme_choice(std::string_view name);
std::span<const std::string_view> theme_choice_names();

}  // namespace carom

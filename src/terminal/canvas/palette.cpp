#include "terminal/canvas/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace carom {

namespace {

// With few colours, attributes tell roles apart. In the order of Role.
struct RoleAttributes {
    std::uint8_t in_color = plain;
    std::uint8_t in_mono = plain;
};
constexpr std::array<RoleAttributes, role_count> role_attributes = {{{plain, plain},
                                                                     {plain, plain},
                                                                     {plain, bold},
                                                                     {plain, dim},
                                                                     {bold, bold},
                                                                     {plain, plain},
                                                                     {bold, bold},
                                                                     {bold, bold},
                                                                     {bold, bold},
                                                                     {plain, plain},
                                                                     {plain, plain},
                                                                     {bold, bold},
                                                                     {plain, plain},
                                                                     {plain, bold},
                                                                     {bold, reverse},
                                                                     {bold, bold},
                                                                     {plain, plain},
                                                                     {plain, plain}}};

constexpr std::size_t scale_steps = 12;

/// A theme's colours on a terminal with so many colours.
struct Palette {
    std::array<Ink, role_count> roles;
    std::array<Ink, 14> classes;
    std::array<Ink, 6> materials;
    std::array<Ink, scale_steps> scale;
    std::array<Ink, 9> pool;
    Color foreground = default_color;  ///< of text, where its colour must be known
    Color ground = default_color;
};

/// The colours of a terminal with 8 or 16 that can be told from the background.
struct VisibleColors {
    int of = 8;  // so many
    std::vector<Color> colors;
};

VisibleColors visible_colors(int of, const Rgb& ground) {
    constexpr double least_difference = 0.22;  // of lightness
    VisibleColors visible{of, {}};
    const double behind = lab_of(ground).lightness;
    for (Color color = 0; color < of; ++color)
        if (std::abs(lab_of(rgb_of(color)).lightness - behind) >= least_difference)
            visible.colors.push_back(color);
    return visible;
}

double error_of(Color color, const Lab& wanted, int of) {
    return reduction_error(lab_of(rgb_of(color)), wanted, of);
}

Color nearest_of(const VisibleColors& visible, const Lab& wanted) {
    return *std::ranges::min_element(
        visible.colors, {}, [&](Color color) { return error_of(color, wanted, visible.of); });
}

// Gives each of the group a colour of its own, those with the least error first. When colours run
// out, they are used again in bold.
void assign(std::span<const Lch> wanted, std::span<Ink> inks, const VisibleColors& visible) {
    const std::size_t count = visible.colors.size();
    for (std::size_t start = 0; start < wanted.size(); start += count) {
        const std::size_t end = std::min(wanted.size(), start + count);
        const std::uint8_t attributes = start / count % 2 == 1 ? bold : plain;
        VisibleColors unused = visible;
        std::vector<std::size_t> left;
        for (std::size_t i = start; i < end; ++i)
            left.push_back(i);
        while (!left.empty()) {
            std::size_t best = 0;
            Color color = unused.colors.front();
            double least = HUGE_VAL;
            for (std::size_t i = 0; i < left.size(); ++i) {
                const Lab lab = lab_of(wanted[left[i]]);
                const Color nearest = nearest_of(unused, lab);
                const double error = error_of(nearest, lab, visible.of);
                if (error >= least) continue;
                least = error;
                best = i;
                color = nearest;
            }
            inks[left[best]] = {color, attributes};
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
            std::erase(unused.colors, color);
        }
    }
}

Lab along(std::span<const Lch> stops, double fraction) {
    const double place = fraction * static_cast<double>(stops.size() - 1);
    const std::size_t stop = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    const Lab a = lab_of(stops[stop]);
    const Lab b = lab_of(stops[stop + 1]);
    const double share = place - static_cast<double>(stop);
    return {a.lightness + share * (b.lightness - a.lightness), a.a + share * (b.a - a.a),
            a.b + share * (b.b - a.b)};
}

double fraction_of_step(std::size_t step) {
    return static_cast<double>(step) / (scale_steps - 1);
}

Palette shaded_palette(const Theme& theme, int colors) {
    Palette palette;
    const auto fill = [&](std::span<const Lch> from, std::span<Ink> to) {
        std::ranges::transform(from, to.begin(), [&](const Lch& lch) {
            return Ink{color_for_terminal(direct_color(rgb_of(lch)), colors), plain};
        });
    };
    fill(theme.roles, palette.roles);
    fill(theme.classes, palette.classes);
    fill(theme.materials, palette.materials);
    fill(theme.pool, palette.pool);
    for (std::size_t i = 0; i < scale_steps; ++i) {
        const Rgb rgb = rgb_of(along(theme.scale, fraction_of_step(i)));
        palette.scale[i] = {color_for_terminal(direct_color(rgb), colors), plain};
    }
    return palette;
}

Palette coarse_palette(const Theme& theme, int colors) {
    Palette palette;
    const VisibleColors visible = visible_colors(colors, theme.ground);
    for (std::size_t i = 0; i < role_count; ++i)
        palette.roles[i] = {nearest_of(visible, lab_of(theme.roles[i])), plain};
    assign(theme.classes, palette.classes, visible);
    assign(theme.materials, palette.materials, visible);
    assign(theme.pool, palette.pool, visible);
    std::array<Ink, 5> stops;
    assign(theme.scale, stops, visible);
    for (std::size_t i = 0; i < scale_steps; ++i)
        palette.scale[i] = stops[i * stops.size() / scale_steps];
    return palette;
}

enum class Depth : std::uint8_t { of_8, of_16, of_256, direct };

Depth depth_of(int colors) {
    if (colors >= direct_colors) return Depth::direct;
    return colors >= 256 ? Depth::of_256 : colors >= 16 ? Depth::of_16 : Depth::of_8;
}

Palette make_palette(const Theme& theme, Depth depth) {
    Palette palette = depth == Depth::direct ? shaded_palette(theme, direct_colors)
                      : depth == Depth::of_256
                          ? shaded_palette(theme, 256)
                          : coarse_palette(theme, depth == Depth::of_16 ? 16 : 8);
    palette.ground =
        color_for_terminal(direct_color(theme.ground), depth == Depth::direct   ? direct_colors
                                                       : depth == Depth::of_256 ? 256
                                                       : depth == Depth::of_16  ? 16
                                                                                : 8);
    for (std::size_t i = 0; i < role_count; ++i)
        palette.roles[i].attributes = role_attributes[i].in_color;
    // Plain text has the terminal's own colour.
    palette.foreground = palette.roles[static_cast<std::size_t>(Role::text)].color;
    palette.roles[static_cast<std::size_t>(Role::text)] = {};
    return palette;
}

constexpr std::size_t depth_count = 4;
using Palettes = std::array<Palette, 3 * 2 * depth_count>;

Palettes make_palettes() {
    Palettes palettes;
    std::size_t next = 0;
    for (const ThemeName name : {ThemeName::standard, ThemeName::contrast, ThemeName::color_blind})
        for (const bool is_light : {false, true})
            for (const Depth depth : {Depth::of_8, Depth::of_16, Depth::of_256, Depth::direct})
                palettes[next++] = make_palette(theme_for(name, is_light), depth);
    return palettes;
}

const Palette& palette_of(const Look& look) {
    static const Palettes palettes = make_palettes();  // 2 ms, once
    const std::size_t theme =
        2 * static_cast<std::size_t>(look.theme) + (look.light_background ? 1 : 0);
    return palettes[theme * depth_count + static_cast<std::size_t>(depth_of(look.colors))];
}

Tones make_tones(Color color, int colors) {
    const Lab base = lab_of(rgb_of(color));
    const auto tone = [&](double lightness, double chroma) {
        const Lab lab{std::clamp(lightness, 0.0, 1.0), chroma * base.a, chroma * base.b};
        return color_for_terminal(direct_color(rgb_of(lab)), colors);
    };
    const double l = base.lightness;
    return {tone(l * 0.72, 0.95), color, tone(l + 0.35 * (1.0 - l), 0.8),
            tone(l + 0.8 * (1.0 - l), 0.3)};
}

}  // namespace

Ink ink_of(Role role, const Look& look) {
    const auto i = static_cast<std::size_t>(role);
    if (!look.has_colors()) return {default_color, role_attributes[i].in_mono};
    return palette_of(look).roles[i];
}

Ink ink_of_class(std::size_t number, const Look& look) {
    if (!look.has_colors()) return {};
    const auto& classes = palette_of(look).classes;
    return classes[number % classes.size()];
}

Ink ink_of_scale(double fraction, const Look& look) {
    const double place = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 1.0;
    if (!look.has_colors()) return {default_color, place > 0.6 ? bold : plain};
    return palette_of(look).scale[static_cast<std::size_t>(place * (scale_steps - 1) + 0.5)];
}

Ink ink_of_material(std::size_t number, const Look& look) {
    if (!look.has_colors() || look.colors < 16) return ink_of(Role::edge, look);
    const auto& materials = palette_of(look).materials;
    return materials[number % materials.size()];
}

Ink ink_of_pool_ball(int number, const Look& look) {
    if (!look.has_colors()) return {};
    const auto& pool = palette_of(look).pool;
    const std::size_t row = static_cast<std::size_t>(number > 8 ? number - 8 : number);
    return pool[std::min(row, pool.size() - 1)];
}

Ink ink_of_color(const Rgb& rgb, const Look& look) {
    if (!look.has_colors()) return {};
    const Color color = color_for_terminal(direct_color(rgb), look.colors);
    if (look.has_shades()) return {color, plain};
    const Theme& theme = theme_for(look.theme, look.light_background);
    return {nearest_of(visible_colors(look.colors, theme.ground), lab_of(rgb)), plain};
}

Color color_of_hue(const Rgb& rgb, const Look& look) {
    const Theme& theme = theme_for(look.theme, look.light_background);
    const std::vector<Color> visible = visible_colors(look.colors, theme.ground).colors;
    const Lab wanted = lab_of(rgb);
    // The cosine of the angle between the hues, 1 if they are equal. Grey has none.
    const auto likeness = [&](Color color) {
        const Lab lab = lab_of(rgb_of(color));
        const double chroma = std::hypot(lab.a, lab.b);
        constexpr double least_chroma = 0.05;
        return chroma < least_chroma ? -1.0 : (lab.a * wanted.a + lab.b * wanted.b) / chroma;
    };
    return *std::ranges::max_element(visible, {}, likeness);
}

Color text_color_on(Color color, const Look& look) {
    if (color < 0) return default_color;
    constexpr Color black = 16;
    constexpr Color white = 231;
    const bool is_dark = lab_of(rgb_of(color)).lightness < 0.62;
    if (!look.has_shades()) return is_dark ? Color{7} : Color{0};
    return is_dark ? white : black;
}

Ink strong_text_on(Color color, const Look& look) {
    const Color text = text_color_on(color, look);
    constexpr Color black = 0;
    return {text, text == black ? plain : bold};
}

Color ground_color(const Look& look) {
    if (look.ground) return color_for_terminal(direct_color(*look.ground), look.colors);
    return palette_of(look).ground;
}

Color foreground_color(const Look& look) {
    return palette_of(look).foreground;
}

Color blended(Color over, Color ground, double share, const Look& look) {
    if (share >= 1.0 || over == ground) return over;
    if (share <= 0.0) return ground;
    if (!look.has_shades()) return share >= 0.5 ? over : ground;
    const Color behind = ground_color(look);
    const Color mix = mixed(over < 0 ? behind : over, ground < 0 ? behind : ground, share);
    return color_for_terminal(mix, look.colors);
}

Color dimmed(Color color, double share, Color ground, const Look& look) {
    if (!look.has_shades() || !(share < 1.0) || color < 0) return color;
    constexpr double steps = 12.0;  // few, so that neighbouring cells share their colours
    const double rounded = std::round(std::max(0.0, share) * steps) / steps;
    // Half as bright to the eye is a quarter of the light.
    return blended(color, ground, rounded * rounded, look);
}

Tones tones_of(Color color, const Look& look) {
    if (!look.has_shades() || color < 0) return {color, color, color, color};
    struct Known {
        Color color = default_color;
        int colors = 0;
        Tones tones;
    };
    thread_local std::array<Known, 256> cache;
    Known& known = cache[(static_cast<std::uint32_t>(color) * 2654435761u) >> 24];
    if (known.color != color || known.colors != look.colors)
        known = {color, look.colors, make_tones(color, look.colors)};
    return known.tones;
}

}  // namespace carom

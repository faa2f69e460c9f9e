#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

/// Renderers turn samples, several in each cell, into characters. A renderer is a row of the table
/// in renderer.cpp and a function there; everything else (the raster, the drawing of balls and
/// tables, the command line, preferences, the key that cycles through them) reads the table.
namespace carom {

inline constexpr std::size_t most_samples = 8;

/// The samples of a cell, row by row from the top left.
struct CellSamples {
    std::array<std::uint8_t, most_samples> levels{};  ///< 0 is empty, 255 full
    /// The colour of each sample where the renderer has pixels; else only the first entry is used,
    /// for the whole cell.
    std::array<Color, most_samples> colors{};
    /// Pixels: the colour that shows where `colors` does not cover the sample.
    std::array<Color, most_samples> grounds = filled_with_ground();
    std::array<std::uint8_t, most_samples> attributes{};
    /// Regions: the character of a cell that is all inside; 0: chosen by the levels.
    char fill = '\0';

    Ink ink(std::size_t sample = 0) const { return {colors[sample], attributes[sample]}; }

  private:
    static constexpr std::array<Color, most_samples> filled_with_ground() {
        std::array<Color, most_samples> grounds{};
        grounds.fill(default_color);
        return grounds;
    }
};

/// The colour of a pixel: the mixture of its colour and its ground, in few enough steps that
/// neighbours share them. default_color: nothing is drawn there.
Color pixel_color(const CellSamples& samples, std::size_t pixel, const Look& look);

struct Renderer {
    /// What a sample stands for.
    enum class Samples : std::uint8_t {
        regions,  ///< part of a character, which is chosen by shape; one colour a cell
        pixels,   ///< a pixel with its own colour, shaded by its level
        dots      ///< lit or not; one colour a cell
    };

    std::string_view name;   ///< on the command line and in preferences
    std::string_view title;  ///< shown to a player
    bool needs_utf8 = true;
    Samples samples = Samples::pixels;
    int across = 1;  ///< samples in a cell; across * down <= most_samples
    int down = 1;

    // In columns:
    double hairline = 0.5;  ///< half the width of the thinnest line that is clearly visible
    double gap = 0.12;      ///< by which balls are drawn smaller, so that touching balls stay apart
    double least_rimmed = 0.0;  ///< the radius below which a rim leaves no room for an inside

    double level_of_dot = 1.0;  ///< the level of a sample with a disc too small to fill it, 0 to 1
    /// Pixels: a border runs between pixels, and is not smoothed. For cells of more pixels than
    /// colours, where a mixture would take the place of a colour that is really there.
    bool is_sharp = false;
    Mosaic mosaic = Mosaic::halves;  ///< pixels: what the terminal must be able to show

    /// Makes the cell that shows the samples. Called only for cells that are not empty.
    Cell (*show)(const CellSamples& samples, const Look& look) = nullptr;

    bool has_regions() const { return samples == Samples::regions; }
    bool has_pixels() const { return samples == Samples::pixels; }
    bool has_dots() const { return samples == Samples::dots; }
};

/// All renderers, in the order in which a player cycles through them.
std::span<const Renderer> renderers();

/// ASCII: each character is chosen by its shape, from 2 x 3 regions.
const Renderer& ascii_renderer();
/// Half blocks: 1 x 2 pixels of two colours.
const Renderer& half_block_renderer();
/// Quadrants, sextants and octants: 2 x 2, 2 x 3 and 2 x 4 pixels of two colours.
const Renderer& quadrant_renderer();
const Renderer& sextant_renderer();
const Renderer& octant_renderer();
/// Braille: 2 x 4 dots of one colour.
const Renderer& braille_renderer();

/// The next renderer in the table; after the last, the first.
const Renderer& renderer_after(const Renderer& renderer);

/// A player's choice: a row of the table, or null for the renderer that suits the terminal best.
using RendererChoice = const Renderer*;

/// The choice of this name: a renderer's name, or "auto". None if there is no such choice.
std::optional<RendererChoice> renderer_choice(std::string_view name);
std::string_view name_of(RendererChoice choice);
/// "auto", then the names of all renderers.
std::vector<std::string_view> renderer_choice_names();

/// The renderer that a choice resolves to: one that the terminal can show.
const Renderer& renderer_for(RendererChoice choice, const Look& look);

}  // namespace carom

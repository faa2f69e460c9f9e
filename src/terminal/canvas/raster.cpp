#include "terminal/canvas/raster.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace carom {

namespace {

// A dot is either lit or not. A tone lights the dots whose threshold it exceeds: a 2 x 4 pattern
// that thins out evenly.
constexpr std::array<int, 8> dot_thresholds = {16, 144, 208, 80, 48, 176, 240, 112};

}  // namespace

Raster::Raster(const Renderer& renderer, int columns, int rows, double aspect, const Look& look)
    : renderer_(&renderer),
      columns_(std::max(0, columns)),
      rows_(std::max(0, rows)),
      aspect_(aspect),
      look_(look),
      is_sharp_(renderer.has_pixels() && (renderer.is_sharp || !look.has_shades())),
      width_(1.0 / renderer.across),
      height_(aspect / renderer.down),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    if (renderer.has_regions()) lines_ = LineLayer(columns_, rows_);
    for (int i = 0; i < renderer.across * renderer.down; ++i) {
        middles_[static_cast<std::size_t>(i)] = {(i % renderer.across + 0.5) * width_,
                                                 (i / renderer.across + 0.5) * height_};
    }
}

CellSamples& Raster::cell_at(int column, int row) {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
}

const CellSamples& Raster::cell_at(int column, int row) const {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
}

void Raster::erase_line(int column, int row) {
    if (renderer_->has_regions()) lines_.erase(column, row);
}

Raster::Span Raster::columns_within(double left, double right) const {
    const double most = columns_;
    return {static_cast<int>(std::floor(std::clamp(left, 0.0, most))),
            static_cast<int>(std::ceil(std::clamp(right, 0.0, most))) - 1};
}

std::uint8_t Raster::tone_of_sample(std::uint8_t tone, int sample) const {
    if (!renderer_->has_dots()) return tone;
    return tone > dot_thresholds[static_cast<std::size_t>(sample)] ? 255 : 0;
}

// Pixels mix colours, so the terminal's own foreground must be one.
Ink Raster::visible(Ink ink) const {
    if (ink.color < 0 && renderer_->has_pixels() && look_.has_colors())
        ink.color = foreground_color(look_);
    return ink;
}

// Pieces of one colour merge where they overlap, as the pieces of a polyline do.
void Raster::blend(CellSamples& cell, std::size_t pixel, const Ink& ink, double opacity) {
    if (!look_.has_shades()) opacity = opacity >= 0.44 ? 1.0 : 0.0;
    const auto level = static_cast<std::uint8_t>(std::min(1.0, opacity) * 255.0 + 0.5);
    if (level == 0) return;
    const bool is_one = cell.levels[pixel] > 0 && cell.colors[pixel] == ink.color;
    if (is_one) {
        cell.levels[pixel] = std::max(cell.levels[pixel], level);
    } else {
        if (level < 255) cell.grounds[pixel] = pixel_color(cell, pixel, look_);
        cell.levels[pixel] = level;
    }
    cell.colors[pixel] = ink.color;
    cell.attributes[pixel] = ink.attributes;
}

void Raster::fill_cell(CellSamples& cell, const Brush& brush) {
    if (renderer_->has_pixels() && brush.tone == 0 && brush.is_ring) return;
    const bool is_mixed = renderer_->has_pixels() && brush.tone > 0 && brush.tone < 255;
    for (int i = 0; i < renderer_->across * renderer_->down; ++i) {
        const auto sample = static_cast<std::size_t>(i);
        if (is_mixed)
            blend(cell, sample, brush.ink, brush.tone / 255.0);
        else
            cell.levels[sample] = tone_of_sample(brush.tone, i);
    }
    if (is_mixed) return;
    if (brush.tone == 0) cell.grounds.fill(default_color);
    cell.colors.fill(brush.ink.color);
    cell.attributes.fill(brush.ink.attributes);
    cell.fill = brush.fill;
}

void Raster::stamp(RasterPoint center, std::string_view glyphs, const Ink& ink) {
    const double row = std::floor(center.y / aspect_);
    const double first = std::floor(center.x - 0.5 * static_cast<double>(glyphs.size()) + 0.5);
    if (!renderer_->has_regions() || !(row >= 0.0 && row < rows_)) return;
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
        const double column = first + static_cast<double>(i);
        if (!(column >= 0.0 && column < columns_)) continue;
        fill_cell(cell_at(static_cast<int>(column), static_cast<int>(row)), {ink, 0, glyphs[i]});
        erase_line(static_cast<int>(column), static_cast<int>(row));
    }
}

void Raster::sample(int across, int down, std::uint8_t level, const Ink& ink) {
    if (across < 0 || down < 0 || across >= samples_across() || down >= samples_down()) return;
    CellSamples& cell = cell_at(across / renderer_->across, down / renderer_->down);
    const int i = down % renderer_->down * renderer_->across + across % renderer_->across;
    cell.fill = '\0';
    if (renderer_->has_pixels() && look_.has_shades())
        return blend(cell, static_cast<std::size_t>(i), visible(ink), level / 255.0);
    const std::uint8_t shown = tone_of_sample(level, i);
    std::uint8_t& present = cell.levels[static_cast<std::size_t>(i)];
    // A pixel takes the colour of the later of two that are equally strong.
    if (present > shown || (present == shown && !renderer_->has_pixels())) return;
    present = shown;
    const std::size_t slot = renderer_->has_pixels() ? static_cast<std::size_t>(i) : 0;
    cell.colors[slot] = visible(ink).color;
    cell.attributes[slot] = ink.attributes;
}

std::uint8_t Raster::level_at(int across, int down) const {
    assert(across >= 0 && down >= 0 && across < samples_across() && down < samples_down());
    const CellSamples& cell = cell_at(across / renderer_->across, down / renderer_->down);
    return cell.levels[static_cast<std::size_t>(down % renderer_->down * renderer_->across +
                                                across % renderer_->across)];
}

void Raster::show(Canvas& canvas, int column, int row) const {
    for (int r = 0; r < rows_; ++r) {
        for (int c = 0; c < columns_; ++c) {
            if (renderer_->has_regions() && is_shown(lines_.line(c, r))) {
                const CellLine& line = lines_.line(c, r);
                canvas.put(column + c, row + r,
                           {static_cast<unsigned char>(glyph_of(line)), line.ink.color,
                            default_color, line.ink.attributes});
                continue;
            }
            const CellSamples& from = cell_at(c, r);
            const bool is_empty = std::bit_cast<std::uint64_t>(from.levels) == 0;
            if (is_empty && from.fill == '\0') continue;
            const Cell to = renderer_->show(from, look_);
            if (to.glyph != U' ') canvas.put(column + c, row + r, to);
        }
    }
}

}  // namespace carom

#include "terminal/canvas/raster.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace carom {

namespace {

struct Samples {
    int across;
    int down;
};

constexpr Samples samples_of(Sampling sampling) {
    switch (sampling) {
        case Sampling::shapes:
            return {2, 3};
        case Sampling::halves:
            return {1, 2};
        case Sampling::dots:
            return {2, 4};
    }
    return {1, 1};
}

// A font's stroke for shapes; a pixel or a dot for the others.
constexpr double hairline_of(Sampling sampling) {
    switch (sampling) {
        case Sampling::shapes:
            return 0.13;
        case Sampling::halves:
            return 0.45;
        case Sampling::dots:
            return 0.27;
    }
    return 0.5;
}

// A dot is lit or it is not; of a tone, those are lit that it exceeds: a pattern of 2 x 4 that
// thins out evenly.
constexpr std::array<int, 8> dot_thresholds = {16, 144, 208, 80, 48, 176, 240, 112};

}  // namespace

Raster::Raster(Sampling sampling, int columns, int rows, double aspect)
    : sampling_(sampling),
      columns_(std::max(0, columns)),
      rows_(std::max(0, rows)),
      aspect_(aspect),
      across_(samples_of(sampling).across),
      down_(samples_of(sampling).down),
      hairline_(hairline_of(sampling)),
      width_(1.0 / across_),
      height_(aspect / down_),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

Raster::RasterCell& Raster::cell_at(int column, int row) {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
}

const Raster::RasterCell& Raster::cell_at(int column, int row) const {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
}

Raster::Span Raster::columns_within(double left, double right) const {
    const double most = columns_;
    return {static_cast<int>(std::floor(std::clamp(left, 0.0, most))),
            static_cast<int>(std::ceil(std::clamp(right, 0.0, most))) - 1};
}

std::uint8_t Raster::tone_of_sample(std::uint8_t tone, int sample) const {
    if (sampling_ != Sampling::dots) return tone;
    return tone > dot_thresholds[static_cast<std::size_t>(sample)] ? 255 : 0;
}

void Raster::fill_cell(RasterCell& cell, const Brush& brush) {
    for (int i = 0; i < across_ * down_; ++i)
        cell.levels[i] = tone_of_sample(brush.tone, i);
    cell.colors.fill(brush.ink.color);
    cell.attributes.fill(brush.ink.attributes);
    cell.fill = brush.fill;
}

void Raster::stamp(RasterPoint center, std::string_view glyphs, const Ink& ink) {
    const double row = std::floor(center.y / aspect_);
    const double first = std::floor(center.x - 0.5 * static_cast<double>(glyphs.size()) + 0.5);
    if (sampling_ != Sampling::shapes || !(row >= 0.0 && row < rows_)) return;
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
        const double column = first + static_cast<double>(i);
        if (!(column >= 0.0 && column < columns_)) continue;
        fill_cell(cell_at(static_cast<int>(column), static_cast<int>(row)), {ink, 0, glyphs[i]});
    }
}

void Raster::sample(int across, int down, std::uint8_t level, const Ink& ink) {
    if (across < 0 || down < 0 || across >= samples_across() || down >= samples_down()) return;
    RasterCell& cell = cell_at(across / across_, down / down_);
    const int y = down % down_;
    const int i = y * across_ + across % across_;
    const std::uint8_t shown = tone_of_sample(level, i);
    std::uint8_t& present = cell.levels[static_cast<std::size_t>(i)];
    if (present >= shown) return;
    present = shown;
    const std::size_t slot = sampling_ == Sampling::halves ? static_cast<std::size_t>(y) : 0;
    cell.colors[slot] = ink.color;
    cell.attributes[slot] = ink.attributes;
    cell.fill = '\0';
}

std::uint8_t Raster::level_at(int across, int down) const {
    assert(across >= 0 && down >= 0 && across < samples_across() && down < samples_down());
    const RasterCell& cell = cell_at(across / across_, down / down_);
    return cell.levels[static_cast<std::size_t>((down % down_) * across_ + across % across_)];
}

}  // namespace carom

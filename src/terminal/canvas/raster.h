#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"
#include "terminal/canvas/renderer.h"

/// Shapes onto a grid of samples, several in each cell, with smooth borders; and the samples into
/// characters. What is painted later covers what was painted before.
///
/// Places are in columns: x from the left edge of the raster, y from its top, *downwards*, both in
/// widths of a cell, so that circles are circles. Shapes may lie outside, be of any size, and be
/// not finite: what cannot be seen costs next to nothing, and what is not finite is not painted.
namespace carom {

struct RasterPoint {
    double x = 0.0;
    double y = 0.0;
};

/// What a shape is painted with.
struct Brush {
    Ink ink;
    /// How solid its inside is, 0 to 255: a shade where pixels have colours, a pattern of dots in
    /// dots. Its rim is always solid.
    std::uint8_t tone = 255;
    /// Regions: the character of cells that are all inside; 0: the one that looks most solid.
    char fill = 0;
};

class Raster {
  public:
    /// All empty. `renderer` is a row of the table, which outlives every raster. Pre: aspect
    /// (height of a cell over its width) positive and finite.
    Raster(const Renderer& renderer, int columns, int rows, double aspect);

    const Renderer& renderer() const { return *renderer_; }
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    double aspect() const { return aspect_; }
    int samples_across() const { return columns_ * renderer_->across; }
    int samples_down() const { return rows_ * renderer_->down; }
    /// Half the width of the thinnest line that shows well, in columns.
    double hairline() const { return renderer_->hairline; }

    /// A disc, at least a dot: one too small for a sample lights the sample that it is in, and many
    /// such in one cell make it denser. The rim has a `rim` as thick as that, in columns; 0: the
    /// whole disc is inside.
    void disc(RasterPoint center, double radius, double rim, const Brush& brush);
    /// A capsule, never thinner than a hairline. All of it is inside.
    void capsule(RasterPoint start, RasterPoint end, double radius, const Brush& brush);
    /// A hairline from start to end, `strength` (0 to 255) of full.
    void line(RasterPoint start, RasterPoint end, const Ink& ink, std::uint8_t strength = 255);
    /// Regions: a few characters in the row of `center`, as near to it as cells allow, in place
    /// of what is there. Other renderers: nothing.
    void stamp(RasterPoint center, std::string_view glyphs, const Ink& ink);
    /// Lights one sample, if it is darker than `level`. Dots have no levels: the lower `level`, the
    /// fewer of them are lit.
    void sample(int across, int down, std::uint8_t level, const Ink& ink);

    /// The level of one sample: 0 is empty, 255 full. Pre: within the raster.
    std::uint8_t level_at(int across, int down) const;

    /// Writes every cell that is not empty, the raster's top left cell at column, row.
    void show(Canvas& canvas, int column, int row, const Look& look) const;

  private:
    struct Span {
        int first = 0;
        int last = -1;
    };

    template <class Coverage>
    void paint_cell(int column, int row, const Brush& brush, Coverage coverage);
    template <class SpanAt, class Inside, class Coverage>
    void paint_rows(double top, double bottom, const Brush& brush, SpanAt span_at, Inside inside,
                    Coverage coverage);
    std::uint8_t tone_of_sample(std::uint8_t tone, int sample) const;
    void fill_cell(CellSamples& cell, const Brush& brush);
    Span columns_within(double left, double right) const;
    CellSamples& cell_at(int column, int row);
    const CellSamples& cell_at(int column, int row) const;
    double filter_width(double dx, double dy, double distance) const;

    const Renderer* renderer_;
    int columns_;
    int rows_;
    double aspect_;
    double width_;  // of a sample, in columns
    double height_;
    std::array<RasterPoint, most_samples> middles_{};  // of the samples, from the cell's corner
    std::vector<CellSamples> cells_;
};

}  // namespace carom

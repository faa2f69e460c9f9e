#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "terminal/canvas/canvas.h"
#include "terminal/canvas/cell_line.h"
#include "terminal/canvas/palette.h"
#include "terminal/canvas/renderer.h"

/// A raster paints shapes onto a grid of samples, several in each cell, with antialiased borders,
/// and turns the samples into characters. Later shapes cover earlier ones.
///
/// Coordinates are in columns: x from the left edge of the raster, y from its top, *downwards*,
/// both in cell widths, so that circles are circles. Shapes may lie outside and be of any size: a
/// shape out of view costs next to nothing, and one with coordinates that are not finite is not
/// painted.
namespace carom {

struct RasterPoint {
    double x = 0.0;
    double y = 0.0;
};

/// How a shape is painted.
struct Brush {
    Ink ink;
    /// The opacity of its inside, 0 to 255: a shade on renderers with pixels, a pattern of dots on
    /// renderers with dots. The rim is always opaque. 0 clears the inside.
    std::uint8_t tone = 255;
    /// Renderers with regions: the character for cells that lie all inside; 0: the densest one.
    char fill = 0;
    /// Renderers with pixels: an inside of tone 0 stays as it was, so that a disc is a ring.
    bool is_ring = false;
    /// Renderers with pixels: its border runs between pixels, and is not smoothed, as where
    /// borders are sharp.
    bool is_crisp = false;
};

/// How a ball is painted with pixels.
struct BallPaint {
    Tones tones;
    std::optional<Tones> band;  ///< of a striped ball: its stripe; `tones` above and below it
    std::uint8_t attributes = plain;
    /// The columns of a number that is written on it: its middle then is that of those cells. 0:
    /// none.
    int number_width = 0;
    bool is_lit = false;    ///< shaded as a sphere, with a highlight at the upper left
    bool is_crisp = false;  ///< its border is not smoothed, as where borders are sharp
    /// The middles of other balls of this size. Where small balls lie close together, their pixels
    /// overlap: each is left to the ball whose middle is nearest.
    std::span<const RasterPoint> rivals;
};

class Raster {
  public:
    /// An empty raster. `renderer` is a row of the renderer table, which outlives every raster.
    /// Pre: aspect (height of a cell over its width) is positive and finite.
    Raster(const Renderer& renderer, int columns, int rows, double aspect, const Look& look = {});

    const Renderer& renderer() const { return *renderer_; }
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    double aspect() const { return aspect_; }
    int samples_across() const { return columns_ * renderer_->across; }
    int samples_down() const { return rows_ * renderer_->down; }
    /// Half the width, in columns, of the thinnest line that is clearly visible.
    double hairline() const { return renderer_->hairline; }

    /// A disc. One too small to cover a sample lights the sample that contains its centre; many
    /// such discs in one cell make the cell denser. `rim`: thickness of the rim, in columns; 0: the
    /// whole disc is inside.
    void disc(RasterPoint center, double radius, double rim, const Brush& brush);
    /// Renderers with pixels: a ball. Small ones, and all where borders are sharp, lie on whole
    /// pixels, so a ball has the same shape wherever it is. Its diameter is rounded down, to a
    /// pixel at least.
    void ball(RasterPoint center, double radius, const BallPaint& paint);
    /// Renderers with pixels: the soft shadow of a ball that lies on a surface, to its lower right.
    /// A ball of few pixels has none.
    void ball_shadow(RasterPoint center, double radius, const BallPaint& paint, Color color);
    /// A capsule, drawn at least a hairline thick. All of it is inside. Renderers with regions draw
    /// a thin one as a line of characters.
    void capsule(RasterPoint start, RasterPoint end, double radius, const Brush& brush);
    /// A hairline from start to end, `strength` (0 to 255) of full.
    void line(RasterPoint start, RasterPoint end, const Ink& ink, std::uint8_t strength = 255);
    /// Renderers with regions: writes a few characters in the row of `center`, as near to it as
    /// cells allow, in place of what is there. Other renderers: nothing.
    void stamp(RasterPoint center, std::string_view glyphs, const Ink& ink);
    /// Lights one sample, unless it is brighter than `level`. Dots have no levels: a lower `level`
    /// lights fewer of them.
    void sample(int across, int down, std::uint8_t level, const Ink& ink);

    /// The level of one sample: 0 is empty, 255 full. Pre: the sample lies within the raster.
    std::uint8_t level_at(int across, int down) const;

    /// Writes every non-empty cell to the canvas, with the raster's top left cell at column, row.
    void show(Canvas& canvas, int column, int row) const;

  private:
    struct Span {
        int first = 0;
        int last = -1;
    };

    template <class Paint>
    void paint_ball(RasterPoint center, double radius, const BallPaint& ball, Paint paint);
    template <class Coverage>
    void paint_cell(int column, int row, const Brush& brush, Coverage coverage);
    template <class SpanAt, class Inside, class Coverage>
    void paint_rows(double top, double bottom, const Brush& brush, SpanAt span_at, Inside inside,
                    Coverage coverage);
    template <class Coverage>
    void paint_pixels(CellSamples& cell, RasterPoint corner, const Brush& brush, Coverage coverage);
    double snap_to_pixels(RasterPoint& start, RasterPoint& end, double radius) const;
    void thin_line(RasterPoint start, RasterPoint end, const Brush& brush);
    void paint_capsule(RasterPoint start, RasterPoint end, double thickness, const Brush& brush);
    RasterPoint middle_of_number(RasterPoint center, int width) const;
    void blend_pixel(int column, int row, const Ink& ink, double opacity);
    void blend(CellSamples& cell, std::size_t pixel, const Ink& ink, double opacity);
    std::uint8_t tone_of_sample(std::uint8_t tone, int sample) const;
    void fill_cell(CellSamples& cell, const Brush& brush);
    void erase_line(int column, int row);
    Ink visible(Ink ink) const;
    Span columns_within(double left, double right) const;
    CellSamples& cell_at(int column, int row);
    const CellSamples& cell_at(int column, int row) const;
    double filter_width(double dx, double dy, double distance) const;

    const Renderer* renderer_;
    int columns_;
    int rows_;
    double aspect_;
    Look look_;
    bool is_sharp_;  // a pixel is either inside a shape or not
    double width_;   // of a sample, in columns
    double height_;
    std::array<RasterPoint, most_samples> middles_{};  // of the samples, from the cell's corner
    std::vector<CellSamples> cells_;
    LineLayer lines_;  // renderers with regions only
};

}  // namespace carom

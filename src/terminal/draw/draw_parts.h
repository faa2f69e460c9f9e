#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "terminal/canvas/raster.h"
#include "terminal/draw/draw.h"

/// The layers of a picture of the world, in the order in which draw_world combines them. Private to
/// this room.
namespace carom {

class BoardTexts;

/// The input of all layers.
struct View {
    const Camera& camera;
    const Scene& scene;
    const World& world;
    const ViewOptions& options;
    const Annotations& annotations;
    const ViewMemory& memory;
    std::span<const Contact> contacts;  ///< of the last tick
    std::span<const Ink> inks;          ///< of each ball, by index
};

/// A world point, in the raster's columns.
/// A round edge, `radius` in columns. It has the same shape wherever it lies: in ASCII a few
/// characters, with pixels as a ball.
void paint_peg(Raster& raster, RasterPoint center, double radius, const Brush& brush);

/// The row in which a number is written on a ball whose middle is at `row`: in ASCII, a row of its
/// shape.
int middle_row(const View& view, double radius, double row);

RasterPoint to_raster(const Camera& camera, Vec2 point);

/// The offsets at which a body is shown: zero, and on a torus also those that bring an image of
/// `bounds` into view, in the torus or beyond its border.
struct Images {
    std::array<Vec2, 9> offsets{};
    std::size_t count = 0;

    const Vec2* begin() const { return offsets.data(); }
    const Vec2* end() const { return offsets.data() + count; }
};
Images images_of(const Model& model, const Box& bounds, const Camera& camera);

/// The ink of a lit light. Without colours it is reversed where a cell has one glyph: some
/// terminals have no dim characters, and bold alone is hard to tell.
Ink lit_ink(const Raster& raster, Ink ink, const Look& look);
/// By how much a lit light is larger than an unlit one, in columns: a pixel, where there are pixels
/// and no colours; else 0.
double lit_swell(const Raster& raster, const Look& look);

/// Gives balls the colours of the level's dress, where it has any.
void dress_balls(std::vector<Ink>& inks, const Scene& scene, const World& world, const Look& look);
/// The ink of an edge: its own colour, that of its material, that of the theme, or one by number.
Ink edge_ink(const View& view, std::size_t edge);

std::vector<Ink> ball_inks(const World& world, const ViewOptions& options,
                           const ViewMemory& memory);

/// Renderers with pixels: a rectangle about as wide and high as a disc, of whole pixels, so that
/// dots of one size are alike wherever they are.
void fill_dot(Raster& raster, RasterPoint middle, double radius, const Ink& ink,
              std::uint8_t level = 255);
// Onto the raster, from back to front.
/// The overlays that are on and lie under the bodies. The first row of the table is nearest to the
/// bodies.
void paint_overlays_below(Raster& raster, const View& view);
void paint_overlays_above(Raster& raster, const View& view);
/// The leather of pockets, diamonds, head string and spots.
void paint_pool_table(Raster& raster, const View& view, const Board& board);
/// Whether pool tables show wood and leather: the raster has pixels, and the terminal shades.
bool paints_tables(const Raster& raster, const View& view);
/// The holes of pockets, over the cushions, which would cover small ones. They have the same shape
/// wherever they lie.
void paint_holes(Raster& raster, const View& view);
/// With pixels: paints the zone if it is a pocket that paint_pool_table and paint_holes do not
/// draw. Whether it is a pocket.
bool paint_pocket(Raster& raster, const View& view, std::size_t zone);
/// The border of a torus, where there is something to be seen beyond it.
void paint_border(Raster& raster, const View& view);
void paint_zones(Raster& raster, const View& view);
/// What lies on the board, or what lies above it on another layer, as the rails of a ramp do.
enum class Level : std::uint8_t { board, above };
/// Whether the level has anything above its board.
bool has_level_above(const View& view);
void paint_edges(Raster& raster, const View& view, const Board& board, Level level);
/// The hinges of seesaws, on their edges.
void paint_hinges(Raster& raster, const View& view);
void paint_balls(Raster& raster, const View& view, Level level);
/// The frames and strings of cradles, behind their balls.
void paint_cradles(Raster& raster, const View& view);
/// Adds the hard impacts of the last tick to the flashes, and forgets those that are over.
void note_impacts(ViewMemory& memory, const World& world, std::span<const Contact> contacts);
void paint_flashes(Raster& raster, const View& view);
/// The shadows of pool balls on their cloth, all of them before the first ball.
void paint_shadows(Raster& raster, const View& view);
/// The areas that the level paints above its board: see-through.
void paint_areas_above(Raster& raster, const View& view);
void paint_cloud(Raster& raster, const View& view);
void paint_pool(Raster& raster, const View& view);
void paint_lamps(Raster& raster, const View& view);
/// The radius of the glow around a light while it is lit, in columns; 0: it has none.
double halo_radius(const View& view, const TableLight& light);
void paint_insert(Raster& raster, const View& view, const TableLight& light);
/// Fills a polygon by the even-odd rule, without smoothing its border.
void fill_polygon(Raster& raster, std::span<const RasterPoint> corners, const Ink& ink,
                  std::uint8_t level);
void paint_lit_edges(Raster& raster, const View& view);
void paint_annotations(Raster& raster, const View& view);

/// Gives numbered balls their pool colours.
void color_pool_balls(std::vector<Ink>& inks, const Scene& scene, const World& world,
                      const PoolAnnotations& pool, const Look& look);

/// Whether the ball is a stripe of pool, white with a band in its colour.
bool is_striped(const View& view, std::size_t ball);

/// The columns of the number that is written on a ball of pool; 0: none. Among pixels a ball that
/// is too small to look round around its number is no more than the cells of the number.
int number_width(const View& view, std::size_t ball);

/// Gives the balls of a pinball table the look of steel, which differs from the board.
void polish_balls(std::vector<Ink>& inks, const View& view, const Board& board);

// Onto the canvas, over all shapes.
void write_insert_names(BoardTexts& texts, const View& view);
/// The labels of the level.
void write_board_labels(BoardTexts& texts, const View& view);
/// What the colours stand for, where they are a scale: of speed, in length/s, or of mass.
void write_scale(Canvas& canvas, const View& view);
/// The distance of the grid lines at round coordinates, a length: 1, 2 or 5 times a power of ten,
/// so that they are some 16 columns apart.
double round_spacing(double columns_per_length);
/// The coordinates of the grid lines, along the bottom and the left side, where the grid is shown.
void write_coordinates(Canvas& canvas, const View& view);
void write_counters(Canvas& canvas, const View& view);
void write_labels(Canvas& canvas, const View& view);
void write_numbers(Canvas& canvas, const View& view);
void write_annotations(Canvas& canvas, const View& view);

}  // namespace carom

#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "level/scene/scene.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/raster.h"
#include "terminal/draw/board.h"

/// The ground of a picture: the board with its rail, and the areas that the level paints. It does
/// not change while the camera stands, so it is kept from picture to picture.
namespace carom {

/// An ink of the colour that a level gives; none of its own on a terminal without colours.
Ink dress_ink(Rgb24 color, const Look& look);

/// The inside of a pocket.
inline constexpr Rgb24 hole_color = 0x08090b;
inline constexpr double hole_share = 0.84;  ///< of the pocket's radius
/// Of the colour of a sink in what it shows; the rest is that of what lies below.
inline constexpr double sink_share = 0.47;

/// The colours of what is large in the picture, chosen together (surface_colors.h).
struct GroundInks {
    std::array<Color, ground_count> board{};  ///< by Ground
    Color nose = default_color;               ///< of a pool table's cushions
    Color chalk = default_color;              ///< a line that is drawn on the board
    std::vector<Color> areas;                 ///< those that the level paints, in its order
    std::vector<Color> sinks;                 ///< of colored_sinks(), over what lies below
};

/// The zones that are sinks to which the level gives a colour.
std::vector<std::size_t> colored_sinks(const Scene& scene);

class GroundLayer {
  public:
    /// Computes what the picture needs, unless that is known.
    void update(const Scene& scene, const Camera& camera, const Renderer& renderer,
                const Look& look);

    /// The board of the level. Computes it unless it is known.
    const Board& board(const Scene& scene);

    /// On a terminal with shades. Pre: updated.
    const GroundInks& inks() const { return inks_; }
    /// Whether the ground shows the sinks that have a colour. Pre: updated.
    bool has_sinks() const { return !colors_.empty(); }
    /// The raster to paint shapes on: with pixels that show the ground, else empty. Pre: updated.
    Raster raster() const;
    /// Whether the cell shows the ground alone: no shape and no text.
    bool is_bare(const Canvas& canvas, int column, int row) const;
    /// Whether the level has a board and the cell is outside of it. Pre: updated.
    bool is_off_board(int column, int row) const;
    /// The colour of the ground in the middle of a cell of the canvas; that of the screen where the
    /// picture has no ground. Pre: updated.
    Color behind(int column, int row) const;
    /// Gives cells without a background of their own that of the ground, under text and shapes.
    void lay(Canvas& canvas) const;

  private:
    struct Key {
        Camera camera;
        const Renderer* renderer = nullptr;
        Look look;

        friend bool operator==(const Key&, const Key&) = default;
    };
    /// Samples, the last of each row and column excluded.
    struct Samples {
        int left = 0;
        int right = 0;
        int top = 0;
        int bottom = 0;
    };
    void choose_inks(const Scene& scene);
    void fill(const Scene& scene);
    void weave(const Scene& scene);
    void paint();
    void fill_board();
    void fill_area(const PaintedArea& area, Color color);
    void fill_sinks(const Scene& scene);
    void fill_sink(const Capsule& shape, Color color);
    void fill_holes(const Scene& scene);
    bool fill_small_hole(const Disc& hole, Color color);
    Samples samples_in(const Box& box) const;
    Vec2 place_of(int across, int down) const;
    /// In the middle of a cell of the camera's area.
    Color color_of_cell(int column, int row) const {
        const Renderer& renderer = *key_->renderer;
        return color_at(column * renderer.across + renderer.across / 2,
                        row * renderer.down + renderer.down / 2);
    }
    Color& sample_of_cell(int column, int row) {
        const Renderer& renderer = *key_->renderer;
        return sample(column * renderer.across + renderer.across / 2,
                      row * renderer.down + renderer.down / 2);
    }
    Color color_at(int across, int down) const {
        return colors_[static_cast<std::size_t>(down) * static_cast<std::size_t>(across_) +
                       static_cast<std::size_t>(across)];
    }
    Color& sample(int across, int down) {
        return colors_[static_cast<std::size_t>(down) * static_cast<std::size_t>(across_) +
                       static_cast<std::size_t>(across)];
    }

    std::shared_ptr<const Board> board_;
    std::uint64_t scene_hash_ = 0;  ///< of the scene that the board is of
    std::optional<Key> key_;
    GroundInks inks_;
    std::optional<Raster> painted_;  ///< none: nothing to paint
    int across_ = 0;                 ///< samples
    int down_ = 0;
    std::vector<Color> colors_;  ///< row by row; default_color: no ground; empty: none anywhere
    /// With few colours: of the cloth of a pool table, cell by cell, as in `colors_`.
    std::vector<Color> cloth_;
};

}  // namespace carom

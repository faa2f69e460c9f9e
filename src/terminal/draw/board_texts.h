#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "terminal/canvas/canvas.h"
#include "terminal/draw/draw_parts.h"

/// Where do the labels of a level and the names of its lights stand on the board?
namespace carom {

/// Writes texts, and keeps each apart from those before it, so the caller writes the important ones
/// first. Between two texts in a row are two columns, or one where two do not fit. A text moves up
/// to three columns aside to where only the ground is, and stays outside of the board where all of
/// it is there. It never covers a ball. Without such a place it is left out: half on a part, or
/// half out of view, it could not be read.
class BoardTexts {
  public:
    /// Keeps references to both.
    BoardTexts(Canvas& canvas, const View& view) : canvas_(canvas), view_(view) {}

    /// Cells of a row.
    struct Span {
        int row = 0;
        int first = 0;
        int end = 0;  ///< past the last column
    };

    void write(int column, int row, std::string_view text, const Ink& ink);
    /// Whether a text would hide a light.
    bool covers_light(Span text) const;

  private:
    std::optional<Span> place_for(Span text, int columns) const;
    bool is_in_view(Span text) const;
    bool is_apart(Span text, int columns) const;
    bool is_bare(int column, int row) const;
    /// What all of the cells show. Outside: of the board, where the level has one.
    enum class Under : std::uint8_t { ground, part, outside, mixed };
    Under under(Span cells) const;
    bool is_in_glow(int column, int row) const;
    bool is_under(std::size_t ball, int column, int row) const;
    bool is_under_ball(int column, int row) const;
    bool is_under_moving_ball(int column, int row) const;

    Canvas& canvas_;
    const View& view_;
    std::vector<Span> written_;
};

}  // namespace carom

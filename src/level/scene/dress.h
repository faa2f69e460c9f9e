#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes.h"

/// The dress of a level: colours, painted areas, labels and inserts. None of it is part of the
/// world, so it changes neither the physics nor a fingerprint.
namespace carom {

/// Red, green and blue, 8 bits each: 0xRRGGBB.
using Rgb24 = std::uint32_t;

/// A filled area under everything on its layer. Later areas cover earlier ones.
struct PaintedArea {
    std::vector<Vec2> corners;  ///< of a polygon, filled by the even-odd rule; empty: a disc
    Disc disc;
    Rgb24 color = 0;
    std::uint8_t layer = 0;  ///< above 0: over the balls on the board, and see-through
};

/// Text on the board, in one line.
struct BoardLabel {
    /// Which point of the text lies at `at`.
    enum class Align : std::uint8_t { center, left, right };
    std::string text;  ///< safe to print on a terminal
    Vec2 at;
    Align align = Align::center;
    std::optional<Rgb24> color;
};

/// The shape of a light that is set into the board.
enum class InsertShape : std::uint8_t { circle, arrow, triangle, square, diamond, star, bar };

/// How a device of a pinball table looks.
struct DeviceDress {
    std::optional<Rgb24> color;
    bool is_insert = false;  ///< made by `insert`: the following are its own
    InsertShape shape = InsertShape::circle;
    double radius = 0.0;       ///< from its middle to its rim, length
    Vec2 direction{0.0, 1.0};  ///< unit vector: where an arrow points
    std::string text;          ///< written on it, or beside it; may be empty
};

/// `theme`: the colours of the board as a whole.
struct BoardTheme {
    std::optional<Rgb24> board;  ///< the ground inside of the outer edges: cloth, playfield
    std::optional<Rgb24> rail;   ///< the frame around the board
    std::optional<Rgb24> edge;   ///< of edges whose material has no colour of its own
};

/// A string from which a ball of a cradle seems to hang. It is a picture: cradles have no strings.
struct CradleString {
    std::uint32_t ball = 0;  ///< number of the ball
    Vec2 pivot;              ///< above the place where the ball hangs at rest
    bool is_first = false;   ///< of its cradle
};

/// Lists by number are as long as what they describe, or empty, where nothing has a colour.
struct Dress {
    std::vector<std::optional<Rgb24>> kinds;      ///< by World::kinds
    std::vector<std::optional<Rgb24>> materials;  ///< by World::materials
    std::vector<std::optional<Rgb24>> balls;      ///< by number of the ball
    std::vector<std::optional<Rgb24>> edges;      ///< by number of the capsule
    std::vector<std::optional<Rgb24>> zones;      ///< by World::zones
    std::vector<DeviceDress> devices;             ///< by PinballTable::devices
    std::vector<PaintedArea> areas;
    std::vector<BoardLabel> labels;
    std::vector<CradleString> strings;  ///< cradle by cradle, each from one end to the other
    BoardTheme theme;
    std::vector<std::uint8_t> layers;  ///< by World::materials: 0 is the board, others lie above
};

/// The colour in such a list; none: the level gives it no colour, as it gives none to what was
/// added in play.
inline std::optional<Rgb24> color_in(const std::vector<std::optional<Rgb24>>& list,
                                     std::size_t number) {
    return number < list.size() ? list[number] : std::nullopt;
}

}  // namespace carom

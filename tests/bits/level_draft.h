#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

#include "bits/level_writer.h"
#include "bits/scene_random.h"

/// A random level under construction: its text so far, its scales, and the occupied places.
namespace carom::bits {

struct Point {
    double x = 0.0;
    double y = 0.0;
};

/// Numbers in the syntax of levels and recordings; they read back to the same bits.
std::string text_of(double value);
std::string text_of(Point p);

/// A line of a level or a recording, written word by word. Operands of << are evaluated from left
/// to right, so the random numbers in them are drawn in one order with every compiler. Those of +
/// are not.
class Line {
  public:
    Line& operator<<(std::string_view words) { return text_ += words, *this; }
    Line& operator<<(char letter) { return text_ += letter, *this; }
    Line& operator<<(std::floating_point auto value) { return text_ += text_of(value), *this; }
    Line& operator<<(std::integral auto value) { return text_ += std::to_string(value), *this; }
    Line& operator<<(Point p) { return text_ += text_of(p), *this; }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

struct Draft {
    struct Disc {
        Point at;
        double r = 0.0;
    };
    struct Edge {
        Point a, b;
        double r = 0.0;
    };

    Random& random;
    Level level;
    double length = 1.0;  ///< about the diameter of a ball
    double speed = 1.0;   ///< a typical speed: a ball crosses some lengths within the level's time
    Point origin;
    std::vector<Disc> discs;  ///< balls
    std::vector<Edge> edges;  ///< edges, or discs that contain them

    void line(std::string_view text) { level.text.append(text) += '\n'; }
    void line(const Line& words) { line(words.text()); }
    /// Records where an edge is, so that no ball starts there.
    void add_edge(Point a, Point b, double r);
    /// A point of the scene, from its lower left corner.
    Point at(double x, double y) const { return {origin.x + x, origin.y + y}; }
    /// Any point of the scene.
    Point place();
    /// The name of a material, preceded by a blank, or nothing.
    std::string material();
    bool is_inside(Point p) const;
    /// Whether a disc overlaps nothing.
    bool fits(Point p, double r) const;
};

/// Bumpers, flippers and other pinball devices, anywhere.
void add_pinball_parts(Draft& draft);
void add_pockets(Draft& draft);
/// Zones and bins that count or remove balls.
void add_sinks(Draft& draft);
void add_grid_of_pegs(Draft& draft);

}  // namespace carom::bits

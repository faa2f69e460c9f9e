#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bits/level_writer.h"
#include "bits/scene_random.h"

/// A random level as it grows: its text so far, its scales, and where things already lie.
namespace carom::bits {

struct Point {
    double x = 0.0;
    double y = 0.0;
};

/// As levels and recordings write them; they read back to the same bits.
std::string text_of(double value);
std::string text_of(Point p);

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
    double speed = 1.0;   ///< a usual one: it takes a ball some lengths in the level's time
    Point origin;
    std::vector<Disc> discs;  ///< balls
    std::vector<Edge> edges;  ///< edges, or discs that have those within

    void line(std::string_view text) { level.text.append(text) += '\n'; }
    /// Notes where an edge lies, so that no ball starts there.
    void add_edge(Point a, Point b, double r);
    /// A point of the scene, from its lower left corner.
    Point at(double x, double y) const { return {origin.x + x, origin.y + y}; }
    /// Any point of the scene.
    Point place();
    /// The name of a material with a blank, or nothing.
    std::string material();
    bool is_inside(Point p) const;
    /// Whether a disc overlaps nothing.
    bool fits(Point p, double r) const;
};

/// Bumpers, flippers and whatever else a pinball table has, anywhere.
void add_pinball_parts(Draft& draft);
void add_pockets(Draft& draft);
/// Zones and bins that count balls or swallow them.
void add_sinks(Draft& draft);
void add_grid_of_pegs(Draft& draft);

}  // namespace carom::bits

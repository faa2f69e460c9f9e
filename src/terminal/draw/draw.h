#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "level/scene/scene.h"
#include "physics/world/contact.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"
#include "terminal/canvas/renderer.h"
#include "terminal/draw/overlays.h"
#include "terminal/draw/pool_marks.h"
#include "terminal/draw/table_marks.h"
#include "terminal/draw/trails.h"

/// Draws a world into a canvas. Start here: a camera says what is seen, view options say how, marks
/// say what the player is doing, and the memory is what a picture needs to know of the one before.
namespace carom {

enum class ColorBy : std::uint8_t {
    kind,  ///< by ball where all are of one kind
    speed,
    mass,
    ball
};
enum class BallStyle : std::uint8_t {
    filled,
    outline  ///< with a radius that shows where the ball heads
};
enum class Labels : std::uint8_t {
    none,
    automatic,  ///< without colour: on balls that are big enough
    all         ///< the id at every ball
};

struct ViewOptions {
    RendererChoice renderer = nullptr;  ///< null: what suits the terminal
    ColorBy color_by = ColorBy::kind;
    BallStyle ball_style = BallStyle::filled;
    Labels labels = Labels::automatic;
    bool trails = false;
    OverlaySet overlays;

    Look look;
};

/// The renderer that the options come to on this terminal.
const Renderer& renderer_in_force(const ViewOptions& options);

/// The cells of a uniform grid, or of the uniform part of what the solver uses.
struct CellGrid {
    Vec2 origin;
    double size = 0.0;  ///< length, > 0
};

/// A pulled cue.
struct CueLine {
    Vec2 ball;          ///< the middle of the ball, length
    Vec2 hand;          ///< where the pull has got to
    std::string speed;  ///< written beside it, as in "3.20 m/s"
};

/// What the player points at and does. Positions are of the world.
struct Marks {
    std::optional<BallId> selected_ball;
    std::optional<CapsuleId> selected_capsule;  ///< both of its ends get handles
    std::optional<Vec2> cursor;
    std::optional<CueLine> cue;
    std::optional<Capsule> new_capsule;  ///< while an edge is being drawn
    std::vector<Vec2> path;              ///< a line of dots, such as a predicted path
    std::optional<CellGrid> broad_phase;
    /// Copies of the world: their balls are drawn in place of its own, as a density.
    std::span<const World> copies;
    std::optional<PoolMarks> pool;
    std::optional<TableMarks> table;
    std::optional<Vec2> divergence;  ///< where a ball left its twin in another picture
};

/// What a picture remembers of those before it. One for each view; start with a fresh one for each
/// level.
struct ViewMemory {
    Trails trails;
    double fastest = 0.0;    ///< speed of the fastest ball of late, length/s
    std::uint64_t tick = 0;  ///< of the world, when it was drawn
};

/// Draws into camera.area, which is blanked first; nothing outside is touched. `world` may be ahead
/// of `scene`, which gives the names. Balls and edges may lie anywhere, be of any size, and be not
/// finite: what cannot be seen is not drawn. On a torus, what stands across a side shows on both.
void draw_world(Canvas& canvas, const Camera& camera, const Scene& scene, const World& world,
                std::span<const Contact> contacts, const Marks& marks, const ViewOptions& options,
                ViewMemory& memory);

}  // namespace carom

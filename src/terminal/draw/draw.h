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
#include "terminal/draw/ground.h"
#include "terminal/draw/overlays.h"
#include "terminal/draw/pool_annotations.h"
#include "terminal/draw/table_annotations.h"
#include "terminal/draw/trails.h"

/// Draws a world into a canvas. Start here: a camera says which part is seen, view options say how,
/// annotations say what the player points at and does, and the view memory carries state from one
/// picture to the next.
namespace carom {

enum class ColorBy : std::uint8_t {
    kind,  ///< by ball where all are of one kind
    speed,
    mass,
    ball
};
enum class BallStyle : std::uint8_t {
    filled,
    outline  ///< with a radius that shows the direction of motion
};
enum class Labels : std::uint8_t {
    none,
    automatic,  ///< without colour: on balls that are large enough
    all         ///< the id on every ball
};

struct ViewOptions {
    RendererChoice renderer = nullptr;  ///< null: the one that suits the terminal
    ColorBy color_by = ColorBy::kind;
    BallStyle ball_style = BallStyle::filled;
    Labels labels = Labels::automatic;
    bool trails = false;
    bool counters = true;     ///< numbers over bins
    bool board_texts = true;  ///< the labels of the board, and the names of its lights
    bool is_table = false;    ///< of pinball, where one small ball and the lights must be seen
    OverlaySet overlays;

    Look look;
};

/// The renderer that the options resolve to on this terminal.
const Renderer& renderer_in_force(const ViewOptions& options);

/// The cells of a uniform grid, or of the uniform part of the structure that the solver uses.
struct CellGrid {
    Vec2 origin;
    double size = 0.0;  ///< length, > 0
};

/// A cue that is pulled back.
struct CueLine {
    Vec2 ball;          ///< its centre, length
    Vec2 hand;          ///< how far back the cue is pulled, length
    std::string speed;  ///< written beside it, such as "3.20 m/s"
};

/// Drawn over the world: what the player points at and does. Positions are in world coordinates.
struct Annotations {
    std::optional<BallId> selected_ball;
    std::optional<CapsuleId> selected_capsule;  ///< both of its ends get handles
    std::optional<Vec2> cursor;
    std::optional<CueLine> cue;
    std::optional<Capsule> new_capsule;  ///< while the player draws an edge
    std::vector<Vec2> path;              ///< dots along it, such as a predicted path
    std::optional<CellGrid> broad_phase;
    /// Copies of the world: their balls are drawn as a density, in place of the world's own.
    std::span<const World> copies;
    std::optional<PoolAnnotations> pool;
    std::optional<TableAnnotations> table;
    std::vector<Vec2> marks;  ///< places to look at: a divergence, a collision, what is in the way
};

/// A hard impact that still shows.
struct ImpactFlash {
    Vec2 place;
    double radius = 0.0;     ///< of the ball, length
    std::uint64_t tick = 0;  ///< when it happened
};

/// What a picture needs to know about earlier pictures. One for each view; start afresh for each
/// level.
struct ViewMemory {
    Trails trails;
    GroundLayer ground;
    double fastest = 0.0;    ///< the recent top speed of the balls, length/s
    std::uint64_t tick = 0;  ///< the world's tick when it was last drawn
    std::vector<ImpactFlash> flashes;
    std::uint64_t flashed_at = 0;  ///< the tick whose impacts were noted last
};

/// Draws into camera.area, which is blanked first; nothing outside is touched. `world` may be ahead
/// of `scene`, which provides the names. Balls and edges may lie anywhere, be of any size, and be
/// not finite: what is out of view is not drawn. On a torus, a body across a side shows on both.
void draw_world(Canvas& canvas, const Camera& camera, const Scene& scene, const World& world,
                std::span<const Contact> contacts, const Annotations& annotations,
                const ViewOptions& options, ViewMemory& memory);

}  // namespace carom

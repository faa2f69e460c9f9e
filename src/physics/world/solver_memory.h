#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes.h"
#include "physics/memory/large_pages.h"
#include "physics/world/contact.h"
#include "physics/world/ids.h"
#include "physics/world/model.h"

/// What a solver leaves in the world for its next tick, beyond the bodies.
namespace carom {

/// How a ball moves, for the solver `event`.
enum class Motion : std::uint8_t {
    free,      ///< flies
    sliding,   ///< along the side of an edge
    turning,   ///< round an end of an edge, a peg or a ball that rests
    resting,   ///< does not move until it is hit or its support goes
    held,      ///< a hand moves it: a straight line, whatever acts on it
    slipping,  ///< on cloth, over which its lowest point slips
    rolling,   ///< on cloth
    still      ///< on cloth
};

/// What carries a ball, by number; on a torus, which image of it.
struct PathSupport {
    enum class By : std::uint8_t { nothing, edge, ball };
    By by = By::nothing;
    std::int8_t across = 0;
    std::int8_t along = 0;
    std::uint32_t number = 0;

    friend bool operator==(const PathSupport&, const PathSupport&) = default;
};

/// The path that a ball has been on since its last event: at `position` with `velocity` at `time`.
/// The solver `event` goes from one event to the next, however many ticks lie between: so that the
/// next tick starts from the very path and not from its rounded end, the path belongs to the state.
struct BallPath {
    BallId id{};
    std::uint16_t quick = 0;  ///< collisions in a row without way between them, as far as it counts
    Motion motion = Motion::free;
    double time = 0.0;  ///< s since the start
    Vec2 position;
    Vec2 velocity;

    friend bool operator==(const BallPath&, const BallPath&) = default;
};

/// What makes the path of a ball other than a straight line; drag does so to all of them.
struct PathBend {
    Vec2 acceleration;  ///< since the path's `time`, before drag
    Vec2 center;        ///< turning: of the circle; on cloth: the roll (cloth.h) at `time`
    PathSupport support;
    PathSupport second_support;
    /// Sum of the edges that carry it, as they were when it began (event_path.h): what carries it
    /// is no longer there once that is another.
    std::uint32_t carriers = 0;

    friend bool operator==(const PathBend&, const PathBend&) = default;
};

/// Whether anything can bend the paths of balls, drag apart: without gravity and cloth nothing
/// accelerates, carries or presses a ball between two events.
inline bool has_bends(const Model& model) {
    return model.gravity || model.cloth;
}

/// A ball that presses on another or on an edge: what the solver `contact` starts the next tick
/// from.
struct PressedPair {
    BallId ball{};            ///< of two balls the lower
    std::uint32_t other = 0;  ///< number of the other ball, or of the edge
    ContactKind kind = ContactKind::ball_ball;
    std::int8_t across = 0;  ///< which image of the edge on a torus
    std::int8_t along = 0;
    double impulse = 0.0;  ///< in a substep, along the normal, mass * length/s
    double rub = 0.0;      ///< the same, across it

    friend bool operator==(const PressedPair&, const PressedPair&) = default;
};

/// Where the balls were when the solver `contact` last looked who could meet whom. While each stays
/// within its margin of there, it goes on with the same pairs in the same order: they belong to the
/// state, since pairs are solved one after another. Counts only for a world of just these balls.
struct Homes {
    std::vector<BallId> ball;
    std::vector<Vec2> place;     ///< by index: of the ball's centre
    std::vector<double> margin;  ///< by index, length

    void clear() {
        ball.clear();
        place.clear();
        margin.clear();
    }
};

/// How a ball on a BallPath turns: with `spin` at `time`, changing at `rate` since.
struct SpinPath {
    double time = 0.0;   ///< s since the start
    double spin = 0.0;   ///< rad/s, counter-clockwise
    double rate = 0.0;   ///< rad/s^2
    bool rolls = false;  ///< along the side of an edge, without slip

    friend bool operator==(const SpinPath&, const SpinPath&) = default;
};

/// All that solvers remember. A solver clears what others have left.
struct SolverMemory {
    /// Ascending by id; empty unless the last tick was one of the solver `event`. A path counts
    /// only while it leads through the ball's position and velocity, bit by bit, so a change of the
    /// ball from outside leaves it alone.
    LargeVector<BallPath> paths;
    std::vector<PathBend> path_bends;  ///< beside `paths`; empty unless has_bends (Model)
    std::vector<SpinPath> spin_paths;  ///< beside `paths`; empty unless Model::spin
    Vec2 paths_gravity;       ///< what acted on `paths`: in another field they count no more
    double paths_drag = 0.0;  ///< 1/s
    /// What they could meet when they were left: sum_of_obstacles (trajectory.h), or 0 where a
    /// kinematic edge moved. With another sum, a path that would have met an edge before now counts
    /// no more.
    std::uint64_t paths_obstacles = 0;

    /// Ascending by ball; empty unless the last tick was one of the solver `contact`, or of `event`
    /// with a cluster.
    std::vector<PressedPair> pressed;
    /// Empty unless the last tick was one of the solver `contact`, and something could press in it.
    Homes homes;
    /// Balls that the hybrid step hands over to `contact` in the next tick, with all that could
    /// meet them (hybrid_step.h). Ascending; ids of removed balls are ignored. Empty unless the
    /// last tick was one of the solver `event`.
    std::vector<BallId> heaped;
};

}  // namespace carom

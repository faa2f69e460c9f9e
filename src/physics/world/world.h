#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/shapes.h"
#include "physics/memory/large_pages.h"
#include "physics/world/bodies.h"
#include "physics/world/contact.h"
#include "physics/world/flipper.h"
#include "physics/world/ids.h"
#include "physics/world/model.h"

/// The world: all state of a simulation, and nothing else. Copy it and you have a snapshot; a copy
/// that goes on gives the same bits as the original.
///
/// Units throughout: length, mass and time of the level (SI where the level has `units`); angles in
/// radians. Balls are laid out as one array a quantity; a ball's place in the arrays is its
/// *index*, which changes when balls before it are removed; its *id* never changes. Arrays are
/// always in ascending order of id.
namespace carom {

/// A region that reports and does not push.
struct Zone {
    enum class Effect : std::uint8_t {
        census,  ///< its counter is the number of balls whose centre is in it now
        sink     ///< a ball whose centre is in it at the end of a tick is counted and removed
    };
    Capsule shape;
    Effect effect = Effect::census;
    std::uint32_t counter = 0;  ///< index into World::counters
};

/// Gives birth to balls of one kind: number n (from 0) in the first tick that ends after n * every
/// seconds, or as soon after that as its place is free (unless balls do not meet).
struct Emitter {
    ClassIndex kind = 0;
    Vec2 at;
    Vec2 velocity;
    Vec2 jitter;           ///< largest offset from `at`, uniform, seeded
    Vec2 velocity_jitter;  ///< largest offset from `velocity`, uniform, seeded
    double every = 1.0;    ///< s, > 0
    std::uint32_t count = 0;
    std::uint32_t emitted = 0;
};

/// A ball in a hand: it goes where the hand is, pushes what it meets, and nothing pushes it. It can
/// be carried no further than the edges let it.
struct HeldBall {
    BallId id{};
    Vec2 target;
};

/// A capsule in a hand: its ends go to the targets during the next tick. It pushes balls aside,
/// without throwing them: a ball leaves it no faster along the normal than it came, or than the
/// edge moves.
struct HeldCapsule {
    CapsuleId id{};
    Vec2 start_target;
    Vec2 end_target;
    /// It is driven, not held: it throws what it meets, as a wall that moves.
    bool is_driven = false;
};

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

/// A ball that is no longer there.
struct Removal {
    BallId id{};
    std::int32_t zone = -1;  ///< index into World::zones, or -1: removed by the player
    std::uint64_t tick = 0;
};

struct World {
    Model model;
    std::uint64_t seed = 0;
    double rate = 120.0;     ///< ticks a second, > 0
    std::uint64_t tick = 0;  ///< ticks done

    Balls balls;
    Capsules capsules;
    std::vector<Kind> kinds;
    std::vector<Material> materials;
    /// Row by row, 1 where two classes meet; classes are the kinds, then the materials. Symmetric.
    /// Empty unless Model::filtered.
    std::vector<std::uint8_t> meets;

    std::vector<Zone> zones;
    std::vector<Emitter> emitters;
    std::vector<std::uint64_t> counters;  ///< what sinks have counted; see also `census`
    std::vector<Removal> removed;

    std::vector<Flipper> flippers;  ///< each of another capsule, ascending by it

    std::vector<HeldBall> held_balls;        ///< ascending by id
    std::vector<HeldCapsule> held_capsules;  ///< ascending by id

    /// Ascending by id; empty unless the last tick was one of the solver `event`. A path counts
    /// only while it leads through the ball's position and velocity, bit by bit, so what moves a
    /// ball from outside need not know of it.
    LargeVector<BallPath> paths;
    std::vector<PathBend> path_bends;  ///< beside `paths`; empty unless has_bends (Model)
    std::vector<SpinPath> spin_paths;  ///< beside `paths`; empty unless Model::spin
    Vec2 paths_gravity;       ///< what acted on `paths`: another field, and they count no more
    double paths_drag = 0.0;  ///< 1/s
    /// By which a solver knows the paths that it left: the sum of sum_of (event_path.h) over them.
    std::uint64_t paths_sum = 0;
    /// What they could meet, when they were left: sum_of_obstacles (event_path.h); or 0, where a
    /// hand moved edges. With another, one that would have met an edge before counts no more.
    std::uint64_t paths_obstacles = 0;

    /// Ascending by ball; empty unless the last tick was one of the solver `contact`, or `event`
    /// had a heap in it.
    std::vector<PressedPair> pressed;
    /// Empty unless the last tick was one of the solver `contact`, and something could press in it.
    Homes homes;
    /// Balls that the solver `event` hands over to `contact` in the next tick, with all that could
    /// meet them (handover.h). Ascending; numbers of balls that are gone do not count. Empty unless
    /// the last tick was one of the solver `event`.
    std::vector<BallId> heaped;

    std::uint32_t next_ball = 0;
    std::uint32_t next_capsule = 0;
    std::uint64_t ball_ball_collisions = 0;
    std::uint64_t ball_edge_collisions = 0;

    /// s since the start.
    double time() const { return static_cast<double>(tick) / rate; }
    /// s a tick.
    double tick_length() const { return 1.0 / rate; }
};

/// Pre: kind is an index into world.kinds; radius and mass positive and finite. A restitution below
/// 1 makes the model lossy.
BallId add_ball(World& world, const BallSpec& spec);

/// Pre: material is an index into world.materials. A material with restitution below 1 or soften >
/// 0 makes the model lossy, one with a kick makes it one that kicks, and a side other than both
/// makes it one_way.
CapsuleId add_capsule(World& world, const Capsule& shape, ClassIndex material,
                      Side side = Side::both);

/// The ball's index, or none when it is not (or no longer) there.
std::optional<std::size_t> index_of(const World& world, BallId id);
std::optional<std::size_t> index_of(const World& world, CapsuleId id);

/// From now on the edge pushes on this side; the model becomes one_way where it has to. Nothing
/// happens when there is no such edge.
void set_side(World& world, CapsuleId id, Side side);

/// How many kinds there are, each counted once whatever the layers.
std::size_t kinds_of_a_layer(const World& world);
/// The ball is on this layer from now on: it meets what stands there. Nothing happens when there is
/// no such ball, or no such layer.
void set_layer(World& world, BallId id, std::uint8_t layer);

/// The solver `event` starts from where the balls are. As if the last tick had been another's.
void forget_paths(World& world);

/// By the player; `removed` gets an entry. Nothing happens when there is no such ball.
void remove_ball(World& world, BallId id);
void remove_capsule(World& world, CapsuleId id);

/// World::counters with the balls that are in census zones now. Index = Zone::counter.
std::vector<std::uint64_t> census(const World& world);

/// Whether a ball of kind `a` and a ball of kind `b` meet; and a ball of a kind with an edge of a
/// material.
bool kinds_meet(const World& world, ClassIndex a, ClassIndex b);
bool kind_meets_material(const World& world, ClassIndex kind, ClassIndex material);

}  // namespace carom

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/shapes.h"
#include "physics/world/bodies.h"
#include "physics/world/ids.h"
#include "physics/world/model.h"

/// What a world has besides its bodies: its definition, zones, emitters, and kinematic bodies,
/// which go where something outside the physics moves them.
///
/// Units: length, mass and time of the level; angles in radians.
namespace carom {

/// A region that reports balls and does not push them.
struct Zone {
    enum class Effect : std::uint8_t {
        census,  ///< its counter is the number of balls whose centre is in the region now
        sink     ///< counts and removes a ball whose centre is in the region when a tick ends
    };
    Capsule shape;
    Effect effect = Effect::census;
    std::uint32_t counter = 0;  ///< index into Ledger::counters
};

/// What the level asks of the solver that `auto` picks; no solver reads it.
///
/// With a budget, `auto` picks the most accurate solver that keeps the budget and the tolerance, if
/// there is one. With a tolerance alone, it picks the cheapest solver that keeps it. If no solver
/// does, it picks the most accurate one, or without a tolerance one that keeps the budget.
struct Need {
    std::optional<double> tolerance;  ///< error of a position, radii, > 0 ...
    double within = 10.0;             ///< ... after so many seconds, > 0
    std::optional<double> budget;     ///< s of computation a tick, > 0

    friend bool operator==(const Need&, const Need&) = default;
};

/// What a scene is made of. Ticks do not change it, with one exception: an emitter that makes the
/// first ball with a restitution below 1 sets Model::inelastic.
struct Definition {
    Model model;
    Need need;
    std::uint64_t seed = 0;
    double rate = 120.0;  ///< ticks a second, > 0
    std::vector<Kind> kinds;
    std::vector<Material> materials;
    /// Row by row, 1 where two classes meet; classes are the kinds, then the materials. Symmetric.
    /// Empty without Model::filtered.
    std::vector<std::uint8_t> meets;
    std::vector<Zone> zones;
};

/// Makes balls of one kind. Ball n (from 0) appears in the first tick that ends after n * every
/// seconds, or as soon after that as its place is free (at once if balls do not meet).
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

/// A ball as a kinematic body. It moves to its target during the next tick and pushes what it
/// meets; nothing pushes it, but edges stop it.
struct HeldBall {
    BallId id{};
    Vec2 target;
};

/// An edge as a kinematic body. Its ends move to their targets during the next tick. It pushes
/// balls aside without throwing them: a ball leaves it no faster along the normal than it came, or
/// than the edge moves and 5 % of its approach (`hand_restitution`, laws/bounce.h).
struct HeldCapsule {
    CapsuleId id{};
    Vec2 start_target;
    Vec2 end_target;
    /// Motorised, by a flipper or a mover: it throws what it meets, as a moving wall does.
    bool is_driven = false;
    /// The edge of a seesaw: the solver turns it, the targets mean nothing, and balls push it.
    bool is_seesaw = false;
};

/// A hand that holds a ball or an edge: what the next tick must know about it (tick/hands.h).
struct Hand {
    bool is_on_ball = false;
    std::uint32_t number = 0;  ///< id of the ball or the edge
    Vec2 start_target;         ///< that of the last tick; of a ball, its target
    Vec2 end_target;
    double pace = 0.0;  ///< its speed limit, length/s

    friend bool operator==(const Hand&, const Hand&) = default;
};

/// All hands. They yield together, so that edges that a player drags by their joint stay joined.
struct Hands {
    std::vector<Hand> each;  ///< balls before edges, ascending by number
    double share = 1.0;      ///< how much of their displacements the last tick allowed
    double overlap = 0.0;    ///< the deepest in the scene when the first hand took hold, in radii

    friend bool operator==(const Hands&, const Hands&) = default;
};

/// A ball that has been removed.
struct Removal {
    BallId id{};
    std::int32_t zone = -1;  ///< index into Definition::zones, or -1: removed by a player
    std::uint64_t tick = 0;
};

/// What has happened so far.
struct Ledger {
    std::vector<std::uint64_t> counters;  ///< balls that sinks have counted; see also `census`
    std::vector<Removal> removed;
    std::uint64_t ball_ball_collisions = 0;
    std::uint64_t ball_edge_collisions = 0;
};

}  // namespace carom

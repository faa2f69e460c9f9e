#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/shapes.h"
#include "physics/world/bodies.h"
#include "physics/world/flipper.h"
#include "physics/world/ids.h"
#include "physics/world/model.h"
#include "physics/world/mover.h"
#include "physics/world/seesaw.h"
#include "physics/world/solver_memory.h"
#include "physics/world/stamp.h"
#include "physics/world/things.h"

/// The world: all state of a simulation, and nothing else. A copy continues with the same bits as
/// the original. README.md says what else a snapshot of a game holds, who may write to a world,
/// and how each solver learns of it.
namespace carom {

/// Reading is free; every change goes through a function named edit_.... Those that are not inline
/// give what they change a new stamp (stamp.h), on every call. The tick, emitters, flippers,
/// movers, seesaws, hands, ledger and ids have none, since no solver prepares anything from them.
/// Solvers, which write in every tick, have SolverAccess (solver_access.h).
///
/// Invariants, which edits must keep:
/// - rows of balls and capsules, and the lists of kinematic bodies, are in ascending order of id;
/// - a column is as long as its table, or empty where the model does not use it;
/// - equal stamps mean equal data, of what has a stamp.
///
/// A reference from edit_... is for the statement or block that asked for it. Do not keep it across
/// a tick or a copy: what is written later has no new stamp.
class World {
  public:
    // Defined in world.cpp: the code for so many members is then compiled once, not wherever a
    // world is made or copied.
    World();
    World(const World& other);
    World(World&& other) noexcept;
    World& operator=(const World& other);
    World& operator=(World&& other) noexcept;
    ~World();

    const Definition& definition() const { return definition_; }
    const Model& model() const { return definition_.model; }
    std::uint64_t seed() const { return definition_.seed; }
    double rate() const { return definition_.rate; }  ///< ticks a second
    const std::vector<Kind>& kinds() const { return definition_.kinds; }
    const std::vector<Material>& materials() const { return definition_.materials; }
    const std::vector<Zone>& zones() const { return definition_.zones; }

    std::uint64_t tick() const { return tick_; }                         ///< ticks done
    double time() const { return static_cast<double>(tick_) / rate(); }  ///< s since the start
    double tick_length() const { return 1.0 / rate(); }                  ///< s a tick

    const Balls& balls() const { return balls_; }
    const Capsules& capsules() const { return capsules_; }
    const std::vector<Emitter>& emitters() const { return emitters_; }
    /// Each turns another capsule; ascending by it.
    const std::vector<Flipper>& flippers() const { return flippers_; }
    const std::vector<Mover>& movers() const { return movers_; }     ///< each of other edges
    const std::vector<Seesaw>& seesaws() const { return seesaws_; }  ///< ascending by edge
    const std::vector<HeldBall>& held_balls() const { return held_balls_; }           ///< by id
    const std::vector<HeldCapsule>& held_capsules() const { return held_capsules_; }  ///< by id
    /// How far the hands that hold those may move in a tick; not of flippers or movers.
    const Hands& hands() const { return hands_; }

    /// What has been counted and removed.
    const Ledger& ledger() const { return ledger_; }

    const SolverMemory& memory() const { return memory_; }
    const Stamps& stamps() const { return stamps_; }
    /// Number of the next ball to be added: ids are given once.
    std::uint32_t next_ball() const { return ids_.next_ball; }

    Definition& edit_definition();
    std::uint64_t& edit_tick() { return tick_; }
    Balls& edit_balls();
    Capsules& edit_capsules();
    std::vector<Emitter>& edit_emitters() { return emitters_; }
    std::vector<Flipper>& edit_flippers() { return flippers_; }
    std::vector<Mover>& edit_movers() { return movers_; }
    std::vector<Seesaw>& edit_seesaws() { return seesaws_; }
    std::vector<HeldBall>& edit_held_balls();
    std::vector<HeldCapsule>& edit_held_capsules();
    Hands& edit_hands() { return hands_; }
    Ledger& edit_ledger() { return ledger_; }
    SolverMemory& edit_memory();
    /// Whoever takes an id adds the row.
    NextIds& edit_ids() { return ids_; }

  private:
    friend class SolverAccess;

    Definition definition_;
    std::uint64_t tick_ = 0;
    Balls balls_;
    Capsules capsules_;
    std::vector<Emitter> emitters_;
    std::vector<Flipper> flippers_;
    std::vector<Mover> movers_;
    std::vector<Seesaw> seesaws_;
    std::vector<HeldBall> held_balls_;
    std::vector<HeldCapsule> held_capsules_;
    Hands hands_;
    Ledger ledger_;
    SolverMemory memory_;
    Stamps stamps_;
    NextIds ids_;
};

/// Bytes that a copy occupies.
std::size_t bytes_of(const World& world);

/// Pre: kind is an index into World::kinds(); radius and mass positive and finite. A restitution
/// below 1 sets Model::inelastic, and a kind with friction Model::rough.
BallId add_ball(World& world, const BallSpec& spec);

/// Sets Model::inelastic. Balls that are there stay elastic.
void become_inelastic(World& world);

/// The spec of a ball that is like this one in everything but its id. Pre: index < balls().size().
BallSpec spec_of(const World& world, std::size_t index);
/// A copy of the spec, at rest at `position` and without spin.
BallSpec spec_at_rest(const World& world, std::size_t index, Vec2 position);

/// Pre: material is an index into World::materials(). A material with restitution below 1 or soften
/// > 0 sets Model::inelastic, one with friction Model::rough, one with a kick Model::kicks, and a
/// side other than both sets Model::one_way.
CapsuleId add_capsule(World& world, const Capsule& shape, ClassIndex material,
                      Side side = Side::both);

/// The ball's index, or none when it is not (or no longer) there.
std::optional<std::size_t> index_of(const World& world, BallId id);
std::optional<std::size_t> index_of(const World& world, CapsuleId id);

/// How the ball or the edge is held as a kinematic body: by the player, and within a tick also by a
/// flipper, a mover or a hinge. Null where it is not held. Valid until the list changes.
const HeldBall* held_of(const World& world, BallId id);
const HeldCapsule* held_of(const World& world, CapsuleId id);
inline bool is_held(const World& world, BallId id) {
    return held_of(world, id) != nullptr;
}
inline bool is_held(const World& world, CapsuleId id) {
    return held_of(world, id) != nullptr;
}
/// Holds the ball or the edge from now on, in this way alone.
void hold(World& world, const HeldBall& held);
void hold(World& world, const HeldCapsule& held);

/// Sets the side on which the edge pushes, and Model::one_way if the side requires it. Nothing
/// happens when there is no such edge.
void set_side(World& world, CapsuleId id, Side side);

/// Makes the edge a piece of a curve, which continues in these edges, and sets Model::curved.
/// Nothing happens when there is no such edge.
void set_joints(World& world, CapsuleId id, const Joints& joints);

/// How many kinds there are, each counted once whatever the layers.
std::size_t kinds_of_a_layer(const World& world);
/// Moves the ball to this layer: it then collides with the edges and balls of the layer. Nothing
/// happens when there is no such ball, or no such layer.
void set_layer(World& world, BallId id, std::uint8_t layer);

/// The solver `event` starts new trajectories from where the balls are.
void forget_trajectories(World& world);

/// By the player; `removed` gets an entry. Nothing happens when there is no such ball.
void remove_ball(World& world, BallId id);
void remove_capsule(World& world, CapsuleId id);

/// Ledger::counters with the balls that are in census zones now. Index = Zone::counter.
std::vector<std::uint64_t> census(const World& world);

/// Whether a ball of kind `a` and a ball of kind `b` meet; and a ball of a kind with an edge of a
/// material.
bool kinds_meet(const World& world, ClassIndex a, ClassIndex b);
bool kind_meets_material(const World& world, ClassIndex kind, ClassIndex material);

}  // namespace carom

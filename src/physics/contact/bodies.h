#pragma once

#include <cstdint>

#include "geometry/vec2.h"
#include "physics/broad_phase/fat_pairs.h"

/// What the solver `contact` knows of its bodies in a substep, and of what is between them: what
/// presses, and the paths on which others come.
namespace carom {

/// What an impulse changes.
struct ContactMover {
    Vec2 velocity;
    double rim = 0.0;  ///< spin * radius, length/s
    double inverse_mass = 0.0;
};

/// What a pair is in a substep.
enum class ContactState : std::uint8_t { idle, pressed, flying };

/// Two bodies that could meet in the tick.
struct ContactPair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;  ///< a body; for an edge a body that nothing moves
    Vec2 normal;          ///< from b to a
    double gap = 0.0;
    double mass = 0.0;  ///< 1 / sum of inverse masses
    double impulse = 0.0;
    double rub = 0.0;  ///< impulse along perpendicular(normal)
    double friction = 0.0;
    std::uint32_t edge = NearPair::no_edge;
    std::int8_t across = 0;
    std::int8_t along = 0;
    ContactState state = ContactState::idle;
    bool bounces : 1 = false;  ///< restitution above 0
    bool damped : 1 = false;   ///< and below 1
    bool by_hand : 1 = false;  ///< the edge is held
    bool is_new : 1 = true;    ///< did not press yet
    bool settled : 1 = false;  ///< in this substep: has come to rest at an impact
};

/// A pressed pair in a substep: what the rounds need, one after another in their order.
struct ContactPress {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t pair = 0;
    bool lasts = false;      ///< pressed in the last substep too
    bool with_next = false;  ///< this press and the next one are neighbours: take_back_throws
    Vec2 normal;
    double target = 0.0;  ///< speed at which they may close (positive) or must part, length/s
    double mass = 0.0;    ///< of a rigid contact
    double impulse = 0.0;
    double rub = 0.0;
    double friction = 0.0;
};

/// How pressed pairs that overlap are held apart.
struct ContactSoftness {
    double push = 0.0;  ///< speed apart for each unit of overlap, 1/s
    double mass = 1.0;  ///< share of a rigid contact's impulse
    double impulse = 0.0;
};

/// How fast the upper of two bodies goes up from the lower one, and what changes that.
struct ContactThrow {
    double speed = 0.0;
    double inverse_mass = 0.0;
};

/// A ball in a substep with impacts: at `position` at `time`, since then on a parabola if it is
/// free, else straight on at `chord` while its velocity changes evenly by `pull` and its rim's
/// by `turn`. It stands from `end` on.
struct ContactPath {
    Vec2 position;
    Vec2 velocity;
    Vec2 chord;          ///< to where it will be at the end, length/s
    Vec2 pull;           ///< length/s^2
    double rim = 0.0;    ///< spin * radius, length/s
    double turn = 0.0;   ///< length/s^2
    double given = 1.0;  ///< share of what pressing gives in the substep
    double time = 0.0;
    double end = 0.0;
    std::uint32_t version = 0;
    std::uint16_t impacts = 0;
    std::uint16_t pushes = 0;  ///< impacts with hands that moved towards it
    bool free = false;
    bool stands = false;
    bool is_surrounded = false;  ///< all that the ball could meet have paths
    std::uint32_t body = 0;
};

/// What comes next in a substep with impacts, as far as one body can tell.
struct ContactEvent {
    static constexpr std::uint8_t ball = 0;
    static constexpr std::uint8_t edge = 1;
    static constexpr std::uint8_t stands = 2;  ///< the body's path ends

    double time = 0.0;
    std::uint8_t kind = ball;
    std::uint32_t low = 0;  ///< the bodies' indices in the world
    std::uint32_t high = 0;
    std::uint32_t body = 0;  ///< whose prediction this is
    std::uint32_t pair = 0;
    std::uint32_t body_version = 0;
    std::uint32_t other_version = 0;
};

/// A hand that holds a ball or an edge.
struct ContactHand {
    std::uint32_t index = 0;  ///< of the capsule; of a held ball the body
    std::uint32_t held = 0;   ///< index into World::held_capsules or held_balls
    bool is_ball = false;
    bool is_driven = false;  ///< throws what it meets
    Vec2 start_velocity;
    Vec2 end_velocity;
    double share = 1.0;        ///< of its way that it can go in this substep
    double shortened = 1.0;    ///< to this, of what the share was
    double stopped_at = -1.0;  ///< s in the substep; negative: moves
    std::uint32_t version = 0;
};

}  // namespace carom

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/vec2.h"
#include "physics/broad_phase/near_pairs.h"
#include "physics/laws/free_motion.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// What the parts of the solver `contact` share: the constants of a substep, the bodies and the
/// pairs. Plain records; README.md says which part writes what.
namespace carom {

/// How a constraint that overlaps is softened: a damped spring, solved implicitly.
struct ContactSoftness {
    double push = 0.0;           ///< separating speed for each unit of overlap, 1/s
    double mass_share = 1.0;     ///< of a rigid contact's impulse
    double impulse_share = 0.0;  ///< of the accumulated impulse that is given back
    double spring = 0.0;         ///< stiffness of a mass of 1, 1/s^2
};

/// Constants of a substep. All follow from the world and the number of substeps.
struct ContactSubstep {
    double duration = 0.0;    ///< s
    double start_time = 0.0;  ///< s since the start of the simulation
    Flight flight;            ///< over the substep
    Vec2 gravity;
    std::optional<double> drag;
    Vec2 torus;  ///< width and height; 0 on a plane
    bool wraps = false;
    bool spins = false;
    bool is_strict = false;   ///< ContactSolver::tick
    double rest_speed = 0.0;  ///< a slower approach does not bounce, length/s
    double fall = 0.0;        ///< bound of what gravity adds to a displacement, length
    ContactSoftness softness;
    double spin_ease = 2.0;            ///< m r^2 / inertia
    double spin_share = 0.5;           ///< inertia / (m r^2)
    double friction_mass = 1.0 / 3.0;  ///< mass that friction moves, of a contact's mass

    /// Whether the constraints of later substeps are trusted to separate bodies that overlap.
    bool trusts_constraints() const { return !is_strict && rest_speed > 0.0; }
};

/// The constants for a tick of `world` in `count` substeps.
ContactSubstep contact_substep(const World& world, int count, bool is_strict);

/// What an impulse changes.
struct ContactBody {
    Vec2 velocity;
    double surface_speed = 0.0;  ///< spin * radius, length/s
    double inverse_mass = 0.0;   ///< 0: kinematic or fixed
};

/// The bodies of a tick, in arrays. Balls come first, in the order of the broad phase's cells;
/// `fixed` is a body that nothing moves; behind it stands one for each pair of a ball and a
/// kinematic edge, for the point of the edge that is nearest to the ball.
struct ContactBodies {
    std::uint32_t fixed = 0;  ///< also the number of balls
    double smallest_radius = 0.0;
    std::vector<std::uint32_t> ball;  ///< index in the world (ReferencePositions::order)
    std::vector<Vec2> position;
    std::vector<Vec2> reference;  ///< Verlet reference position
    std::vector<double> skin;     ///< how far the centre may be from there
    std::vector<double> radius;
    std::vector<Vec2> start_velocity;         ///< at the start of the substep
    std::vector<double> start_surface_speed;  ///< empty where balls do not turn
    std::vector<Vec2> displacement;           ///< over the substep
    std::vector<ContactBody> body;

    bool is_ball(std::uint32_t b) const { return b < fixed; }
    bool is_kinematic(std::uint32_t b) const { return body[b].inverse_mass == 0.0; }

    /// Everything anew, from World and its reference positions. Pre: these have an order.
    void load(const World& world);
    /// Positions and velocities alone. Pre: radii, masses, reference positions and skins are those
    /// of the last tick.
    void reload(const World& world);
    /// Positions, velocities and spins go back to the world.
    void store(World& world) const;
    /// Applies gravity and drag to the velocities, and notes what they were.
    void integrate_velocities(const World& world, const ContactSubstep& step);
};

/// What a pair is in a substep.
enum class ContactState : std::uint8_t {
    idle,
    constraint,  ///< touches without bouncing: held apart by an impulse
    ccd          ///< may collide: its impact is found in time
};

/// Two bodies by index.
struct BodyPair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
};

/// Two bodies that could meet in the tick: a persistent contact, which carries its impulses from
/// substep to substep.
struct ContactPair {
    std::uint32_t a = 0;      ///< a ball
    std::uint32_t b = 0;      ///< a ball, or for an edge `fixed` or a kinematic point behind it
    Vec2 normal;              ///< unit, from b to a
    double separation = 0.0;  ///< negative: they overlap
    double mass = 0.0;        ///< effective mass, 1 / sum of inverse masses; 0: both kinematic
    double impulse = 0.0;     ///< along the normal
    double tangential_impulse = 0.0;  ///< along perpendicular(normal)
    double friction = 0.0;
    double radius = 0.0;  ///< the smaller one; an edge counts as large
    /// Of a constraint. Positive: the speed at which the gap may close. Negative: the speed at
    /// which the overlap must open. Length/s.
    double target = 0.0;
    std::uint32_t edge = NearPair::no_edge;
    std::int8_t across = 0;  ///< which image of the edge on a torus
    std::int8_t along = 0;
    ContactState state = ContactState::idle;
    bool is_persistent = false;  ///< a constraint that pressed in the last substep too
    bool has_pressed = false;    ///< in this substep, before it gave its impulse back
    /// It is solved together with the next constraint, with which it shares no body but the fixed
    /// one.
    bool has_neighbour = false;
    bool has_settled = false;              ///< came to rest at an impact in this substep
    bool bounces : 1 = false;              ///< restitution above 0
    bool is_inelastic : 1 = false;         ///< restitution above 0 and below 1
    bool is_kinematic : 1 = false;         ///< one of the bodies is
    bool is_new : 1 = true;                ///< did not press yet: no contact has been reported
    bool is_hinged : 1 = false;            ///< b is a point of a seesaw, of which `mass` knows
    bool has_high_mass_ratio : 1 = false;  ///< of the two balls: `high_mass_ratio`

    bool is_on_edge() const { return edge != NearPair::no_edge; }
};

/// At the end of a tick: a pair that does not press is reported anew when it does.
inline void forget_unless_pressing(ContactPair& pair) {
    pair.is_new = !(pair.impulse > 0.0);
    if (pair.is_new) pair.impulse = pair.tangential_impulse = 0.0;
}

/// The overlap at which two bodies stop, however hard they are pressed together.
double overlap_bound(const ContactPair& pair);

/// Whether two balls overlap deeper than any that are pressed: they started so, or a player has put
/// them there.
bool is_embedded(const ContactBodies& bodies, const ContactPair& pair);

/// The overlap at which a pair that need not bounce collides again. Below it, the approach is left
/// to the constraints of later substeps. Where these are not trusted (in a strict tick, and without
/// gravity, where pairs that bounce never become constraints) it is a part of the way to
/// `strict_overlap`, or what the pair has.
double soft_bound(const ContactSubstep& step, const ContactPair& pair);

/// The report of a constraint that passes this impulse.
Contact contact_of(const ContactBodies& bodies, const ContactPair& pair, double time,
                   double impulse);

}  // namespace carom

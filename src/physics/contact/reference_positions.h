#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/contact/bodies.h"

/// Verlet reference positions of the solver `contact` (ContactMemory::reference): where the balls
/// were when their pairs were found. While each ball stays within its skin of there, these pairs
/// are all that could meet. A ball that might leave gets a new one; the others keep theirs. So the
/// reference positions belong to the world: pairs are solved in an order that depends on them.
namespace carom {

/// Whether the result is the same whenever pairs are found anew: in a scene in which nothing is
/// ever a constraint, so pairs need no order, and which has neither a torus nor spin, which would
/// be rounded when bodies are loaded.
bool is_pair_order_irrelevant(const World& world);

/// How large skins are in a tick. A skin holds what the ball needs for the tick at its speed, but
/// at least what it needs in a substep if it is hit.
struct SkinSizes {
    double tick = 0.0;     ///< s
    double substep = 0.0;  ///< s
    double fall = 0.0;     ///< length/s^2
    /// Whether balls typically go further than their radius in a tick: there large skins would
    /// overlap with crowds.
    bool is_fast_crowd = false;
    /// Bound of a skin that lasts for a whole tick; a faster ball's lasts for a substep.
    double most_radii = 0.0;
    /// How far hits move balls in a substep, length. In a gas hardly any ball becomes faster than
    /// `usual_hit`; where most balls rest, it is small, and few are hit.
    double usual_hit = 0.0;
    double any_hit = 0.0;
    /// Where it does not show when pairs are found, skins are larger, and mostly last for the tick.
    double roomy = 0.0;

    /// What the ball needs if another one hits it.
    double hit_of(double radius) const;
    double of(double speed, double radius) const;
};

/// The sizes for a tick that begins with the balls as they are. Cost: linear in balls.
SkinSizes skin_sizes(const World& world, const ContactSubstep& step);

/// Gives all balls new reference positions, where they are now, and forgets the order of bodies.
void set_reference_positions(World& world, const SkinSizes& sizes);

/// Gives the balls of `which` (bodies) new reference positions and skins, in the world and in
/// `bodies`. Pre: `has_reference_positions`.
void renew_reference_positions(World& world, const SkinSizes& sizes, ContactBodies& bodies,
                               std::span<const std::uint32_t> which);

/// Whether the world has reference positions from before, for just the balls that there are. Never
/// on a torus, where balls leave them behind at the seams, nor while anything is held, since its
/// pairs change in each tick.
bool has_reference_positions(const World& world, const ContactSubstep& step);

/// Sets `leaving` to the bodies that could leave their skins: in the tick by their own motion, or
/// in a substep after a hit.
void find_leaving_in_tick(const ContactBodies& bodies, const SkinSizes& sizes,
                          std::vector<std::uint32_t>& leaving);

/// Sets `leaving` to the bodies that could leave their skins in the next substep by their own
/// motion. One that is hit and leaves all the same freezes at the border (paths.h).
void find_leaving_in_substep(const ContactBodies& bodies, const SkinSizes& sizes,
                             std::vector<std::uint32_t>& leaving);

}  // namespace carom

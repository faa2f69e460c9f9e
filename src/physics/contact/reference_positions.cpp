#include "physics/contact/reference_positions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/contact/contact_memory.h"
#include "physics/tick/kinematic.h"
#include "physics/tick/totals.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

// What the sizes of skins depend on.
struct SkinTerms {
    double tick = 0.0;     // s
    double substep = 0.0;  // s
    double fall = 0.0;     // length/s^2
    double radii = 0.0;    // bound of a skin that lasts for a whole tick
};

// `hit`: what the ball needs if another one hits it, length.
double skin_for(double speed, double radius, const SkinTerms& terms, double hit) {
    const double whole = speed * terms.tick + terms.fall * terms.tick * terms.tick;
    const double most = std::max(
        terms.radii * radius, speed * terms.substep + terms.fall * terms.substep * terms.substep);
    return std::max(1.25 * std::min(whole, most), hit) + 0.03 * radius;
}

// A few fast balls get large skins, so that not all pairs are found anew for their sake. Where
// balls typically go further than their radius in a tick, such skins would overlap with crowds:
// there they last for a substep.
double most_radii(const World& world) {
    return typical_travel_in_radii(world) > 1.0 ? 0.5 : 4.0;
}

// Whether a ball that is `away` from its reference position cannot leave its skin in the next
// substep: (away + displacement)^2 <= 2 (away^2 + displacement^2).
bool stays_within(Vec2 away, Vec2 velocity, double skin, const ContactSubstep& step) {
    const double displacement = length(velocity) * step.duration + step.fall;
    return 2.0 * (length_squared(away) + displacement * displacement) <= skin * skin;
}

}  // namespace

bool is_pair_order_irrelevant(const World& world) {
    const Model& model = world.model();
    return !model.gravity && !model.inelastic && !model.wrap && !model.spin &&
           world.held_balls().empty() && world.held_capsules().empty();
}

void set_reference_positions(World& world, const ContactSubstep& step) {
    const Balls& balls = world.balls();
    const SkinTerms terms{.tick = world.tick_length(),
                          .substep = step.duration,
                          .fall = length(step.gravity),
                          .radii = most_radii(world)};
    double fastest = 0.0;
    double squares = 0.0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        fastest = std::max(fastest, length_squared(balls.velocity[i]));
        squares += length_squared(balls.velocity[i]);
        smallest = std::min(smallest, balls.radius[i]);
    }
    fastest = std::sqrt(fastest);
    // In a substep. A few very fast balls do not make all skins large, and in a gas hardly any ball
    // becomes faster than this.
    const double usual =
        step.duration *
        std::min(1.4 * fastest, 4.0 * std::sqrt(squares / static_cast<double>(balls.size())));
    // Where it does not show when pairs are found, hits get more room, so that pairs mostly last
    // for the tick.
    const double roomy = is_pair_order_irrelevant(world)
                             ? std::min(1.15 * fastest * terms.tick, 0.4 * smallest)
                             : 0.0;
    ReferencePositions& reference = SolverAccess(world).memory().use<ContactMemory>().reference;
    reference.ball = balls.id;
    reference.position = balls.position;
    reference.skin.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double radius = balls.radius[i];
        const double slight = std::min(1.1 * fastest * step.duration, 0.25 * radius);
        const double hit = std::max(usual > 0.25 * radius ? usual : slight, roomy);
        reference.skin[i] = skin_for(length(balls.velocity[i]), radius, terms, hit);
    }
    for (const HeldBall& held : world.held_balls())
        if (const auto index = index_of(world, held.id))
            reference.skin[*index] +=
                length(displacement_to_target(world, held, balls.position[*index]));
}

bool has_valid_reference_positions(const World& world, const ContactSubstep& step) {
    const ReferencePositions& reference = contact_memory(world).reference;
    if (step.wraps || !world.held_balls().empty() || !world.held_capsules().empty()) return false;
    if (reference.ball != world.balls().id) return false;
    const Balls& balls = world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (!stays_within(balls.position[i] - reference.position[i], balls.velocity[i],
                          reference.skin[i], step))
            return false;
    return true;
}

bool are_within_skins(const ContactBodies& bodies, const ContactSubstep& step) {
    for (std::uint32_t i = 0; i < bodies.fixed; ++i)
        if (!stays_within(bodies.position[i] - bodies.reference[i], bodies.body[i].velocity,
                          bodies.skin[i], step))
            return false;
    return true;
}

}  // namespace carom

#include "physics/contact/reference_positions.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "physics/contact/contact_memory.h"
#include "physics/tick/kinematic.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

// Sets `leaving` to the balls that may leave their skins if they go as far as `distance_of(speed,
// radius)`. This runs in every substep. The columns are in locals, which a compiler need not read
// again after `leaving` has grown.
template <typename DistanceOf>
void find_leaving(const ContactBodies& bodies, DistanceOf distance_of,
                  std::vector<std::uint32_t>& leaving) {
    leaving.clear();
    const std::span<const ContactBody> body(bodies.body);
    const std::span<const Vec2> position(bodies.position);
    const std::span<const Vec2> reference(bodies.reference);
    const std::span<const double> skin(bodies.skin);
    const std::span<const double> radius(bodies.radius);
    const std::size_t count = position.size();
    for (std::size_t i = 0; i < count; ++i) {
        const double room = skin[i] - distance_of(length(body[i].velocity), radius[i]);
        if (!(length_squared(position[i] - reference[i]) <= room * std::abs(room)))
            leaving.push_back(static_cast<std::uint32_t>(i));
    }
}

// Whether balls typically go further than their radius in a tick. `squares`: the sum of the squares
// of their speeds.
bool is_fast_crowd(const Balls& balls, double squares, double tick) {
    double square_of_radii = 0.0;
    for (const double radius : balls.radius) {
        square_of_radii += radius * radius;
        if (square_of_radii > 2.0 * squares * tick * tick) return false;
    }
    return std::sqrt(squares / square_of_radii) * tick > 1.0;
}

double smallest_radius(const Balls& balls) {
    return balls.size() == 0 ? 0.0 : *std::ranges::min_element(balls.radius);
}

}  // namespace

bool is_pair_order_irrelevant(const World& world) {
    const Model& model = world.model();
    return !model.gravity && !model.inelastic && !model.wrap && !model.spin &&
           world.held_balls().empty() && world.held_capsules().empty();
}

SkinSizes skin_sizes(const World& world, const ContactSubstep& step) {
    const Balls& balls = world.balls();
    double fastest = 0.0;
    double squares = 0.0;
    double speeds = 0.0;
    for (const Vec2 velocity : balls.velocity) {
        const double square = length_squared(velocity);
        const double speed = std::sqrt(square);
        fastest = std::max(fastest, speed);
        squares += square;
        speeds += speed;
    }
    SkinSizes sizes{
        .tick = world.tick_length(), .substep = step.duration, .fall = length(step.gravity)};
    sizes.is_fast_crowd = is_fast_crowd(balls, squares, sizes.tick);
    sizes.most_radii = sizes.is_fast_crowd ? 0.5 : 4.0;
    const double mean = speeds / static_cast<double>(balls.size());
    sizes.usual_hit = sizes.substep * std::min(1.4 * fastest, 4.5 * mean);
    sizes.any_hit = 1.1 * fastest * sizes.substep;
    if (is_pair_order_irrelevant(world))
        sizes.roomy = std::min(1.15 * fastest * sizes.tick, 0.4 * smallest_radius(balls));
    return sizes;
}

double SkinSizes::hit_of(double radius) const {
    const double slight = 0.1 * radius;
    return std::max(usual_hit > slight ? usual_hit : std::min(any_hit, slight), roomy);
}

double SkinSizes::of(double speed, double radius) const {
    const double whole = speed * tick + fall * tick * tick;
    const double most = std::max(most_radii * radius, speed * substep + fall * substep * substep);
    return std::max(1.25 * std::min(whole, most), hit_of(radius)) + 0.03 * radius;
}

void set_reference_positions(World& world, const SkinSizes& sizes) {
    const Balls& balls = world.balls();
    ReferencePositions& reference = SolverAccess(world).memory().use<ContactMemory>().reference;
    reference.ball = balls.id;
    reference.position = balls.position;
    reference.order.clear();
    reference.skin.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i)
        reference.skin[i] = sizes.of(length(balls.velocity[i]), balls.radius[i]);
    for (const HeldBall& held : world.held_balls())
        if (const auto index = index_of(world, held.id))
            reference.skin[*index] +=
                length(displacement_to_target(world, held, balls.position[*index]));
}

void renew_reference_positions(World& world, const SkinSizes& sizes, ContactBodies& bodies,
                               std::span<const std::uint32_t> which) {
    ReferencePositions& reference = SolverAccess(world).memory().use<ContactMemory>().reference;
    for (const std::uint32_t i : which) {
        bodies.reference[i] = bodies.position[i];
        bodies.skin[i] = sizes.of(length(bodies.body[i].velocity), bodies.radius[i]);
        reference.position[bodies.ball[i]] = bodies.reference[i];
        reference.skin[bodies.ball[i]] = bodies.skin[i];
    }
}

bool has_reference_positions(const World& world, const ContactSubstep& step) {
    return !step.wraps && world.held_balls().empty() && world.held_capsules().empty() &&
           contact_memory(world).reference.ball == world.balls().id;
}

void find_leaving_in_tick(const ContactBodies& bodies, const SkinSizes& sizes,
                          std::vector<std::uint32_t>& leaving) {
    const auto distance_of = [sizes, fall = sizes.fall * sizes.tick * sizes.tick](double speed,
                                                                                  double radius) {
        return std::max(speed * sizes.tick + fall, sizes.hit_of(radius));
    };
    find_leaving(bodies, distance_of, leaving);
}

void find_leaving_in_substep(const ContactBodies& bodies, const SkinSizes& sizes,
                             std::vector<std::uint32_t>& leaving) {
    const auto distance_of = [time = sizes.substep,
                              fall = sizes.fall * sizes.substep * sizes.substep](
                                 double speed, double) { return speed * time + fall; };
    find_leaving(bodies, distance_of, leaving);
}

}  // namespace carom

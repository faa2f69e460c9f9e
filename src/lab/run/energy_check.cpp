#include "lab/run/energy_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/event/motion/event_memory.h"
#include "physics/laws/bounce.h"

namespace carom {
namespace {

double energy_of_seesaws(const World& world) {
    double sum = 0.0;
    for (const Seesaw& seesaw : world.seesaws())
        sum += 0.5 * seesaw.inertia * seesaw.rate * seesaw.rate;
    return sum;
}

double energy_of(const World& world) {
    const Balls& balls = world.balls();
    const Model& model = world.model();
    double sum = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double mass = 1.0 / balls.inverse_mass[i];
        double square = length_squared(balls.velocity[i]);
        if (model.spin) {
            const double inertia = *model.spin * balls.radius[i] * balls.radius[i];
            square += inertia * balls.spin[i] * balls.spin[i];
            // On cloth the ball rolls too: its roll is a surface speed.
            if (model.cloth) square += *model.spin * length_squared(balls.roll[i]);
        }
        sum += 0.5 * mass * square;
        if (model.gravity && !model.cloth) sum -= mass * dot(*model.gravity, balls.position[i]);
    }
    return sum + energy_of_seesaws(world);
}

double kinetic_energy_of(const World& world) {
    double sum = 0.0;
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        sum += 0.5 * length_squared(world.balls().velocity[i]) / world.balls().inverse_mass[i];
    return sum + energy_of_seesaws(world);
}

// The least potential energy of a ball for each unit of its mass.
double lowest_potential(const World& world) {
    const Vec2 gravity = world.model().gravity.value_or(Vec2{});
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec2 position : world.balls().position)
        lowest = std::min(lowest, -dot(gravity, position));
    return lowest;
}

// Whether something besides the balls may give energy in a tick.
bool may_be_given_energy(const World& world) {
    return !world.held_balls().empty() || !world.held_capsules().empty() ||
           !world.flippers().empty() || world.model().kicks ||
           (world.model().wrap && world.model().gravity);
}

}  // namespace

EnergyCheck::EnergyCheck(const Promise& promise, bool reports_impulses, const World& world)
    : promise_(promise),
      reports_impulses_(reports_impulses),
      baseline_(energy_of(world)),
      ground_(lowest_potential(world)) {
    scale_ = energy_in_play(world);
    remember(world);
}

void EnergyCheck::change_promise(const Promise& promise, bool reports_impulses,
                                 const World& world) {
    promise_ = promise;
    reports_impulses_ = reports_impulses;
    clustered_gain_ = 0.0;
    restart(world);
    remember(world);
}

void EnergyCheck::begin(const World& world) {
    is_hybrid_step_ = !event_memory(world).clustered.empty();
}

void EnergyCheck::take_over(const World& world) {
    // The rest is subtracted first: where the change is great, as from a huge gravity to none, a
    // baseline that equals the energy stays equal to it.
    baseline_ = energy_of(world) + (baseline_ - energy_);
}

void EnergyCheck::restart(const World& world) {
    baseline_ = energy_of(world);
}

double EnergyCheck::energy_in_play(const World& world) const {
    double sum = kinetic_energy_of(world);
    if (!promise_.counts_heights || !world.model().gravity || world.model().cloth) return sum;
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        sum += std::max(0.0, -dot(*world.model().gravity, world.balls().position[i]) - ground_) /
               world.balls().inverse_mass[i];
    return sum;
}

// The most energy that movers may have given in the tick: for each contact, the impulse times the
// velocity of the edge there, and at most that of friction along it. A ball leaves a mover with a
// little speed of its own even if it came with none (laws/bounce.h).
double EnergyCheck::most_work_of_movers(const World& world,
                                        std::span<const Contact> contacts) const {
    double work = 0.0;
    for (const Contact& contact : contacts) {
        if (contact.kind != ContactKind::ball_edge) continue;
        const auto was =
            std::ranges::find(moved_, CapsuleId{contact.b}, &std::pair<CapsuleId, Capsule>::first);
        const auto edge = index_of(world, CapsuleId{contact.b});
        const auto ball = index_of(world, BallId{contact.a});
        if (was == moved_.end() || !edge || !ball) continue;
        const Vec2 start = world.capsules().shape[*edge].start - was->second.start;
        const Vec2 end = world.capsules().shape[*edge].end - was->second.end;
        const double since = contact.time * world.rate() - static_cast<double>(tick_);
        const Vec2 from = was->second.start + start * since;
        const Vec2 span = was->second.end + end * since - from;
        const double whole = length_squared(span);
        const double share =
            whole > 0.0 ? std::clamp(dot(contact.point - from, span) / whole, 0.0, 1.0) : 0.0;
        const Vec2 surface = (start + (end - start) * share) * world.rate();
        const double across = dot(surface, contact.normal);
        const double along = std::fabs(cross(surface, contact.normal));
        const double friction =
            world.model().spin ? world.materials()[world.capsules().material[*edge]].friction : 0.0;
        const double pull = length(world.model().gravity.value_or(Vec2{}));
        const double lift =
            std::max(driven_lift * std::fabs(across),
                     std::sqrt(2.0 * driven_lift_height * pull * world.balls().radius[*ball]));
        work += contact.impulse * (across + friction * along) +
                0.5 / world.balls().inverse_mass[*ball] * lift * lift;
    }
    return work;
}

std::optional<double> EnergyCheck::check(const World& world, std::span<const Contact> contacts,
                                         bool are_same_balls, bool are_parting) {
    const double energy = energy_of(world);
    scale_ = std::max(scale_, energy_in_play(world));
    // A ball may appear and be removed within the tick, and meet another one in between.
    if (!promise_.energy || !are_same_balls || next_ball_ != world.next_ball()) {
        restart(world);
        clustered_gain_ = 0.0;
        return std::nullopt;
    }
    const bool is_known =
        reports_impulses_ && !is_hybrid_step_ && event_memory(world).clustered.empty();
    if (!moved_.empty())
        baseline_ = is_known ? baseline_ + most_work_of_movers(world, contacts)
                             : std::max(baseline_, energy);
    const bool is_lifted = are_parting && (promise_.lifts_overlaps || is_hybrid_step_);
    if (is_lifted || may_be_given_energy(world)) baseline_ = std::max(baseline_, energy);
    const double gain = energy - baseline_;
    double most = clustered_gain_ + *promise_.energy * scale_;
    if (is_hybrid_step_) most = std::max(most, promise_.energy_of_clustered * scale_);
    // Potential energy is measured from the origin: its rounding is that of the coordinates.
    const double rounding = 1e-12 * std::fabs(baseline_);
    if (is_hybrid_step_) clustered_gain_ = std::max(clustered_gain_, gain);
    if (!(gain > most + rounding)) return std::nullopt;
    return gain;
}

void EnergyCheck::remember(const World& world) {
    energy_ = energy_of(world);
    tick_ = world.tick();
    next_ball_ = world.next_ball();
    moved_.clear();
    for (const Mover& mover : world.movers())
        for (const MovedEdge& edge : mover.edges)
            if (const auto index = index_of(world, edge.capsule))
                moved_.push_back({edge.capsule, world.capsules().shape[*index]});
}

}  // namespace carom

#include "physics/overlap_solver.h"

#include <algorithm>
#include <numeric>

#include "geometry/closest.h"
#include "physics/bounce.h"
#include "physics/cloth_contact.h"
#include "physics/flight.h"

namespace carom {
namespace {

// The way out for two bodies with the same centre: any way will do, but always the same.
constexpr Vec2 when_coincident{1.0, 0.0};

}  // namespace

void OverlapSolver::tick(World& world, int updates, int steps, std::vector<Contact>& contacts,
                         std::vector<std::uint8_t>& touched) {
    const double duration = world.tick_length() / updates;
    const double start = world.time();
    inverse_mass_ = world.balls.inverse_mass;
    for (const HeldBall& held : world.held_balls)
        if (const auto index = index_of(world, held.id)) inverse_mass_[*index] = 0.0;
    const auto first = static_cast<std::ptrdiff_t>(contacts.size());
    for (int i = 0; i < updates; ++i) {
        move_hands(world, 1.0 / (updates - i), duration);
        with_terms(terms_of(world), [&]<Terms terms>() {
            update<terms>(world, duration, steps, start + duration * (i + 1), contacts);
        });
    }
    for (auto contact = contacts.begin() + first; contact != contacts.end(); ++contact) {
        touched[contact->a] = 1;
        if (contact->kind == ContactKind::ball_ball) touched[contact->b] = 1;
    }
}

// How fast a hand or a coil moves the edge at this point. A hand's counts only along the edge
// (friction), since what is in its way is pushed out; what is driven throws as well.
Vec2 OverlapSolver::hand_velocity(const World& world, std::uint32_t capsule, Vec2 point) const {
    const Capsule& shape = world.capsules.shape[capsule];
    for (std::size_t i = 0; i < world.held_capsules.size(); ++i)
        if (world.held_capsules[i].id == world.capsules.id[capsule])
            return hands_[i].start + (hands_[i].end - hands_[i].start) *
                                         closest_parameter(shape.start, shape.end, point);
    return {};
}

bool OverlapSolver::is_driven(const World& world, std::uint32_t capsule) const {
    return std::ranges::any_of(world.held_capsules, [&](const HeldCapsule& held) {
        return held.is_driven && held.id == world.capsules.id[capsule];
    });
}

// Hands go `share` of what is left of their way, whatever is in it; balls are pushed out of it
// afterwards.
void OverlapSolver::move_hands(World& world, double share, double duration) {
    for (const HeldBall& held : world.held_balls) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        Vec2& position = world.balls.position[*index];
        Vec2 way = held.target - position;
        if (world.model.wrap) way = nearest_image(way, size(*world.model.wrap));
        position += way * share;
        world.balls.velocity[*index] = {};
    }
    hands_.assign(world.held_capsules.size(), {});
    for (std::size_t i = 0; i < world.held_capsules.size(); ++i) {
        const HeldCapsule& held = world.held_capsules[i];
        const auto index = index_of(world, held.id);
        if (!index) continue;
        Capsule& shape = world.capsules.shape[*index];
        const Vec2 start = (held.start_target - shape.start) * share;
        const Vec2 end = (held.end_target - shape.end) * share;
        hands_[i] = {start / duration, end / duration};
        shape.start += start;
        shape.end += end;
    }
}

template <Terms terms>
void OverlapSolver::update(World& world, double duration, int steps, double end_time,
                           std::vector<Contact>& contacts) {
    const std::size_t count = world.balls.size();
    active_.resize(count);
    std::iota(active_.begin(), active_.end(), 0u);
    is_active_.assign(count, 1);
    is_touched_.assign(count, 0);
    left_.assign(count, duration);
    origin_.resize(count);
    intended_.resize(count);
    if (world.model.cloth) before_.resize(count);
    const double largest = largest_radius(world.balls);
    for (int step = 0; step < steps && !active_.empty(); ++step) {
        move<terms>(world, step);
        if (step == 0) {
            const CellFrame frame = frame_around(world, 2.0 * largest);
            cells_.rebuild(frame, world.balls.position);
            edges_.update(world, frame, largest);
        } else {
            for (const std::uint32_t i : active_)
                cells_.move(i, world.balls.position[i]);
        }
        pairs_.clear();
        moved_.clear();
        part_overlaps<terms>(world, step == 0);
        for (const std::uint32_t i : moved_)
            cells_.move(i, world.balls.position[i]);
        if (steps > 1) keep_time(world);
        exchange_momentum<terms>(world, end_time, contacts);
    }
}

template <Terms terms>
void OverlapSolver::move(World& world, int step) {
    Balls& balls = world.balls;
    const Vec2 gravity = world.model.gravity.value_or(Vec2{});
    Flight flight = flight_over(world.model.drag, left_[active_.front()]);
    for (const std::uint32_t i : active_) {
        if (step > 0 && flight.duration != left_[i])
            flight = flight_over(world.model.drag, left_[i]);
        Vec2 way;
        if (terms.spin() && world.model.cloth) {
            way = move_on_cloth(world, i);
        } else {
            way = travel(flight, balls.velocity[i], gravity);
            balls.velocity[i] = velocity_after(flight, balls.velocity[i], gravity);
        }
        if (terms.special() && inverse_mass_[i] == 0.0) {
            way = {};
            balls.velocity[i] = {};
            if (terms.spin()) balls.spin[i] = 0.0;
            if (terms.spin() && world.model.cloth) balls.roll[i] = {};
        }
        if (world.model.speed_limit) {
            balls.velocity[i] = limited(balls.velocity[i], *world.model.speed_limit);
            way = limited(way, *world.model.speed_limit * flight.duration);
        }
        balls.position[i] += way;
        if (terms.wrap()) balls.position[i] = wrapped(balls.position[i], *world.model.wrap);
        origin_[i] = balls.position[i] - way;
        intended_[i] = length(way);
    }
}

namespace {

ClothState<double> state_on_cloth(const Balls& balls, std::size_t i) {
    return {{}, Vector<double>(balls.velocity[i]), Vector<double>(balls.roll[i]), balls.spin[i]};
}

void take_state(Balls& balls, std::size_t i, const ClothState<double>& state) {
    balls.velocity[i] = Vec2(state.velocity);
    balls.roll[i] = Vec2(state.roll);
    balls.spin[i] = state.spin;
}

}  // namespace

// How far the ball goes on cloth in the time that it has left; its state becomes that at the end.
Vec2 OverlapSolver::move_on_cloth(World& world, std::uint32_t ball) {
    before_[ball] = state_on_cloth(world.balls, ball);
    const auto after =
        cloth_state_after(*world.model.cloth, *world.model.spin, before_[ball], left_[ball]);
    take_state(world.balls, ball, after);
    return Vec2(after.position);
}

template <Terms terms>
void OverlapSolver::part_overlaps(World& world, bool all_active) {
    Balls& balls = world.balls;
    const Vec2 torus = terms.wrap() ? size(*world.model.wrap) : Vec2{};
    const auto note = [&](std::uint32_t i) {
        if (is_touched_[i]) return;
        is_touched_[i] = 1;
        moved_.push_back(i);
        if (all_active || is_active_[i]) return;
        origin_[i] = balls.position[i];
        intended_[i] = 0.0;
    };
    for (const std::uint32_t i : active_) {
        if (world.model.ball_ball) {
            cells_.for_each_near(i, [&](std::uint32_t j) {
                if (j <= i && (j == i || all_active || is_active_[j])) return;
                Vec2 offset = balls.position[i] - balls.position[j];
                if (terms.wrap()) offset = nearest_image(offset, torus);
                const double reach = balls.radius[i] + balls.radius[j];
                const double squared = length_squared(offset);
                if (squared >= reach * reach) return;
                if (terms.special() && !kinds_meet(world, balls.kind[i], balls.kind[j])) return;
                note(i);
                note(j);
                const Vec2 normal = direction(offset, when_coincident);
                double share_i = 0.5;
                double share_j = 0.5;
                if (terms.special()) {
                    const bool i_held = inverse_mass_[i] == 0.0;
                    const bool j_held = inverse_mass_[j] == 0.0;
                    if (i_held != j_held) {
                        share_i = i_held ? 0.0 : 1.0;
                        share_j = j_held ? 0.0 : 1.0;
                    }
                }
                const double depth = reach - std::sqrt(squared);
                balls.position[i] += normal * (depth * share_i);
                balls.position[j] -= normal * (depth * share_j);
                if (terms.wrap()) {
                    balls.position[i] = wrapped(balls.position[i], *world.model.wrap);
                    balls.position[j] = wrapped(balls.position[j], *world.model.wrap);
                }
                pairs_.push_back({i, j, ContactKind::ball_ball, {}});
            });
        }
        if (!world.model.ball_edge) continue;
        for (const CapsuleEntry entry : edges_.in_cell(cells_.cell_of(i)))
            push_out_of_edge<terms>(world, i, entry.index,
                                    {entry.across * torus.x, entry.along * torus.y});
        if (!terms.special()) continue;
        for (const HeldCapsule& held : world.held_capsules)
            if (const auto index = index_of(world, held.id))
                push_out_of_edge<terms>(world, i, static_cast<std::uint32_t>(*index), {});
    }
}

template <Terms terms>
void OverlapSolver::push_out_of_edge(World& world, std::uint32_t ball, std::uint32_t capsule,
                                     Vec2 shift) {
    Balls& balls = world.balls;
    Capsule shape = world.capsules.shape[capsule];
    if (terms.wrap()) {
        shape.start += shift;
        shape.end += shift;
    }
    Vec2& position = balls.position[ball];
    const Vec2 offset = position - closest_point(shape.start, shape.end, position);
    const double reach = balls.radius[ball] + shape.radius;
    const double squared = length_squared(offset);
    if (squared >= reach * reach) return;
    if (terms.special() &&
        !kind_meets_material(world, balls.kind[ball], world.capsules.material[capsule]))
        return;
    if (terms.special() && world.model.one_way &&
        (!is_on_solid_side(shape, world.capsules.side[capsule], position) ||
         dot(balls.velocity[ball], offset) > 0.0))
        return;
    if (!is_touched_[ball]) {
        is_touched_[ball] = 1;
        moved_.push_back(ball);
    }
    const Vec2 across = direction(perpendicular(shape.end - shape.start), when_coincident);
    const Vec2 normal =
        direction(offset, dot(across, balls.velocity[ball]) > 0.0 ? -across : across);
    position += normal * (reach - std::sqrt(squared));
    pairs_.push_back({ball, capsule, ContactKind::ball_edge, shift});
}

// What each ball that was pushed has left of its time; the others are done.
void OverlapSolver::keep_time(World& world) {
    Balls& balls = world.balls;
    for (const std::uint32_t i : active_)
        is_active_[i] = 0;
    active_.clear();
    std::sort(moved_.begin(), moved_.end());
    for (const std::uint32_t i : moved_) {
        is_touched_[i] = 0;
        if (!(intended_[i] > 0.0)) continue;
        const Vec2 torus = world.model.wrap ? size(*world.model.wrap) : Vec2{};
        Vec2 way = balls.position[i] - origin_[i];
        if (world.model.wrap) way = nearest_image(way, torus);
        const double covered = std::min(1.0, length(way) / intended_[i]);
        const double left = left_[i] * (1.0 - covered);
        if (world.model.gravity) balls.velocity[i] -= *world.model.gravity * left;
        // A ball that got nowhere gives up the rest of its time.
        if (covered < 1e-9 || left < 1e-9 * left_[i]) continue;
        if (world.model.cloth)
            take_state(balls, i,
                       cloth_state_after(*world.model.cloth, *world.model.spin, before_[i],
                                         left_[i] - left));
        left_[i] = left;
        is_active_[i] = 1;
        active_.push_back(i);
    }
}

template <Terms terms>
void OverlapSolver::exchange_momentum(World& world, double time, std::vector<Contact>& contacts) {
    Balls& balls = world.balls;
    const Vec2 torus = terms.wrap() ? size(*world.model.wrap) : Vec2{};
    for (const Pair& pair : pairs_) {
        const std::uint32_t i = pair.ball;
        if (pair.kind == ContactKind::ball_ball) {
            const std::uint32_t j = pair.other;
            Vec2 offset = balls.position[i] - balls.position[j];
            if (terms.wrap()) offset = nearest_image(offset, torus);
            Vec2 normal = direction(offset, when_coincident);
            if (!(dot(balls.velocity[i] - balls.velocity[j], normal) < 0.0)) continue;
            if (terms.special() && inverse_mass_[i] == 0.0 && inverse_mass_[j] == 0.0) continue;
            const double restitution =
                terms.lossy() ? std::min(balls.restitution[i], balls.restitution[j]) : 1.0;
            const Exchange done = bounce(balls.velocity[i], inverse_mass_[i], balls.velocity[j],
                                         inverse_mass_[j], normal, restitution);
            if (terms.spin()) {
                const Kind& kind_i = world.kinds[balls.kind[i]];
                const Kind& kind_j = world.kinds[balls.kind[j]];
                const Friction friction{friction_between(kind_i, kind_j), *world.model.spin};
                if (world.model.cloth)
                    rub_on_cloth(balls.velocity[i], roller(balls, i), inverse_mass_[i],
                                 balls.velocity[j], roller(balls, j), inverse_mass_[j], normal,
                                 done.impulse, friction);
                else
                    rub(balls.velocity[i], {balls.spin[i], balls.radius[i]}, inverse_mass_[i],
                        balls.velocity[j], {balls.spin[j], balls.radius[j]}, inverse_mass_[j],
                        normal, done.impulse, friction);
            }
            const Vec2 point = balls.position[j] + normal * balls.radius[j];
            if (i > j) normal = -normal;
            contacts.push_back({time, ContactKind::ball_ball, std::min(i, j), std::max(i, j), point,
                                normal, done.approach, done.impulse});
            continue;
        }
        if (terms.special() && inverse_mass_[i] == 0.0) continue;
        Capsule shape = world.capsules.shape[pair.other];
        shape.start += pair.shift;
        shape.end += pair.shift;
        const Vec2 nearest = closest_point(shape.start, shape.end, balls.position[i]);
        Vec2 normal = direction(balls.position[i] - nearest, when_coincident);
        const Vec2 surface = terms.special() ? hand_velocity(world, pair.other, nearest) : Vec2{};
        const bool driven = terms.special() && is_driven(world, pair.other);
        const double throwing = driven ? dot(surface, normal) : 0.0;
        const double speed = throwing - dot(balls.velocity[i], normal);
        if (!(speed > 0.0)) continue;
        const Material& material = world.materials[world.capsules.material[pair.other]];
        const double restitution = terms.lossy() ? restitution_at(material, speed) : 1.0;
        const Vec2 flat = normal;
        if (terms.special() && world.model.scatter)
            normal = scattered_normal(world, balls.id[i], balls.edge_contacts[i]++, normal,
                                      balls.velocity[i], restitution);
        const Exchange done =
            bounce_off(balls.velocity[i], inverse_mass_[i], normal, throwing, restitution, driven);
        if (terms.special() && world.model.kicks)
            balls.velocity[i] += normal * kick_at(material, shape, nearest, speed);
        if (terms.spin()) {
            const Friction friction{material.friction, *world.model.spin};
            if (world.model.cloth)
                rub_edge_on_cloth(balls.velocity[i], roller(balls, i), inverse_mass_[i], flat,
                                  surface, done.impulse, friction);
            else
                rub_on(balls.velocity[i], {balls.spin[i], balls.radius[i]}, inverse_mass_[i], flat,
                       surface, done.impulse, friction);
        }
        contacts.push_back({time, ContactKind::ball_edge, i, pair.other,
                            nearest + normal * shape.radius, normal, done.approach, done.impulse});
    }
}

}  // namespace carom

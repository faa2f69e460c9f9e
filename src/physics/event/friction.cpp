#include <type_traits>

#include "physics/event/engine.h"
#include "physics/laws/bounce.h"

// Friction and spin in the solver `event`.
namespace carom {
namespace {

template <typename Real>
Real clamped(const Real& value, const Real& most) {
    return value < -most ? -most : (most < value ? most : value);
}

}  // namespace

template <typename Real>
Real EventEngine<Real>::spin_at(std::uint32_t ball, const Real& time) const {
    const Spinning& turn = spins_[ball];
    if (turn.rate == Real{}) return turn.spin;
    const Real since = time - turn.time;
    if (world_->model.cloth) return cloth_spin_after(*world_->model.cloth, turn.spin, since);
    return turn.spin + turn.rate * since;
}

// From now on it turns as it does now.
template <typename Real>
void EventEngine<Real>::let_spin(std::uint32_t ball, const Real& time) {
    spins_[ball] = {time, spin_at(ball, time), Real{}, false};
}

template <typename Real>
Real EventEngine<Real>::friction_of(std::uint32_t ball, const PathSupport& support) const {
    if (support.by == PathSupport::By::edge) {
        const auto index = index_of(*world_, CapsuleId{support.number});
        return Real(world_->materials[world_->capsules.material[*index]].friction);
    }
    if (support.by != PathSupport::By::ball) return Real{};
    const auto index = index_of(*world_, BallId{support.number});
    return Real(friction_between(world_->kinds[world_->balls.kind[ball]],
                                 world_->kinds[world_->balls.kind[*index]]));
}

// The contacts that rub, of those that have passed these impulses at the same instant.
template <typename Real>
void EventEngine<Real>::take_rubbing(const std::vector<std::uint32_t>& which,
                                     std::span<const Real> passed) {
    std::vector<Rubbing>& all = rubbings_;
    std::vector<int>& shares = shares_;
    all.clear();
    shares.assign(bodies_.size(), 0);
    for (std::size_t i = 0; i < which.size(); ++i) {
        const Touch& touch = touches_[which[i]];
        if (!(passed[i] > Real{})) continue;
        const Real coefficient =
            touch.kind == Kind::hand
                ? Real(world_->materials[world_->capsules.material[touch.other]].friction)
                : friction_of(bodies_[touch.contact.a].ball, touch.support);
        const Real most = coefficient * passed[i];
        if (!(most > Real{})) continue;
        all.push_back({.touch = &touch, .most = most});
        ++shares[touch.contact.a];
        if (touch.contact.b != ImpactContact<Real>::fixed) ++shares[touch.contact.b];
    }
}

// What contacts that have passed these impulses at the same instant pass along themselves.
template <typename Real>
void EventEngine<Real>::rub_contacts(const std::vector<std::uint32_t>& which,
                                     std::span<const Real> passed) {
    take_rubbing(which, passed);
    if (world_->model.cloth) return rub_contacts_on_cloth();
    std::vector<Rubbing>& all = rubbings_;
    const std::vector<int>& shares = shares_;
    const Real inertia(*world_->model.spin);
    const Real reluctance = Real(1.0) + Real(1.0) / inertia;
    const auto turn = [&](std::uint32_t body, const Real& impulse) {
        const Real inverse = impact_bodies_[body].inverse_mass;
        body_spins_[body] -= impulse * inverse / (inertia * radius(bodies_[body].ball));
    };
    const int most_rounds = all.size() == 1 ? 1 : 64;
    for (int round = 0; round < most_rounds; ++round) {
        bool is_done = true;
        for (Rubbing& each : all) {
            const auto& contact = each.touch->contact;
            const Vector<Real> along = perpendicular(contact.normal);
            const auto& a = impact_bodies_[contact.a];
            Real inverse = a.inverse_mass * Real(double(shares[contact.a]));
            Real slip =
                dot(a.velocity, along) - radius(bodies_[contact.a].ball) * body_spins_[contact.a];
            if (contact.b != ImpactContact<Real>::fixed) {
                const auto& b = impact_bodies_[contact.b];
                inverse += b.inverse_mass * Real(double(shares[contact.b]));
                slip -= dot(b.velocity, along) +
                        radius(bodies_[contact.b].ball) * body_spins_[contact.b];
            } else {
                slip -= dot(each.touch->surface_velocity, along);
            }
            each.change = Real{};
            if (!(inverse > Real{})) continue;
            const Real wanted = each.impulse - slip / (inverse * reluctance);
            each.change = clamped(wanted, each.most) - each.impulse;
            is_done =
                is_done && !(absolute(each.change) > Real(16.0 * precision<Real>) * each.most);
        }
        for (Rubbing& each : all) {
            const auto& contact = each.touch->contact;
            const Vector<Real> way = perpendicular(contact.normal) * each.change;
            each.impulse += each.change;
            impact_bodies_[contact.a].velocity += way * impact_bodies_[contact.a].inverse_mass;
            turn(contact.a, each.change);
            if (contact.b == ImpactContact<Real>::fixed) continue;
            impact_bodies_[contact.b].velocity -= way * impact_bodies_[contact.b].inverse_mass;
            turn(contact.b, each.change);
        }
        if (is_done) break;
    }
}

// Slips up to this are none: what is left of a slip that has just come to its end.
template <typename Real>
Real EventEngine<Real>::slip_noise(std::uint32_t ball, const Vector<Real>& velocity) const {
    const Real size = radius(ball);
    const Real pull = length(field_.gravity);
    return Real(1e6 * precision<Real>) *
               (length(velocity) + size * absolute(spins_[ball].spin) + square_root(pull * size)) +
           Real(64.0 * precision<Real>) * pull * absolute(now_);
}

// Friction on the side of an edge, where `pull` is gravity's part along it: the acceleration that
// it gives, and how the ball begins to turn.
template <typename Real>
typename EventEngine<Real>::Rub EventEngine<Real>::rub_on_side(std::uint32_t ball,
                                                               const Support& support,
                                                               const Vector<Real>& velocity,
                                                               const Vector<Real>& pull) const {
    Rub rub;
    rub.turn = spins_[ball];
    const Real press = -dot(field_.gravity, support.normal);
    const Real most = friction_of(ball, support.by) * press;
    if (!(most > Real{})) return rub;
    const Real inertia(*world_->model.spin);
    const Real size = radius(ball);
    const Vector<Real> along = perpendicular(support.normal);
    const Real speed = dot(velocity, along);
    const Real slip = speed - size * rub.turn.spin;
    // Drag acts on what rolls, too.
    const Real way = dot(pull, along) - (field_.has_drag ? field_.drag * speed : Real{});
    const Real needed = -way / (Real(1.0) + Real(1.0) / inertia);
    Real push = slip < Real{} ? most : -most;
    if (!(absolute(slip) > slip_noise(ball, velocity))) {
        push = clamped(needed, most);
        rub.turn.rolls = push == needed;
        if (rub.turn.rolls) rub.turn.spin = speed / size + Real{};  // never -0
    }
    rub.turn.rate = -push / (inertia * size);
    rub.acceleration = along * push;
    return rub;
}

// Two supports hold the ball: friction at both brakes its spin, until it stops.
template <typename Real>
void EventEngine<Real>::brake_spin(std::uint32_t ball, const Real& friction) {
    Spinning& turn = spins_[ball];
    const Real rate = friction / (Real(*world_->model.spin) * radius(ball));
    turn.rolls = false;
    turn.rate = turn.spin == Real{} ? Real{} : (turn.spin < Real{} ? rate : -rate);
}

// An edge that the ball touches and that bars the way: as seen from it.
template <typename Real>
std::optional<typename EventEngine<Real>::Support> EventEngine<Real>::barrier_to(
    std::uint32_t ball, const Vector<Real>& velocity, const Vector<Real>& acceleration) const {
    const EventPath<Real> path = balls_.path(ball);
    const Real size = radius(ball);
    std::optional<Support> found;
    for_each_edge_near(ball, [&](std::uint32_t capsule, Vec2 shift, int across, int along) {
        const Edge<Real> edge(world_->capsules.shape[capsule], shift);
        const auto contact = contact_with(edge, path.position, size);
        const Real near =
            size * Real(touching) + Real(16.0) * rounding_at(path.position, size + edge.radius);
        if (found || contact.gap > near || !is_solid_for(capsule, path.position, shift)) return;
        const Real press = -dot(acceleration, contact.normal);
        if (!(press > Real(1e-9) * length(acceleration))) return;
        const Real rate = dot(velocity, contact.normal);
        if (rate * rate > Real(8.0 * resting_rise) * press * size) return;
        Support support;
        support.normal = contact.normal;
        support.by = {PathSupport::By::edge, static_cast<std::int8_t>(across),
                      static_cast<std::int8_t>(along), number(world_->capsules.id[capsule])};
        found = support;
    });
    return found;
}

// Friction on the side that carries the ball pushes it against something that it touches already:
// it stays there while it turns.
template <typename Real>
bool EventEngine<Real>::is_braced(std::uint32_t ball, const Support& carrier,
                                  const Vector<Real>& velocity, const Rub& rub,
                                  const Vector<Real>& acceleration) {
    if (rub.turn.rolls || rub.acceleration == Vector<Real>{}) return false;
    const auto barrier = barrier_to(ball, velocity, acceleration);
    if (!barrier) return false;
    const Real ours = friction_of(ball, carrier.by);
    const Real theirs = friction_of(ball, barrier->by);
    const Real press = -dot(field_.gravity, carrier.normal) / (Real(1.0) + ours * theirs);
    lay_down(ball, carrier.by, barrier->by);
    brake_spin(ball, ours * press * (Real(1.0) + theirs));
    return true;
}

// Two bear all of the weight, but the ball turns fast enough to roll off along one of them.
template <typename Real>
bool EventEngine<Real>::rolls_off(std::uint32_t ball, const Support& side,
                                  const Support& other) const {
    if (!side.is_side || spins_[ball].spin == Real{}) return false;
    const Vector<Real> pull = field_.gravity - side.normal * dot(field_.gravity, side.normal);
    const Rub rub = rub_on_side(ball, side, {}, pull);
    return dot(pull + rub.acceleration, other.normal) > Real(1e-9) * length(field_.gravity);
}

// When the slip of a ball that slides comes to its end, or the spin of one that lies still.
template <typename Real>
std::optional<Real> EventEngine<Real>::end_of_slip(std::uint32_t ball, const Real& horizon) {
    const EventPath<Real> path = balls_.path(ball);
    const Spinning& turn = spins_[ball];
    if (turn.rolls) {
        // Under drag what rolls needs less and less friction: it is found anew, piece by piece.
        if (!field_.has_drag) return std::nullopt;
        return path.time + Real(1.0 / 1024.0) / field_.drag;
    }
    if (turn.rate == Real{}) return std::nullopt;
    if (path.motion == Motion::resting) return turn.time - turn.spin / turn.rate;
    // Along the way in which friction turns the ball, so that the slip is u - r w as in bounce.h.
    const Real size = radius(ball);
    const Vector<Real> along = slip_direction(ball);
    const Real slip = dot(path.velocity, along) - size * turn.spin;
    if (!(absolute(slip) > slip_noise(ball, path.velocity))) return std::nullopt;
    const Real sign(slip < Real{} ? -1.0 : 1.0);
    const Real bend = dot(path.acceleration, along) - size * turn.rate;
    if (!field_.has_drag) {
        if (!(bend * sign < Real{})) return std::nullopt;
        return path.time - slip / bend;
    }
    const Real most = field_.drag * most_acceleration(path, field_, path.time);
    return first_closing<Real>(
        [&](const Real& when) -> Gap<Real> {
            const Real speed = dot(state_at(path, field_, when).velocity, along);
            return {sign * (speed - size * spin_at(ball, when)),
                    sign * (bend - field_.drag * speed), Real{}};
        },
        path.time, horizon, most, {slip_noise(ball, path.velocity), Real{}}, search_);
}

// To the left of the normal of the side along which the ball slides.
template <typename Real>
Vector<Real> EventEngine<Real>::slip_direction(std::uint32_t ball) const {
    const EventPath<Real> path = balls_.path(ball);
    const auto capsule = index_of(*world_, CapsuleId{path.support.number});
    const Edge<Real> edge(world_->capsules.shape[*capsule],
                          Vec2(torus_shift(path.support.across, path.support.along)));
    const Vector<Real> span = edge.end - edge.start;
    const Vector<Real> direction = span / length(span);
    const bool is_left = !(cross(span, path.position - edge.start) < Real{});
    return is_left ? -direction : direction;
}

// An event of the ball's own, from which it begins anew: what is left of a spin or a slip that has
// come to its end is none.
template <typename Real>
void EventEngine<Real>::end_spin(std::uint32_t ball) {
    const EventPath<Real> path = balls_.path(ball);
    const bool rolled = spins_[ball].rolls;
    const bool was_braked = path.motion == Motion::resting && !(spins_[ball].rate == Real{});
    const Real first = spins_[ball].spin;
    let_spin(ball, now_);
    Real& spin = spins_[ball].spin;
    if (was_braked && absolute(spin) <= Real(1e6 * precision<Real>) * absolute(first))
        spin = Real{};
    if (rolled && path.motion == Motion::sliding && field_.has_drag)
        spin = dot(state_at(path, field_, now_).velocity, slip_direction(ball)) / radius(ball);
}

// `known`: by ball, which of the paths that are remembered is its own; -1: none.
template <typename Real>
void EventEngine<Real>::take_spins(const World& world, const std::vector<std::int64_t>& known) {
    std::vector<Spinning> before;
    if constexpr (!std::is_same_v<Real, double>) before.swap(spins_);
    spins_.assign(known.size(), {});
    for (std::size_t i = 0; i < known.size(); ++i) {
        const auto at = static_cast<std::size_t>(known[i]);
        if (known[i] < 0) {
            spins_[i] = {now_, Real(world.balls.spin[i]), Real{}, false};
        } else if constexpr (std::is_same_v<Real, double>) {
            const SpinPath& path = world.spin_paths[at];
            spins_[i] = {path.time, path.spin, path.rate, path.rolls};
        } else {
            spins_[i] = before[at];
        }
    }
}

template <typename Real>
bool EventEngine<Real>::are_spins_left(const World& world) const {
    if (!world.model.spin) return true;
    if constexpr (std::is_same_v<Real, double>) {
        if (world.spin_paths.size() != spins_.size()) return false;
        for (std::size_t i = 0; i < spins_.size(); ++i) {
            const SpinPath& path = world.spin_paths[i];
            if (path.time != spins_[i].time || path.spin != spins_[i].spin ||
                path.rate != spins_[i].rate || path.rolls != spins_[i].rolls)
                return false;
        }
    }
    return true;
}

template <typename Real>
bool EventEngine<Real>::is_spin_left(std::uint32_t ball) const {
    return !world_->model.spin ||
           static_cast<double>(spin_at(ball, now_)) == world_->balls.spin[ball];
}

template <typename Real>
void EventEngine<Real>::write_spins(World& world) {
    for (std::uint32_t i = 0; i < spins_.size(); ++i)
        world.balls.spin[i] =
            balls_[i].line.motion == Motion::held ? 0.0 : static_cast<double>(spin_at(i, end_));
    if constexpr (std::is_same_v<Real, double>) {
        world.spin_paths.clear();
        for (const Spinning& turn : spins_)
            world.spin_paths.push_back({turn.time, turn.spin, turn.rate, turn.rolls});
    }
    if (world.model.cloth) write_rolls(world);
}

template class EventEngine<double>;
template class EventEngine<Wide>;

}  // namespace carom

#include <type_traits>

#include "physics/event/engine.h"
#include "physics/laws/bounce.h"

// Balls on cloth in the solver `event`.
namespace carom {

template <typename Real>
ClothPhase<Real> EventEngine<Real>::phase_of(const EventPath<Real>& path) const {
    return cloth_phase(*world_->model.cloth, *world_->model.spin, path.velocity, path.center);
}

// A ball that lies still or is in a hand does not roll.
template <typename Real>
Vector<Real> EventEngine<Real>::roll_at(std::uint32_t ball, const Real& time) const {
    const EventPath<Real> path = balls_.path(ball);
    const Real since = time - path.time;
    if (path.motion == Motion::slipping)
        return path.center - path.acceleration * (since / Real(*world_->model.spin));
    if (path.motion == Motion::rolling) return path.velocity + path.acceleration * since;
    return {};
}

// Decides how a ball goes on that has just begun a path, with its roll in `center`. What the cloth
// presses on an edge gives up the part of its roll that does: see event_engine.h.
template <typename Real>
void EventEngine<Real>::begin_phase(std::uint32_t ball) {
    constexpr int most_edges = 4;
    EventPath<Real> path = balls_.path(ball);
    ClothPhase<Real> phase = phase_of(path);
    for (int i = 0; phase.motion == ClothMotion::sliding; ++i) {
        const auto edge = barrier_to(ball, path.velocity, phase.acceleration);
        if (!edge) break;
        path.velocity -= edge->normal * dot(path.velocity, edge->normal);
        path.center -= edge->normal * dot(path.center, edge->normal);
        if (i == most_edges) path.center = path.velocity;
        phase = phase_of(path);
    }
    // What is over before the clock can tell is over now.
    while (phase.lasts && path.time + *phase.lasts == path.time) {
        const bool stops = phase.motion == ClothMotion::rolling;
        path.velocity = stops ? Vector<Real>{} : path.velocity + phase.acceleration * *phase.lasts;
        path.center = path.velocity;
        phase = phase_of(path);
    }
    path.acceleration = phase.acceleration;
    switch (phase.motion) {
        case ClothMotion::sliding:
            path.motion = Motion::slipping;
            break;
        case ClothMotion::rolling:
            path.motion = Motion::rolling;
            path.center = path.velocity;
            break;
        case ClothMotion::still:
            path.motion = Motion::still;
            path.velocity = path.center = {};
    }
    balls_.set_path(ball, path);
    Spinning& turn = spins_[ball];
    const Real rate(world_->model.cloth->spin);
    turn.rate = turn.spin == Real{} ? Real{} : (turn.spin < Real{} ? rate : -rate);
}

template <typename Real>
std::optional<Real> EventEngine<Real>::end_of_phase(std::uint32_t ball) const {
    const EventPath<Real> path = balls_.path(ball);
    const ClothPhase<Real> phase = phase_of(path);
    if (!phase.lasts) return std::nullopt;
    return path.time + *phase.lasts;
}

// The end of a phase is known, not computed: what has slipped rolls, what has rolled lies still.
template <typename Real>
void EventEngine<Real>::end_phase(std::uint32_t ball) {
    const EventPath<Real> before = balls_.path(ball);
    const BallState<Real> state = state_at(before, field_, now_);
    const bool stops = before.motion == Motion::rolling;
    start_path(ball, now_, state.position, stops ? Vector<Real>{} : state.velocity);
    balls_.bend(ball).center = balls_[ball].line.velocity;
    balls_[ball].line.quick = before.quick;
    begin_phase(ball);
    predict(ball);
}

// All that can happen to a ball that lies still is that one comes which moves. That one looks again
// at its own next event, so there is no need to look further.
template <typename Real>
void EventEngine<Real>::look_for_the_moving(std::uint32_t ball) {
    Event best;
    search_.begin_at(now_);
    if (world_->model.ball_ball)
        for_each_ball_near(ball, [&](std::uint32_t other, int across, int along) {
            const Event theirs = balls_.plan(other).coming();
            if (theirs.kind == Kind::none) return;
            Event meeting;
            meeting.time = theirs.time;
            predict_pair(ball, other, across, along, meeting);
            if (meeting.kind != Kind::none) consider(ball, meeting, best);
        });
    go_on_searching(ball, best);
    balls_.plan(ball).set_coming(best);
}

// What the pair's restitution is worth where cloth presses the two together: see event_engine.h.
template <typename Real>
double EventEngine<Real>::restitution_on_cloth(const Touch& touch, bool is_alone,
                                               double usual) const {
    if (!is_alone) return usual;
    const EventBall<Real>& us = balls_[bodies_[touch.contact.a].ball];
    Vector<Real> acceleration = balls_.bend(bodies_[touch.contact.a].ball).acceleration;
    Real small = us.radius;
    bool is_hand = touch.kind == Kind::hand || us.line.motion == Motion::held;
    if (touch.kind == Kind::ball_ball) {
        const EventBall<Real>& them = balls_[touch.other];
        acceleration -= balls_.bend(touch.other).acceleration;
        small = them.radius < small ? them.radius : small;
        is_hand = is_hand || them.line.motion == Motion::held;
    }
    const Real press = -dot(acceleration, touch.contact.normal);
    if (!(press > Real{})) return usual;
    const auto rises = [&](double restitution, double least) {
        const Real rebound = approach_of<Real>(touch.contact, impact_bodies_) * Real(restitution);
        return !(rebound * rebound < Real(2.0 * least) * press * small);
    };
    if (is_hand) return rises(1.0, 2.0 * lively_rise) ? usual : 1.0;
    if (touch.kind == Kind::ball_ball) return rises(usual, pushing_rise) ? usual : 1.0;
    return rises(usual, resting_rise) ? usual : 0.0;
}

// As rub_contacts, in both of the ways in which surfaces slip here: each contact goes from what it
// passes towards what would stop both slips, as far as its limit allows. So no round makes energy.
template <typename Real>
void EventEngine<Real>::rub_contacts_on_cloth() {
    std::vector<Rubbing>& all = rubbings_;
    const Real zero{};
    const Real one(1.0);
    const Real inertia(*world_->model.spin);
    const auto pass = [&](std::uint32_t body, const Vector<Real>& normal, const Real& along,
                          const Real& upwards, const Real& side) {
        ImpactBody<Real>& each = impact_bodies_[body];
        const Real size = radius(bodies_[body].ball);
        each.velocity += perpendicular(normal) * (side * along * each.inverse_mass);
        body_spins_[body] -= along * each.inverse_mass / (inertia * size);
        body_rolls_[body] += normal * (upwards * each.inverse_mass / inertia);
    };
    const int most_rounds = all.size() == 1 ? 1 : 64;
    for (int round = 0; round < most_rounds; ++round) {
        bool is_done = true;
        for (Rubbing& each : all) {
            const auto& contact = each.touch->contact;
            const bool on_ball = contact.b != ImpactContact<Real>::fixed;
            const Vector<Real> along = perpendicular(contact.normal);
            const auto& a = impact_bodies_[contact.a];
            Real inverse = a.inverse_mass * Real(double(shares_[contact.a]));
            Real slip =
                dot(a.velocity, along) - radius(bodies_[contact.a].ball) * body_spins_[contact.a];
            Real rise = dot(body_rolls_[contact.a], contact.normal);
            if (on_ball) {
                const auto& b = impact_bodies_[contact.b];
                inverse += b.inverse_mass * Real(double(shares_[contact.b]));
                slip -= dot(b.velocity, along) +
                        radius(bodies_[contact.b].ball) * body_spins_[contact.b];
                rise += dot(body_rolls_[contact.b], contact.normal);
            } else {
                slip -= dot(each.touch->surface_velocity, along);
            }
            each.change = each.lift_change = zero;
            if (!(inverse > zero)) continue;
            const Real wanted = -slip / (inverse * (one + one / inertia));
            const Real wanted_lift = -rise * inertia / inverse;
            // The largest share of it that stays within the limit, by the root without
            // cancellation.
            const Real square = wanted * wanted + wanted_lift * wanted_lift;
            const Real lean = each.impulse * wanted + each.lift * wanted_lift;
            const Real left =
                each.most * each.most - (each.impulse * each.impulse + each.lift * each.lift);
            const Real room = left > zero ? left : zero;
            Real share = one;
            if (square + lean + lean > room) {
                const Real root = square_root(lean * lean + square * room);
                share = lean > zero ? room / (lean + root) : (root - lean) / square;
            }
            each.change = wanted * share;
            each.lift_change = wanted_lift * share;
            const Real noise = Real(16.0 * precision<Real>) * each.most;
            is_done = is_done && !(absolute(each.change) > noise) &&
                      !(absolute(each.lift_change) > noise);
        }
        for (Rubbing& each : all) {
            const auto& contact = each.touch->contact;
            each.impulse += each.change;
            each.lift += each.lift_change;
            pass(contact.a, contact.normal, each.change, each.lift_change, one);
            if (contact.b != ImpactContact<Real>::fixed)
                pass(contact.b, contact.normal, each.change, each.lift_change, -one);
        }
        if (is_done) break;
    }
}

// Whether a path that the world remembers is one of its cloth, or of none where it has none.
template <typename Real>
bool EventEngine<Real>::is_path_on_cloth(const EventPath<Real>& path) const {
    if (!world_->model.cloth) return !is_on_cloth(path);
    return is_on_cloth(path) && phase_of(path).acceleration == path.acceleration;
}

template <typename Real>
bool EventEngine<Real>::is_roll_left(std::uint32_t ball) const {
    return !world_->model.cloth || Vec2(roll_at(ball, now_)) == world_->balls.roll[ball];
}

template <typename Real>
void EventEngine<Real>::write_rolls(World& world) const {
    for (std::uint32_t i = 0; i < balls_.size(); ++i)
        world.balls.roll[i] = Vec2(roll_at(i, end_));
}

template class EventEngine<double>;
template class EventEngine<Wide>;

}  // namespace carom

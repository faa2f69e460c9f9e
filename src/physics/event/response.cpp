#include <algorithm>
#include <array>

#include "physics/event/engine.h"
#include "physics/laws/bounce.h"

// What an impact does.
namespace carom {

// What the pair's restitution is worth here: see the rules in event_engine.h.
template <typename Real>
double EventEngine<Real>::restitution_of(const Touch& touch, bool is_alone) {
    const Body& body = bodies_[touch.contact.a];
    const std::uint32_t ball = body.ball;
    const Real approach = approach_of<Real>(touch.contact, impact_bodies_);
    const double speed = static_cast<double>(approach);
    double restitution = 1.0;
    const EventPath<Real> path = balls_.path(ball);
    if (touch.kind == Kind::ball_ball) {
        const EventPath<Real> theirs = balls_.path(touch.other);
        if (world_->model.lossy)
            restitution =
                std::min(world_->balls.restitution[ball], world_->balls.restitution[touch.other]);
        const bool is_pushed = impact_bodies_[touch.contact.a].inverse_mass == Real{} ||
                               impact_bodies_[touch.contact.b].inverse_mass == Real{};
        if (is_pushed && (path.motion == Motion::held || theirs.motion == Motion::held))
            return hand_restitution;
        if (restitution < 1.0 && path.quick > most_quick && theirs.quick > most_quick) return 0.0;
        if (!is_alone || !world_->model.gravity) return restitution;
        const Real press = -dot(path.acceleration - theirs.acceleration, touch.contact.normal);
        if (!(press > Real{})) return restitution;
        const Real rebound = approach * Real(restitution);
        const Real small = std::min(radius(ball), radius(touch.other));
        const Real rise = rebound * rebound / (Real(2.0) * press);
        const bool one_rests = body.was_resting || bodies_[touch.contact.b].was_resting;
        if (one_rests) return is_alone && rise < Real(resting_rise) * small ? 0.0 : restitution;
        return rise < Real(lively_rise) * small ? 1.0 : restitution;
    }
    const Material& material = world_->materials[world_->capsules.material[touch.other]];
    if (world_->model.lossy) restitution = restitution_at(material, std::max(0.0, speed));
    if (touch.is_driven && approach > Real{})
        return driven_restitution(restitution, static_cast<double>(touch.contact.surface), speed);
    if (touch.kind == Kind::hand && touch.contact.surface > Real{}) {
        // As bounce_off, as a share of the approach.
        Vec2 velocity(impact_bodies_[touch.contact.a].velocity);
        const Vec2 normal(touch.contact.normal);
        const double surface = static_cast<double>(touch.contact.surface);
        const Exchange done = bounce_off(velocity, 1.0, normal, surface, restitution);
        return done.approach > 0.0
                   ? std::max(0.0, (dot(velocity, normal) - surface) / done.approach)
                   : 0.0;
    }
    if (restitution < 1.0 && path.quick > most_quick && !world_->model.gravity) return 0.0;
    if (!is_alone || !world_->model.gravity) return restitution;
    const Real press = -dot(path.acceleration, touch.contact.normal);
    if (!(press > Real{})) return restitution;
    const Real rebound = approach * Real(restitution);
    return rebound * rebound < Real(2.0 * resting_rise) * press * radius(ball) ? 0.0 : restitution;
}

template <typename Real>
void EventEngine<Real>::pass_impulses(const std::vector<std::uint32_t>& which, bool is_alone,
                                      std::vector<Contact>& contacts) {
    std::vector<ImpactContact<Real>>& group = group_;
    std::vector<Real>& approach = approach_;
    group.clear();
    approach.clear();
    for (const std::uint32_t index : which) {
        Touch& touch = touches_[index];
        const double restitution = restitution_of(touch, is_alone);
        touch.contact.restitution = Real(
            world_->model.cloth ? restitution_on_cloth(touch, is_alone, restitution) : restitution);
        group.push_back(touch.contact);
        if (touch.kind == Kind::ball_edge && world_->model.scatter && is_alone) {
            const std::uint32_t ball = bodies_[touch.contact.a].ball;
            const Vec2 velocity(impact_bodies_[touch.contact.a].velocity);
            if (touch.contact.restitution > Real{})
                group.back().normal = Vector<Real>(
                    scattered_normal(*world_, world_->balls.id[ball], edge_contacts_[ball]++,
                                     Vec2(touch.contact.normal), velocity,
                                     static_cast<double>(touch.contact.restitution)));
        }
        approach.push_back(approach_of<Real>(group.back(), impact_bodies_));
    }
    // A ball at rest that is met so softly that the other comes to rest on it does not wake.
    std::array<Real, 2> masses{};
    const bool is_soft = is_alone && touches_[which[0]].kind == Kind::ball_ball &&
                         group[0].restitution == Real{} && world_->model.gravity;
    if (is_soft) {
        masses = {impact_bodies_[group[0].a].inverse_mass, impact_bodies_[group[0].b].inverse_mass};
        for (const std::uint32_t body : {group[0].a, group[0].b}) {
            const bool both = bodies_[group[0].a].was_resting && bodies_[group[0].b].was_resting;
            if (bodies_[body].was_resting && !both) impact_bodies_[body].inverse_mass = Real{};
        }
    }
    std::pmr::vector<Real>& passed = passed_;
    if (group.size() == 1)
        passed.assign(1, reflect_alone<Real>(impact_bodies_, group[0]));
    else
        passed = reflect<Real>(impact_bodies_, group, &reflections_);
    if (world_->model.spin) rub_contacts(which, passed);
    if (is_soft) {
        impact_bodies_[group[0].a].inverse_mass = masses[0];
        impact_bodies_[group[0].b].inverse_mass = masses[1];
    }
    for (std::size_t i = 0; i < which.size(); ++i) {
        const Touch& touch = touches_[which[i]];
        if (!(passed[i] > Real{})) continue;
        const std::uint32_t ball = bodies_[touch.contact.a].ball;
        const bool on_ball = touch.kind == Kind::ball_ball;
        const bool swapped = on_ball && touch.other < ball;
        const Real size = radius(ball);
        for (const std::uint32_t body : {touch.contact.a, touch.contact.b})
            if (body != ImpactContact<Real>::fixed && !(is_soft && bodies_[body].was_resting))
                bodies_[body].is_changed = true;
        const Vec2 point(bodies_[touch.contact.a].position - touch.contact.normal * size);
        const Vec2 normal(group[i].normal);
        if (world_->model.kicks && touch.kind != Kind::ball_ball)
            impact_bodies_[touch.contact.a].velocity +=
                group[i].normal *
                Real(kick_at(world_->materials[world_->capsules.material[touch.other]],
                             world_->capsules.shape[touch.other], point,
                             static_cast<double>(approach[i])));
        contacts.push_back(
            {.time = static_cast<double>(now_),
             .kind = on_ball ? ContactKind::ball_ball : ContactKind::ball_edge,
             .a = swapped ? touch.other : ball,
             .b = swapped ? ball : touch.other,
             .point = world_->model.wrap ? wrapped(point, *world_->model.wrap) : point,
             .normal = swapped ? -normal : normal,
             .approach = static_cast<double>(approach[i]),
             .impulse = static_cast<double>(passed[i])});
    }
}

template <typename Real>
void EventEngine<Real>::impact(std::uint32_t ball, const Event& event,
                               std::vector<Contact>& contacts, std::vector<std::uint8_t>& touched) {
    bodies_.clear();
    impact_bodies_.clear();
    body_spins_.clear();
    body_rolls_.clear();
    touches_.clear();
    near_count_ = 0;
    is_near_valid_ = true;
    // Seen from the lower number, whoever's event it is: the other may not know of it yet.
    const bool is_pair = event.kind == Kind::ball_ball;
    const bool is_swapped = is_pair && event.other < ball;
    const std::uint32_t body = body_of(select(is_swapped, event.other, ball));
    const int side = 1 - 2 * static_cast<int>(is_swapped);
    if (is_pair)
        add_ball_touch(body, select(is_swapped, ball, event.other), side * event.across,
                       side * event.along, true);
    else if (event.kind == Kind::hand)
        add_hand_touch(body, hands_[event.other], true);
    else
        add_edge_touch(body, event.other, event.across, event.along, true);
    const bool has_pair = touches_.front().contact.b != ImpactContact<Real>::fixed;
    bodies_[body].is_changed = true;
    if (has_pair && !bodies_[touches_.front().contact.b].was_resting)
        bodies_[touches_.front().contact.b].is_changed = true;
    scan(body);
    if (has_pair) scan(touches_.front().contact.b);

    const std::size_t most_rounds = 200;
    std::vector<std::uint32_t>& approaching = approaching_;
    bool is_shut_in = false;
    for (std::size_t round = 0;; ++round) {
        approaching.clear();
        for (std::uint32_t i = 0; i < touches_.size(); ++i) {
            const Touch& touch = touches_[i];
            Real speeds = bodies_[touch.contact.a].fastest + absolute(touch.contact.surface);
            Real inverse = impact_bodies_[touch.contact.a].inverse_mass;
            if (touch.contact.b != ImpactContact<Real>::fixed) {
                speeds += bodies_[touch.contact.b].fastest;
                inverse += impact_bodies_[touch.contact.b].inverse_mass;
            }
            if (!(inverse > Real{})) continue;
            Real rounding = Real(approach_noise<Real>) * speeds;
            if (field_.pressing > Real{}) {
                const Real small =
                    touch.kind == Kind::ball_ball
                        ? std::min(radius(bodies_[touch.contact.a].ball), radius(touch.other))
                        : radius(bodies_[touch.contact.a].ball);
                rounding += Real(0.125 * pressing_noise) * square_root(field_.pressing * small);
            }
            const Real slow = round == 0 && i == 0 ? Real{} : pressing_speed(touch);
            if (approach_of<Real>(touch.contact, impact_bodies_) > std::max(rounding, slow))
                approaching.push_back(i);
        }
        if (approaching.empty()) break;
        if (round > 0) more_rounds_ += 1 + approaching.size() * approaching.size();
        // Many rounds: losing contacts that are shut in. From here on they stop, all at once.
        if (round > most_rounds + 8 * touches_.size()) break;
        if (round > most_rounds / 2 + 4 * touches_.size()) {
            if (!is_shut_in) hold_the_tired();
            is_shut_in = true;
            approaching.clear();
            for (std::uint32_t i = 0; i < touches_.size(); ++i)
                approaching.push_back(i);
            std::erase_if(approaching, [&](std::uint32_t i) {
                const auto& contact = touches_[i].contact;
                Real inverse = impact_bodies_[contact.a].inverse_mass;
                if (contact.b != ImpactContact<Real>::fixed)
                    inverse += impact_bodies_[contact.b].inverse_mass;
                return !(inverse > Real{});
            });
            group_.clear();
            for (const std::uint32_t i : approaching) {
                group_.push_back(touches_[i].contact);
                group_.back().restitution = Real{};
            }
            reflect<Real>(impact_bodies_, group_, &reflections_);
            for (Body& each : bodies_)
                each.is_changed = true;
        } else {
            pass_impulses(approaching, round == 0 && approaching.size() == 1, contacts);
        }
        note_speeds(is_shut_in);
        const std::size_t count = bodies_.size();
        for (std::uint32_t i = 0; i < count; ++i)
            if (bodies_[i].is_changed) scan(i);
    }
    bool squeezed = false;
    for (std::uint32_t i = 0; i < bodies_.size(); ++i)
        if (balls_[bodies_[i].ball].line.motion == Motion::held && !hold_back(i)) squeezed = true;
    for (const Touch& touch : touches_) {
        const std::uint32_t held = bodies_[touch.contact.a].ball;
        if (touch.kind == Kind::ball_ball) continue;
        if (touch.kind == Kind::hand && (is_shut_in || balls_[held].line.quick > most_quick))
            squeezed = true;
    }
    for (const Touch& touch : touches_)
        if (touch.kind == Kind::ball_ball &&
            (is_shut_in || balls_[bodies_[touch.contact.a].ball].line.quick > most_quick) &&
            (balls_[bodies_[touch.contact.a].ball].line.motion == Motion::held ||
             balls_[touch.other].line.motion == Motion::held))
            squeezed = true;

    part_pressed();
    std::vector<std::uint32_t>& changed = changed_;
    changed.clear();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Body& each = bodies_[i];
        touched[each.ball] |= each.is_changed;
        if (!each.is_changed) continue;
        const EventPath<Real> before = balls_.path(each.ball);
        const Real way = length(each.position - before.position);
        if (each.is_moved) cells_.leave(balls_, each.ball);
        start_path(each.ball, now_, each.position, impact_bodies_[i].velocity);
        if (each.is_moved) cells_.enter(balls_, each.ball, Vec2(balls_[each.ball].line.position));
        if (world_->model.spin) spins_[each.ball].spin = body_spins_[i];
        if (world_->model.cloth) balls_.bend(each.ball).center = body_rolls_[i];
        EventLine<Real>& line = balls_[each.ball].line;
        line.quick = world_->model.gravity
                         ? tiredness(each.ball, before)
                         : (way < Real(touching) * radius(each.ball) ? one_more(before.quick) : 0);
        if (before.motion == Motion::held) hold(each.ball);
        if (line.quick > crowding) note_crowded(i);
        changed.push_back(each.ball);
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i].is_changed && bodies_[i].was_resting)
            release_what_rests_on(bodies_[i].ball, changed);
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const std::uint32_t each : changed)
        settle(each);
    for (const std::uint32_t each : changed)
        lie_down_if_tired(each, is_shut_in);
    if (squeezed) stop_hands();
    bool is_predicted = false;
    for (const std::uint32_t each : changed) {
        is_predicted = static_cast<int>(is_predicted) | static_cast<int>(each == ball);
        const std::uint32_t index = balls_.body(each);
        if (index != EventBall<Real>::none)
            predict_after(bodies_[index]);
        else
            predict(each);
        reorder(each);
    }
    for (const Body& each : bodies_)
        balls_.body(each.ball) = EventBall<Real>::none;
    if (is_predicted) return;
    predict(ball);
    reorder(ball);
}

// Balls that lie still since they are tired would lie down again at once, and what has been stopped
// with them would meet them anew: it is stopped by them.
template <typename Real>
void EventEngine<Real>::hold_the_tired() {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const EventPath<Real> path = balls_.path(bodies_[i].ball);
        if (path.motion == Motion::resting && path.support.by == PathSupport::By::nothing)
            impact_bodies_[i] = {{}, Real{}};
    }
}

// After a round of an impact. What is left of a speed that was stopped is rounding, and none.
template <typename Real>
void EventEngine<Real>::note_speeds(bool is_shut_in) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Vector<Real>& velocity = impact_bodies_[i].velocity;
        const Real speed = length(velocity);
        if (bodies_[i].fastest < speed) bodies_[i].fastest = speed;
        if (is_shut_in && !(speed > Real(approach_noise<Real>) * bodies_[i].fastest)) velocity = {};
    }
}

// A held ball goes no further against what cannot give way, but along it; and where that leads
// against something else that it touches, along that, or not at all. False: something comes at it
// even then.
template <typename Real>
bool EventEngine<Real>::hold_back(std::uint32_t body) {
    const auto for_each_bar = [&](auto&& visit) {
        for (const Touch& touch : touches_)
            if (touch.kind != Kind::ball_ball && touch.contact.a == body) visit(touch.contact);
    };
    const auto is_free = [&](const Vector<Real>& velocity) {
        bool is = true;
        for_each_bar([&](const ImpactContact<Real>& bar) {
            const Real speeds = length(velocity) + absolute(bar.surface);
            is = is &&
                 !(bar.surface - dot(velocity, bar.normal) > Real(approach_noise<Real>) * speeds);
        });
        return is;
    };
    Vector<Real>& velocity = impact_bodies_[body].velocity;
    const Vector<Real> wanted = velocity;
    const auto along = [](const Vector<Real>& way, const ImpactContact<Real>& bar) {
        const Real into = bar.surface - dot(way, bar.normal);
        return into > Real{} ? way + bar.normal * into : way;
    };
    for_each_bar([&](const ImpactContact<Real>& bar) { velocity = along(velocity, bar); });
    if (is_free(velocity)) return true;
    for_each_bar([&](const ImpactContact<Real>& bar) {
        if (!is_free(velocity)) velocity = along(wanted, bar);
    });
    if (is_free(velocity)) return true;
    velocity = {};
    return is_free(velocity);
}

// Balls that move and are pressed together sink in by a hair before they meet again: they are taken
// apart to touch, the free ones of them, by their masses.
template <typename Real>
void EventEngine<Real>::part_pressed() {
    const bool on_cloth = world_->model.cloth.has_value();
    if (!(world_->model.gravity && world_->model.lossy) && !on_cloth) return;
    const Real deep(on_cloth ? 2.0 * pushing_rise : 0.5 * lively_rise);
    for (const Touch& touch : touches_) {
        if (touch.kind != Kind::ball_ball) continue;
        Body& a = bodies_[touch.contact.a];
        Body& b = bodies_[touch.contact.b];
        const Real small = std::min(radius(a.ball), radius(b.ball));
        if (!(touch.gap < -deep * small)) continue;
        // By no more than what cannot take a ball past an edge unseen, even where one has been put
        // into another.
        const Real depth = std::min(-touch.gap, Real(0.5) * small);
        const auto share = [&](const Body& body, std::uint32_t index, const Vector<Real>& way) {
            const EventPath<Real> path = balls_.path(body.ball);
            const bool may_give_way = path.motion == Motion::free || is_on_cloth(path);
            if (!body.is_changed || !may_give_way) return Real{};
            const Vector<Real> there = body.position + way * depth;
            bool is_barred = false;  // never into an edge
            const auto bar = [&](std::uint32_t capsule, Vec2 shift, int, int) {
                const Edge<Real> edge(world_->capsules.shape[capsule], shift);
                const Real size = radius(body.ball);
                const Real gap = contact_with(edge, there, size).gap;
                is_barred = is_barred ||
                            (gap < Real{} && gap < contact_with(edge, body.position, size).gap);
            };
            for_each_edge_around(body.ball, cells_.spot_of(Vec2(there)), bar);
            if (is_barred) return Real{};
            return impact_bodies_[index].inverse_mass;
        };
        const Real ours = share(a, touch.contact.a, touch.contact.normal);
        const Real theirs = share(b, touch.contact.b, -touch.contact.normal);
        if (!(ours + theirs > Real{})) continue;
        const Vector<Real> way = touch.contact.normal * (depth / (ours + theirs));
        a.position += way * ours;
        b.position -= way * theirs;
        a.is_moved = b.is_moved = true;
        is_near_valid_ = false;
    }
}

// A hand that would squeeze a ball stops for the rest of the tick.
template <typename Real>
void EventEngine<Real>::stop_hands() {
    for (Hand& hand : hands_) {
        if (!(now_ < hand.edge.stop)) continue;
        hand.edge.stop = now_;
        hand_stopped_ = true;
    }
    for (std::uint32_t i = 0; i < balls_.size(); ++i) {
        const EventLine<Real>& line = balls_[i].line;
        if (line.motion != Motion::held || line.velocity == Vector<Real>{}) continue;
        start_path(i, now_, state_at(balls_.path(i), field_, now_).position, {});
        hold(i);
        hand_stopped_ = true;
    }
}

template class EventEngine<double>;
template class EventEngine<Wide>;

}  // namespace carom

#include <algorithm>
#include <array>
#include <limits>

#include "physics/event_engine.h"

// Where all balls fly in straight lines and may meet one another, as in a gas: the same events,
// with the same bits, without asking at each what gravity, friction, a torus or rest would change.
namespace carom {
namespace {

// Two balls where the later of their paths begins: StraightPair, where nothing accelerates them.
template <typename Real>
struct LinePair {
    Real begin;
    Vector<Real> velocity;
    Vector<Real> offset;

    LinePair(const EventPath<Real>& a, const EventPath<Real>& b)
        : begin(a.time < b.time ? b.time : a.time),
          velocity(a.velocity - b.velocity),
          offset((a.position + a.velocity * (begin - a.time)) -
                 (b.position + b.velocity * (begin - b.time))) {}
};

}  // namespace

// Pre: no path has been kept from a time when the scene had other terms.
template <typename Real>
bool EventEngine<Real>::are_lines() const {
    const Model& model = world_->model;
    return model.ball_ball && !model.gravity && !field_.has_drag && !model.spin && !model.cloth &&
           !model.wrap && !model.filtered && !model.one_way && hands_.empty() &&
           cells_.giants().empty() &&
           std::all_of(balls_.begin(), balls_.end(), [](const EventBall<Real>& ball) {
               return ball.path.motion == Motion::free;
           });
}

template <typename Real>
void EventEngine<Real>::happen_on_lines(std::uint32_t ball, const Event& event,
                                        std::vector<Contact>& contacts,
                                        std::vector<std::uint8_t>& touched) {
    if (event.kind == Kind::crossing) {
        enter_next_cell_on_line(ball, event.other);
    } else if (event.kind != Kind::ball_ball) {
        impact(ball, event, contacts, touched);
    } else if (event.other_version != balls_[event.other].version) {
        predict_on_line(ball);
    } else if (!impact_of_two(ball, event, contacts, touched)) {
        impact(ball, event, contacts, touched);
    }
}

// The ball is going to meet another: takes that for `best`, if it comes before.
template <typename Real>
inline void EventEngine<Real>::meet_on_line(std::uint32_t ball, std::uint32_t other,
                                            const LineMeeting<Real>& meeting, const Real& begin,
                                            const Vector<Real>& offset, Event& best) const {
    const EventBall<Real>& us = balls_[ball];
    const EventBall<Real>& them = balls_[other];
    const Real small = us.radius < them.radius ? us.radius : them.radius;
    // As seen from the one with the lower number, whoever asks: the same bits.
    auto time = meeting_time(meeting, balls_[std::min(ball, other)].path,
                             balls_[std::max(ball, other)].path, begin, offset, Vector<Real>{},
                             us.radius + them.radius, small, field_);
    if (!time) return;
    if (*time < now_) time = now_;
    const Event found{*time, Kind::ball_ball, 0, 0, other, them.version};
    int comes = static_cast<int>(*time < best.time);
    if (*time == best.time) comes = comes_first(ball, found, ball, best);
    assign_if(comes != 0, best, found);
}

template <typename Real>
void EventEngine<Real>::look_at_line(std::uint32_t ball, std::uint32_t other, Event& best) const {
    const EventBall<Real>& us = balls_[ball];
    const EventBall<Real>& them = balls_[other];
    const LinePair<Real> pair(us.path, them.path);
    const LineMeeting<Real> line(pair.offset, pair.velocity, us.radius + them.radius);
    if (line.is_one()) meet_on_line(ball, other, line, pair.begin, pair.offset, best);
}

template <typename Real>
void EventEngine<Real>::predict_on_line(std::uint32_t ball) {
    Event meeting;
    meeting.time = Real(std::numeric_limits<double>::infinity());
    auto firsts = cells_.firsts_near(balls_, ball);
    firsts.for_each(balls_.data(),
                    [&](std::uint32_t other, int, int) { look_at_line(ball, other, meeting); });
    choose_next_on_line(ball, meeting);
}

template <typename Real>
void EventEngine<Real>::enter_next_cell_on_line(std::uint32_t ball, std::uint32_t direction) {
    const int way = 1 - 2 * static_cast<int>(direction & 1);
    const int rows = way & -static_cast<int>(direction >> 1);
    const int columns = way - rows;
    cells_.step(balls_, ball, columns, rows);
    Event meeting = balls_.plan(ball).meeting;
    assign_if(meeting.kind == Kind::none, meeting.time,
              Real(std::numeric_limits<double>::infinity()));
    auto firsts = cells_.firsts_of_new(balls_, ball, columns, rows);
    firsts.for_each(balls_.data(),
                    [&](std::uint32_t other, int, int) { look_at_line(ball, other, meeting); });
    choose_next_on_line(ball, meeting);
}

// `choose_next`, and `reorder`.
template <typename Real>
inline void EventEngine<Real>::choose_next_on_line(std::uint32_t ball, const Event& meeting) {
    EventPlan<Real>& plan = balls_.plan(ball);
    plan.meeting = meeting;
    balls_[ball].is_meeting_known = true;
    plan.coming = meeting;
    predict_crossing_of_line(ball, plan.coming);
    if (world_->model.ball_edge && !edges_.is_empty(plan.place.cell))
        predict_edges(ball, plan.coming);
    reorder(ball);
}

// The balls near the one that is at `place` now and flies on with `velocity`, its `partner` never
// approached. False if it may touch another already, or if they are too many.
template <typename Real>
inline bool EventEngine<Real>::find_lines(std::uint32_t ball, std::uint32_t partner,
                                          const Vector<Real>& place, const Vector<Real>& velocity,
                                          Lines& lines) const {
    const EventBall<Real>* const balls = balls_.data();
    const Real now = now_;
    const Real size = balls[ball].radius;
    const Real slack = Real(16.0) * rounding_at(place, Real{});
    const Vector<Real> from = place;
    const Vector<Real> way = velocity;
    std::size_t count = 0;
    std::size_t approached = 0;
    int are_apart = 1;
    auto firsts = cells_.firsts_near(balls_, ball);
    firsts.for_each(balls, [&](std::uint32_t other, int, int) {
        const EventPath<Real>& path = balls[other].path;
        const Vector<Real> offset = from - (path.position + path.velocity * (now - path.time));
        const Real reach = size + balls[other].radius;
        // Further than any that may touch: as in `scan`.
        const Real rough = reach * Real(1.0 + 4.0 * touching) + slack;
        const LineMeeting<Real> meeting(offset, way - path.velocity, reach);
        const auto is_other = static_cast<int>(other != partner);
        are_apart &= (is_other ^ 1) | static_cast<int>(length_squared(offset) > rough * rough);
        const std::size_t at = std::min(count, Lines::most - 1);
        lines.other[at] = other;
        lines.offset[at] = offset;
        lines.meeting[at] = meeting;
        lines.approached[approached] = static_cast<std::uint32_t>(at);
        approached = std::min(
            approached + static_cast<std::size_t>(static_cast<int>(meeting.is_one()) & is_other),
            Lines::most - 1);
        ++count;
    });
    lines.approached_count = approached;
    return are_apart != 0 && count < Lines::most;
}

// Whether the ball, at `place` now, touches no edge.
template <typename Real>
bool EventEngine<Real>::is_off_edges(std::uint32_t ball, const Vector<Real>& place) const {
    bool is_off = true;
    for_each_edge_near(ball, [&](std::uint32_t capsule, Vec2 shift, int, int) {
        const Edge<Real> edge(world_->capsules.shape[capsule], shift);
        const Real size = radius(ball);
        is_off = is_off &&
                 contact_with(edge, place, size).gap >
                     size * Real(touching) + Real(16.0) * rounding_at(place, size + edge.radius);
    });
    return is_off;
}

// Two balls meet that touch nothing else, which nearly all do. False, and nothing has changed:
// `impact` has to do it.
template <typename Real>
bool EventEngine<Real>::impact_of_two(std::uint32_t ball, const Event& event,
                                      std::vector<Contact>& contacts,
                                      std::vector<std::uint8_t>& touched) {
    // Seen from the lower number, whoever's event it is.
    const std::array<std::uint32_t, 2> both{std::min(ball, event.other),
                                            std::max(ball, event.other)};
    std::array<ImpactBody<Real>, 2> bodies;
    std::array<Vector<Real>, 2> places;
    std::array<std::uint32_t, 2> quick{};
    for (std::size_t i = 0; i < 2; ++i) {
        const EventBall<Real>& each = balls_[both[i]];
        if (each.path.quick >= most_quick) return false;
        const Vector<Real> way = each.path.velocity * (now_ - each.path.time);
        places[i] = each.path.position + way;
        bodies[i] = {each.path.velocity, each.inverse_mass};
        const bool is_quick = length(places[i] - each.path.position) < Real(touching) * each.radius;
        quick[i] = select(is_quick, each.path.quick + 1, 0);
    }
    const Vector<Real> offset = places[0] - places[1];
    const Real away = length(offset);
    ImpactContact<Real> contact;
    contact.a = 0;
    contact.b = 1;
    contact.normal = offset / away;
    const auto approach_now = [&] { return approach_of<Real>(contact, bodies); };
    const auto noise = [&] {
        return Real(approach_noise<Real>) *
               (length(bodies[0].velocity) + length(bodies[1].velocity));
    };
    const Real approach = approach_now();
    const bool can_move = bodies[0].inverse_mass + bodies[1].inverse_mass > Real{};
    if (!(away > Real{}) || !can_move || !(approach > noise())) return false;
    if (world_->model.lossy)
        contact.restitution =
            Real(std::min(world_->balls.restitution[both[0]], world_->balls.restitution[both[1]]));
    const Real impulse = reflect_alone<Real>(bodies, contact);
    if (!(impulse > Real{}) || approach_now() > noise()) return false;
    if (!is_off_edges(both[0], places[0]) || !is_off_edges(both[1], places[1])) return false;
    for (std::size_t i = 0; i < 2; ++i)
        if (!find_lines(both[i], both[1 - i], places[i], bodies[i].velocity, lines_[i]))
            return false;

    contacts.push_back({.time = static_cast<double>(now_),
                        .kind = ContactKind::ball_ball,
                        .a = both[0],
                        .b = both[1],
                        .point = Vec2(places[0] - contact.normal * radius(both[0])),
                        .normal = Vec2(contact.normal),
                        .approach = static_cast<double>(approach),
                        .impulse = static_cast<double>(impulse)});
    for (std::size_t i = 0; i < 2; ++i) {
        touched[both[i]] = 1;
        start_path(both[i], now_, places[i], bodies[i].velocity);
        balls_[both[i]].path.quick = quick[i];
    }
    // They part; or nearly so.
    const bool is_parting = !LineMeeting<Real>(offset, bodies[0].velocity - bodies[1].velocity,
                                               radius(both[0]) + radius(both[1]))
                                 .is_one();
    for (std::size_t i = 0; i < 2; ++i) {
        Event meeting;
        meeting.time = Real(std::numeric_limits<double>::infinity());
        if (!is_parting) look_at_line(both[i], both[1 - i], meeting);
        const Lines& lines = lines_[i];
        for (std::size_t at = 0; at < lines.approached_count; ++at) {
            const std::uint32_t which = lines.approached[at];
            meet_on_line(both[i], lines.other[which], lines.meeting[which], now_,
                         lines.offset[which], meeting);
        }
        choose_next_on_line(both[i], meeting);
    }
    return true;
}

template class EventEngine<double>;
template class EventEngine<Wide>;

}  // namespace carom

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

#include "geometry/f64x2.h"
#include "physics/event/engine.h"

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

    LinePair(const EventLine<Real>& a, const EventLine<Real>& b)
        : begin(a.time < b.time ? b.time : a.time),
          velocity(a.velocity - b.velocity),
          offset((a.position + a.velocity * (begin - a.time)) -
                 (b.position + b.velocity * (begin - b.time))) {}
};

}  // namespace

// Whether all balls fly in straight lines, and each may meet any other.
template <typename Real>
bool EventEngine<Real>::are_lines() const {
    const Model& model = world_->model;
    return model.ball_ball && !model.gravity && !field_.has_drag && !model.spin && !model.cloth &&
           !model.wrap && !model.filtered && !model.one_way && hands_.empty() &&
           cells_.giants().empty() &&
           std::all_of(balls_.begin(), balls_.end(), [](const EventBall<Real>& ball) {
               return ball.line.motion == Motion::free;
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

// The ball is going to meet another, unless it meets `best` before: who comes first.
template <typename Real>
inline auto EventEngine<Real>::first_met(std::uint32_t ball, std::uint32_t other,
                                         const LineMeeting<Real>& meeting, const Real& begin,
                                         const Vector<Real>& offset, FirstMet best) const
    -> FirstMet {
    const EventBall<Real>& us = balls_[ball];
    const EventBall<Real>& them = balls_[other];
    const Real small = us.radius < them.radius ? us.radius : them.radius;
    // As seen from the one with the lower number, whoever asks: the same bits.
    const auto met = meeting_time(meeting, balls_[std::min(ball, other)].line,
                                  balls_[std::max(ball, other)].line, begin, offset, Vector<Real>{},
                                  us.radius + them.radius, small, field_);
    if (!met) return best;
    const Real time = *met < now_ ? now_ : *met;
    bool comes = time < best.time;
    if (time == best.time)
        comes = comes_first(ball, {time, Kind::ball_ball, 0, 0, other, 0}, ball,
                            {best.time, Kind::ball_ball, 0, 0, best.other, 0});
    best.time = time < best.time ? time : best.time;
    best.other = select(comes, other, best.other);
    best.version = select(comes, them.version, best.version);
    return best;
}

// The same of a ball that it may never meet.
template <typename Real>
inline auto EventEngine<Real>::first_met(std::uint32_t ball, std::uint32_t other,
                                         FirstMet best) const -> FirstMet {
    const EventBall<Real>& us = balls_[ball];
    const EventBall<Real>& them = balls_[other];
    const LinePair<Real> pair(us.line, them.line);
    const LineMeeting<Real> line(pair.offset, pair.velocity, us.radius + them.radius);
    return line.is_one() ? first_met(ball, other, line, pair.begin, pair.offset, best) : best;
}

template <typename Real>
void EventEngine<Real>::predict_on_line(std::uint32_t ball) {
    FirstMet met;
    auto firsts = cells_.firsts_near(balls_, ball);
    firsts.for_each(balls_.data(),
                    [&](std::uint32_t other, int, int) { met = first_met(ball, other, met); });
    choose_next_on_line(ball, met);
}

template <typename Real>
void EventEngine<Real>::enter_next_cell_on_line(std::uint32_t ball, std::uint32_t direction) {
    const int way = 1 - 2 * static_cast<int>(direction & 1);
    const int rows = way & -static_cast<int>(direction >> 1);
    const int columns = way - rows;
    cells_.step(balls_, ball, columns, rows);
    const Event known = balls_.plan(ball).meeting();
    FirstMet met;
    if (known.kind != Kind::none) met = {known.time, known.other, known.other_version};
    auto firsts = cells_.firsts_of_new(balls_, ball, columns, rows);
    firsts.for_each(balls_.data(),
                    [&](std::uint32_t other, int, int) { met = first_met(ball, other, met); });
    choose_next_on_line(ball, met);
}

// `choose_next`, and `reorder`. Where and when the ball leaves its cell: predict_crossing_of_line
// on a plane, both axes side by side where the numbers are doubles.
template <typename Real>
inline void EventEngine<Real>::choose_next_on_line(std::uint32_t ball, FirstMet met) {
    EventPlan<Real>& plan = balls_.plan(ball);
    const bool is_one = met.other != EventBall<Real>::none;
    const Event meeting{met.time,   is_one ? Kind::ball_ball : Kind::none, 0, 0, met.other,
                        met.version};
    plan.set_meeting(meeting);
    Event coming = meeting;
    if constexpr (!std::is_same_v<Real, double>) {
        predict_crossing_of_line(ball, coming);
    } else {
        const EventLine<double>& path = balls_[ball].line;
        const EventPlace& own = plan.place;
        const CellFrame& frame = cells_.frame();
        const Two speed{path.velocity.x, path.velocity.y};
        const Two place{path.position.x, path.position.y};
        const Two origin{frame.origin.x, frame.origin.y};
        const Two width{frame.cell.x, frame.cell.y};
        const Two last{static_cast<double>(frame.columns), static_cast<double>(frame.rows)};
        const Two cell{static_cast<double>(own.column), static_cast<double>(own.row)};
        const Two zero{};
        const Two one{1.0, 1.0};
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const Two never{infinity, infinity};
        const Two border = cell + (speed > zero ? one : zero);
        const Two crossed = path.time + ((origin + width * border) - place) / speed;
        const Two no_earlier = at_least(Two{now_, now_}, crossed);
        const auto is_crossing = (speed != zero) & (border > zero) & (border < last);
        const Two time = is_crossing ? no_earlier : never;
        const bool is_y = time[1] < time[0];
        const double left = time[1] < time[0] ? time[1] : time[0];
        const auto to_x = static_cast<std::uint32_t>(!(path.velocity.x > 0.0));
        const auto to_y = static_cast<std::uint32_t>(!(path.velocity.y > 0.0));
        // At the same time meetings come first.
        const bool leaves = left < met.time;
        coming.time = left < met.time ? left : met.time;
        constexpr auto crossing = static_cast<std::uint32_t>(Kind::crossing);
        const auto otherwise = static_cast<std::uint32_t>(meeting.kind);
        coming.kind = static_cast<Kind>(select(leaves, crossing, otherwise));
        coming.other = select(leaves, select(is_y, 2 + to_y, to_x), met.other);
    }
    if (world_->model.ball_edge && !edges_.is_empty(plan.place.cell)) predict_edges(ball, coming);
    plan.set_coming(coming);
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
        const EventLine<Real>& path = balls[other].line;
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
    // Nearly always, and much is to be passed about for the rest.
    if (!world_->model.ball_edge || edges_.is_empty(balls_.plan(ball).place.cell)) return true;
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

// `start_path`, after a path that was a line too.
template <typename Real>
inline void EventEngine<Real>::begin_line(std::uint32_t ball, const Vector<Real>& place,
                                          const Vector<Real>& velocity, std::uint32_t quick) {
    EventBall<Real>& each = balls_[ball];
    each.line.quick = quick;
    each.line.time = now_;
    each.line.position = place;
    each.line.velocity = velocity;
    ++each.version;
    note_begun(ball);
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
        if (each.line.quick >= most_quick) return false;
        // As state_at, which makes 0 of -0.
        const Vector<Real> speed = each.line.velocity + Vector<Real>{};
        places[i] = each.line.position + speed * (now_ - each.line.time);
        bodies[i] = {speed, balls_.plan(both[i]).inverse_mass};
        const Vector<Real> way = places[i] - each.line.position;
        const Real near = Real(touching) * each.radius;
        // Roughly first: nearly none are near.
        const bool is_quick = length_squared(way) < Real(2.0) * near * near && length(way) < near;
        quick[i] = select(is_quick, each.line.quick + 1, 0);
    }
    const Vector<Real> offset = places[0] - places[1];
    const Real away = length(offset);
    ImpactContact<Real> contact;
    contact.a = 0;
    contact.b = 1;
    contact.normal = offset / away;
    // What may be rounding is for `impact`: more than what it takes for that.
    const auto sum_of_parts = [](const Vector<Real>& v) { return absolute(v.x) + absolute(v.y); };
    const Real noise = Real(2.0 * approach_noise<Real>) *
                       (sum_of_parts(bodies[0].velocity) + sum_of_parts(bodies[1].velocity));
    const Real approach = approach_of<Real>(contact, bodies);
    const bool can_move = bodies[0].inverse_mass + bodies[1].inverse_mass > Real{};
    if (!(away > Real{}) || !can_move || !(approach > noise)) return false;
    if (world_->model.lossy)
        contact.restitution =
            Real(std::min(world_->balls.restitution[both[0]], world_->balls.restitution[both[1]]));
    const Real impulse = reflect_alone<Real>(bodies, contact);
    if (!(impulse > Real{}) || approach_of<Real>(contact, bodies) > Real{}) return false;
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
        begin_line(both[i], places[i], bodies[i].velocity, quick[i]);
    }
    // They part; or nearly so.
    const bool is_parting = !LineMeeting<Real>(offset, bodies[0].velocity - bodies[1].velocity,
                                               radius(both[0]) + radius(both[1]))
                                 .is_one();
    for (std::size_t i = 0; i < 2; ++i) {
        FirstMet met;
        if (!is_parting) met = first_met(both[i], both[1 - i], met);
        const Lines& lines = lines_[i];
        for (std::size_t at = 0; at < lines.approached_count; ++at) {
            const std::uint32_t which = lines.approached[at];
            met = first_met(both[i], lines.other[which], lines.meeting[which], now_,
                            lines.offset[which], met);
        }
        choose_next_on_line(both[i], met);
    }
    return true;
}

template class EventEngine<double>;
template class EventEngine<Wide>;

}  // namespace carom

#include <algorithm>
#include <array>
#include <limits>

#include "physics/event/engine.h"
#include "physics/laws/bounce.h"

// Which event of a ball comes next.
namespace carom {
namespace {

struct Step {
    int columns = 0;
    int rows = 0;
};
constexpr std::uint32_t look_again = 4;
constexpr std::uint32_t begin_again = 5;
constexpr std::array<Step, 4> steps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

// The first time in begin..end at which `value` (0 at most, say) has changed its sign. Pre: it
// does.
template <typename Real, typename Value>
Real change_of_sign(Value&& value, Real begin, Real end) {
    for (int i = 0; i < 200; ++i) {
        const Real middle = begin + (end - begin) * Real(0.5);
        if (!(begin < middle) || !(middle < end)) break;
        if (value(middle) < Real{})
            end = middle;
        else
            begin = middle;
    }
    return end;
}

}  // namespace

// The order of events: time, kind, lower id, higher id; then whose event it is.
template <typename Real>
bool EventEngine<Real>::comes_first(std::uint32_t ball_a, const Event& a, std::uint32_t ball_b,
                                    const Event& b) const {
    if (a.kind == Kind::none || b.kind == Kind::none)
        return b.kind == Kind::none && (a.kind != Kind::none || ball_a < ball_b);
    if (!(a.time == b.time)) return a.time < b.time;
    if (a.kind != b.kind) return a.kind < b.kind;
    const auto low = [](std::uint32_t ball, const Event& e) {
        return e.kind == Kind::ball_ball ? std::min(ball, e.other) : ball;
    };
    const auto high = [](std::uint32_t ball, const Event& e) {
        return e.kind == Kind::ball_ball ? std::max(ball, e.other) : e.other;
    };
    if (low(ball_a, a) != low(ball_b, b)) return low(ball_a, a) < low(ball_b, b);
    if (high(ball_a, a) != high(ball_b, b)) return high(ball_a, a) < high(ball_b, b);
    return ball_a < ball_b;
}

template <typename Real>
double EventEngine<Real>::queue_time(std::uint32_t ball) const {
    const Event next = balls_.plan(ball).coming();
    return next.kind == Kind::none ? EventQueue::never : static_cast<double>(next.time);
}

template <typename Real>
void EventEngine<Real>::build_queue() {
    coming_.fill({});
    queue_.build(
        balls_.size(), [this](std::uint32_t ball) { return queue_time(ball); },
        [this](std::uint32_t a, std::uint32_t b) {
            return comes_first(a, balls_.plan(a).coming(), b, balls_.plan(b).coming());
        });
}

// The ball's event has changed.
template <typename Real>
void EventEngine<Real>::reorder(std::uint32_t ball) {
    queue_.update(ball, queue_time(ball), [this](std::uint32_t a, std::uint32_t b) {
        return comes_first(a, balls_.plan(a).coming(), b, balls_.plan(b).coming());
    });
}

template <typename Real>
bool EventEngine<Real>::is_flying(std::uint32_t ball) const {
    return balls_[ball].line.motion == Motion::free && !field_.has_drag;
}

// All anew: after its path has changed, or another's that it was to meet.
//
// Balls that fly move in straight lines as seen from one another, so whom such a ball meets first
// is known however far ahead, and stays known from cell to cell: only the new neighbours are looked
// at there. The paths of others are looked at no further than the next event. One-way edges are
// looked at whenever all is predicted anew, which happens at every cell then.
template <typename Real>
void EventEngine<Real>::predict(std::uint32_t ball) {
    Event meeting;
    bool is_known = is_foreseen(ball);
    if (is_known && world_->model.ball_ball)
        cells_.for_each_near(balls_, ball, [&](std::uint32_t other, int across, int along) {
            is_known = is_known && is_flying(other);
            if (is_known) meet_flying(ball, other, across, along, meeting);
        });
    if (!is_known) meeting.kind = Kind::unknown;
    balls_.plan(ball).set_meeting(meeting);
    choose_next(ball);
}

// The same for a ball that an impact has changed just now, from what was seen around it then.
template <typename Real>
void EventEngine<Real>::predict_after(const Body& body) {
    const std::uint32_t ball = body.ball;
    if (!is_near_valid_ || !body.is_scanned || !is_foreseen(ball)) return predict(ball);
    const Vector<Real> velocity = balls_[ball].line.velocity;
    const bool has_gravity = world_->model.gravity.has_value();
    const bool is_filtered = world_->model.filtered;
    const EventBall<Real>* const balls = balls_.data();
    const Real now = now_;
    const Near* const near = near_.data() + body.first_near;
    const auto line_to = [&](const Near& other) {
        const EventLine<Real>& path = balls[other.other].line;
        Vector<Real> relative = velocity - path.velocity;
        if (has_gravity) relative += field_.gravity * -(now - path.time);
        return LineMeeting<Real>(other.offset, relative, other.reach);
    };
    // First who of them may be met, and who has a new path too: nobody can foretell that.
    which_near_.resize(std::max<std::size_t>(which_near_.size(), 2 * std::size_t{body.near}));
    std::uint32_t* const approached = which_near_.data();
    std::uint32_t* const begun = which_near_.data() + body.near;
    std::size_t approached_count = 0;
    std::size_t begun_count = 0;
    int are_free = 1;
    for (std::uint32_t i = 0; i < body.near; ++i) {
        const EventLine<Real>& path = balls[near[i].other].line;
        const auto has_begun = static_cast<int>(path.time == now);
        are_free &= static_cast<int>(path.motion == Motion::free);
        approached[approached_count] = begun[begun_count] = i;
        approached_count +=
            static_cast<std::size_t>(static_cast<int>(line_to(near[i]).is_one()) & ~has_begun);
        begun_count += static_cast<std::size_t>(has_begun);
    }
    const bool is_known = are_free != 0;
    Event meeting;
    if (is_known) {
        for (std::size_t i = 0; i < begun_count; ++i) {
            const Near& other = near[begun[i]];
            meet_flying(ball, other.other, other.across, other.along, meeting);
        }
        for (std::size_t i = 0; i < approached_count; ++i) {
            const Near& other = near[approached[i]];
            if (is_filtered && !balls_meet(ball, other.other)) continue;
            meet_at(ball, other.other, other.across, other.along, line_to(other), now, other.offset,
                    meeting);
        }
    }
    if (!is_known) meeting.kind = Kind::unknown;
    balls_.plan(ball).set_meeting(meeting);
    choose_next(ball);
}

// Whether it can be known whom the ball meets first, if those around it fly too.
template <typename Real>
bool EventEngine<Real>::is_foreseen(std::uint32_t ball) const {
    return is_flying(ball) && cells_.giants().empty() && !world_->model.one_way;
}

// The first of all that can happen to the ball, from now on.
template <typename Real>
void EventEngine<Real>::choose_next(std::uint32_t ball) {
    if (balls_[ball].line.motion == Motion::still && hands_.empty())
        return look_for_the_moving(ball);
    search_.begin_at(now_);
    const bool is_known = balls_.plan(ball).meeting().kind != Kind::unknown;
    const bool is_line = is_known && !world_->model.gravity;
    Event best;
    best.time = Real(std::numeric_limits<double>::infinity());
    // How far to look where it takes longer the further one looks.
    if (!is_line || !hands_.empty())
        best = {now_ + Real(16.0 / world_->rate), Kind::crossing, 0, 0, look_again, 0};
    if (is_known) consider(ball, balls_.plan(ball).meeting(), best);
    if (is_line)
        predict_crossing_of_line(ball, best);
    else
        predict_crossing(ball, best);
    if (world_->model.wrap) predict_far_round(ball, best);
    predict_own(ball, best);
    if (!is_known && world_->model.ball_ball) predict_balls(ball, best);
    if (world_->model.ball_edge && balls_[ball].line.motion != Motion::resting)
        predict_edges(ball, best);
    go_on_searching(ball, best);
    balls_.plan(ball).set_coming(best);
}

// Searches that were left off: before anything that comes later, they begin again.
template <typename Real>
void EventEngine<Real>::go_on_searching(std::uint32_t ball, Event& best) const {
    if (search_.reached)
        consider(ball, {*search_.reached, Kind::crossing, 0, 0, look_again, 0}, best);
}

// On a torus a ball that meets nobody goes round and round: before its path leads too far from the
// frame for the images to be counted, it begins anew. When that is depends on the path alone, so
// that it does not show where the cells are, nor when somebody asked.
template <typename Real>
void EventEngine<Real>::predict_far_round(std::uint32_t ball, Event& best) const {
    constexpr double most_tori = 50.0;
    const EventLine<Real>& line = balls_[ball].line;
    if (line.motion != Motion::free && !is_on_cloth(line)) return;
    const EventPath<Real> path = balls_.path(ball);
    const Real far(most_tori * std::min(torus_.x, torus_.y));
    // Roughly first: nearly all do something else before.
    const auto sum_of_parts = [](const Vector<Real>& v) { return absolute(v.x) + absolute(v.y); };
    const Real since = best.time - path.time;
    const Real most = sum_of_parts(path.velocity) + sum_of_parts(path.acceleration) * since;
    if (most * since < far) return;
    // |velocity| s + |acceleration| s^2 / 2 = far, which no drag makes longer, by the root without
    // cancellation.
    const Real speed = length(path.velocity);
    const Real pull = length(path.acceleration);
    const Real root = speed + square_root(speed * speed + Real(2.0) * pull * far);
    if (!(root > Real{})) return;
    const Real time = path.time + Real(2.0) * far / root;
    consider(ball, {time < now_ ? now_ : time, Kind::crossing, 0, 0, begin_again, 0}, best);
}

template <typename Real>
void EventEngine<Real>::begin_in_frame(std::uint32_t ball) {
    const std::uint32_t quick = balls_[ball].line.quick;
    const BallState<Real> state = state_at(balls_.path(ball), field_, now_);
    const Vector<Real> roll = world_->model.cloth ? roll_at(ball, now_) : Vector<Real>{};
    start_path(ball, now_, state.position, state.velocity);
    balls_[ball].line.quick = quick;
    if (!world_->model.cloth) return;
    balls_.bend(ball).center = roll;
    begin_phase(ball);
}

template <typename Real>
void EventEngine<Real>::enter_next_cell(std::uint32_t ball, std::uint32_t direction) {
    if (direction == begin_again) {
        begin_in_frame(ball);
        predict(ball);
        return;
    }
    bool is_known = balls_.plan(ball).meeting().kind != Kind::unknown;
    if (direction < steps.size()) {
        const auto [columns, rows] = steps[direction];
        cells_.step(balls_, ball, columns, rows);
        if (is_known && world_->model.ball_ball) {
            Event meeting = balls_.plan(ball).meeting();
            cells_.for_each_new(balls_, ball, columns, rows,
                                [&](std::uint32_t other, int across, int along) {
                                    is_known = is_known && is_flying(other);
                                    if (is_known) meet_flying(ball, other, across, along, meeting);
                                });
            balls_.plan(ball).set_meeting(meeting);
        }
    }
    if (is_known)
        choose_next(ball);
    else
        predict(ball);
}

// One more neighbour of a ball that flies, which flies too.
template <typename Real>
void EventEngine<Real>::meet_flying(std::uint32_t ball, std::uint32_t other, int across, int along,
                                    Event& best) {
    if (!balls_meet(ball, other)) return;
    const EventBall<Real>& us = balls_[ball];
    const EventBall<Real>& them = balls_[other];
    const StraightPair<Real> pair(us.line, them.line, field_.gravity, torus_shift(across, along));
    const LineMeeting<Real> line(pair.offset, pair.velocity, us.radius + them.radius);
    if (line.is_one()) meet_at(ball, other, across, along, line, pair.begin, pair.offset, best);
}

// The two are going to meet: takes that for the event, if it comes before.
template <typename Real>
void EventEngine<Real>::meet_at(std::uint32_t ball, std::uint32_t other, int across, int along,
                                const LineMeeting<Real>& meeting, const Real& begin,
                                const Vector<Real>& offset, Event& best) {
    const EventBall<Real>& us = balls_[ball];
    const EventBall<Real>& them = balls_[other];
    const Real small = us.radius < them.radius ? us.radius : them.radius;
    // As seen from the one with the lower number, whoever asks: the same bits.
    auto time = meeting_time(meeting, balls_[std::min(ball, other)].line,
                             balls_[std::max(ball, other)].line, begin, offset, field_.gravity,
                             us.radius + them.radius, small, field_);
    if (!time) return;
    if (*time < now_) time = now_;
    consider(ball,
             {*time, Kind::ball_ball, static_cast<std::int8_t>(across),
              static_cast<std::int8_t>(along), other, them.version},
             best);
}

// The same as the next function for a straight line, which crosses only what lies ahead. Nobody can
// foretell which way that is, nor which of two borders comes first.
template <typename Real>
void EventEngine<Real>::predict_crossing_of_line(std::uint32_t ball, Event& best) const {
    const EventLine<Real>& path = balls_[ball].line;
    const EventPlace& own = balls_.plan(ball).place;
    const CellFrame& frame = cells_.frame();
    const Real zero{};
    const Real never(std::numeric_limits<double>::infinity());
    const auto crossing = [&](const Real& from, const Real& speed, int place, int count,
                              double origin, double width) {
        const int border = place + static_cast<int>(speed > zero);
        if (speed == zero || (!frame.wraps && (border <= 0 || border >= count))) return never;
        const Real time = path.time + (Real(origin + width * border) - from) / speed;
        return time < now_ ? now_ : time;
    };
    const Real x = crossing(path.position.x, path.velocity.x, own.column, frame.columns,
                            frame.origin.x, frame.cell.x);
    const Real y = crossing(path.position.y, path.velocity.y, own.row, frame.rows, frame.origin.y,
                            frame.cell.y);
    const bool is_y = y < x;
    Real time = x;
    assign_if(is_y, time, y);
    if (!(time < never)) return;
    const auto to_x = static_cast<std::uint32_t>(!(path.velocity.x > zero));
    const auto to_y = static_cast<std::uint32_t>(!(path.velocity.y > zero));
    consider(ball, {time, Kind::crossing, 0, 0, select(is_y, 2 + to_y, to_x), 0}, best);
}

// When the centre comes to a border of its cell. This is bookkeeping: it never changes a path.
template <typename Real>
void EventEngine<Real>::predict_crossing(std::uint32_t ball, Event& best) const {
    const EventPath<Real> path = balls_.path(ball);
    if (cells_.is_giant(balls_, ball) || path.motion == Motion::resting ||
        path.motion == Motion::still)
        return;
    const CellFrame& frame = cells_.frame();
    const BallState<Real> now = state_at(path, field_, now_);
    const bool is_simple = is_parabola(path, field_);
    const bool is_straight = is_simple && path.acceleration == Vector<Real>{};
    const Real last = path.motion == Motion::turning ? piece_end(path, field_) : best.time;
    for (std::uint32_t direction = 0; direction < steps.size(); ++direction) {
        const auto [columns, rows] = steps[direction];
        const int place =
            columns != 0 ? balls_.plan(ball).place.column : balls_.plan(ball).place.row;
        const int count = columns != 0 ? frame.columns : frame.rows;
        const int way = columns + rows;
        if (!frame.wraps && (way > 0 ? place >= count - 1 : place <= 0)) continue;
        const double origin = columns != 0 ? frame.origin.x : frame.origin.y;
        const double width = columns != 0 ? frame.cell.x : frame.cell.y;
        const Real border(origin + width * (way > 0 ? place + 1 : place));
        const Real sign(static_cast<double>(way));
        const auto along = [is_column = columns != 0](const Vector<Real>& v) {
            return is_column ? v.x : v.y;
        };
        // A straight line crosses only what lies ahead.
        if (is_straight && !(along(now.velocity) * sign > Real{})) continue;
        std::optional<Real> time;
        const ClosingTolerance<Real> exact{};
        if (is_simple) {
            const auto since = quadratic_closing<Real>(
                {(border - along(now.position)) * sign, -along(now.velocity) * sign,
                 -along(path.acceleration) * sign},
                exact);
            if (since) time = now_ + *since;
        } else {
            // Not exact: when it may have come a hair past the border, which is not too late, since
            // a cell is a little wider than it need be, and so is what is near it. So who has
            // crossed is past the border he would have to cross to come back, by all of that hair.
            const Real hair(std::min(1e-3 * width, 0.5 * (near_edges - 1.0) * cells_.largest()));
            const Real most = most_acceleration(path, field_, now_);
            const auto since = quadratic_closing<Real>(
                {(border - along(now.position)) * sign + hair, -along(now.velocity) * sign, -most},
                exact);
            if (since) {
                const Real crossing = now_ + *since;
                if (!(crossing < last)) continue;
                if ((border - along(state_at(path, field_, crossing).position)) * sign <= Real{})
                    time = crossing;
                else  // look again then
                    consider(ball, {crossing, Kind::crossing, 0, 0, look_again, 0}, best);
            }
        }
        if (time) consider(ball, {*time, Kind::crossing, 0, 0, direction, 0}, best);
    }
}

// The end of the side along which the ball slides, of a piece of its turn, of a phase on cloth.
template <typename Real>
void EventEngine<Real>::predict_own(std::uint32_t ball, Event& best) {
    const Motion motion = balls_[ball].line.motion;
    if (motion == Motion::free || motion == Motion::held) return;
    const EventPath<Real> path = balls_.path(ball);
    if (is_on_cloth(path)) {
        if (const auto time = end_of_phase(ball))
            consider(ball, {*time < now_ ? now_ : *time, Kind::own, 0, 0, 0, 0}, best);
        return;
    }
    if (path.motion == Motion::turning) {
        if (const auto time = end_of_turn(ball))
            consider(ball, {*time, Kind::own, 0, 0, 0, 0}, best);
        return;
    }
    if (path.motion == Motion::resting && path.support.by == PathSupport::By::nothing)
        consider(ball, {path.time + fall_time(ball) * Real(0.25), Kind::own, 0, 0, 0, 0}, best);
    if (world_->model.spin)
        if (auto time = end_of_slip(ball, best.time)) {
            if (*time < now_) time = now_;
            consider(ball, {*time, Kind::own, 0, 0, 0, 0}, best);
        }
    if (path.motion != Motion::sliding) return;
    const auto capsule = index_of(*world_, CapsuleId{path.support.number});
    const Edge<Real> edge(world_->capsules.shape[*capsule],
                          Vec2(torus_shift(path.support.across, path.support.along)));
    const Vector<Real> span = edge.end - edge.start;
    const Real whole = length(span);
    const Vector<Real> along = span / whole;
    const Real place = dot(along, path.position - edge.start);
    const Real rate = dot(along, path.velocity);
    const Real bend = dot(along, path.acceleration);
    const ClosingTolerance<Real> exact{};
    for (const bool to_end : {false, true}) {
        const Gap<Real> gap =
            to_end ? Gap<Real>{whole - place, -rate, -bend} : Gap<Real>{place, rate, bend};
        std::optional<Real> time;
        if (is_parabola(path, field_)) {
            const auto since = quadratic_closing<Real>(gap, exact);
            if (since) time = path.time + *since;
        } else {
            const Real horizon = best.time;
            const Real pull = most_acceleration(path, field_, path.time);
            time = first_closing<Real>(
                [&](const Real& when) -> Gap<Real> {
                    const BallState<Real> state = state_at(path, field_, when);
                    const Real there = dot(along, state.position - edge.start);
                    const Real speed = dot(along, state.velocity);
                    return to_end ? Gap<Real>{whole - there, -speed, Real{}}
                                  : Gap<Real>{there, speed, Real{}};
                },
                path.time, horizon, pull, {rounding_at(path.position, whole), Real{}}, search_);
        }
        if (time) consider(ball, {*time, Kind::own, 0, 0, 0, 0}, best);
    }
}

// A turn ends where its piece does, or before: where it turns back, where nothing presses it on any
// more, or where the side of an edge begins.
template <typename Real>
std::optional<Real> EventEngine<Real>::end_of_turn(std::uint32_t ball) const {
    const EventPath<Real> path = balls_.path(ball);
    Real last = piece_end(path, field_);
    const Turn<Real> first = turn_at(path, field_, path.time);
    const auto shorten = [&](auto&& value) {
        if (!(value(last) < Real{})) return;
        last = change_of_sign<Real>(value, path.time, last);
    };
    const Real zero{};
    if (!(first.speed == zero))
        shorten([&](const Real& time) {
            const Real speed = turn_at(path, field_, time).speed;
            return first.speed < zero ? -speed : speed;
        });
    shorten([&](const Real& time) { return turn_at(path, field_, time).press; });
    if (path.support.by != PathSupport::By::edge) return last;
    const bool is_left_turn = !(turn_at(path, field_, last).speed < zero);
    for_each_edge_near(ball, [&](std::uint32_t capsule, Vec2 shift, int, int) {
        const Edge<Real> edge(world_->capsules.shape[capsule], shift);
        if (edge.is_point() || !(edge.start == path.center || edge.end == path.center)) return;
        const Vector<Real> side = perpendicular(edge.end - edge.start);
        for (const Vector<Real>& normal : {side, -side}) {
            // Which way the side lies, as seen from the ball.
            const auto before = [&](const Vector<Real>& there) {
                return is_left_turn ? cross(there, normal) : cross(normal, there);
            };
            // A side that begins here is behind, or it would carry the ball now.
            const Real here = Real(2.0 * touching) * radius(ball) / first.radius;
            if (!(before(first.normal) > here) || !(dot(first.normal, normal) > zero)) continue;
            shorten([&](const Real& time) { return before(turn_at(path, field_, time).normal); });
        }
    });
    return last;
}

template <typename Real>
void EventEngine<Real>::predict_balls(std::uint32_t ball, Event& best) {
    for_each_ball_near(ball, [&](std::uint32_t other, int across, int along) {
        predict_pair(ball, other, across, along, best);
    });
}

template <typename Real>
void EventEngine<Real>::predict_pair(std::uint32_t ball, std::uint32_t other, int across, int along,
                                     Event& best) {
    if (world_->model.filtered && !balls_meet(ball, other)) return;
    const Motion motion = balls_[ball].line.motion;
    const bool may_stay =
        motion == Motion::held || motion == Motion::resting || motion == Motion::still;
    if (may_stay && balls_[other].line.motion == motion) return;
    const EventPath<Real> ours = balls_.path(ball);
    const EventPath<Real> theirs = balls_.path(other);
    const auto rests_on = [this](const EventPath<Real>& path, std::uint32_t support) {
        const auto id = number(world_->balls.id[support]);
        return (path.support.by == PathSupport::By::ball && path.support.number == id) ||
               (path.second_support.by == PathSupport::By::ball &&
                path.second_support.number == id);
    };
    if (ours.motion != Motion::free && rests_on(ours, other)) return;
    if (theirs.motion != Motion::free && rests_on(theirs, ball)) return;
    const Real our_radius = radius(ball);
    const Real their_radius = radius(other);
    // As seen from the one with the lower number, whoever asks: the same bits.
    const Real reach = our_radius + their_radius;
    const Real small = our_radius < their_radius ? our_radius : their_radius;
    auto time = ball < other ? ball_closing(ours, theirs, torus_shift(across, along), reach, small,
                                            field_, best.time, search_)
                             : ball_closing(theirs, ours, torus_shift(-across, -along), reach,
                                            small, field_, best.time, search_);
    if (!time) return;
    if (*time < now_) time = now_;
    consider(ball,
             {*time, Kind::ball_ball, static_cast<std::int8_t>(across),
              static_cast<std::int8_t>(along), other, balls_[other].version},
             best);
}

template <typename Real>
bool EventEngine<Real>::is_solid_for(std::uint32_t capsule, const Vector<Real>& position,
                                     Vec2 shift) const {
    if (!world_->model.one_way) return true;
    return is_on_solid_side(world_->capsules.shape[capsule], world_->capsules.side[capsule],
                            Vec2(position) - shift);
}

template <typename Real>
bool EventEngine<Real>::rests_on_edge(const EventPath<Real>& path, std::uint32_t capsule,
                                      int across, int along) const {
    const auto is = [&](const PathSupport& support) {
        return support.by == PathSupport::By::edge && support.across == across &&
               support.along == along && support.number == number(world_->capsules.id[capsule]);
    };
    return path.motion != Motion::free && (is(path.support) || is(path.second_support));
}

template <typename Real>
void EventEngine<Real>::predict_edges(std::uint32_t ball, Event& best) {
    const EventPath<Real> path = balls_.path(ball);
    for_each_edge_near(ball, [&](std::uint32_t capsule, Vec2 shift, int across, int along) {
        if (rests_on_edge(path, capsule, across, along)) return;
        const Edge<Real> edge(world_->capsules.shape[capsule], shift);
        auto time = edge_closing(path, edge, radius(ball), field_, best.time, search_);
        if (!time) return;
        if (*time < now_) time = now_;
        if (!is_solid_for(capsule, state_at(path, field_, *time).position, shift)) return;
        consider(ball,
                 {*time, Kind::ball_edge, static_cast<std::int8_t>(across),
                  static_cast<std::int8_t>(along), capsule, 0},
                 best);
    });
    for (std::uint32_t i = 0; i < hands_.size(); ++i) {
        if (!ball_meets(ball, hands_[i].capsule)) continue;
        const Real horizon = end_ < best.time ? end_ : best.time;
        const Real begin = path.time < now_ ? now_ : path.time;
        const auto time =
            hand_closing(path, hands_[i].edge, radius(ball), field_, begin, horizon, search_);
        if (!time) continue;
        if (!is_solid_for(hands_[i].capsule, state_at(path, field_, *time).position, {})) continue;
        consider(ball, {*time, Kind::hand, 0, 0, i, 0}, best);
    }
}

template class EventEngine<double>;
template class EventEngine<Wide>;

}  // namespace carom

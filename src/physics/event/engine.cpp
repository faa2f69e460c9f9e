#include "physics/event/engine.h"

#include <algorithm>

#include "physics/laws/free_motion.h"
#include "physics/world/same_bits.h"

namespace carom {
namespace {

// Between two questions whether a tick may go on.
constexpr std::uint64_t ask_every = 4096;
// Looks that take as long as an event, roughly.
constexpr std::uint64_t looks_of_event = 8;

template <typename Real>
Field<Real> field_of(const Model& model) {
    Field<Real> field;
    // Models with 0 and with -0 are equal.
    field.gravity = Vector<Real>(model.gravity.value_or(Vec2{}) + Vec2{});
    field.has_drag = model.drag.has_value();
    field.drag = Real(model.drag.value_or(0.0));
    if (model.lossy) field.pressing = length(field.gravity);
    return field;
}

}  // namespace

template <typename Real>
EventOutcome EventEngine<Real>::tick(World& world, std::vector<Contact>& contacts,
                                     std::vector<std::uint8_t>& touched,
                                     const std::function<bool()>& keep_going) {
    world_ = &world;
    events_ = more_rounds_ = 0;
    search_.looks = 0;
    keep_going_ = &keep_going;
    next_ask_ = ask_every;
    is_given_up_ = false;
    now_ = Real(world.time());
    end_ = Real(static_cast<double>(world.tick + 1) / world.rate);
    begin(world);
    left_.is_valid = false;
    if (is_given_up_) return EventOutcome::given_up;
    EventOutcome outcome = EventOutcome::done;
    while (const std::optional<std::uint32_t> first = first_ball()) {
        const std::uint32_t ball = *first;
        const Event event = balls_.plan(ball).coming();
        if (!(event.time <= end_)) break;
        ++events_;
        if (events_ > most_events) {
            outcome = EventOutcome::too_dense;
            break;
        }
        if (!may_go_on()) return EventOutcome::given_up;
        if (now_ < event.time) now_ = event.time;
        if (are_lines_) {
            happen_on_lines(ball, event, contacts, touched);
        } else if (event.kind == Kind::crossing) {
            enter_next_cell(ball, event.other);
            reorder(ball);
        } else if (event.kind == Kind::own) {
            end_own(ball);
            reorder(ball);
        } else if (event.kind == Kind::ball_ball &&
                   event.other_version != balls_[event.other].version) {
            predict(ball);
            reorder(ball);
        } else {
            impact(ball, event, contacts, touched);
        }
        if (hand_stopped_) {
            hand_stopped_ = false;
            predict_all();
            if (is_given_up_) return EventOutcome::given_up;
        }
    }
    if (outcome == EventOutcome::too_dense) {
        // Time stands still: where everything is now, it is at the end of the tick.
        for (std::uint32_t i = 0; i < balls_.size(); ++i) {
            const BallState<Real> state = state_at(balls_.path(i), field_, now_);
            const Vector<Real> roll = world.model.cloth ? roll_at(i, now_) : Vector<Real>{};
            EventPath<Real> path;
            path.time = end_;
            path.position = state.position;
            path.velocity = state.velocity;
            path.acceleration = field_.gravity;
            balls_.set_path(i, path);
            if (world.model.spin) let_spin(i, now_);
            if (!world.model.cloth) continue;
            spins_[i].time = end_;
            balls_.bend(i).center = roll;
            begin_phase(i);
        }
        is_begun_anew_ = true;
    }
    now_ = end_;
    write(world);
    if (outcome == EventOutcome::too_dense) left_.is_valid = false;
    return outcome;
}

// Asked now and then in a long tick. Once it may not, it is to be given up.
template <typename Real>
bool EventEngine<Real>::may_go_on() {
    const std::uint64_t done = events_ + more_rounds_ + search_.looks / looks_of_event;
    if (done < next_ask_) return !is_given_up_;
    next_ask_ = done + ask_every;
    if (*keep_going_ && !(*keep_going_)()) is_given_up_ = true;
    return !is_given_up_;
}

template <typename Real>
void EventEngine<Real>::predict_all() {
    for (std::uint32_t i = 0; i < balls_.size() && may_go_on(); ++i)
        predict(i);
    build_queue();
}

template <typename Real>
Vec2 EventEngine<Real>::shown_position(const EventPath<Real>& path, const Real& time) const {
    const Vec2 position(state_at(path, field_, time).position);
    return world_->model.wrap ? wrapped(position, *world_->model.wrap) : position;
}

template <typename Real>
void EventEngine<Real>::begin(World& world) {
    is_begun_anew_ = false;
    begun_.clear();
    crowded_.clear();
    edge_contacts_ = world.balls.edge_contacts;
    // What a ball will meet on a one-way edge depends on when that is asked: for a snapshot to go
    // on with the same bits, all ask when a tick begins.
    is_all_left_ = false;
    constexpr std::uint64_t look_at_frame_every = 64;
    if (!world.model.one_way && is_continued(world) &&
        (world.tick % look_at_frame_every != 0 || cells_.suits(world))) {
        const bool turns = world.model.spin.has_value();
        is_all_left_ = are_left(world);
        if (!turns && is_all_left_) return;
        std::size_t changed = 0;
        for (std::uint32_t i = 0; i < balls_.size(); ++i)
            changed += !is_position_left(i) || !is_velocity_left(i) || (turns && !is_turn_left(i));
        if (changed <= balls_.size() / 8 + 1) {
            if (changed > 0) take_what_changed(world);
            return;
        }
    }
    is_begun_anew_ = true;
    is_all_left_ = false;
    begin_anew(world);
}

// Some balls were moved or pushed from outside: they begin new paths.
template <typename Real>
void EventEngine<Real>::take_what_changed(const World& world) {
    std::vector<std::uint32_t>& changed = changed_;
    changed.clear();
    for (std::uint32_t i = 0; i < balls_.size(); ++i) {
        if (is_position_left(i) && is_velocity_left(i) && is_turn_left(i)) continue;
        changed.push_back(i);
        if (world.model.spin) spins_[i] = {now_, Real(world.balls.spin[i]), Real{}, false};
        // While it is where they lie on it.
        if (balls_[i].line.motion == Motion::resting) release_what_rests_on(i, changed);
        if (!is_position_left(i)) {
            cells_.leave(balls_, i);
            start_path(i, now_, Vector<Real>(world.balls.position[i]),
                       Vector<Real>(world.balls.velocity[i]));
            cells_.enter(balls_, i, Vec2(balls_[i].line.position));
        } else {
            start_path(i, now_, state_at(balls_.path(i), field_, now_).position,
                       Vector<Real>(world.balls.velocity[i]));
        }
        if (world.model.cloth) balls_.bend(i).center = Vector<Real>(world.balls.roll[i]);
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    // As in begin_anew, also for those that lay on others.
    for (const std::uint32_t i : changed)
        balls_[i].line.quick = 0;
    for (const std::uint32_t i : changed)
        settle(i);
    for (const std::uint32_t i : changed) {
        predict(i);
        reorder(i);
    }
}

template <typename Real>
void EventEngine<Real>::begin_anew(const World& world) {
    const std::size_t count = world.balls.size();
    field_ = field_of<Real>(world.model);
    torus_ = world.model.wrap ? size(*world.model.wrap) : Vec2{};

    // Paths that the world, or for other numbers this engine, remembers.
    EventBalls<Real> before;
    if constexpr (!std::is_same_v<Real, double>) before = balls_;
    balls_.resize(count, has_bends(world.model));
    for (std::size_t i = 0; i < count; ++i) {
        balls_.set_path(i, {});
        balls_.body(i) = EventBall<Real>::none;
        balls_.plan(i).set_coming({});
    }
    std::vector<std::uint8_t>& is_kept = is_kept_;
    std::vector<std::int64_t>& spin_from = spin_from_;
    is_kept.assign(count, 0);
    spin_from.assign(world.model.spin ? count : 0, -1);
    const bool same_field = world.paths_gravity == world.model.gravity.value_or(Vec2{}) &&
                            world.paths_drag == world.model.drag.value_or(0.0);
    if constexpr (std::is_same_v<Real, double>) {
        std::size_t at = 0;
        for (std::size_t i = 0; i < count && same_field; ++i) {
            while (at < world.paths.size() && world.paths[at].id < world.balls.id[i])
                ++at;
            if (at < world.paths.size() && world.paths[at].id == world.balls.id[i]) {
                const PathBend bend =
                    at < world.path_bends.size() ? world.path_bends[at] : PathBend{};
                balls_.set_path(i, path_from(world.paths[at], bend));
                is_kept[i] = (!world.model.spin || at < world.spin_paths.size()) &&
                             are_carriers_left(balls_.path(i), bend.carriers);
                if (world.model.spin && is_kept[i]) spin_from[i] = static_cast<std::int64_t>(at);
            }
        }
    } else if (left_.is_valid && left_.tick == world.tick && left_.model == world.model) {
        std::size_t at = 0;
        for (std::size_t i = 0; i < count; ++i) {
            while (at < left_.ids.size() && left_.ids[at] < world.balls.id[i])
                ++at;
            if (at < left_.ids.size() && left_.ids[at] == world.balls.id[i]) {
                balls_.set_path(i, before.path(at));
                is_kept[i] = are_carriers_left(balls_.path(i), left_.carriers[at]);
                if (world.model.spin) spin_from[i] = static_cast<std::int64_t>(at);
            }
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        balls_.plan(i).inverse_mass = Real(world.balls.inverse_mass[i]);
        balls_[i].radius = Real(world.balls.radius[i]);
    }
    take_hands(world);
    take_spins(world, spin_from);
    for (std::size_t i = 0; i < count; ++i)
        is_kept[i] = is_kept[i] && !(balls_.plan(i).inverse_mass == Real{}) &&
                     leads_through(balls_.path(i), i);
    if (world.paths_obstacles == 0 || world.paths_obstacles != sum_of_obstacles(world))
        for (std::uint32_t i = 0; i < count; ++i)
            is_kept[i] = is_kept[i] && !has_passed_an_edge(i);
    // What rests on something that is gone begins anew, and so on up the heap.
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < count; ++i) {
            if (!is_kept[i] || has_support(is_kept, i)) continue;
            is_kept[i] = 0;
            changed = true;
        }
    }
    cells_.reset(world, balls_);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (is_kept[i]) {
            // The path may be some tori away from where the ball is shown.
            if (world.model.wrap) {
                const Vec2 way =
                    Vec2(state_at(balls_.path(i), field_, now_).position) - world.balls.position[i];
                const auto tori = [](double x, double torus) {
                    return static_cast<int>(x / torus + (x < 0.0 ? -0.5 : 0.5));
                };
                cells_.shift(balls_, i, tori(way.x, torus_.x), tori(way.y, torus_.y));
            }
            continue;
        }
        const bool is_in_hand = balls_.plan(i).inverse_mass == Real{};
        Vector<Real> velocity(world.balls.velocity[i]);
        if (is_in_hand) velocity = balls_[i].line.velocity;
        if (world.model.spin) spins_[i] = {now_, Real(world.balls.spin[i]), Real{}, false};
        start_path(i, now_, Vector<Real>(world.balls.position[i]), velocity);
        if (world.model.cloth && !is_in_hand)
            balls_.bend(i).center = Vector<Real>(world.balls.roll[i]);
        if (is_in_hand) {
            hold(i);
        }
    }
    are_lines_ = are_lines();
    begun_.reserve(leaves_lines() ? 0 : count);
    if (world.model.ball_edge) edges_.update(world, cells_.frame(), near_edges * cells_.largest());
    for (std::uint32_t i = 0; i < count; ++i)
        if (!is_kept[i]) settle(i);
    predict_all();
}

template <typename Real>
void EventEngine<Real>::take_hands(const World& world) {
    const Real duration = end_ - now_;
    for (const HeldBall& held : world.held_balls) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        Vec2 way = held.target - world.balls.position[*index];
        if (world.model.wrap) way = nearest_image(way, torus_);
        balls_.plan(*index).inverse_mass = Real{};
        balls_[*index].line.velocity = Vector<Real>(way) / duration;
    }
    hands_.clear();
    for (const HeldCapsule& held : world.held_capsules) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        const Capsule& shape = world.capsules.shape[*index];
        Hand hand;
        hand.capsule = static_cast<std::uint32_t>(*index);
        hand.is_driven = held.is_driven;
        hand.edge.edge = Edge<Real>(shape, {});
        hand.edge.start_velocity = Vector<Real>(held.start_target - shape.start) / duration;
        hand.edge.end_velocity = Vector<Real>(held.end_target - shape.end) / duration;
        hand.edge.time = now_;
        hand.edge.stop = end_;
        hands_.push_back(hand);
    }
}

// From `time` on the ball flies. On a torus its path begins in the frame.
template <typename Real>
void EventEngine<Real>::start_path(std::uint32_t ball, const Real& time, Vector<Real> position,
                                   const Vector<Real>& velocity) {
    if (world_->model.wrap) {
        const Vec2 shown(position);
        const Vec2 inside = wrapped(shown, *world_->model.wrap);
        const auto tori = [](double way, double torus) {
            return static_cast<int>(way / torus + (way < 0.0 ? -0.5 : 0.5));
        };
        const int across = tori(inside.x - shown.x, torus_.x);
        const int along = tori(inside.y - shown.y, torus_.y);
        if (across != 0 || along != 0) {
            position += torus_shift(across, along);
            cells_.shift(balls_, ball, across, along);
            is_near_valid_ = false;
        }
    }
    if (world_->model.spin) let_spin(ball, time);
    EventLine<Real>& line = balls_[ball].line;
    line = {.across = line.across,
            .along = line.along,
            .time = time,
            .position = position,
            .velocity = velocity};
    if (balls_.may_bend()) balls_.bend(ball) = {.acceleration = field_.gravity};
    ++balls_[ball].version;
    note_begun(ball);
}

// A hand holds the ball: its path is straight.
template <typename Real>
void EventEngine<Real>::hold(std::uint32_t ball) {
    balls_[ball].line.motion = Motion::held;
    if (balls_.may_bend()) balls_.bend(ball).acceleration = {};
}

template class EventEngine<double>;
template class EventEngine<Wide>;

}  // namespace carom

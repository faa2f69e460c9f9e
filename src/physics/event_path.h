#pragma once

#include <cstdint>

#include "geometry/vector.h"
#include "physics/fetch.h"
#include "physics/large_pages.h"
#include "physics/world.h"

/// How a ball moves between two events of the solver `event`, exactly.
namespace carom {

/// A path, over any number type; World stores the double ones (BallPath says what each part means).
/// What is read of every neighbour comes last: see EventBall.
template <typename Real>
struct EventPath {
    Vector<Real> acceleration;
    Vector<Real> center;  ///< or the roll
    PathSupport support;
    PathSupport second_support;
    std::uint32_t quick = 0;
    Motion motion = Motion::free;
    std::int8_t across = 0;  ///< tori between where it is now and the frame: EventCells counts them
    std::int8_t along = 0;
    Real time{};
    Vector<Real> position;
    Vector<Real> velocity;
};

/// What happens to a ball next. In the order in which those of the same time come.
enum class EventKind : std::uint8_t { ball_ball, ball_edge, hand, own, crossing, none };
template <typename Real>
struct alignas(8) BallEvent {  // on every machine, for assign_if
    Real time{};
    EventKind kind = EventKind::none;
    std::int8_t across = 0;  ///< tori from the other's path to the image that is met
    std::int8_t along = 0;
    std::uint32_t other = 0;  ///< ball, capsule or direction
    std::uint32_t other_version = 0;
};

/// Where a ball is in EventCells.
struct EventPlace {
    /// Counted without bound, so that on a torus they say in which image the path is.
    int column = 0;
    int row = 0;
    std::uint32_t cell = 0;
    std::uint32_t before = 0;  ///< ball in the same cell
};

/// A ball as the solver `event` sees it. What is read of every neighbour is one line of the cache:
/// from the path's `quick` on.
template <typename Real>
struct alignas(64) EventBall {
    static constexpr std::uint32_t none = 0xffffffffu;

    Real inverse_mass{};            ///< 0: in a hand
    std::uint32_t body = none;      ///< in the impact that is being worked out
    bool is_giant = false;          ///< see EventCells
    bool is_meeting_known = false;  ///< see EventEngine::predict
    EventPath<Real> path;
    Real radius{};
    std::uint32_t next = none;  ///< ball in the same cell
    std::uint32_t version = 0;  ///< counts the paths
};
static_assert(sizeof(EventBall<double>) == 128);

/// What only the ball's own events need of it, in one line.
template <typename Real>
struct alignas(64) EventPlan {
    BallEvent<Real> coming;  ///< the first of those found
    /// Whom it meets first, wherever, where it flies among flying balls: see EventEngine::predict.
    BallEvent<Real> meeting;
    EventPlace place;
};
static_assert(sizeof(EventPlan<double>) == 64);

/// All of them.
template <typename Real>
class EventBalls {
  public:
    std::size_t size() const { return balls_.size(); }
    void resize(std::size_t count) {
        balls_.resize(count);
        plans_.resize(count);
    }
    EventBall<Real>& operator[](std::size_t ball) { return balls_[ball]; }
    const EventBall<Real>& operator[](std::size_t ball) const { return balls_[ball]; }
    EventPlan<Real>& plan(std::size_t ball) { return plans_[ball]; }
    const EventPlan<Real>& plan(std::size_t ball) const { return plans_[ball]; }
    const EventBall<Real>* data() const { return balls_.data(); }
    auto begin() { return balls_.begin(); }
    auto end() { return balls_.end(); }
    auto begin() const { return balls_.begin(); }
    auto end() const { return balls_.end(); }

    /// Into the cache: what is read of a neighbour; the ball; its plan too.
    void fetch_neighbour(std::size_t ball) const { fetch_early(&balls_[ball].path.quick); }
    void fetch_ball(std::size_t ball) const {
        fetch_early(&balls_[ball]);
        fetch_neighbour(ball);
    }
    void fetch(std::size_t ball) const {
        fetch_ball(ball);
        fetch_early(&plans_[ball]);
    }

  private:
    LargeVector<EventBall<Real>> balls_;
    LargeVector<EventPlan<Real>> plans_;
};

EventPath<double> path_from(const BallPath& stored);
BallPath stored_path(const World& world, BallId id, const EventPath<double>& path);
/// The same where `stored` is an earlier path of the ball, and it flew and flies: those differ in
/// nothing else.
inline void begin_stored(BallPath& stored, const EventPath<double>& path) {
    stored.quick = path.quick;
    stored.time = path.time;
    stored.position = Vec2(path.position);
    stored.velocity = Vec2(path.velocity);
}

/// What BallPath::carriers is for a ball that these carry: where they are and which way they push,
/// stirred; 0 where no edge is among them. An edge that is gone, or in a hand, is as one of another
/// shape.
std::uint32_t sum_of_carriers(const World& world, const PathSupport& support,
                              const PathSupport& second);

/// What the path adds to World::paths_sum: all of it, stirred.
std::uint64_t sum_of(const BallPath& path);

template <typename Real>
struct BallState {
    Vector<Real> position;
    Vector<Real> velocity;
};

/// What acts on every ball.
template <typename Real>
struct Field {
    Vector<Real> gravity;
    Real drag{};  ///< 1/s; 0: none
    bool has_drag = false;
    /// Gravity's length where impacts lose energy, so that balls come to be pressed together; or 0.
    Real pressing{};
};

/// Where the ball is at `time`, and how fast. Pre: time >= path.time, and for Motion::turning no
/// later than its piece lasts.
template <typename Real>
BallState<Real> state_at(const EventPath<Real>& path, const Field<Real>& field, const Real& time);

/// The place alone, of a path without drag that does not turn: three multiplications.
template <typename Real>
inline Vector<Real> parabola_at(const EventPath<Real>& path, const Real& time) {
    const Real since = time - path.time;
    return path.position + (path.velocity + path.acceleration * (Real(0.5) * since)) * since;
}

/// Whether the path is a parabola: no drag in force on it, and no turning.
template <typename Real>
inline bool is_parabola(const EventPath<Real>& path, const Field<Real>& field) {
    return path.motion != Motion::turning && (!field.has_drag || path.motion == Motion::held);
}

/// Whether the ball lies on cloth, in no hand.
template <typename Real>
inline bool is_on_cloth(const EventPath<Real>& path) {
    return path.motion >= Motion::slipping;
}

/// The largest acceleration, length/s^2, that the ball has from `time` on, for Motion::turning
/// while its piece lasts. It does not depend on how far anybody looks, so neither do the impacts
/// that are found with it.
template <typename Real>
Real most_acceleration(const EventPath<Real>& path, const Field<Real>& field, const Real& time);

/// A ball that slides round a round end, a peg or another ball without friction moves as a
/// pendulum. Its angle is a Taylor series in time; a piece of it lasts until the angle could have
/// changed by 0.05 rad, so the series is exact to rounding.
template <typename Real>
struct Turn {
    Real radius{};        ///< of the circle of the centre, length
    Vector<Real> normal;  ///< from the centre of the circle to the ball, unit
    Real speed{};         ///< along perpendicular(normal), length/s
    Real press{};         ///< acceleration with which it is pressed on, length/s^2; < 0: it leaves
};
template <typename Real>
Turn<Real> turn_at(const EventPath<Real>& path, const Field<Real>& field, const Real& time);

/// When the present piece ends: a function of the path alone.
template <typename Real>
Real piece_end(const EventPath<Real>& path, const Field<Real>& field);

}  // namespace carom

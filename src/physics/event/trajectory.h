#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "geometry/vector.h"
#include "physics/memory/large_pages.h"
#include "physics/memory/prefetch.h"
#include "physics/world/world.h"

/// How a ball moves between two events of the solver `event`, exactly.
namespace carom {

/// What there is to a path that is a straight line, over any number type; World stores the double
/// ones (BallPath says what each part means).
template <typename Real>
struct EventLine {
    std::uint32_t quick = 0;
    Motion motion = Motion::free;
    std::int8_t across = 0;  ///< tori between where it is now and the frame: EventCells counts them
    std::int8_t along = 0;
    Real time{};
    Vector<Real> position;
    Vector<Real> velocity;
};

/// EventLine::quick after another, as far as BallPath counts.
inline std::uint32_t one_more(std::uint32_t quick) {
    return std::min<std::uint32_t>(quick + 1, std::numeric_limits<std::uint16_t>::max());
}

/// What bends one (PathBend says what each part means).
template <typename Real>
struct EventBend {
    Vector<Real> acceleration;
    Vector<Real> center;  ///< or the roll
    PathSupport support;
    PathSupport second_support;

    friend bool operator==(const EventBend&, const EventBend&) = default;
};

/// A whole path.
template <typename Real>
struct EventPath : EventLine<Real>, EventBend<Real> {};

/// What happens to a ball next. In the order in which those of the same time come.
enum class EventKind : std::uint8_t {
    ball_ball,
    ball_edge,
    hand,
    own,
    crossing,
    none,
    unknown,  ///< of EventPlan::meeting alone
};
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
    std::uint32_t cell = 0;    ///< of a giant (EventCells): the highest number
    std::uint32_t before = 0;  ///< ball in the same cell
};

/// What the solver `event` reads of every neighbour, in one line of the cache.
template <typename Real>
struct alignas(64) EventBall {
    static constexpr std::uint32_t none = 0xffffffffu;

    EventLine<Real> line;  ///< of its path
    Real radius{};
    std::uint32_t next = none;  ///< ball in the same cell
    std::uint32_t version = 0;  ///< counts the paths
};
static_assert(sizeof(EventBall<double>) == 64);

/// What the ball's own events need of it besides, in one line.
template <typename Real>
class alignas(64) EventPlan {
  public:
    Real inverse_mass{};  ///< 0: in a hand
    EventPlace place;

    /// The first of its events that were found.
    BallEvent<Real> coming() const { return event(coming_time_, coming_); }
    void set_coming(const BallEvent<Real>& event) {
        coming_time_ = event.time;
        coming_ = What(event);
    }
    /// Whom it meets first, wherever, where it flies among flying balls: see EventEngine::predict.
    BallEvent<Real> meeting() const { return event(meeting_time_, meeting_); }
    void set_meeting(const BallEvent<Real>& event) {
        meeting_time_ = event.time;
        meeting_ = What(event);
    }

  private:
    // An event but for its time, without a gap.
    struct What {
        std::uint32_t other = 0;
        std::uint32_t other_version = 0;
        EventKind kind = EventKind::none;
        std::int8_t across = 0;
        std::int8_t along = 0;

        What() = default;
        explicit What(const BallEvent<Real>& event)
            : other(event.other),
              other_version(event.other_version),
              kind(event.kind),
              across(event.across),
              along(event.along) {}
    };
    static BallEvent<Real> event(const Real& time, const What& what) {
        return {time, what.kind, what.across, what.along, what.other, what.other_version};
    }

    Real coming_time_{};
    Real meeting_time_{};
    What coming_;
    What meeting_{BallEvent<Real>{.kind = EventKind::unknown}};
};
static_assert(sizeof(EventPlan<double>) == 64);

/// All of them.
template <typename Real>
class EventBalls {
  public:
    std::size_t size() const { return balls_.size(); }
    /// `bend`: whether their paths may, as has_bends says.
    void resize(std::size_t count, bool bend) {
        balls_.resize(count);
        bodies_.resize(count);
        plans_.resize(count);
        bends_.resize(bend ? count : 0);
    }
    EventBall<Real>& operator[](std::size_t ball) { return balls_[ball]; }
    const EventBall<Real>& operator[](std::size_t ball) const { return balls_[ball]; }
    EventPath<Real> path(std::size_t ball) const {
        return bends_.empty() ? EventPath<Real>{balls_[ball].line, {}}
                              : EventPath<Real>{balls_[ball].line, bends_[ball]};
    }
    /// Pre: it does not bend, unless paths may.
    void set_path(std::size_t ball, const EventPath<Real>& path) {
        balls_[ball].line = path;
        if (!bends_.empty()) bends_[ball] = path;
    }
    /// In the impact that is being worked out; or EventBall::none.
    std::uint32_t& body(std::size_t ball) { return bodies_[ball]; }
    bool may_bend() const { return !bends_.empty(); }
    /// Pre: paths may bend.
    EventBend<Real>& bend(std::size_t ball) { return bends_[ball]; }
    const EventBend<Real>& bend(std::size_t ball) const { return bends_[ball]; }
    EventPlan<Real>& plan(std::size_t ball) { return plans_[ball]; }
    const EventPlan<Real>& plan(std::size_t ball) const { return plans_[ball]; }
    const EventBall<Real>* data() const { return balls_.data(); }
    auto begin() { return balls_.begin(); }
    auto end() { return balls_.end(); }
    auto begin() const { return balls_.begin(); }
    auto end() const { return balls_.end(); }

    /// Into the cache: what is read of a neighbour; what a ball's own events need.
    void fetch_neighbour(std::size_t ball) const { fetch_early(&balls_[ball]); }
    void fetch(std::size_t ball) const {
        fetch_neighbour(ball);
        fetch_early(&plans_[ball]);
    }

  private:
    LargeVector<EventBall<Real>> balls_;
    LargeVector<EventPlan<Real>> plans_;
    std::vector<std::uint32_t> bodies_;
    LargeVector<EventBend<Real>> bends_;  ///< empty where paths do not bend
};

EventPath<double> path_from(const BallPath& stored, const PathBend& bend);
inline BallPath stored_line(BallId id, const EventLine<double>& line) {
    return {.id = id,
            .quick = static_cast<std::uint16_t>(line.quick),
            .motion = line.motion,
            .time = line.time,
            .position = Vec2(line.position),
            .velocity = Vec2(line.velocity)};
}
PathBend stored_bend(const World& world, const EventPath<double>& path);

/// What PathBend::carriers is for a ball that these carry: where they are and which way they push,
/// stirred; 0 where no edge is among them. An edge that is gone, or in a hand, is as one of another
/// shape.
std::uint32_t sum_of_carriers(const World& world, const PathSupport& support,
                              const PathSupport& second);

/// What World::paths_obstacles is: edges that no hand holds, how large the balls are, and who meets
/// whom, stirred; never 0.
std::uint64_t sum_of_obstacles(const World& world);

inline std::uint64_t stirred(std::uint64_t sum, std::uint64_t word) {
    return std::rotl(sum ^ word, 29) * 0x9fb21c651e98df25u;
}
inline std::uint64_t stirred(std::uint64_t sum, double value) {
    return stirred(sum, std::bit_cast<std::uint64_t>(value));
}
inline std::uint64_t stirred(std::uint64_t sum, Vec2 v) {
    return stirred(stirred(sum, v.x), v.y);
}
/// What the path adds to World::paths_sum: all of it, stirred; without what bends one that flies.
inline std::uint64_t sum_of(const BallPath& path) {
    // Two chains, since each step of one waits for the last.
    const auto motion = static_cast<std::uint64_t>(path.motion);
    const std::uint64_t first = stirred(number(path.id), motion | std::uint64_t{path.quick} << 8);
    const std::uint64_t second = stirred(1, path.time);
    return stirred(stirred(first, path.position), stirred(second, path.velocity));
}
std::uint64_t sum_of(const BallPath& path, const PathBend& bend);

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
inline bool is_on_cloth(const EventLine<Real>& path) {
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

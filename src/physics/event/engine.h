#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

#include "physics/broad_phase/capsule_cells.h"
#include "physics/event/cells.h"
#include "physics/event/queue.h"
#include "physics/event/toi_search.h"
#include "physics/event/trajectory.h"
#include "physics/laws/cloth.h"
#include "physics/laws/simultaneous_impact.h"
#include "physics/memory/large_pages.h"
#include "physics/world/contact.h"
#include "physics/world/same_bits.h"

namespace carom {

/// How a tick of the solver `event` ended.
enum class EventOutcome : std::uint8_t {
    done,
    given_up,   ///< asked to stop: the world is as it was before the tick
    too_dense,  ///< more than `EventEngine::most_events`: time stood still for the rest of the tick
};

/// The solver `event`: from one event to the next, on exact paths.
///
/// Every ball is on a path (EventPath) until an event changes it: an impact, the end of the edge
/// that it slides along, the end of a piece of its way round an end. Paths change at events only,
/// never at a tick or where a ball goes from cell to cell, so neither the rate nor the cells show
/// in the result beyond the rounding of what is read at the end of a tick. Each ball has one event
/// in the queue, the first of those found for it; one that another ball's change has made void is
/// found out when its turn comes, and predicted anew. Events are taken in the order (time, kind,
/// lower id, higher id).
///
/// Impacts at the same instant: reflection.h. Bodies touch, for that, within `touching` of the
/// smaller radius.
///
/// Rest: where gravity presses a ball on something, a rebound that would rise less than
/// `resting_rise` of its radius is none: the ball slides, turns or rests on what it touches from
/// then on. What it can rest on: edges, and balls that rest themselves. Two hold a ball if between
/// them they bear all of gravity, also where gravity presses it on one alone, along which it would
/// slide against the other: a slope and an upright wall, a slope and what hangs over it. A ball
/// that rests on balls does not press on them: heaps stand as they came to rest, and this solver
/// does not say how the weight of one is borne. A ball that bounces on balls that move loses no
/// more once it rises less than `lively_rise` of a radius, so their impacts stay finite in number
/// (after Luding and McNamara, How to handle the inelastic collapse of a dissipative hard-sphere
/// gas, Granular Matter 1, 1998). Heaps in which balls press on moving balls from all sides are too
/// dense for events: what has had more than `crowding` impacts in quick succession is in
/// World::heaped when the tick ends, and goes over to `contact` (handover.h). Until then, and with
/// other numbers than doubles, a ball that has had `most_tiring` of them, and is slow, lies still
/// where it is for a quarter of the time in which it would fall through its radius, and longer if
/// what it touches then carries it. That loses energy and momentum. So does one that is shut in, so
/// that its impacts at one instant come to no end and are stopped, after `most_quick` of them, also
/// where nothing else loses energy; what is stopped with one that lies so already is stopped by it.
/// Balls that are pressed together and overlap by more than half
/// of `lively_rise` are taken apart where nothing bars the way, by half a radius at most, which
/// lifts them by as much; where they are barred, they sink in further. Without gravity, two balls
/// that have met `most_quick` times in a row within `touching` of a radius pass their impulse
/// without restitution, for the same reason.
///
/// Friction, at an impact: once the impulses along the normals are known, each contact passes along
/// itself what stops its slip, but no more than its coefficient times its own impulse. Where bodies
/// have several such contacts all are found together, in rounds: in each, every contact looks at
/// the same velocities and takes its bodies to be as heavy as their share (a body's mass by its
/// number of contacts), so that no round makes energy and no order shows (Tonge, Benevolenski and
/// Voroshilov, Mass splitting for jitter-free parallel rigid body simulation, ACM Transactions on
/// Graphics 31, 2012); at most 64 rounds. What approaches then is reflected next.
///
/// Friction, on the side of an edge on which a ball lies: while it slips, the coefficient times the
/// weight on the side acts against the slip, so it slides with constant acceleration; the end of
/// the slip is an event, found in closed form. Then it rolls, with gravity along the side over (1 +
/// inertia), if friction suffices for that. Under drag, how much of it rolling needs is found anew
/// every 1/1024 of drag's time. A ball that lies on two, or that its spin presses against an edge,
/// lies there while friction at both brakes its spin. Round ends, pegs and balls that rest do not
/// rub what turns round them.
///
/// Cloth: a ball slips, rolls or lies still, each with a constant acceleration (cloth.h); the end
/// of such a phase is an event of its own, and an impact begins another. A ball that lies still has
/// no events: those that move look for it. Friction at an impact also acts on the roll, as in
/// cloth_contact.h, and each contact passes as much along both slips as its limit allows. Cloth
/// presses, too: a ball that turns towards what it touches would bounce there ever more softly. On
/// an edge, once a rebound would rise less than `resting_rise`, it is none, and the ball loses the
/// part of its roll that turns it into the edge. Of two balls, impacts that rise less than
/// `pushing_rise` lose no more, nor do those of a ball and a hand below `lively_rise`: so they push
/// one another in finitely many. Balls that overlap by more than twice `pushing_rise` are taken
/// apart where nothing bars the way.
///
/// What is in a hand moves in a straight line during a tick; the numeric bound that finds its
/// impacts is in event_closing.h. A hand that would squeeze a ball against something stops for the
/// tick.
template <typename Real>
class EventEngine {
  public:
    static constexpr std::uint64_t most_events = 100'000'000;
    static constexpr double touching = 1e-10;
    static constexpr std::uint32_t most_quick = 64;
    static constexpr std::uint32_t most_tiring = 256;
    /// A ball with more impacts in quick succession than this is in a heap: see handover.h.
    static constexpr std::uint32_t crowding = 64;
    static constexpr double quick_succession = 1.0 / 64.0;  ///< of the fall through a radius

    /// Moves everything by one tick and appends the exchanges to `contacts` (bodies by index).
    /// `touched`: see surroundings.h. `keep_going`, where there is one, is asked every few thousand
    /// events, and sooner where impacts take many rounds or searches many looks.
    EventOutcome tick(World& world, std::vector<Contact>& contacts,
                      std::vector<std::uint8_t>& touched, const std::function<bool()>& keep_going);

    const CellFrame& cells() const { return cells_.frame(); }
    /// Of the searches for impacts (geometry/closing.h) in the last tick.
    std::uint64_t looks() const { return search_.looks; }

  private:
    using Kind = EventKind;
    using Event = BallEvent<Real>;
    /// An edge is near a cell if it is no further from it than so many times the largest radius.
    static constexpr double near_edges = 1.01;
    /// A ball whose event comes soon, and what of it is known.
    struct Coming {
        std::uint32_t ball = 0;
        std::uint32_t partner = 0;  ///< whom it meets; or itself
        std::uint32_t cell = 0;     ///< around which it looks then
        std::uint32_t partner_cell = 0;
        std::uint32_t direction = EventCells<Real>::no_direction;  ///< into another cell
    };
    struct Hand {
        std::uint32_t capsule = 0;
        bool is_driven = false;  ///< by a coil: it throws
        MovingEdge<Real> edge;
    };
    struct Body {
        std::uint32_t ball = 0;
        Vector<Real> position;
        Real fastest{};  ///< its speed in the impact so far
        bool is_scanned = false;
        bool is_changed = false;
        bool is_moved = false;  ///< taken apart from another
        bool was_resting = false;
        std::uint32_t first_near = 0;  ///< in near_, as many as `near`, once it is scanned
        std::uint32_t near = 0;
    };
    /// Another ball in the cells around a body's, at the instant of the impact.
    struct Near {
        Vector<Real> offset;  ///< from its centre to the body's
        Real reach;           ///< sum of the radii
        std::uint32_t other = 0;
        std::int8_t across = 0;  ///< tori to the image that is near
        std::int8_t along = 0;
    };
    /// Whom a ball on a line meets first, wherever. Passed about by value, in registers: what has
    /// been written to memory in parts takes long to be read as a whole.
    struct FirstMet {
        Real time{std::numeric_limits<double>::infinity()};
        std::uint32_t other = EventBall<Real>::none;
        std::uint32_t version = 0;
    };
    /// The balls near one that flies, and whom of them it approaches so as to meet.
    struct Lines {
        static constexpr std::size_t most = 64;
        std::array<std::uint32_t, most> other;
        std::array<Vector<Real>, most> offset;  ///< as of Near, now
        std::array<LineMeeting<Real>, most> meeting;
        std::array<std::uint32_t, most> approached;  ///< indices of those
        std::size_t approached_count = 0;
    };
    struct Touch {
        ImpactContact<Real> contact;
        Kind kind = Kind::ball_ball;
        std::uint32_t other = 0;  ///< ball or capsule
        bool is_driven = false;   ///< the capsule, by a coil
        PathSupport support;      ///< what it would be
        Real gap{};
        Vector<Real> surface_velocity;  ///< of the capsule, where a hand moves it
    };
    /// How a ball turns: `spin` at `time`, rad/s counter-clockwise, changing at `rate` since.
    struct Spinning {
        Real time{};
        Real spin{};
        Real rate{};
        bool rolls = false;  ///< along a side, without slip
    };
    /// A contact that has passed an impulse, and what it passes along itself, mass * length/s.
    struct Rubbing {
        const Touch* touch = nullptr;
        Real most{};
        Real impulse{};
        Real change{};
        Real lift{};  ///< the same upwards, on cloth
        Real lift_change{};
    };
    struct Rub {
        Vector<Real> acceleration;
        Spinning turn;
    };
    struct Support {
        Vector<Real> normal;
        Vector<Real> center;  ///< of a round end
        bool is_side = false;
        bool carries = false;  ///< gravity presses the ball on it
        PathSupport by;
    };

    // event_engine.cpp: a tick, and what lasts from one to the next.
    bool may_go_on();
    void begin(World& world);
    void predict_all();
    void begin_anew(const World& world);
    void take_what_changed(const World& world);
    void take_hands(const World& world);
    Vec2 shown_position(const EventPath<Real>& path, const Real& time) const;
    void start_path(std::uint32_t ball, const Real& time, Vector<Real> position,
                    const Vector<Real>& velocity);
    void hold(std::uint32_t ball);

    // event_kept.cpp: which paths still hold when a tick begins anew.
    bool leads_through(const EventPath<Real>& path, std::size_t ball) const;
    bool are_carriers_left(const EventPath<Real>& path, std::uint32_t sum) const;
    bool has_support(const std::vector<std::uint8_t>& is_kept, std::size_t ball) const;
    bool has_passed_an_edge(std::uint32_t ball);

    // event_left.cpp: what a tick leaves in the world.
    bool is_continued(const World& world) const;
    bool are_left(const World& world) const;
    bool is_position_left(std::uint32_t ball) const;
    bool is_velocity_left(std::uint32_t ball) const;
    void write(World& world);
    /// Whether the world is left with every ball where its line says: see Left.
    bool leaves_lines() const { return are_lines_ && !world_->model.speed_limit; }
    bool is_summed() const { return balls_.size() >= too_many_to_cache; }
    /// The ball's path began now. Lines tell that themselves.
    void note_begun(std::uint32_t ball) {
        if (!is_begun_anew_ && !leaves_lines() && begun_.size() < balls_.size())
            begun_.push_back(ball);
    }
    void write_lines(World& world);
    /// Those on lines that began in this tick.
    void write_begun(World& world, std::span<const std::uint32_t> begun);
    void write_paths(World& world);
    void clear_paths(World& world);
    void store_paths(World& world);

    // event_predict.cpp: which event comes next.
    void predict(std::uint32_t ball);
    void predict_after(const Body& body);
    bool is_foreseen(std::uint32_t ball) const;
    void choose_next(std::uint32_t ball);
    void enter_next_cell(std::uint32_t ball, std::uint32_t direction);
    void predict_far_round(std::uint32_t ball, Event& best) const;
    void begin_in_frame(std::uint32_t ball);
    bool is_flying(std::uint32_t ball) const;
    void meet_flying(std::uint32_t ball, std::uint32_t other, int across, int along, Event& best);
    void meet_at(std::uint32_t ball, std::uint32_t other, int across, int along,
                 const LineMeeting<Real>& meeting, const Real& begin, const Vector<Real>& offset,
                 Event& best);
    void predict_crossing(std::uint32_t ball, Event& best) const;
    void predict_crossing_of_line(std::uint32_t ball, Event& best) const;
    void predict_own(std::uint32_t ball, Event& best);
    std::optional<Real> end_of_turn(std::uint32_t ball) const;
    void predict_balls(std::uint32_t ball, Event& best);
    void predict_pair(std::uint32_t ball, std::uint32_t other, int across, int along, Event& best);
    void predict_edges(std::uint32_t ball, Event& best);
    void go_on_searching(std::uint32_t ball, Event& best) const;
    double queue_time(std::uint32_t ball) const;
    void build_queue();
    /// Whose event comes first. Inlined, so that what it returns stays in registers.
    [[gnu::always_inline]] std::optional<std::uint32_t> first_ball() {
        if (balls_.size() >= many) look_ahead();
        return queue_.first([this](std::uint32_t a, std::uint32_t b) {
            return comes_first(a, balls_.plan(a).coming(), b, balls_.plan(b).coming());
        });
    }
    void reorder(std::uint32_t ball);
    bool comes_first(std::uint32_t ball_a, const Event& a, std::uint32_t ball_b,
                     const Event& b) const;
    /// Nobody can foretell which of two comes first.
    void consider(std::uint32_t ball, const Event& event, Event& best) const {
        const auto is_event = static_cast<int>(event.kind != Kind::none);
        const auto is_none = static_cast<int>(best.kind == Kind::none);
        int comes = is_event & (is_none | static_cast<int>(event.time < best.time));
        if (event.time == best.time) comes = comes_first(ball, event, ball, best);
        assign_if(comes != 0, best, event);
    }
    /// Every other ball that may be near, as visit(other, tori across, tori along).
    template <typename Visit>
    void for_each_ball_near(std::uint32_t ball, Visit&& visit) const;
    template <typename Visit>
    void for_each_edge_near(std::uint32_t ball, Visit&& visit) const {
        const EventLine<Real>& path = balls_[ball].line;
        for_each_edge_around(ball, {balls_.plan(ball).place.cell, path.across, path.along}, visit);
    }
    /// The same if it were somewhere else.
    template <typename Visit>
    void for_each_edge_around(std::uint32_t ball, EventSpot spot, Visit&& visit) const;
    bool is_solid_for(std::uint32_t capsule, const Vector<Real>& position, Vec2 shift) const;
    /// Whether that image of the edge carries what is on the path.
    bool rests_on_edge(const EventPath<Real>& path, std::uint32_t capsule, int across,
                       int along) const;

    // event_ahead.cpp: fetching from memory before it is needed.
    static constexpr std::size_t many = 4096;  ///< balls, from which on it is worth its cost
    void look_ahead();

    // event_touch.cpp: what touches what then.
    std::uint32_t body_of(std::uint32_t ball);
    void scan(std::uint32_t body);
    Real pressing_speed(const Touch& touch) const;
    bool may_touch(std::uint32_t body, const Near& near) const;
    void add_ball_touch(std::uint32_t body, std::uint32_t other, int across, int along,
                        bool is_certain);
    void add_edge_touch(std::uint32_t body, std::uint32_t capsule, int across, int along,
                        bool is_certain);
    void add_hand_touch(std::uint32_t body, const Hand& hand, bool is_certain);

    // event_impact.cpp: what happens then.
    void impact(std::uint32_t ball, const Event& event, std::vector<Contact>& contacts,
                std::vector<std::uint8_t>& touched);
    double restitution_of(const Touch& touch, bool is_alone);
    void pass_impulses(const std::vector<std::uint32_t>& which, bool is_alone,
                       std::vector<Contact>& contacts);
    void hold_the_tired();
    void note_speeds(bool is_shut_in);
    bool hold_back(std::uint32_t body);
    void stop_hands();
    void part_pressed();

    // event_lines.cpp: the same where all balls fly in straight lines.
    bool are_lines() const;
    void happen_on_lines(std::uint32_t ball, const Event& event, std::vector<Contact>& contacts,
                         std::vector<std::uint8_t>& touched);
    FirstMet first_met(std::uint32_t ball, std::uint32_t other, const LineMeeting<Real>& meeting,
                       const Real& begin, const Vector<Real>& offset, FirstMet best) const;
    FirstMet first_met(std::uint32_t ball, std::uint32_t other, FirstMet best) const;
    void predict_on_line(std::uint32_t ball);
    void enter_next_cell_on_line(std::uint32_t ball, std::uint32_t direction);
    void choose_next_on_line(std::uint32_t ball, FirstMet met);
    bool find_lines(std::uint32_t ball, std::uint32_t partner, const Vector<Real>& place,
                    const Vector<Real>& velocity, Lines& lines) const;
    void begin_line(std::uint32_t ball, const Vector<Real>& place, const Vector<Real>& velocity,
                    std::uint32_t quick);
    bool is_off_edges(std::uint32_t ball, const Vector<Real>& place) const;
    bool impact_of_two(std::uint32_t ball, const Event& event, std::vector<Contact>& contacts,
                       std::vector<std::uint8_t>& touched);

    // event_rest.cpp: what carries a ball.
    void settle(std::uint32_t ball);
    /// Valid until the next call.
    const std::vector<Support>& supports_of(std::uint32_t ball, bool also_moving);
    bool is_barred(const Support& support, const Support& other) const;
    bool leads_against(std::uint32_t ball, const Support& support, const Support& other) const;
    std::optional<std::pair<std::size_t, std::size_t>> bearing_two(
        const std::vector<Support>& supports) const;
    void rest(std::uint32_t ball, const Support& first, const Support* second);
    void lay_down(std::uint32_t ball, const PathSupport& support,
                  const PathSupport& second_support);
    void release_what_rests_on(std::uint32_t ball, std::vector<std::uint32_t>& released);
    void end_own(std::uint32_t ball);
    Real fall_time(std::uint32_t ball) const;
    std::uint32_t tiredness(std::uint32_t ball, const EventPath<Real>& before) const;
    void lie_down_if_tired(std::uint32_t ball, bool is_shut_in);
    void note_crowded(std::size_t body);
    void write_crowded(World& world);

    // event_friction.cpp: friction and spin. Pre, where nothing else is said: Model::spin.
    Real spin_at(std::uint32_t ball, const Real& time) const;
    void let_spin(std::uint32_t ball, const Real& time);
    Real friction_of(std::uint32_t ball, const PathSupport& support) const;
    void rub_contacts(const std::vector<std::uint32_t>& which, std::span<const Real> passed);
    void take_rubbing(const std::vector<std::uint32_t>& which, std::span<const Real> passed);
    Real slip_noise(std::uint32_t ball, const Vector<Real>& velocity) const;
    Rub rub_on_side(std::uint32_t ball, const Support& support, const Vector<Real>& velocity,
                    const Vector<Real>& pull) const;
    void brake_spin(std::uint32_t ball, const Real& friction);
    std::optional<Support> barrier_to(std::uint32_t ball, const Vector<Real>& velocity,
                                      const Vector<Real>& acceleration) const;
    bool is_braced(std::uint32_t ball, const Support& carrier, const Vector<Real>& velocity,
                   const Rub& rub, const Vector<Real>& acceleration);
    bool rolls_off(std::uint32_t ball, const Support& side, const Support& other) const;
    std::optional<Real> end_of_slip(std::uint32_t ball, const Real& horizon);
    Vector<Real> slip_direction(std::uint32_t ball) const;
    void end_spin(std::uint32_t ball);
    bool is_turn_left(std::uint32_t ball) const { return is_spin_left(ball) && is_roll_left(ball); }
    /// Nothing to do where balls do not turn.
    void take_spins(const World& world, const std::vector<std::int64_t>& known);
    bool are_spins_left(const World& world) const;
    /// Whether the ball turns as its path says. True where balls do not turn.
    bool is_spin_left(std::uint32_t ball) const;
    void write_spins(World& world);

    // event_cloth.cpp: balls on cloth. Pre, where nothing else is said: Model::cloth.
    Vector<Real> roll_at(std::uint32_t ball, const Real& time) const;
    /// From its velocity and roll at the beginning of its path.
    ClothPhase<Real> phase_of(const EventPath<Real>& path) const;
    void begin_phase(std::uint32_t ball);
    std::optional<Real> end_of_phase(std::uint32_t ball) const;
    void end_phase(std::uint32_t ball);
    void look_for_the_moving(std::uint32_t ball);
    double restitution_on_cloth(const Touch& touch, bool is_alone, double usual) const;
    void rub_contacts_on_cloth();
    bool is_path_on_cloth(const EventPath<Real>& path) const;
    /// Whether the ball rolls as its path says. True where there is no cloth.
    bool is_roll_left(std::uint32_t ball) const;
    void write_rolls(World& world) const;

    Vector<Real> position_of(std::uint32_t ball) const {
        const EventLine<Real>& line = balls_[ball].line;
        if (line.motion == Motion::free && !field_.has_drag) {
            const Real since = now_ - line.time;
            return line.position + (line.velocity + field_.gravity * (Real(0.5) * since)) * since;
        }
        const EventPath<Real> path = balls_.path(ball);
        return is_parabola(path, field_) ? parabola_at(path, now_)
                                         : state_at(path, field_, now_).position;
    }
    Real radius(std::uint32_t ball) const { return balls_[ball].radius; }
    Vector<Real> torus_shift(int across, int along) const {
        return {Real(torus_.x) * Real(double(across)), Real(torus_.y) * Real(double(along))};
    }
    bool balls_meet(std::uint32_t a, std::uint32_t b) const {
        return !world_->model.filtered ||
               kinds_meet(*world_, world_->balls.kind[a], world_->balls.kind[b]);
    }
    bool ball_meets(std::uint32_t ball, std::uint32_t capsule) const {
        return !world_->model.filtered || kind_meets_material(*world_, world_->balls.kind[ball],
                                                              world_->capsules.material[capsule]);
    }

    const World* world_ = nullptr;  ///< during a tick
    Field<Real> field_;
    Vec2 torus_;
    Real now_{};
    Real end_{};
    std::uint64_t events_ = 0;
    std::uint64_t more_rounds_ = 0;  ///< of impacts, in events that take as long, roughly
    ClosingSearch<Real> search_;     ///< its looks: in this tick
    const std::function<bool()>* keep_going_ = nullptr;  ///< during a tick
    std::uint64_t next_ask_ = 0;                         ///< once so much has been done
    bool is_given_up_ = false;

    EventBalls<Real> balls_;
    /// Whose paths began in this tick; as many as balls: all. Empty where it leaves lines.
    std::vector<std::uint32_t> begun_;
    std::vector<Spinning> spins_;  ///< empty unless Model::spin
    std::vector<std::uint32_t> edge_contacts_;
    std::vector<Hand> hands_;
    EventCells<Real> cells_;
    CapsuleCells edges_;
    EventQueue queue_;
    std::array<Coming, 8> coming_{};  ///< whom look_ahead has seen, in a ring
    std::uint32_t came_ = 0;
    bool are_lines_ = false;  ///< see event_lines.cpp
    bool hand_stopped_ = false;
    bool is_begun_anew_ = false;
    bool is_all_left_ = false;  ///< positions and velocities, bit by bit as the last tick left them

    std::vector<Body> bodies_;
    std::vector<ImpactBody<Real>> impact_bodies_;
    std::vector<Real> body_spins_;          ///< empty unless Model::spin
    std::vector<Vector<Real>> body_rolls_;  ///< empty unless Model::cloth
    std::vector<Touch> touches_;
    std::vector<std::uint32_t> approaching_;
    std::vector<ImpactContact<Real>> group_;
    std::vector<Real> approach_;
    /// What `reflect` works in.
    std::pmr::unsynchronized_pool_resource reflections_{{.largest_required_pool_block = 1 << 20}};
    std::pmr::vector<Real> passed_{&reflections_};
    std::vector<std::uint32_t> changed_;
    std::vector<std::uint32_t> crowded_;  ///< in this tick, and may not be any more
    std::vector<std::uint32_t> gone_;     ///< what others rested on
    std::vector<Support> supports_;
    std::vector<Support> points_;
    std::vector<Support> bars_;
    std::vector<Rubbing> rubbings_;
    std::vector<int> shares_;
    std::vector<std::uint8_t> is_kept_;
    std::vector<std::int64_t> spin_from_;
    std::vector<Near> near_;  ///< the first `near_count_` count
    std::size_t near_count_ = 0;
    std::array<Lines, 2> lines_;
    std::vector<std::uint32_t> which_near_;     ///< some of them, for a moment
    std::vector<std::array<int, 3>> touching_;  ///< ball, tori across and along
    bool is_near_valid_ = false;                ///< no path has been moved by a torus since

    /// The world as the last tick left it, to see whether the next one goes on from there.
    struct Left {
        bool is_valid = false;
        std::uint64_t tick = 0;
        double rate = 0.0;
        Model model;
        /// All balls flew in straight lines, and are where those say: there are no copies.
        bool on_lines = false;
        KeptIds<BallId> ids;
        SumOfBits position_sum;  ///< of those on lines, where they are many
        SumOfBits velocity_sum;
        /// Not so where they are on lines.
        std::vector<Vec2> positions;
        std::vector<Vec2> velocities;
        KeptBits<double> radii;
        KeptBits<double> inverse_masses;
        std::vector<std::uint8_t> meets;
        Capsules capsules;
        std::uint64_t paths_sum = 0;
        /// By ball, PathBend::carriers; empty with doubles, whose paths are in the world.
        std::vector<std::uint32_t> carriers;
        bool had_hands = false;
    };
    Left left_;
};

template <typename Real>
template <typename Visit>
void EventEngine<Real>::for_each_ball_near(std::uint32_t ball, Visit&& visit) const {
    if (!world_->model.ball_ball) return;
    const bool is_giant = cells_.is_giant(balls_, ball);
    if (!is_giant) cells_.for_each_near(balls_, ball, visit);
    if (cells_.giants().empty()) return;
    // Giants reach beyond cells: on a torus, the nearest image and those around it.
    const auto with_images = [&](std::uint32_t other) {
        if (other == ball) return;
        if (!world_->model.wrap) return visit(other, 0, 0);
        const Vec2 way(state_at(balls_.path(ball), field_, now_).position -
                       state_at(balls_.path(other), field_, now_).position);
        const int across = static_cast<int>(std::floor(way.x / torus_.x + 0.5));
        const int along = static_cast<int>(std::floor(way.y / torus_.y + 0.5));
        for (int i = across - 1; i <= across + 1; ++i)
            for (int j = along - 1; j <= along + 1; ++j)
                visit(other, i, j);
    };
    if (is_giant)
        for (std::uint32_t other = 0; other < balls_.size(); ++other)
            with_images(other);
    else
        for (const std::uint32_t giant : cells_.giants())
            with_images(giant);
}

template <typename Real>
template <typename Visit>
void EventEngine<Real>::for_each_edge_around(std::uint32_t ball, EventSpot spot,
                                             Visit&& visit) const {
    if (!world_->model.ball_edge) return;
    const auto at_image = [&](std::uint32_t capsule, int across, int along) {
        if (!ball_meets(ball, capsule)) return;
        visit(capsule, Vec2{torus_.x * across, torus_.y * along}, across, along);
    };
    if (!cells_.is_giant(balls_, ball)) {
        if (edges_.is_empty(spot.cell)) return;
        for (const CapsuleEntry entry : edges_.in_cell(spot.cell))
            at_image(entry.index, entry.across + spot.across, entry.along + spot.along);
        return;
    }
    int across = 0;
    int along = 0;
    if (world_->model.wrap) {
        const Vec2 way(state_at(balls_.path(ball), field_, now_).position -
                       Vector<Real>(world_->model.wrap->low));
        across = static_cast<int>(std::floor(way.x / torus_.x));
        along = static_cast<int>(std::floor(way.y / torus_.y));
    }
    const int reach = world_->model.wrap ? 1 : 0;
    for (std::uint32_t capsule = 0; capsule < world_->capsules.size(); ++capsule) {
        if (is_held(*world_, world_->capsules.id[capsule])) continue;
        for (int i = across - reach; i <= across + reach; ++i)
            for (int j = along - reach; j <= along + reach; ++j)
                at_image(capsule, i, j);
    }
}

}  // namespace carom

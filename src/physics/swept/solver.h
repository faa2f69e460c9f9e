#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "geometry/impact.h"
#include "physics/broad_phase/capsule_cells.h"
#include "physics/broad_phase/neighbour_list.h"
#include "physics/broad_phase/swept_cells.h"
#include "physics/ccd/impact_queue.h"
#include "physics/laws/cloth.h"
#include "physics/laws/free_motion.h"
#include "physics/memory/large_pages.h"
#include "physics/tick/cancellation.h"
#include "physics/tick/kinematic.h"
#include "physics/world/contact.h"
#include "physics/world/terms.h"

namespace carom {

/// The solver `swept`: in each substep balls go along straight paths. The first impact of all is
/// found and resolved, and the rest of the substep goes on. Nothing passes through anything,
/// however fast.
///
/// Path: the chord of the parabola from where a ball is to where free motion takes it by the end of
/// the substep. So free flight is exact, and an impact is early or late by at most g h^2 / 8 of
/// height. The velocity at an impact is that of the parabola where it has the height of the chord,
/// so an elastic bounce keeps the energy to rounding. On cloth the path is the chord of the exact
/// way through sliding, rolling and rest.
///
/// Order: impacts are resolved by (time, ball-ball before ball-edge, lower number, higher number),
/// so cells do not show. Several contacts at one instant are resolved one after another.
///
/// Resting contact: a ball comes to rest on what it touches when its flight after the bounce would
/// end in it before the substep does, or, where restitution is below 1, when it approaches slower
/// than `resting_approach` times the speed that gravity gives in a substep. A ball that rests on
/// something immovable feels only the gravity along it, and supports what comes to rest on it in
/// the same substep.
///
/// Freezing: a ball freezes for the rest of the substep after `most_resting_impacts` of these, or
/// `most_impacts` of any kind. That bounds the work and never adds energy: a frozen ball loses its
/// velocity, except in a scene that is all elastic flight (contact/swept_fallback.h), where it only
/// loses time. A kinematic edge stops at a frozen ball.
///
/// Friction: the impulse of an impact acts at once (laws/bounce.h). While a ball rests on an edge,
/// its weight acts as a constant acceleration for the rest of the substep: enough to stop the slip
/// by then, gravity along the edge included, but no more than the coefficient allows. So a rolling
/// ball accelerates by g sin / (1 + inertia), and the end of a slip is rounded to a substep. Where
/// two edges share the weight, it brakes the spin alone. A ball on cloth that is pressed
/// `most_resting_impacts` times in a substep rolls at once as it would after the slip.
///
/// Fails by nature: impacts under gravity are early or late (above); a bounce lower than g h^2 / 8
/// is lost; dense piles cost many impacts, and what would still slide in them may freeze.
class SweptSolver {
  public:
    static constexpr double resting_approach = 1.5;
    static constexpr int most_resting_impacts = 16;
    static constexpr int most_impacts = 4096;
    /// A ball that comes to rest separates at this share of its approach, so that rounding does not
    /// make it meet again.
    static constexpr double resting_restitution = 1e-6;
    /// An approach slower than this share of the speeds of two bodies that touch, and of what
    /// gravity gives, is rounding.
    static constexpr double noise = 1e-14;

    /// Moves everything by one tick, appends the exchanges to `contacts`, and sets `touched` for
    /// each ball that meets something. `patience` is asked between two impacts; once it is out, the
    /// world stays somewhere within the tick.
    void tick(World& world, int substeps, std::vector<Contact>& contacts,
              std::vector<std::uint8_t>& touched, Patience& patience);

    const CellFrame& cells() const { return neighbours_.grid().finest(); }

  private:
    /// A ball in the substep: at `position` at `time`, since then along the chord at `velocity`.
    /// It fills one line of the cache, since lines fetched are what a gas of many balls costs.
    struct alignas(64) Path {
        Vec2 position;
        Vec2 velocity;
        Vec2 start_velocity;  ///< of the parabola, at `time`; of a frozen ball, at the end
        double time = 0.0;
        std::uint32_t version : 29 = 0;     ///< counts its changes of path
        std::uint32_t is_frozen : 1 = 0;    ///< until the substep ends
        std::uint32_t is_grounded : 1 = 0;  ///< rests on something that does not give way
        std::uint32_t is_resting : 1 = 0;   ///< see resting_
        std::uint16_t impacts = 0;
        std::uint16_t resting_impacts = 0;
    };

    /// The resting contacts of a ball.
    struct RestingContacts {
        Vec2 gravity;  ///< what the supports leave of it, with friction
        Vec2 support;  ///< normals of the last two supports, 0 where there is none
        Vec2 other_support;
    };

    struct Event {
        double time = 0.0;
        ContactKind kind = ContactKind::ball_ball;
        std::uint32_t ball = 0;  ///< whose prediction this is
        std::uint32_t other = 0;
        std::uint32_t ball_version = 0;
        std::uint32_t other_version = 0;
        Vec2 normal;  ///< from other to ball

        auto tie_break() const {
            const bool on_ball = kind == ContactKind::ball_ball;
            return std::tuple(kind, on_ball ? std::min(ball, other) : ball,
                              on_ball ? std::max(ball, other) : other, ball);
        }
    };

    void move_along_paths(World& world, double start_time, std::vector<Contact>& contacts,
                          std::vector<std::uint8_t>& touched, Patience& patience);
    template <Terms terms>
    void substep(World& world, double start_time, std::vector<Contact>& contacts,
                 std::vector<std::uint8_t>& touched, Patience& patience);
    void begin_paths(World& world, double share_of_way);
    void finish_paths(World& world);
    void find_neighbours(const World& world);
    void enter_remaining(const World& world);
    template <Terms terms>
    void predict_all_at_start(const World& world);
    template <Terms terms>
    void predict(const World& world, std::uint32_t ball, double now, bool only_later);
    template <Terms terms>
    void predict_ball(const World& world, std::uint32_t ball, std::uint32_t other, double now,
                      std::optional<Event>& best) const;
    template <Terms terms>
    void predict_edge(const World& world, std::uint32_t ball, std::uint32_t capsule, Vec2 shift,
                      double now, std::optional<Event>& best) const;
    std::optional<Contact> collide_balls(World& world, const Event& event);
    std::optional<Contact> collide_edge(World& world, const Event& event);
    Vec2 gravity_on(std::uint32_t ball) const {
        return paths_[ball].is_resting ? resting_[ball].gravity : gravity_;
    }
    Vec2 velocity_at(const World& world, std::uint32_t ball, double now) const;
    Vec2 mean_velocity(const World& world, std::uint32_t ball, Vec2 velocity, Vec2 gravity,
                       double now) const;
    /// On cloth: displacement and state of the ball `duration` seconds after the time of its roll.
    ClothState<double> on_cloth(const World& world, std::uint32_t ball, Vec2 velocity,
                                double duration) const;
    void stop_sliding_if_pressed(World& world, std::uint32_t ball, Vec2& velocity);
    void redirect(const World& world, std::uint32_t ball, double now, Vec2 velocity);
    void end_rest(std::uint32_t ball, const World& world);
    void count_impact(std::uint32_t ball, Vec2 velocity, bool resting);
    void rest_on(std::uint32_t ball, Vec2 normal, const World& world);
    // Friction: friction.cpp. Pre, for all of them: Model::spin.
    void advance_spin(World& world, std::uint32_t ball, double now) const;
    void apply_ball_friction(World& world, const Event& event, Vec2& velocity_a, double inverse_a,
                             Vec2& velocity_b, double inverse_b, double impulse, bool resting);
    void apply_edge_friction(World& world, std::uint32_t ball, Vec2 normal, Vec2 surface,
                             double coefficient, double impulse, Vec2& velocity) const;
    /// Friction of the weight of a ball that has just come to rest on an edge.
    void apply_rest_friction(World& world, std::uint32_t ball, Vec2 surface, double coefficient,
                             double now, Vec2& velocity);
    Vec2 surface_velocity(const World& world, std::uint32_t capsule, Vec2 point, double now) const;
    Vec2 position_at(std::uint32_t ball, double now) const {
        const Path& path = paths_[ball];
        return path.position + path.velocity * (now - path.time);
    }
    Disc bounding_disc(const World& world, std::uint32_t ball, double now) const;
    Box bounding_box(const World& world, std::uint32_t ball, double now) const;
    Capsule shape_at(const World& world, std::uint32_t capsule, double now) const;
    const HeldEdge* kinematic_edge(std::uint32_t capsule) const {
        return find_edge(std::span<const HeldEdge>(kinematic_edges_), capsule);
    }
    bool is_void(const Event& event) const;
    bool is_held_ball(std::uint32_t ball) const { return inverse_mass_[ball] == 0.0; }
    void sort_initial_events();
    std::optional<Event> take_event(const World& world);
    void prefetch_next(const World& world) const;

    Flight flight_;
    double duration_ = 0.0;
    double rest_speed_ = 0.0;  ///< slower approaches do not bounce
    Vec2 torus_;
    Vec2 gravity_;
    LargeVector<Path> paths_;
    std::vector<RestingContacts> resting_;  // of the balls that rest on something
    std::vector<double> inverse_mass_;
    std::vector<double> spin_rate_;  ///< rad/s^2 since the path's time; empty unless Model::spin
    std::vector<HeldEdge> kinematic_edges_;
    bool slides_first_ = false;  ///< on cloth a ball stops sliding before it freezes
    bool edge_stopped_ = false;  ///< in the last collision: every prediction must be made again
    // Events that are known when the substep begins, in order, of which those before
    // `next_initial_` are done; and events that come up in it.
    std::vector<Event> initial_events_;
    std::size_t next_initial_ = 0;
    ImpactQueue<Event> queue_;
    std::vector<Event> unsorted_;
    std::vector<std::uint32_t> bin_start_;  ///< of bins of time, into initial_events_
    // Discs around the paths at the start of the substep (on a torus, of the image that lies in
    // it), and which of them are near one another.
    std::vector<Vec2> centers_;
    std::vector<double> reaches_;
    Neighbours neighbours_;
    SweptCells cells_;  ///< of balls that have changed their paths since, or of all
    std::size_t changed_paths_ = 0;
    bool are_all_in_cells_ = false;
    bool keeps_energy_ = false;  ///< a frozen ball keeps its velocity
    CapsuleCells edges_;         ///< in the same cells
};

}  // namespace carom

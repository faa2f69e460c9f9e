#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/impact.h"
#include "physics/broad_phase/capsule_cells.h"
#include "physics/broad_phase/neighbour_list.h"
#include "physics/broad_phase/swept_cells.h"
#include "physics/laws/cloth.h"
#include "physics/laws/free_motion.h"
#include "physics/memory/large_pages.h"
#include "physics/tick/cancellation.h"
#include "physics/world/contact.h"
#include "physics/world/terms.h"

namespace carom {

/// The solver `swept`: in each substep the balls go along straight paths; the first impact of all
/// is found, dealt with, and the rest of the time goes on. Nothing passes through anything, however
/// fast.
///
/// The straight path leads from where a ball is to where free motion would take it at the end of
/// the substep: the chord of its parabola. So free flight is exact, and an impact is early or late
/// by at most g h^2 / 8 of height. The velocity at the impact is that of the parabola where it has
/// the height of the chord, so an elastic bounce keeps the energy to rounding.
///
/// Impacts are taken in the order (time, ball-ball before ball-edge, lower number, higher number),
/// so the cells do not matter. Several contacts at the same instant are taken one after another in
/// that order.
///
/// Rest: a ball rests on what it touches when its flight after the bounce would end in it before
/// the substep does, or, where restitution is below 1, when it comes slower than `resting_approach`
/// times the speed that gravity gives in a substep. What lies on something that cannot give way is
/// carried, and feels only the gravity along it; a carried ball carries, within the substep, what
/// comes to rest on it. A ball that has had `most_resting_impacts` of these in a substep, or
/// `most_impacts` of any kind, lies still until the substep ends; nothing moves it until then. That
/// loses energy and momentum, never gains any, and bounds the work. In a scene that is all elastic
/// flight (contact_flights.h) it goes on after the substep as fast as it was: it loses time and
/// momentum, and no energy.
///
/// Friction: the impulse of an impact rubs at once (bounce.h). On an edge on which a ball rests,
/// the weight rubs as a constant acceleration for what is left of the substep: as much of it as
/// stops the slip by then, gravity along the edge included, but no more than the coefficient
/// allows; so a rolling ball accelerates by g sin / (1 + inertia), and when a slip ends is rounded
/// to a substep. Where two edges bear all of the weight, it brakes the spin alone. The weight on a
/// ball rubs at once. A ball that lies still does not turn.
///
/// On cloth the path is the chord of the exact way through sliding, rolling and rest. What pushes
/// on others so that it meets them `most_resting_impacts` times in a substep stops sliding: it
/// rolls at once as it would once the cloth has stopped the slip.
///
/// A hand pushes: see bounce_off. Where a ball that lies still is in its way, the hand stops for
/// the substep.
///
/// Fails by nature: impacts under gravity are early or late (above); a bounce that would be lower
/// than g h^2 / 8 is lost; dense heaps cost many impacts, and what would still slide in them may
/// lie still.
class SweptSolver {
  public:
    static constexpr double resting_approach = 1.5;
    static constexpr int most_resting_impacts = 16;
    static constexpr int most_impacts = 4096;
    /// What comes to rest parts at this share of its approach, so that rounding does not make it
    /// meet again.
    static constexpr double resting_restitution = 1e-6;
    /// An approach slower than this share of the speeds of two bodies that touch, and of what
    /// gravity gives, is rounding.
    static constexpr double noise = 1e-14;

    /// Moves everything by one tick and appends the exchanges to `contacts`. `touched`: see
    /// surroundings.h. Where `patience` ends, which is asked between two impacts, the world stays
    /// somewhere within the tick.
    void tick(World& world, int substeps, std::vector<Contact>& contacts,
              std::vector<std::uint8_t>& touched, Patience& patience);

    const CellFrame& cells() const { return neighbours_.grid().finest(); }

  private:
    /// A ball in the substep: at `position` at `time`, since then along the chord at `velocity`.
    /// One line of the cache: that is what a gas of many balls costs.
    struct alignas(64) Path {
        Vec2 position;
        Vec2 velocity;
        Vec2 start_velocity;  ///< of the parabola, at `time`; of what lies still, at the end
        double time = 0.0;
        std::uint32_t version : 29 = 0;  ///< counts its changes of path
        std::uint32_t still : 1 = 0;     ///< lies still until the substep ends
        std::uint32_t carried : 1 = 0;   ///< rests on something that does not give way
        std::uint32_t is_borne : 1 = 0;  ///< something bears it: see bearings_
        std::uint16_t impacts = 0;
        std::uint16_t resting_impacts = 0;
    };

    /// What bears a ball.
    struct Bearing {
        Vec2 gravity;  ///< what of it the supports leave
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
    };

    struct Hand {
        std::uint32_t index = 0;
        Vec2 start_velocity;
        Vec2 end_velocity;
        bool is_driven = false;     ///< by a coil: it throws
        double stopped_at = -1.0;   ///< s in the substep; negative: moves
        std::uint32_t version = 0;  ///< 1 once it has stopped
    };

    void move_along_paths(World& world, double start_time, std::vector<Contact>& contacts,
                          std::vector<std::uint8_t>& touched, Patience& patience);
    template <Terms terms>
    void substep(World& world, double start_time, std::vector<Contact>& contacts,
                 std::vector<std::uint8_t>& touched, Patience& patience);
    void begin_paths(World& world, double share_of_way);
    void finish_paths(World& world);
    void look_around_paths(const World& world);
    void enter_the_rest(const World& world);
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
        return paths_[ball].is_borne ? bearings_[ball].gravity : gravity_;
    }
    Vec2 velocity_at(const World& world, std::uint32_t ball, double now) const;
    Vec2 chord(const World& world, std::uint32_t ball, Vec2 velocity, Vec2 gravity,
               double now) const;
    /// On cloth, in swept_friction.cpp: how far the ball goes in `duration` from the time of its
    /// roll on, and how it moves then.
    ClothState<double> on_cloth(const World& world, std::uint32_t ball, Vec2 velocity,
                                double duration) const;
    void stop_sliding_if_pressed(World& world, std::uint32_t ball, Vec2& velocity);
    void take_path(const World& world, std::uint32_t ball, double now, Vec2 velocity);
    void let_go(std::uint32_t ball, const World& world);
    void count_impact(std::uint32_t ball, Vec2 velocity, bool resting);
    void rest_on(std::uint32_t ball, Vec2 normal, const World& world);
    /// Friction, in swept_friction.cpp. Pre, for all of them: Model::spin.
    void advance_spin(World& world, std::uint32_t ball, double now) const;
    void rub_balls(World& world, const Event& event, Vec2& velocity_a, double inverse_a,
                   Vec2& velocity_b, double inverse_b, double impulse, bool resting);
    void rub_edge(World& world, std::uint32_t ball, Vec2 normal, Vec2 surface, double coefficient,
                  double impulse, Vec2& velocity) const;
    /// Of the weight of a ball that has just come to rest on an edge, which bears it.
    void hold_back(World& world, std::uint32_t ball, Vec2 surface, double coefficient, double now,
                   Vec2& velocity);
    Vec2 surface_velocity(const World& world, std::uint32_t capsule, Vec2 point, double now) const;
    Vec2 position_at(std::uint32_t ball, double now) const {
        const Path& path = paths_[ball];
        return path.position + path.velocity * (now - path.time);
    }
    Disc around_path(const World& world, std::uint32_t ball, double now) const;
    Box box_of_path(const World& world, std::uint32_t ball, double now) const;
    Capsule shape_at(const World& world, std::uint32_t capsule, double now) const;
    const Hand* hand_of(std::uint32_t capsule) const;
    bool is_void(const Event& event) const;
    bool is_held_ball(std::uint32_t ball) const { return inverse_mass_[ball] == 0.0; }
    static bool is_earlier(const Event& a, const Event& b);
    void push(const Event& event);
    void sort_first_events();
    std::optional<Event> take_event(const World& world);
    void look_ahead(const World& world) const;

    Flight flight_;
    double duration_ = 0.0;
    double resting_speed_ = 0.0;  ///< slower approaches do not bounce
    Vec2 torus_;
    Vec2 gravity_;
    LargeVector<Path> paths_;
    std::vector<Bearing> bearings_;  // of the balls that are borne
    std::vector<double> inverse_mass_;
    std::vector<double> spin_rate_;  ///< rad/s^2 since the path's time; empty unless Model::spin
    std::vector<Hand> hands_;
    bool slides_first_ = false;  ///< on cloth a ball stops sliding before it lies still
    bool hand_stopped_ = false;  ///< in the last collision: every prediction must be made again
    // Events that are known when the substep begins, in their order, of which those before
    // `next_first_` are done; and those that come up in it.
    std::vector<Event> first_events_;
    std::size_t next_first_ = 0;
    std::vector<Event> queue_;
    std::vector<Event> unsorted_;
    std::vector<std::uint32_t> slice_start_;  ///< of slices of time, into first_events_
    // Who is near whom at the start of the substep: as discs around the paths (on a torus, of the
    // image that lies in it).
    std::vector<Vec2> centers_;
    std::vector<double> reaches_;
    Neighbours neighbours_;
    SweptCells cells_;  ///< of the balls that have changed their paths since, or of all
    std::size_t changed_paths_ = 0;
    bool are_all_in_cells_ = false;
    bool keeps_energy_ = false;  ///< what lies still goes on as fast after the substep
    CapsuleCells edges_;         ///< in the same cells
};

}  // namespace carom

#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/impact.h"
#include "physics/broad_phase/fat_pairs.h"
#include "physics/contact/bodies.h"
#include "physics/contact/environment.h"
#include "physics/laws/free_motion.h"
#include "physics/world/contact.h"
#include "physics/world/terms.h"

namespace carom {

/// The solver `contact`: for heaps, bins, resting contact and thousands of balls that touch.
///
/// A tick is cut into substeps. In each, what touches without bouncing is a *pressed* pair: an
/// impulse keeps its bodies from going into one another, like a stiff spring with strong damping
/// (soft constraints). What bounces is a *flying* pair: its impact is found in time, along the
/// paths that the balls are on, and dealt with then and there, as in `swept`. A substep is
///   1. sort the pairs into pressed, flying and idle ones;
///   2. gravity and drag; then the impulses of the last substep again, to start from, without what
///      throws;
///   3. one round over the pressed pairs, from the bottom up;
///   4. all balls go along their paths; impacts in the order of time;
///   5. one round over the pressed pairs from the top down, that takes back the speed with which
///      overlaps were pushed apart, and a little more (`overshoot`).
/// What bears a ball that is at least four times as heavy is solved in four rounds (`uneven`).
/// The impulses at the end of a tick belong to the world (World::pressed).
///
/// A pair is pressed when it approaches slower than `resting_approach` times the speed that gravity
/// gives in a substep, or its restitution is 0, or a hand pushes the ball faster than it would
/// bounce; and only while it moves less than a quarter of a radius a substep. What overlaps stays
/// pressed where it is pressed already, or would not bounce at once: else a ball that gravity lets
/// fall anew in every substep would sink in, and high heaps would boil. So a ball in flight
/// is on its exact path, an elastic bounce keeps the energy to rounding, and a bounce that would
/// rise no higher than about g h^2 for a substep of h seconds is lost.
///
/// A ball on which three pairs or more press (`bedded`) has no room to bounce in: two such balls,
/// or one and an edge, meet as if their restitution were 0, except where nothing would be lost or
/// the edge kicks. Impacts within a lively heap would follow one another without end, and boil it;
/// what falls on the heap still bounces off it.
///
/// No ball passes through anything: however hard they are pressed, two bodies that have come half
/// a radius into one another stop there (`core`). A hand goes no further into a ball than a tenth
/// of its radius, and what it jams has no more speed than it goes. A ball with `most_impacts`
/// impacts in a substep, or with a speed that would take it out of the region in which it was
/// compared with others, stands for the rest of the substep: it keeps its velocity and loses time.
/// So does what runs into it and is no faster.
///
/// Where nothing in a scene can press, all is flight, and `swept` goes in its place
/// (contact_flights.h).
///
/// What stopped an impact is no load: what it would throw up in the next substep is taken back
/// before anything moves, and again at the end of a substep (`most_throw`, contact_throws.cpp).
///
/// Fails by nature: pressed bodies overlap slightly, the more the heavier what lies on them; a pile
/// of bounces goes pair by pair. A tower in which each ball is ten times as heavy as the one below
/// goes in as deep as the cores; of 40 heaps with friction whose masses are up to 1e8 apart one
/// gained a twentieth of its energy for a time; of 1050 columns of lively balls that something a
/// hundred times as heavy or more fell on six gained up to 2.8 times what the fall had. What lands
/// a hundred times as heavy, or goes in as deep as the cores, may rise again by a few hundredths of
/// its fall, without restitution. What slips out between hands that are far behind where they are
/// wanted may go as fast as they would to be there at the end of the tick.
///
/// There is no sleep: in a heap at rest the last bits of the speeds go on changing, so who slept
/// would wake with others than a run without sleep. But the pairs of balls that stay about where
/// they are last for many ticks, by the homes in the world (World::homes): a solver that has not
/// got these pairs finds them anew from there, the same in the same order.
///
/// Source: soft constraints, substeps and relaxing are those of Box2D 3 (Catto, Solver2D, 2024);
/// sequential impulses and warm starting: Catto, Iterative Dynamics with Temporal Coherence (2005);
/// over-relaxation of impulses that can only push: Cryer, SIAM J. Control 9 (1971) 385; taking back
/// from the top down, as if what lies below were held: the shock propagation of Guendelman, Bridson
/// and Fedkiw, Nonconvex Rigid Bodies with Stacking (2003).
class ContactSolver {
  public:
    static constexpr double resting_approach = 1.5;
    static constexpr int most_impacts = 64;
    static constexpr int most_pushes = 8;
    static constexpr int most_holds = 8;
    /// Pressed pairs are springs of this many cycles a substep, damped by `damping` times what
    /// keeps them from ringing. More: less overlap, until heaps tremble: one of 2,000 without
    /// friction comes to rest at 0.22 (speeds of 1e-12), and at 0.25 never (0.01).
    static constexpr double stiffness = 0.22;
    static constexpr double damping = 10.0;
    /// They push harder than springs do as they are pressed together: an overlap of x is parted at
    /// the speed of one of x (1 + hardening x / radius) in a spring, by the smaller radius. So
    /// where much weight comes together balls go in by less, and elsewhere heaps do not tremble.
    static constexpr double hardening = 5.0;
    /// And no more than half as hard again, or heaps would throw up what lands hard on them.
    static constexpr double most_hardening = 0.5;
    /// Step 5 takes back so much more of a speed, up to this share of the resting speed, where the
    /// pair pressed in the last substep (successive over-relaxation): what a pair takes back, its
    /// neighbours partly give again. With 0 a high heap goes up and down as a whole for a minute;
    /// from 1 on rounds would gain energy. What has just landed is left out, or it would bounce.
    static constexpr double overshoot = 0.6;
    /// A ball that presses on one so many times lighter is a load: all below it that presses is
    /// solved in this many rounds. With one, 400 on balls of mass 1 rock for ever; with two they
    /// come to rest after a minute, with four after some seconds.
    static constexpr double uneven = 4.0;
    static constexpr int loaded_rounds = 4;
    /// An impulse that lets the upper of two bodies go up from the lower one at so many resting
    /// speeds has stopped an impact, and is no load to start from in the next substep: it is taken
    /// back as far as it does. With less, heaps that fall together overlap more.
    static constexpr double most_throw = 4.0;
    /// Pairs that press on a ball in a bed of others.
    static constexpr int bedded = 3;
    /// Approaches slower than this share of the speeds are rounding.
    static constexpr double noise = 1e-14;

    /// Moves everything by one tick and appends the exchanges to `contacts`: impacts, and each
    /// pressed pair once, when it begins to press. `touched`: see surroundings.h.
    void tick(World& world, int substeps, std::vector<Contact>& contacts,
              std::vector<std::uint8_t>& touched);

    const CellFrame& cells() const { return near_.frame(); }

  private:
    using Mover = ContactMover;
    using State = ContactState;
    using Pair = ContactPair;
    using Press = ContactPress;
    using Softness = ContactSoftness;
    using Throw = ContactThrow;
    using Path = ContactPath;
    using Event = ContactEvent;
    using Hand = ContactHand;

    static constexpr std::uint32_t none = 0xffffffffu;

    // Between the world and the bodies.
    void begin(World& world);
    void load(const World& world);
    bool take_up(const World& world);
    void load_bodies(const World& world);
    void load_hands(const World& world);
    void load_pairs(const World& world);
    Pair pair_of(const World& world, const NearPair& near) const;
    void add_pairs_of_hand(const World& world, const Hand& hand);
    void first_impulses(const World& world);
    const PressedPair* last_impulse(const World& world, const Pair& pair) const;
    void order_pairs();
    void store(World& world, std::vector<std::uint8_t>& touched);
    void store_impulses(World& world, std::vector<std::uint8_t>& touched);

    // Homes: for how long the pairs are all that could meet.
    bool has_homes(const World& world) const;
    void find_homes(World& world) const;
    static bool is_order_free(const World& world);
    bool is_at_home() const;
    bool stays_home(Vec2 away, Vec2 velocity, double margin) const;

    // The substep.
    void substep(World& world, double share_of_way, std::vector<Contact>& contacts);
    Softness softness_of(const World& world) const;
    void kick(const World& world);
    void find_ways();
    void go(const World& world);

    // Pressed pairs.
    void prepare(const World& world, Terms terms);
    template <Terms terms>
    void sort_pairs(const World& world);
    template <Terms terms>
    void measure(const World& world, Pair& pair);
    template <Terms terms>
    State state_of(const World& world, const Pair& pair) const;
    bool is_pushed(const World& world, const Pair& pair, double approach) const;
    void count_presses();
    bool is_bedded(const Pair& pair) const;
    template <bool spin>
    void begin_presses();
    template <bool spin>
    void start_with(const Press& press);
    bool share_body(const Press& one, const Press& other) const;
    void end_presses();
    template <bool spin>
    void exchange(Press& press, double impulse);
    template <bool spin>
    void press(Press& press);
    template <bool spin>
    void relax(Press& press);
    template <bool spin>
    void press_all(bool downwards);
    template <bool spin>
    void relax_all();
    double apart(const Press& press) const;
    bool is_about_to_bounce(const Press& press) const;
    void press(bool spin, bool downwards);
    void press_with_loads(bool spin);
    void relax_with_loads(bool spin);
    bool is_uneven(const Pair& pair) const;
    void find_loaded();
    bool has_throws() const;
    Throw throw_of(const Press& press, Vec2 up) const;
    std::optional<double> without_throw(const Press& press, Vec2 up) const;
    template <bool spin>
    void take_back_throws();
    void note_new_contacts(std::vector<Contact>& contacts);

    // Impacts within a substep: which come next.
    void find_hits();
    void look_ahead(std::size_t hit) const;
    void run_impacts(World& world, std::vector<Contact>& contacts);
    void predict(const World& world, std::uint32_t body, double now);
    std::optional<double> meeting(const World& world, const Pair& pair, double now) const;
    Capsule edge_at(const World& world, const Pair& pair, double now) const;
    double core(const Pair& pair) const;
    bool is_void(const Event& event) const;
    void push(const Event& event);
    static bool is_earlier(const Event& a, const Event& b);

    // And what they do.
    void collide(World& world, const Event& event, std::vector<Contact>& contacts);
    std::optional<Contact> collide_balls(World& world, Pair& pair, double now);
    std::optional<Contact> collide_edge(World& world, Pair& pair, double now);
    double restitution_of(const World& world, const Pair& pair, double approach) const;

    // Paths within a substep.
    void begin_paths();
    void list_pairs_of_bodies();
    void begin_path(std::uint32_t body);
    void begin_paths_around(std::uint32_t body);
    Path& path_of(std::uint32_t body) { return paths_[place_of_path_[body]]; }
    const Path& path_of(std::uint32_t body) const { return paths_[place_of_path_[body]]; }
    Vec2 position_at(const World& world, std::uint32_t body, double now) const;
    Vec2 velocity_at(const World& world, std::uint32_t body, double now) const;
    double rim_at(std::uint32_t body, double now) const;
    Vec2 chord_position(std::uint32_t body, double now) const;
    void leave(Path& path, double now) const;
    void take_path(const World& world, std::uint32_t body, double now, Vec2 velocity, double rim);
    void count_push(std::uint32_t body, double now);
    void end_path_at_border(std::uint32_t body, double now);
    void stand(std::uint32_t body, double now);
    void wait_behind(std::uint32_t other, std::uint32_t body, Vec2 normal, double now);
    void wait_at(std::uint32_t body, Vec2 normal, double now);
    void forget_what_was_not_given(const World& world);
    void finish_paths(const World& world);

    // Hands.
    void take_hands(const World& world, double share_of_way);
    void move_hands(World& world);
    Hand* hand_of(std::uint32_t capsule);
    const Hand* hand_of(std::uint32_t capsule) const;
    Hand& hand_of(const Pair& pair);
    Hand* hand_of_body(std::uint32_t body);
    Vec2 surface_velocity(const Hand& hand, const Capsule& shape, Vec2 point) const;
    Capsule shape_of(const World& world, const Hand& hand, double now) const;
    void hold_hands_back(bool spin);
    bool shorten_hands();
    void settle_jams();
    void stop_hand(const World& world, std::uint32_t capsule, double now);
    bool is_held_body(std::uint32_t body) const { return mover_[body].inverse_mass == 0.0; }

    NearPairs near_;
    ContactScenery scenery_;
    Flight flight_;          // over a substep
    double duration_ = 0.0;  // of a substep, s
    double start_time_ = 0.0;
    Vec2 gravity_;
    std::optional<double> drag_;
    Vec2 torus_;
    bool wraps_ = false;
    double resting_speed_ = 0.0;
    Softness softness_;
    double spin_ease_ = 2.0;        // m r^2 / inertia
    double spin_mass_ = 1.0 / 3.0;  // mass that a contact's friction moves, of its mass
    double smallest_ = 0.0;         // radius
    double fall_ = 0.0;             // that gravity gives in a substep, length
    double guard_ = 0.0;            // a gap that pressed pairs may close for others in a substep
    double most_push_ = 0.0;        // longest way that pressing gave in this substep
    double deepest_ = 0.0;          // smallest gap of the pressed pairs

    // Bodies are the balls in the order of the cells; at `still_` one that nothing moves, behind it
    // one for each pair of a ball and a held edge.
    std::uint32_t still_ = 0;
    std::vector<std::uint32_t> ball_;  // by body: index in the world
    std::vector<Vec2> position_;
    std::vector<Vec2> home_;          // where they were when the pairs were found
    std::vector<Vec2> before_;        // velocity at the start of the substep
    std::vector<double> rim_before_;  // the same of the rims; empty where nothing turns
    std::vector<Vec2> way_;           // in the substep, length
    std::vector<Mover> mover_;
    std::vector<double> radius_;
    std::vector<double> margin_;

    std::vector<Pair> pairs_;
    std::vector<double> height_;  // by body; only while pairs are put in order
    std::vector<std::uint32_t> begin_;
    std::vector<std::uint32_t> shift_;       // by near pair
    std::vector<std::uint32_t> last_shift_;  // by body
    std::vector<std::uint32_t> upwards_;     // near pairs by height
    std::vector<std::uint32_t> turn_;  // near pairs in the order of pairs_; empty: as they are
    std::vector<std::uint32_t> first_impulse_;
    std::vector<std::uint32_t> pressed_;
    std::vector<Press> presses_;
    std::vector<std::uint32_t> new_;  // places in presses_ of pairs that did not press yet
    std::vector<std::uint32_t> flying_;
    std::vector<std::uint32_t> hand_pairs_;
    std::vector<std::uint32_t> loaded_;  // places in presses_: see find_loaded
    std::vector<std::uint8_t> is_loaded_;
    std::vector<std::uint32_t> jammed_;  // bodies: see settle_jams
    std::vector<std::uint8_t> is_jammed_;
    std::vector<std::uint8_t> presses_on_;  // by body: how many pairs, up to `bedded`
    bool any_uneven_ = false;
    bool any_damped_ = false;
    bool is_loaded_anew_ = false;

    std::vector<Hand> hands_;
    std::vector<std::uint8_t> was_held_back_;  // by hand: in this tick
    std::vector<std::uint32_t> hits_;
    std::vector<std::uint32_t> strays_;  // bodies whose way leads out of their regions
    bool had_impacts_ = false;
    std::vector<Path> paths_;                   // only of those that could meet something
    std::vector<std::uint32_t> place_of_path_;  // by body
    std::vector<Event> queue_;
    bool has_pairs_of_bodies_ = false;
    std::vector<std::uint32_t> pairs_begin_;  // by body, into pairs_of_
    std::vector<std::uint32_t> pairs_of_;
};

inline double ContactSolver::core(const Pair& pair) const {
    return 0.5 * (pair.b < still_ ? std::min(radius_[pair.a], radius_[pair.b]) : radius_[pair.a]);
}

}  // namespace carom

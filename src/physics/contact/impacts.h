#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "physics/ccd/impact_queue.h"
#include "physics/contact/classification.h"
#include "physics/contact/hinges.h"
#include "physics/contact/kinematics.h"
#include "physics/contact/paths.h"
#include "physics/laws/bounce.h"
#include "physics/laws/curve.h"

namespace carom {

/// What comes next in a substep with impacts, as far as one body can tell.
struct ContactEvent {
    enum class Kind : std::uint8_t { ball, edge, freeze };

    double time = 0.0;
    Kind kind = Kind::ball;
    std::uint32_t low = 0;  ///< indices in the world of the two bodies
    std::uint32_t high = 0;
    std::uint32_t body = 0;  ///< whose prediction this is
    std::uint32_t pair = 0;
    std::uint32_t body_version = 0;
    std::uint32_t other_version = 0;

    auto tie_break() const { return std::tuple(kind, low, high, body); }
};

/// Continuous collision within a substep of the solver `contact`: finds the impacts along the
/// paths of the balls, and resolves them in the order of time (see ccd/impact_queue.h).
///
/// A pair bounces if it approaches faster than the rest speed and is not enclosed; it may bounce
/// again later. Otherwise the impact removes the approach, and the pair has *settled*: it does not
/// bounce again in this substep. Settled pairs and constraints collide again only when they reach
/// their `soft_bound`. So no body passes through another, and piles are left to the constraints.
class ContactImpacts {
  public:
    ContactImpacts(const ContactSubstep& step, ContactBodies& bodies, ContactPairs& pairs,
                   ContactKinematics& kinematics, const ContactClassification& classification)
        : step_(step),
          bodies_(bodies),
          pairs_(pairs),
          kinematics_(kinematics),
          classification_(classification),
          paths_(step, bodies, pairs) {}

    /// Finds the displacement of each ball, and whether anything may collide or leave its skin in
    /// the substep, or a seesaw comes to a stop. If not, positions may simply advance.
    bool find();
    /// Moves the balls along their paths, with all impacts. Pre: `find` found something.
    void run(World& world, ContactHinges& hinges, std::vector<Contact>& contacts);

    void begin_tick() { paths_.begin_tick(); }
    std::span<const std::uint32_t> standing() const { return paths_.standing(); }

    /// Longest displacement that impulses gave in the substep.
    double most_push() const { return most_push_; }
    /// Balls that have collided with one another in the substep, but for held ones.
    std::span<const BodyPair> of_balls() const { return of_balls_; }
    /// Energy that the impacts of the substep have given to balls; below 0: taken from them.
    double given() const { return given_; }

  private:
    void find_displacements();
    void find_candidates();
    void find_embedded();
    void predict(const World& world, std::uint32_t body, double now);
    std::optional<double> time_of_impact(const World& world, const ContactPair& pair,
                                         double now) const;
    bool is_soft(const ContactPair& pair, Vec2 other_velocity, double now) const;
    Capsule edge_at(const World& world, const ContactPair& pair, double now) const;
    bool is_void(const ContactEvent& event) const;
    void push_freeze(std::uint32_t body, std::optional<double> time);
    void redirect(std::uint32_t body, double now, Vec2 velocity, double surface_speed);

    // What impacts do: response.cpp.
    void collide(World& world, const ContactEvent& event, std::vector<Contact>& contacts);
    std::optional<Contact> collide_balls(World& world, ContactPair& pair, double now);
    std::optional<Contact> collide_edge(World& world, ContactPair& pair, double now);
    CurveBounce bounce_off_curve(const World& world, const ContactPair& pair, Vec2 normal,
                                 double now) const;
    /// What a ball at `position` did to the edge of its pair; `normal` is that of the surface.
    Contact edge_contact(const ContactPair& pair, Vec2 position, Vec2 normal, Exchange done,
                         double now) const;
    std::optional<Contact> roll_on(const World& world, ContactPair& pair, Vec2 normal, double now);
    std::optional<Contact> collide_seesaw(World& world, ContactPair& pair, double now);
    void stop_edge(const World& world, const ContactPair& pair, double now);
    void predict_at_edge(const World& world, std::uint32_t capsule, double now);
    void turn_back_at_stops(const World& world, double now);

    const ContactSubstep& step_;
    ContactBodies& bodies_;
    ContactPairs& pairs_;
    ContactKinematics& kinematics_;
    const ContactClassification& classification_;
    ContactPaths paths_;
    ImpactQueue<ContactEvent> queue_;
    std::vector<std::uint32_t> candidates_;  // pairs that may collide in the substep
    std::vector<std::uint8_t> is_embedded_;  // by ball; or empty
    std::vector<std::uint32_t> pushed_;      // bodies off their free flight by over half a gap
    std::vector<std::uint32_t> escaped_;     // bodies whose displacement leads out of their skins
    std::vector<BodyPair> of_balls_;         // that have collided with one another
    double most_push_ = 0.0;
    double given_ = 0.0;
};

}  // namespace carom

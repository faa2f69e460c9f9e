#pragma once

#include <cstdint>
#include <optional>

#include "physics/laws/bounce.h"
#include "physics/laws/curve.h"
#include "physics/swept/candidates.h"
#include "physics/swept/kinematics.h"
#include "physics/swept/paths.h"
#include "physics/swept/schedule.h"

namespace carom {

/// The outcome of an impact.
struct SweptOutcome {
    std::optional<Contact> contact;  ///< to report: the bodies approached, and momentum passed
    /// A kinematic edge stopped at a frozen ball, or a seesaw turns at another rate: every
    /// prediction must be made again.
    bool has_changed_edge = false;
};

/// What an impact does in the solver `swept`: bounce, rest, freezing, and friction.
///
/// A ball comes to rest on a body if its flight after the bounce would lead back into the body
/// before the substep ends; with restitution below 1, also if it approaches slower than the rest
/// speed. It then feels only the gravity along its supports, and can itself support a ball in this
/// substep. A ball that a kinematic body pushes rests on that body.
///
/// The impulse of friction acts at once (laws/bounce.h). The weight of a resting ball causes
/// friction for the rest of the substep (SweptPaths::apply_rest_friction).
class SweptResponse {
  public:
    SweptResponse(const SweptSubstep& step, SweptPaths& paths, SweptKinematics& kinematics,
                  SweptCandidates& candidates)
        : step_(step), paths_(paths), kinematics_(kinematics), candidates_(candidates) {}

    /// Resolves the impact and redirects the balls. Pre: it is the earliest event, and not void.
    SweptOutcome collide(World& world, const SweptEvent& event);

  private:
    /// Two balls at the instant at which they meet.
    struct BallImpact {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        Vec2 normal;  ///< from b to a
        double now = 0.0;
        Vec2 velocity_a{};
        Vec2 velocity_b{};
        double inverse_a = 0.0;  ///< inverse masses; 0: held or frozen
        double inverse_b = 0.0;
        double approach = 0.0;
    };
    /// A ball at the instant at which it meets an edge.
    struct EdgeImpact {
        std::uint32_t ball = 0;
        std::uint32_t capsule = 0;
        Vec2 normal;  ///< from the edge to the ball
        double now = 0.0;
        Vec2 position{};         ///< of the ball's centre
        Vec2 surface{};          ///< velocity of the edge's surface
        double pushing = 0.0;    ///< of it, along the normal
        bool is_driven = false;  ///< by a solenoid
        Vec2 velocity{};         ///< of the ball
        double approach = 0.0;
        Vec2 along{};  ///< normal of the bounce: the scene may scatter it
    };
    /// What has passed along the normal.
    struct Passed {
        Exchange exchange;
        bool is_resting = false;
        bool is_contact = false;
        bool rolls_on = false;  ///< along a curve: it rests, and has kept its speed
    };

    std::optional<Contact> collide_balls(World& world, const SweptEvent& event);
    Passed pass_between(const World& world, BallImpact& impact);
    Passed rest_together(const World& world, BallImpact& impact);
    bool meet_again(const World& world, const BallImpact& impact, Vec2 velocity_a,
                    Vec2 velocity_b) const;
    void apply_ball_friction(World& world, BallImpact& impact, const Passed& passed) const;

    SweptOutcome collide_edge(World& world, const SweptEvent& event);
    SweptOutcome collide_seesaw(World& world, const SweptEvent& event, const HeldEdge& edge);
    std::optional<Contact> collide_free_ball(World& world, EdgeImpact& impact);
    Passed bounce_off_edge(World& world, EdgeImpact& impact) const;
    CurveBounce bounce_off_curve(const World& world, const EdgeImpact& impact,
                                 double restitution) const;
    Passed roll_on(EdgeImpact& impact) const;
    Exchange rest_on_edge(EdgeImpact& impact, double restitution) const;
    void apply_edge_friction(World& world, EdgeImpact& impact, double impulse) const;

    // What it costs to lift resting balls: lifts.cpp.
    double lift(std::uint32_t ball, Vec2 velocity, double now) const;
    double lifts(const BallImpact& impact) const;
    double energy_lost(std::uint32_t ball, Vec2 before, Vec2 after) const;
    double energy_lost(const BallImpact& before, const BallImpact& after) const;
    double lift_by_rounding(std::uint32_t ball, Vec2 velocity, double now) const;
    void pay(std::uint32_t ball, double now, Vec2& velocity) const;
    void pay_for_lifts(BallImpact& impact, const BallImpact& before, double most) const;
    void pay_for_lift(EdgeImpact& impact, Vec2 before, double most, double radius) const;
    void weigh_on(BallImpact& impact, const BallImpact& before) const;

    void redirect(const World& world, std::uint32_t ball, double now, Vec2 velocity) {
        const bool is_first = paths_.redirect(world, ball, now, velocity);
        candidates_.note_change(world, ball, now, is_first);
    }

    const SweptSubstep& step_;
    SweptPaths& paths_;
    SweptKinematics& kinematics_;
    SweptCandidates& candidates_;
};

}  // namespace carom

#pragma once

#include "physics/event/impact/impact_cluster.h"

namespace carom {

/// The coefficient of restitution of each contact point in an impact: that of the pair's materials
/// (laws/contact_material.h), but for the rules by which bodies come to rest and collapse stays
/// finite.
///
///   pair                                    rebound rises less than       restitution
///   ball pressed by gravity on an edge      rest_height                   0: it rests
///   ball pressed on a resting ball          rest_height                   0: it rests
///   two moving balls, pressed together      moving_rest_height            1: nothing more is lost
///   ball and edge pressed by cloth          rest_height                   0
///   two balls pressed by cloth              cloth_rest_height             1
///   ball and kinematic body, by cloth       2 moving_rest_height          1
///   two balls with more than most_recent_collisions each                0
///   such a ball and an edge, without gravity                              0
///   ball against a held ball                always                        laws/bounce.h
///   kinematic edge that approaches          always                        laws/bounce.h
///   ball on a seesaw, under gravity         moving_rest_height            1: nothing more is lost
///   seesaw and its stop                     never                         that of the stop
///
/// "Pressed" refers to the relative acceleration along the normal. Heights are shares of the
/// smaller radius (tolerances.h). Rules with a height apply only if no other contact point of the
/// impact approaches. Counts of collisions (collapse_guard.h) matter only for a restitution
/// below 1.
template <typename Real>
class Restitution {
  public:
    Restitution(const EventScene<Real>& scene, const BallTable<Real>& balls,
                const KinematicBodies<Real>& kinematic, const ImpactCluster<Real>& cluster)
        : scene_(scene), balls_(balls), kinematic_(kinematic), cluster_(cluster) {}

    /// `is_alone`: the contact point is the only one of the impact that approaches.
    double of(const ContactPoint<Real>& point, bool is_alone) const;

  private:
    double of_balls(const ContactPoint<Real>& point, bool is_alone, const Real& approach) const;
    double off_hand(std::uint32_t free, std::uint32_t held, const Vector<Real>& normal,
                    double restitution) const;
    double of_edge(const ContactPoint<Real>& point, bool is_alone, const Real& approach) const;
    double of_seesaw(const ContactPoint<Real>& point, const Real& approach) const;
    double on_cloth(const ContactPoint<Real>& point, bool is_alone, double usual) const;

    const EventScene<Real>& scene_;
    const BallTable<Real>& balls_;
    const KinematicBodies<Real>& kinematic_;
    const ImpactCluster<Real>& cluster_;
};

}  // namespace carom

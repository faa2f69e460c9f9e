#pragma once

#include "physics/event/impact/impact_cluster.h"

namespace carom {

/// The coefficient of restitution of each contact point in an impact: that of the pair's materials
/// (laws/contact_material.h), but for the rules by which bodies come to rest and collapse stays
/// finite.
///
/// The first row that applies decides. Heights are shares of the smaller radius (tolerances.h): the
/// rebound would rise less.
///
///   contact                     if                                        restitution
///   seesaw and its stop         the seesaw comes to it                    that of the stop
///                               the stop only holds it against a load     1
///   ball on a seesaw            gravity, moving_rest_height               1: nothing more is lost
///   ball against a held ball                                              laws/bounce.h
///   two balls                   more than most_recent_collisions each     0 *
///   driven edge                                                           laws/bounce.h
///   held edge that approaches   2 rest_height, of a bounce at 1 (on       1: it is found again
///                               cloth 2 moving_rest_height)
///                               else                                      laws/bounce.h
///   ball and edge               such a ball, no gravity                   0 *
///   ball pressed on an edge     rest_height                               0: it rests
///   ball on a resting ball      rest_height                               0: it rests
///   two moving balls            moving_rest_height                        1: nothing more is lost
///
/// Where cloth presses the two together, these come before all but seesaws:
///
///   ball and kinematic body     2 moving_rest_height, of a bounce at 1    1
///   two balls                   cloth_rest_height                         1
///   ball and edge               rest_height                               0
///
/// The last three rows of the first table need gravity that presses the bodies together, by their
/// relative acceleration along the normal. These three and those on cloth apply only if no other
/// contact point of the impact approaches. Counts of collisions (*, collapse_guard.h) matter only
/// for a restitution below 1.
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

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/event/impact/impact_cluster.h"
#include "physics/event/impact/restitution.h"
#include "physics/laws/hertz_impact.h"

namespace carom {

/// Computes the impulses of an impact whose contacts last (Model::modulus): of all balls that press
/// on one another, also through gaps that close meanwhile, as in the break of a rack.
///
/// A ball takes part if a chain of gaps leads to it and one of them closes before the impact ends.
/// A gap may be as long as the distance that the fastest approaching pair covers during its
/// contact, up to `most_lasting_gap` of a radius. In simulated time the impact is an instant, and
/// no ball is moved: a ball that would have moved by a millimetre meets its next event a fraction
/// of a millisecond late.
///
/// Contacts with edges do not last. A ball that the impact drives into an edge that it touches
/// bounces off in the next round, as from a cushion, which is far softer than a ball.
///
/// An impact of two balls alone follows the ordinary law, which has the same result. So does a pair
/// that cloth presses together, if the rebound would rise less than `moving_rest_height`: gaps that
/// short are rounding.
template <typename Real>
class LastingImpact {
  public:
    LastingImpact(const EventScene<Real>& scene, ImpactCluster<Real>& cluster,
                  const Restitution<Real>& restitution)
        : scene_(scene), cluster_(cluster), restitution_(restitution) {}

    /// Computes the impulses of the impact that begins with the `approaching` contact points.
    /// Returns false if fewer than two contacts of balls press: then the ordinary law applies.
    /// Pre: Model::modulus.
    bool press(std::span<const std::uint32_t> approaching);

    /// After `press`: the contacts that have pressed, in the order in which they first touched.
    std::span<const HertzTouch<Real>> touches() const { return *touches_; }
    /// The contact point of a touch, by index in the cluster.
    std::uint32_t point_of(const HertzTouch<Real>& touch) const { return points_[touch.contact]; }
    /// How much work the last `press` was, in events that take as long.
    std::uint64_t work() const { return work_; }

  private:
    static constexpr std::uint64_t contacts_per_event = 128;

    void collect();
    Real least_speed(const ContactPoint<Real>& point) const;
    HertzContact<Real> contact_of(const ContactPoint<Real>& point) const;

    const EventScene<Real>& scene_;
    ImpactCluster<Real>& cluster_;
    const Restitution<Real>& restitution_;
    HertzImpact<Real> impact_;
    std::vector<HertzContact<Real>> contacts_;
    std::vector<std::uint32_t> points_;  ///< of those
    const std::vector<HertzTouch<Real>>* touches_ = nullptr;
    std::uint64_t work_ = 0;
};

}  // namespace carom

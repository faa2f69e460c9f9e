#include <algorithm>

#include "physics/event/impact/impact_cluster.h"
#include "physics/event/motion/tolerances.h"

// The bodies of an impact that lasts: those, too, whose gaps may close meanwhile.
namespace carom {

template <typename Real>
void ImpactCluster<Real>::gather(const Real& reach) {
    for (std::uint32_t body = 0; body < bodies_.size(); ++body) {
        scan(body);
        if (bodies_[body].is_gathered) continue;
        if (has_neighbours(bodies_[body])) gather_around(body, reach);
        bodies_[body].is_gathered = true;
    }
}

template <typename Real>
void ImpactCluster<Real>::gather_around(std::uint32_t body, const Real& reach) {
    touching_.clear();
    const std::uint32_t ball = bodies_[body].ball;
    for (const Neighbour<Real>& near : neighbours_of(bodies_[body])) {
        const Real small = std::min(radius_of(body), balls_.radius(near.other));
        const Real limit = near.reach + std::min(reach, Real(most_lasting_gap) * small);
        if (length_squared(near.offset) > limit * limit || near.touches ||
            is_gathered(near.other) || is_of_event(body, near) ||
            !scene_.balls_collide(ball, near.other))
            continue;
        touching_.push_back({static_cast<int>(near.other), near.across, near.along});
    }
    std::sort(touching_.begin(), touching_.end());
    for (const auto& [other, across, along] : touching_) {
        add_ball(body, static_cast<std::uint32_t>(other), across, along, true);
        contacts_.back().is_apart = true;
    }
}

// Whether the impact began with these two.
template <typename Real>
bool ImpactCluster<Real>::is_of_event(std::uint32_t body, const Neighbour<Real>& neighbour) const {
    const ContactPoint<Real>& first = contacts_.front();
    if (first.kind != EventKind::ball_ball) return false;
    const bool is_first = first.contact.a == body && first.other == neighbour.other;
    const bool is_second =
        first.contact.b == body && bodies_[first.contact.a].ball == neighbour.other;
    const int side = is_first ? 1 : -1;
    return (is_first || is_second) && first.support.across == side * neighbour.across &&
           first.support.along == side * neighbour.along;
}

// Whether the contact points around that ball are known.
template <typename Real>
bool ImpactCluster<Real>::is_gathered(std::uint32_t ball) const {
    const std::uint32_t body = body_of_[ball];
    return body != BallRecord<Real>::none && bodies_[body].is_gathered;
}

#define CAROM_FOR(Real)                                                                          \
    template void ImpactCluster<Real>::gather(const Real&);                                      \
    template void ImpactCluster<Real>::gather_around(std::uint32_t, const Real&);                \
    template bool ImpactCluster<Real>::is_of_event(std::uint32_t, const Neighbour<Real>&) const; \
    template bool ImpactCluster<Real>::is_gathered(std::uint32_t) const;
CAROM_FOR(double)
CAROM_FOR(DoubleDouble)
#undef CAROM_FOR

}  // namespace carom

#include "physics/event/impact/squeeze.h"

#include <algorithm>

#include "physics/event/motion/tolerances.h"

namespace carom {
namespace {

// Returns false if an edge moves into the held ball even when the ball stops.
template <typename Real>
bool hold_back(ImpactCluster<Real>& cluster, std::uint32_t body) {
    const auto for_each_bar = [&](auto&& visit) {
        for (const ContactPoint<Real>& point : cluster.contacts())
            if (point.kind != EventKind::ball_ball && point.contact.a == body &&
                !point.contact.is_hinged)
                visit(point.contact);
    };
    const auto is_free = [&](const Vector<Real>& velocity) {
        bool is = true;
        for_each_bar([&](const ImpactContact<Real>& bar) {
            const Real speeds = length(velocity) + absolute(bar.surface);
            is = is && !(bar.surface - dot(velocity, bar.normal) >
                         Real(residual_rounding<Real>) * speeds);
        });
        return is;
    };
    Vector<Real>& velocity = cluster.motion()[body].velocity;
    const Vector<Real> wanted = velocity;
    const auto along = [](const Vector<Real>& before, const ImpactContact<Real>& bar) {
        const Real into = bar.surface - dot(before, bar.normal);
        return into > Real{} ? before + bar.normal * into : before;
    };
    for_each_bar([&](const ImpactContact<Real>& bar) { velocity = along(velocity, bar); });
    if (is_free(velocity)) return true;
    for_each_bar([&](const ImpactContact<Real>& bar) {
        if (!is_free(velocity)) velocity = along(wanted, bar);
    });
    if (is_free(velocity)) return true;
    velocity = {};
    return is_free(velocity);
}

}  // namespace

template <typename Real>
bool hold_back(ImpactCluster<Real>& cluster, const BallTable<Real>& balls) {
    bool can_all = true;
    for (std::uint32_t i = 0; i < cluster.bodies().size(); ++i)
        if (cluster.bodies()[i].is_ball() &&
            balls[cluster.bodies()[i].ball].line.motion == Motion::held && !hold_back(cluster, i))
            can_all = false;
    return can_all;
}

template <typename Real>
bool pushes_without_end(const ImpactCluster<Real>& cluster, const BallTable<Real>& balls,
                        bool is_jammed) {
    const auto is_held = [&](std::uint32_t ball) {
        return balls[ball].line.motion == Motion::held;
    };
    return std::ranges::any_of(cluster.contacts(), [&](const ContactPoint<Real>& point) {
        if (point.is_apart || point.is_stop) return false;
        const std::uint32_t ball = cluster.bodies()[point.contact.a].ball;
        const bool is_kinematic =
            (point.kind == EventKind::kinematic_edge && !point.contact.is_hinged) ||
            (point.kind == EventKind::kinematic_edge && is_held(ball)) ||
            (point.kind == EventKind::ball_ball && (is_held(ball) || is_held(point.other)));
        return is_kinematic &&
               (is_jammed || balls[ball].line.recent_collisions > most_recent_collisions);
    });
}

template bool hold_back(ImpactCluster<double>&, const BallTable<double>&);
template bool hold_back(ImpactCluster<DoubleDouble>&, const BallTable<DoubleDouble>&);
template bool pushes_without_end(const ImpactCluster<double>&, const BallTable<double>&, bool);
template bool pushes_without_end(const ImpactCluster<DoubleDouble>&, const BallTable<DoubleDouble>&,
                                 bool);

}  // namespace carom

#include "physics/event/rest/collapse_guard.h"

#include <algorithm>

#include "physics/event/motion/tolerances.h"

namespace carom {

// The time of a fall through the radius.
template <typename Real>
Real CollapseGuard<Real>::fall_time(std::uint32_t ball) const {
    return square_root(Real(2.0) * balls_.radius(ball) / length(scene_.field.gravity));
}

// How often a collision could have followed in quick succession since then. Pre: gravity.
template <typename Real>
double CollapseGuard<Real>::pauses_since(std::uint32_t ball, const Real& time) const {
    return static_cast<double>((scene_.now - time) / (fall_time(ball) * Real(quick_succession)));
}

template <typename Real>
std::uint32_t CollapseGuard<Real>::count(std::uint32_t ball, const Trajectory<Real>& before,
                                         const Vector<Real>& position) const {
    const std::uint32_t collisions = before.recent_collisions;
    if (!scene_.world->model().gravity) {
        const Real distance = length(position - before.position);
        return distance < Real(contact_slop) * balls_.radius(ball) ? one_more(collisions) : 0;
    }
    const double pauses = pauses_since(ball, before.time);
    if (pauses < 1.0) return one_more(collisions);
    return pauses < collisions ? collisions - static_cast<std::uint32_t>(pauses) : 0;
}

template <typename Real>
std::uint32_t CollapseGuard<Real>::remaining(std::uint32_t ball) const {
    const LinearPart<Real>& line = balls_[ball].line;
    const std::uint32_t collisions = line.recent_collisions;
    if (collisions == 0) return 0;
    if (!scene_.world->model().gravity) {
        const Real distance = length(trajectories_.position_now(ball) - line.position);
        return distance < Real(contact_slop) * balls_.radius(ball) ? collisions : 0;
    }
    const double pauses = std::max(0.0, pauses_since(ball, line.time));
    return pauses < collisions ? collisions - static_cast<std::uint32_t>(pauses) : 0;
}

template <typename Real>
void CollapseGuard<Real>::freeze_if_due(std::uint32_t ball, bool is_jammed) {
    const Model& model = scene_.world->model();
    const LinearPart<Real>& line = balls_[ball].line;
    const bool is_due =
        is_jammed ? line.recent_collisions > most_recent_collisions
                  : line.recent_collisions > most_collisions_before_freezing && loses_energy(model);
    if (!is_due || !model.gravity) return;
    if (line.motion == Motion::resting || line.motion == Motion::held) return;
    const bool is_fast = Real(2.0) * length(scene_.field.gravity) * balls_.radius(ball) <
                         length_squared(line.velocity);
    if (is_fast) return;
    trajectories_.put_to_rest(ball, {}, {});
    if (model.spin) trajectories_.spin(ball) = {scene_.now, Real{}, Real{}, false};
    balls_[ball].line.recent_collisions = collisions_after_freezing;
}

template <typename Real>
bool CollapseGuard<Real>::may_be_clustered(std::uint32_t ball) const {
    const Model& model = scene_.world->model();
    return model.gravity && loses_energy(model) && balls_[ball].line.motion != Motion::held;
}

template <typename Real>
void CollapseGuard<Real>::note_dense(std::uint32_t ball) {
    if (may_be_clustered(ball)) dense_.push_back(ball);
}

template <typename Real>
void CollapseGuard<Real>::note_sunk(std::uint32_t ball) {
    if (may_be_clustered(ball) && balls_[ball].line.recent_collisions > sunk_collisions)
        sunk_.push_back(ball);
}

template <typename Real>
const std::vector<std::uint32_t>& CollapseGuard<Real>::dense() {
    std::erase_if(dense_, [&](std::uint32_t ball) {
        return !(balls_[ball].line.recent_collisions > dense_collisions);
    });
    dense_.insert(dense_.end(), sunk_.begin(), sunk_.end());
    std::sort(dense_.begin(), dense_.end());
    dense_.erase(std::unique(dense_.begin(), dense_.end()), dense_.end());
    return dense_;
}

template class CollapseGuard<double>;
template class CollapseGuard<DoubleDouble>;

}  // namespace carom

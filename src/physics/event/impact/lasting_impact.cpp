#include "physics/event/impact/lasting_impact.h"

#include <algorithm>

#include "physics/event/motion/tolerances.h"

namespace carom {

template <typename Real>
bool LastingImpact<Real>::press(std::span<const std::uint32_t> approaching) {
    work_ = 0;
    Real speed{};
    const ContactPoint<Real>* fastest = nullptr;
    for (const std::uint32_t index : approaching) {
        const ContactPoint<Real>& point = cluster_.contacts()[index];
        if (point.kind != EventKind::ball_ball) continue;
        const Real approach = approach_of<Real>(point.contact, cluster_.motion());
        if (!(speed < approach)) continue;
        speed = approach;
        fastest = &point;
    }
    if (!fastest || !(speed > least_speed(*fastest))) return false;
    const Real duration = hertz_duration(contact_of(*fastest).stiffness,
                                         Real(1.0) / cluster_.compliance(*fastest), speed);
    cluster_.gather(speed * duration);
    collect();
    if (contacts_.size() < 2) return false;
    touches_ = &impact_.press(cluster_.motion(), contacts_, speed);
    work_ = impact_.work() / contacts_per_event;
    return touches_->size() > 1;
}

template <typename Real>
void LastingImpact<Real>::collect() {
    contacts_.clear();
    points_.clear();
    const std::vector<ContactPoint<Real>>& all = cluster_.contacts();
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        if (all[i].kind != EventKind::ball_ball || !(cluster_.compliance(all[i]) > Real{}))
            continue;
        contacts_.push_back(contact_of(all[i]));
        points_.push_back(i);
    }
}

template <typename Real>
HertzContact<Real> LastingImpact<Real>::contact_of(const ContactPoint<Real>& point) const {
    HertzContact<Real> contact{.contact = point.contact};
    contact.contact.restitution = Real(restitution_.of(point, false));
    contact.stiffness =
        hertz_stiffness(Real(*scene_.world->model().modulus), cluster_.radius_of(point.contact.a),
                        cluster_.radius_of(point.contact.b));
    if (point.is_apart) contact.gap = point.gap;
    return contact;
}

// What presses the balls by no more than the rounding of a radius. On cloth, of a fall through
// `moving_rest_height` with the largest acceleration that cloth gives two balls.
template <typename Real>
Real LastingImpact<Real>::least_speed(const ContactPoint<Real>& point) const {
    const Real radius = cluster_.smaller_radius(point);
    const Real pressed =
        hertz_speed(contact_of(point).stiffness, Real(1.0) / cluster_.compliance(point),
                    radius * Real(0x1p-53));
    const auto& cloth = scene_.world->model().cloth;
    if (!cloth) return pressed;
    const double acceleration = 2.0 * cloth->slide * cloth->gravity;
    return std::max(pressed, square_root(Real(2.0 * moving_rest_height * acceleration) * radius));
}

template class LastingImpact<double>;
template class LastingImpact<DoubleDouble>;

}  // namespace carom

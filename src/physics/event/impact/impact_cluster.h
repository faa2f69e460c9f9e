#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/event/motion/ball_table.h"
#include "physics/event/motion/kinematic_bodies.h"
#include "physics/event/motion/scene.h"
#include "physics/event/motion/spatial_index.h"
#include "physics/event/motion/trajectories.h"
#include "physics/laws/simultaneous_impact.h"

namespace carom {

/// A ball that takes part in an impact, or a seesaw. A seesaw has no position, and turns at the x
/// of its velocity, rad/s.
template <typename Real>
struct ClusterBody {
    static constexpr std::uint32_t no_edge = 0xffffffffu;
    std::uint32_t ball = 0;
    std::uint32_t seesaw = no_edge;  ///< index into KinematicBodies::edges; no_edge: a ball
    Vector<Real> position;
    Real fastest{};     ///< its largest speed in the impact so far, length/s
    Real spin{};        ///< rad/s; only with Model::spin
    Vector<Real> roll;  ///< length/s; only with Model::cloth
    bool is_scanned = false;
    bool is_changed = false;
    bool is_moved = false;  ///< by position correction
    bool is_gathered = false;
    bool rolls_on = false;  ///< along a curve, which alone is no collision
    bool has_collided = false;
    bool was_resting = false;
    std::uint32_t first_neighbour = 0;  ///< once it is scanned
    std::uint32_t neighbours = 0;

    bool is_ball() const { return seesaw == no_edge; }
};

/// A ball in the cells around a body's, at the instant of the impact.
template <typename Real>
struct Neighbour {
    Vector<Real> offset;  ///< from its centre to the body's
    Real reach;           ///< sum of the radii
    std::uint32_t other = 0;
    std::int8_t across = 0;  ///< periodic image that is near
    std::int8_t along = 0;
    bool touches = false;  ///< within the slop, if the body is scanned
};

/// Two things that touch in the impact: a body, and a body, an edge or a kinematic edge. Or two
/// bodies that are apart, but whose gap may close while the impact lasts (`gather`). Or a seesaw
/// and the stop at which it stands.
template <typename Real>
struct ContactPoint {
    ImpactContact<Real> contact;
    EventKind kind = EventKind::ball_ball;
    std::uint32_t other = 0;  ///< ball or capsule
    bool is_driven = false;
    bool is_apart = false;          ///< no contact yet: it counts only for an impact that lasts
    bool is_stop = false;           ///< of the seesaw that is body a
    SupportId support;              ///< as which it would carry the body
    Real gap{};                     ///< length
    Vector<Real> surface_velocity;  ///< of a kinematic edge, length/s
    Real side_lever{};              ///< of a seesaw: the arm of friction, length
};

/// The bodies and contact points that take part in an impact. The cluster starts with the two
/// bodies that the event names, and grows with each body whose velocity changes (`scan`).
///
/// Bodies touch if they are within `contact_slop` of the smaller radius. The order of contact
/// points does not depend on the cells.
template <typename Real>
class ImpactCluster {
  public:
    ImpactCluster(const EventScene<Real>& scene, const BallTable<Real>& balls,
                  const SpatialIndex<Real>& space, const Trajectories<Real>& trajectories,
                  const KinematicBodies<Real>& kinematic)
        : scene_(scene),
          balls_(balls),
          space_(space),
          trajectories_(trajectories),
          kinematic_(kinematic) {}

    /// The world has this many balls, none of which takes part in an impact.
    void reset(std::size_t balls) { body_of_.assign(balls, BallRecord<Real>::none); }

    /// Starts with the bodies and the contact point of an impact event, seen from the lower ball,
    /// and scans them.
    void begin(std::uint32_t ball, const BallEvent<Real>& event);
    /// Adds everything that the body touches, unless it was scanned before.
    void scan(std::uint32_t body);
    /// Scans all bodies, and adds the balls within `reach` of one, as bodies with contact points
    /// that are apart; then the balls within reach of these, and so on. `reach`, a gap in length,
    /// counts up to `most_lasting_gap` of the smaller radius.
    void gather(const Real& reach);
    /// The impact is over: no ball takes part any more. The neighbours stay until the next one.
    void end();

    std::vector<ClusterBody<Real>>& bodies() { return bodies_; }
    /// Velocities and inverse masses, by body.
    std::vector<ImpactBody<Real>>& motion() { return motion_; }
    std::vector<ContactPoint<Real>>& contacts() { return contacts_; }
    const std::vector<ClusterBody<Real>>& bodies() const { return bodies_; }
    const std::vector<ImpactBody<Real>>& motion() const { return motion_; }
    const std::vector<ContactPoint<Real>>& contacts() const { return contacts_; }

    const Real& radius_of(std::uint32_t body) const { return balls_.radius(bodies_[body].ball); }
    /// The radius that tolerances of the contact scale with.
    Real smaller_radius(const ContactPoint<Real>& point) const;
    /// The sum of the inverse masses: 0 if nothing can give way.
    Real compliance(const ContactPoint<Real>& point) const;
    /// Whether the body touches another ball, or a seesaw.
    bool touches_ball(std::uint32_t body) const;
    /// The contact point of a seesaw and its stop; none where it is free to turn.
    std::optional<std::uint32_t> stop_of(std::uint32_t body) const;

    /// Notes the speeds after a round. With `stops`, a speed that is rounding becomes 0.
    void note_speeds(bool stops);

    /// The body of a ball that takes part; BallRecord::none if it does not.
    std::uint32_t body_of(std::uint32_t ball) const { return body_of_[ball]; }
    /// The neighbours that `scan` found around a body. Pre: `has_neighbours`, which is false if the
    /// body was not scanned, or if something has been moved since.
    std::span<const Neighbour<Real>> neighbours_of(const ClusterBody<Real>& body) const {
        return {neighbours_.data() + body.first_neighbour, body.neighbours};
    }
    bool has_neighbours(const ClusterBody<Real>& body) const {
        return body.is_scanned && !is_corrected_ && image_changes_ == trajectories_.image_changes();
    }
    /// Position correction has moved bodies.
    void note_correction() { is_corrected_ = true; }

  private:
    std::uint32_t add_body(std::uint32_t ball);
    void add_ball(std::uint32_t body, std::uint32_t other, int across, int along, bool is_certain);
    void add_edge(std::uint32_t body, std::uint32_t capsule, int across, int along,
                  bool is_certain);
    void add_kinematic_edge(std::uint32_t body, const KinematicEdge<Real>& edge, bool is_certain);
    std::uint32_t add_seesaw(const KinematicEdge<Real>& edge);
    void add_hinged(ContactPoint<Real> point, const KinematicEdge<Real>& edge);
    void scan_seesaw(std::uint32_t body);
    bool knows_seesaw(std::uint32_t body, std::uint32_t capsule) const;
    void gather_around(std::uint32_t body, const Real& reach);
    bool is_of_event(std::uint32_t body, const Neighbour<Real>& neighbour) const;
    bool is_gathered(std::uint32_t ball) const;
    bool may_touch(std::uint32_t body, const Neighbour<Real>& neighbour) const;
    void find_neighbours(std::uint32_t body);
    Real slop_at(std::uint32_t body, const Real& size, const Real& reach) const;

    const EventScene<Real>& scene_;
    const BallTable<Real>& balls_;
    const SpatialIndex<Real>& space_;
    const Trajectories<Real>& trajectories_;
    const KinematicBodies<Real>& kinematic_;
    std::vector<std::uint32_t> body_of_;  ///< by ball
    std::vector<ClusterBody<Real>> bodies_;
    std::vector<ImpactBody<Real>> motion_;  ///< by body
    std::vector<ContactPoint<Real>> contacts_;
    std::vector<Neighbour<Real>> neighbours_;  ///< the first `neighbour_count_` count
    std::size_t neighbour_count_ = 0;
    std::vector<std::uint32_t> close_;  ///< neighbours of `scan` that may touch
    std::size_t close_count_ = 0;
    std::vector<std::array<int, 3>> touching_;  ///< ball and image, to be sorted
    std::uint64_t image_changes_ = 0;           ///< of Trajectories, when the impact began
    bool is_corrected_ = false;
};

}  // namespace carom

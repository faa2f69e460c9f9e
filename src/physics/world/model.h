#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes.h"

/// What a scene requires of the physics, and nothing more.
///
/// The level's loader fills this in from what the level declares and uses. A term that is absent
/// costs nothing or little: inner loops are compiled without it (terms.h) or pass it by, and no
/// ball carries its bytes.
namespace carom {

/// What the cloth does to balls: see laws/cloth.h.
struct Cloth {
    double slide = 0.2;     ///< friction of a point that slips, > 0
    double roll = 0.01;     ///< resistance to rolling, >= 0
    double spin = 10.0;     ///< how fast side spin dies away, rad/s^2, >= 0
    double gravity = 9.81;  ///< into the table, length/s^2, > 0

    friend bool operator==(const Cloth&, const Cloth&) = default;
};

struct Model {
    /// Acceleration of every ball, length/s^2.
    std::optional<Vec2> gravity;
    /// Linear drag k in a = -k v, 1/s, > 0.
    std::optional<double> drag;
    /// A ball slower than this stops, length/s, > 0. Under gravity this applies only to a ball that
    /// touched something in the same tick, so that no ball stops at the top of its flight.
    std::optional<double> stop_speed;
    /// No ball is faster than this after free motion, length/s, > 0. `event` limits speeds only at
    /// the end of a tick, within which a ball may be faster.
    std::optional<double> speed_limit;
    /// The normal of a contact of ball and edge is turned by a seeded uniform angle within +- this,
    /// radians.
    std::optional<double> scatter;
    /// Friction acts at contacts and balls turn: the moment of inertia / (m r^2), in (0, 1]; 1/2 is
    /// a disc, 2/5 a solid ball.
    std::optional<double> spin;
    /// The balls lie on cloth, seen from above. Only with `spin`, and without gravity and drag.
    std::optional<Cloth> cloth;
    /// Impacts of balls last for a time, so several balls may take part in one (`use modulus`). The
    /// value is the material's E / (1 - nu^2), with Young's modulus E and Poisson's ratio nu,
    /// mass / (length s^2), > 0. Without gravity. Only `event` uses it; under other solvers impacts
    /// are instantaneous. See laws/hertz_impact.h.
    std::optional<double> modulus;
    /// The torus: what leaves on one side comes back on the other. Low included, high excluded.
    std::optional<Box> wrap;
    /// Some restitution is below 1, or some edge is soft: balls carry a restitution.
    bool inelastic = false;
    /// Some ball or edge has friction, which acts in scenes with `spin`.
    bool rough = false;
    /// Some capsules push only balls on one of their sides, or none for the moment.
    bool one_way = false;
    /// Some edges kick what hits them: Material::kick.
    bool kicks = false;
    /// Some edges are pieces of a curve, with smooth joints: Capsules::joints.
    bool curved = false;
    /// Some edges turn on hinges as bodies: World::seesaws.
    bool hinged = false;
    /// Not every pair meets: see World::meets.
    bool filtered = false;
    /// Some pair of balls may meet. False: no ball-ball work at all.
    bool ball_ball = true;
    /// Some ball may meet some edge.
    bool ball_edge = true;

    friend bool operator==(const Model&, const Model&) = default;
};

/// Whether impacts, slip, drag or the stop speed take energy for good: then gravity brings balls to
/// rest on one another, even those with a restitution of 1.
bool loses_energy(const Model& model);

/// The terms in force, in a fixed order, for people: "gravity 0,-9.81", "restitution", "wrap" ...
/// An elastic gas has none.
std::vector<std::string> terms_in_force(const Model& model);

}  // namespace carom

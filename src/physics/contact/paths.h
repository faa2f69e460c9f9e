#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/ccd/chord.h"
#include "physics/contact/constraints.h"
#include "physics/contact/pairs.h"

namespace carom {

/// The path of a ball in a substep that has impacts. After an impact, and where no constraint
/// presses on it, the ball is free: it is on its parabola, while impacts are searched along the
/// chord. Otherwise, and if `is_on_chord`, it moves along the chord itself, while its velocity
/// changes at the constant rate `pull` and its surface speed at the rate `turn`. From `end` on it
/// does not move.
struct ContactPath {
    Chord chord;                 ///< to where it will be at the end; the parabola begins there too
    Vec2 velocity;               ///< at chord.time, length/s
    Vec2 pull;                   ///< length/s^2
    double surface_speed = 0.0;  ///< length/s
    double turn = 0.0;           ///< length/s^2
    double given = 1.0;          ///< share of the constraints' impulses that the ball has felt
    double end = 0.0;            ///< s in the substep
    std::uint32_t version = 0;
    std::uint16_t impacts = 0;
    /// Impacts with kinematic edges that moved towards it, and with held balls, moving or not.
    std::uint16_t pushes = 0;
    bool is_free = false;
    /// It is on the chord even if it is free: under drag, and where the parabola is further from
    /// the chord than walls are thick. Else it would be past what it meets.
    bool is_on_chord = false;
    bool is_frozen = false;      ///< for the rest of the substep
    bool is_surrounded = false;  ///< all balls in its pairs have paths
    bool rolls_on = false;       ///< its last impact has led it along a curve
    std::uint32_t body = 0;

    bool is_on_parabola() const { return is_free && !is_on_chord; }
};

/// The paths of the balls that could meet something in a substep, made when they are asked for.
///
/// A ball freezes after `most_impacts` impacts, and where its path leads out of its skin, since its
/// pairs are known only within the skin. A frozen ball does not move for the rest of the substep
/// but keeps its velocity, unless kinematic bodies have pushed it `most_pushes` times: then it
/// stops. Freezing never adds energy.
class ContactPaths {
  public:
    ContactPaths(const ContactSubstep& step, ContactBodies& bodies, ContactPairs& pairs)
        : step_(step), bodies_(bodies), pairs_(pairs) {}

    void begin_tick() { standing_.clear(); }
    /// The balls for which time has stood still in the tick, by index in the world, with
    /// repetitions.
    std::span<const std::uint32_t> standing() const { return standing_; }

    /// The share of its constraints' impulses that a ball has felt.
    double share_felt(std::uint32_t body) const {
        return has_path(body) ? (*this)[body].given : 1.0;
    }

    /// Begins a substep: only held balls have paths.
    void begin();
    /// Ends it: balls are where their paths lead. Constraints keep only impulses that their balls
    /// have felt.
    void finish(const World& world);

    void add(std::uint32_t body);
    /// Adds the body and all balls in its pairs. References to paths become invalid.
    void add_around(std::uint32_t body);
    ContactPath& operator[](std::uint32_t body) { return paths_[place_[body]]; }
    const ContactPath& operator[](std::uint32_t body) const { return paths_[place_[body]]; }

    Vec2 position_at(std::uint32_t body, double now) const;
    Vec2 velocity_at(std::uint32_t body, double now) const;
    double surface_speed_at(std::uint32_t body, double now) const;
    /// Where it is along the chord, and at which velocity.
    Vec2 chord_position(std::uint32_t body, double now) const {
        const ContactPath& path = (*this)[body];
        return path.chord.position_at(std::min(now, path.end));
    }
    Vec2 chord_velocity(std::uint32_t body, double now) const {
        const ContactPath& path = (*this)[body];
        return now < path.end ? path.chord.velocity : Vec2{};
    }

    /// Starts free flight from where the ball is at `now`. Returns the time at which it leaves its
    /// skin, and so freezes; none if it does not leave it in this substep.
    std::optional<double> redirect(std::uint32_t body, double now, Vec2 velocity,
                                   double surface_speed);
    /// From `now` on the ball rolls along a piece of a curve, whose normal is `normal`, or flies
    /// off. Returns the time as `redirect` does.
    std::optional<double> roll_on(std::uint32_t body, double now, Vec2 velocity,
                                  double surface_speed, Vec2 normal);
    /// The time, s in the substep, whose velocity and surface speed a ball has that rolls on along
    /// a curve: now if it is free, else the end of the substep, since no more impulses follow.
    double rolling_time(std::uint32_t body, double now) const {
        return (*this)[body].is_free ? now : step_.duration;
    }
    /// Shortens the path to where it leaves the skin, and says when.
    std::optional<double> end_at_skin(std::uint32_t body, double now);
    /// The ball has been pushed by a kinematic body; after `most_pushes` it freezes and stops.
    void count_push(std::uint32_t body, double now);
    void freeze(std::uint32_t body, double now);
    /// Freezes the body if its path leads against `normal`, which points to it from what it ran
    /// into. Called where the two no longer approach, but would meet again at once, without end.
    void freeze_at(std::uint32_t body, Vec2 normal, double now);
    /// Calls freeze_at for `body` if `other`, which it ran into, is frozen.
    void freeze_pushed(std::uint32_t other, std::uint32_t body, Vec2 normal, double now);

  private:
    static constexpr std::uint32_t none = 0xffffffffu;

    bool has_path(std::uint32_t body) const {
        return bodies_.is_ball(body) && place_[body] != none;
    }
    void note_given(ContactPath& path, double now) const;
    void reverse_undelivered_impulses() const;
    bool keeps_impulses(std::uint32_t body) const;
    void reverse_undelivered_impulse(ContactPair& constraint) const;

    const ContactSubstep& step_;
    ContactBodies& bodies_;
    ContactPairs& pairs_;
    std::vector<ContactPath> paths_;
    std::vector<std::uint32_t> place_;  // by body, in paths_
    std::vector<std::uint32_t> standing_;
};

}  // namespace carom

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/contact/classification.h"
#include "physics/contact/constraints.h"
#include "physics/contact/energy.h"
#include "physics/contact/hinges.h"
#include "physics/contact/impacts.h"
#include "physics/contact/kinematics.h"
#include "physics/contact/reference_positions.h"

namespace carom {

/// The solver `contact`: for piles, bins, resting contact and thousands of balls that touch.
///
/// A tick is cut into substeps. In each, soft constraints with warm starting hold apart the pairs
/// that touch without bouncing; pairs that bounce collide at their time of impact, as in `swept`.
/// README.md in this folder has the substep in pseudo-code, the invariants and the sources;
/// tolerances.h has the thresholds.
///
/// Free flight is exact, an elastic bounce keeps the energy to rounding, no body passes through
/// another (but for moving edges as under `swept`), and a bounce that would rise no higher than
/// about g h^2 for a substep of h seconds is lost. Pressed bodies overlap slightly, the more the
/// heavier the load.
///
/// Where nothing in a scene can press, `swept` stands in for it: swept_fallback.h.
class ContactSolver {
  public:
    ContactSolver() = default;
    // Its parts refer to one another.
    ContactSolver(const ContactSolver&) = delete;
    ContactSolver& operator=(const ContactSolver&) = delete;

    /// Moves everything by one tick and appends the exchanges to `contacts`: impacts, and each
    /// constraint once, when it begins to press. Sets `touched` for the balls that press on
    /// something at the end of the tick, or when all pairs are found anew in the middle of it.
    /// Pre: `substeps` >= 1.
    ///
    /// In a strict tick constraints are not trusted to separate bodies: a pair that overlaps by
    /// `strict_overlap` collides until it approaches no more, which costs more, and piles settle
    /// more slowly. For ticks in which hands have squashed something otherwise (tick/hands.h).
    void tick(World& world, int substeps, std::vector<Contact>& contacts,
              std::vector<std::uint8_t>& touched, bool is_strict = false);

    /// What constraints gave balls that kinematic bodies press in the last tick, and `contacts`
    /// does not report: an entry for each constraint and substep. One that `contacts` does report
    /// stands here once more, with its impulse below 0, so that the sum of both is what the pair
    /// gave.
    std::span<const Contact> pressing() const { return kinematics_.pressing(); }
    /// The cells in which the last tick looked for pairs.
    const CellFrame& cells() const { return pairs_.frame(); }
    /// The balls for which time has stood still in the last tick, by index, with repetitions.
    std::span<const std::uint32_t> standing() const { return impacts_.standing(); }

  private:
    void begin(World& world);
    bool has_pairs_of(const World& world) const;
    void load(World& world);
    bool must_start_anew(const World& world) const;
    void start_anew(World& world);
    void follow_leaving(World& world);
    void store(World& world, std::vector<std::uint8_t>& touched);
    void substep(World& world, double share_of_displacement, std::vector<Contact>& contacts);
    void advance_positions(const World& world);

    ContactSubstep step_;
    SkinSizes sizes_;
    ContactBodies bodies_;
    ContactPairs pairs_;
    ContactKinematics kinematics_;
    Stamps stamps_;  // of the world for which the pairs were found
    ContactClassification classification_{step_, bodies_, pairs_, kinematics_};
    ContactEnergy energy_{step_, bodies_, pairs_};
    ContactConstraints constraints_{step_, bodies_, pairs_, classification_, energy_};
    ContactHinges hinges_{step_, bodies_, pairs_, kinematics_, classification_};
    ContactImpacts impacts_{step_, bodies_, pairs_, kinematics_, classification_};
    std::vector<std::uint32_t> leaving_;  // bodies that could leave their skins
    bool is_reloaded_ = false;            // the pairs are not those of the last substep
};

}  // namespace carom

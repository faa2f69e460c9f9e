#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/contact/bodies.h"
#include "physics/contact/constraint_order.h"
#include "physics/contact/contact_memory.h"
#include "physics/tick/kinematic.h"

namespace carom {

/// The pairs of the solver `contact`: all that could meet while every ball stays within its skin,
/// in the order in which constraints are solved, with the impulses of the last tick.
///
/// A tick calls `sort`, ContactBodies::load, `find`, ContactKinematics::load and `load`, in this
/// order. The result depends on the world alone.
class ContactPairs {
  public:
    /// Fills in `bodies.ball`: the balls cell by cell.
    void sort(const World& world, ContactBodies& bodies);
    /// Finds the pairs of balls, and of balls and edges that nobody holds.
    void find(const World& world, const ContactBodies& bodies);
    /// Adds the pairs of kinematic edges, each with a body of its own; orders the pairs; takes over
    /// the impulses of ContactMemory::contacts.
    void load(const World& world, const ContactSubstep& step, ContactBodies& bodies,
              std::span<const HeldEdge> edges);

    /// Writes ContactMemory::contacts: every pair that presses, ascending by its first ball. Marks
    /// their balls in `touched` (by index in the world).
    void store_impulses(World& world, const ContactBodies& bodies,
                        std::vector<std::uint8_t>& touched);

    std::vector<ContactPair>& all() { return pairs_; }
    ContactPair& operator[](std::uint32_t p) { return pairs_[p]; }
    const ContactPair& operator[](std::uint32_t p) const { return pairs_[p]; }
    std::uint32_t size() const { return static_cast<std::uint32_t>(pairs_.size()); }

    /// Indices of the pairs of which one body is kinematic.
    std::span<const std::uint32_t> kinematic() const { return kinematic_; }
    /// Whether some pair has a restitution above 0 and below 1.
    bool any_inelastic() const { return any_inelastic_; }

    /// Pre for `of_body`: lists the pairs by ball, unless that is done already.
    void list_by_body(const ContactBodies& bodies);
    /// Indices of the pairs of a ball.
    std::span<const std::uint32_t> of_body(std::uint32_t body) const {
        return std::span(by_body_).subspan(begin_[body], begin_[body + 1] - begin_[body]);
    }

    const CellFrame& frame() const { return near_.frame(); }

  private:
    ContactPair pair_of(const World& world, const ContactBodies& bodies, const NearPair& near,
                        std::span<const PersistentContact> last) const;
    void add_pairs_of_edge(const World& world, ContactBodies& bodies, const HeldEdge& edge);
    void index_impulses(const World& world, const ContactBodies& bodies,
                        std::span<const PersistentContact> last);
    const PersistentContact* last_impulse(const World& world, const ContactBodies& bodies,
                                          const ContactPair& pair,
                                          std::span<const PersistentContact> last) const;

    NearPairs near_;
    ConstraintOrder order_;
    std::vector<ContactPair> pairs_;
    std::vector<std::uint32_t> kinematic_;
    std::vector<std::uint32_t> first_impulse_;  // by index of a ball: into ContactMemory::contacts
    bool any_inelastic_ = false;
    bool is_listed_by_body_ = false;
    std::vector<std::uint32_t> begin_;  // by body, into by_body_
    std::vector<std::uint32_t> by_body_;
};

}  // namespace carom

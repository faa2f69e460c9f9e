#pragma once

#include <cstdint>
#include <iterator>
#include <span>
#include <tuple>
#include <vector>

#include "physics/contact/bodies.h"
#include "physics/contact/constraint_order.h"
#include "physics/contact/contact_memory.h"
#include "physics/contact/pair_rows.h"
#include "physics/tick/kinematic.h"

namespace carom {

/// The pairs of one ball, as a linked list: a range of their indices. A link is twice the index of
/// a pair, and one more if the ball is its `b`.
class PairChain {
  public:
    static constexpr std::uint32_t none = 0xffffffffu;

    PairChain(const std::uint32_t* next, std::uint32_t link) : next_(next), link_(link) {}
    PairChain begin() const { return *this; }
    static std::default_sentinel_t end() { return {}; }
    std::uint32_t operator*() const { return link_ / 2; }
    PairChain& operator++() {
        link_ = next_[link_];
        return *this;
    }
    bool operator==(std::default_sentinel_t) const { return link_ == none; }

  private:
    const std::uint32_t* next_;
    std::uint32_t link_;
};

/// The pairs of the solver `contact`: all that could meet while every ball stays within its skin,
/// in the order in which constraints are solved, with the impulses of the last tick.
///
/// A solver that has no pairs yet calls `find`, ContactBodies::load, ContactKinematics::load and
/// `load`, in this order. One that has them calls `update`. Both give the same pairs in the same
/// order, which depends on the world alone. README.md, "The life of a pair", says when.
class ContactPairs {
  public:
    /// Finds the pairs of balls, and of balls and edges that nobody holds. Gives the balls an order
    /// (ReferencePositions::order), unless they have one: cell by cell.
    void find(World& world);
    /// Adds the pairs of kinematic edges, each with a body of its own; orders the pairs; takes over
    /// the impulses of ContactMemory::contacts.
    void load(const World& world, const ContactSubstep& step, ContactBodies& bodies,
              std::span<const HeldEdge> edges);
    /// The balls of `moved` (bodies) have new reference positions: appends the new pairs that they
    /// form now, out of order, until `update`. Pre of both: nothing is held, and the scene is no
    /// torus.
    void add(const World& world, const ContactBodies& bodies, std::span<const std::uint32_t> moved);
    /// Replaces the pairs of the balls of `moved`, and of those that `add` was given since the last
    /// `update`; puts all pairs in order. Pairs that stay keep their impulses. Cost: linear in
    /// pairs.
    void update(const World& world, const ContactSubstep& step, const ContactBodies& bodies,
                std::span<const std::uint32_t> moved);
    /// Whether there are pairs that are not in order yet.
    bool has_added() const { return !added_.empty(); }

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
    /// Whether the balls of some pair have a high mass ratio.
    bool any_high_mass_ratio() const { return any_high_mass_ratio_; }

    /// Pre for `of_body`: lists the pairs by ball, unless that is done already.
    void list_by_body(const ContactBodies& bodies);
    /// Indices of the pairs of a ball.
    PairChain of_body(std::uint32_t body) const { return {next_link_.data(), first_link_[body]}; }

    const CellFrame& frame() const { return near_.frame(); }

  private:
    /// What tells pairs of bodies apart.
    using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::int8_t, std::int8_t>;
    struct Known {
        Key key;
        std::uint32_t pair = 0;  ///< index
    };

    void find_moved(const World& world, const ContactBodies& bodies,
                    std::span<const std::uint32_t> moved);
    bool is_of_moved(const ContactPair& pair, const ContactBodies& bodies) const;
    void sort_known();
    const Known* known(const Key& key) const;
    void carry_over(const World& world, const ContactBodies& bodies);
    void link(std::uint32_t p, const ContactBodies& bodies);
    void note_kind(std::uint32_t p);
    ContactPair pair_of(const World& world, const ContactBodies& bodies, const NearPair& near,
                        std::span<const PersistentContact> last) const;
    void add_pairs_of_edge(const World& world, ContactBodies& bodies, const HeldEdge& edge);
    void index_impulses(const World& world, const ContactBodies& bodies,
                        std::span<const PersistentContact> last);
    const PersistentContact* last_impulse(const World& world, const ContactBodies& bodies,
                                          const ContactPair& pair,
                                          std::span<const PersistentContact> last) const;

    NearPairs near_;
    PairRows rows_;
    ConstraintOrder order_;
    std::vector<std::uint32_t> body_of_;  // by ball
    std::vector<ContactPair> pairs_;
    std::vector<std::uint32_t> kinematic_;
    std::vector<std::uint32_t> first_impulse_;  // by index of a ball: into ContactMemory::contacts
    bool any_inelastic_ = false;
    bool any_high_mass_ratio_ = false;
    bool is_listed_by_body_ = false;
    std::vector<std::uint32_t> first_link_;  // by body
    std::vector<std::uint32_t> next_link_;   // by link
    std::vector<std::uint32_t> added_;       // bodies with new reference positions since `update`
    // While pairs are added or updated.
    std::vector<std::uint32_t> moved_;     // balls
    std::vector<std::uint8_t> has_moved_;  // by body
    std::vector<Known> known_;             // by key
    std::vector<std::uint32_t> source_;    // by near pair: its index before
    std::vector<std::uint32_t> turn_of_;   // by near pair, before
    std::vector<ContactPair> before_;
};

}  // namespace carom

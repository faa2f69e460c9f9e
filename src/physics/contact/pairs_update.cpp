#include "physics/contact/pairs.h"

#include <algorithm>
#include <utility>

// How ContactPairs follows balls that get new reference positions.
namespace carom {
namespace {

template <typename Pair>
auto key_of(const Pair& pair) {
    return std::tuple(pair.a, pair.b, pair.edge, pair.across, pair.along);
}

}  // namespace

// Leaves their pairs in `near_`.
void ContactPairs::find_moved(const World& world, const ContactBodies& bodies,
                              std::span<const std::uint32_t> moved) {
    has_moved_.assign(bodies.fixed, 0);
    moved_.clear();
    for (const std::uint32_t body : moved) {
        if (std::exchange(has_moved_[body], std::uint8_t{1}) == 0)
            moved_.push_back(bodies.ball[body]);
    }
    const ReferencePositions& reference = contact_memory(world).reference;
    near_.find_moved(world, {reference.position, reference.skin}, moved_);
}

bool ContactPairs::is_of_moved(const ContactPair& pair, const ContactBodies& bodies) const {
    return has_moved_[pair.a] != 0 || (bodies.is_ball(pair.b) && has_moved_[pair.b] != 0);
}

void ContactPairs::sort_known() {
    std::ranges::sort(known_, {}, &Known::key);
}

const ContactPairs::Known* ContactPairs::known(const Key& key) const {
    const auto found = std::ranges::lower_bound(known_, key, {}, &Known::key);
    return found != known_.end() && found->key == key ? &*found : nullptr;
}

void ContactPairs::add(const World& world, const ContactBodies& bodies,
                       std::span<const std::uint32_t> moved) {
    find_moved(world, bodies, moved);
    added_.insert(added_.end(), moved.begin(), moved.end());
    known_.clear();
    for (std::uint32_t p = 0; p < size(); ++p)
        if (is_of_moved(pairs_[p], bodies)) known_.push_back({key_of(pairs_[p]), p});
    sort_known();
    for (NearPair near : near_.pairs()) {
        near = PairRows::of_bodies(near, body_of_);
        if (known(key_of(near))) continue;
        pairs_.push_back(pair_of(world, bodies, near, {}));
        note_kind(size() - 1);
        if (!is_listed_by_body_) continue;
        next_link_.resize(2 * pairs_.size());
        link(size() - 1, bodies);
    }
}

void ContactPairs::update(const World& world, const ContactSubstep& step,
                          const ContactBodies& bodies, std::span<const std::uint32_t> moved) {
    const auto in_order = static_cast<std::uint32_t>(rows_.pairs().size());
    turn_of_.resize(in_order);
    for (std::uint32_t p = 0; p < in_order; ++p)
        turn_of_[order_[p]] = p;
    known_.clear();
    for (std::uint32_t p = in_order; p < size(); ++p)
        known_.push_back({key_of(pairs_[p]), p});
    sort_known();
    added_.insert(added_.end(), moved.begin(), moved.end());
    find_moved(world, bodies, added_);
    added_.clear();
    rows_.replace(near_.pairs(), body_of_, has_moved_);
    order_.arrange(rows_.pairs(), bodies.reference, step.gravity);
    carry_over(world, bodies);
}

// What pairs that were there before know, they keep.
void ContactPairs::carry_over(const World& world, const ContactBodies& bodies) {
    rows_.find_sources(source_);
    std::swap(before_, pairs_);
    const std::span<const NearPair> near = rows_.pairs();
    pairs_.resize(near.size());
    any_inelastic_ = any_high_mass_ratio_ = false;
    is_listed_by_body_ = false;
    kinematic_.clear();
    for (std::uint32_t p = 0; p < near.size(); ++p) {
        const NearPair& now = near[order_[p]];
        const std::uint32_t source = source_[order_[p]];
        if (source != PairRows::none)
            pairs_[p] = before_[turn_of_[source]];
        else if (const Known* const then = known(key_of(now)))
            pairs_[p] = before_[then->pair];
        else
            pairs_[p] = pair_of(world, bodies, now, {});
        forget_unless_pressing(pairs_[p]);
        note_kind(p);
    }
}

}  // namespace carom

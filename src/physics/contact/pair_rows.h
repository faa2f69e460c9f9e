#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/broad_phase/near_pairs.h"

namespace carom {

/// Near pairs by body, in one order, however they were found: by the lower of both bodies, then by
/// the other body, the edge, and its image. So the order is the same whether all pairs were found
/// at once, or those of a few balls later.
///
/// Here `a` and `b` of a NearPair are bodies; `a` is still the ball of lower index. Cost: linear in
/// pairs and bodies. Memory is kept from call to call.
class PairRows {
  public:
    static constexpr std::uint32_t none = 0xffffffffu;

    /// `pair` with bodies in place of balls.
    static NearPair of_bodies(NearPair pair, std::span<const std::uint32_t> body_of) {
        const bool is_on_edge = pair.edge != NearPair::no_edge;
        pair.a = body_of[pair.a];
        if (!is_on_edge) pair.b = body_of[pair.b];
        return pair;
    }

    /// All pairs anew. `body_of`: by ball.
    void assign(std::span<const NearPair> found, std::span<const std::uint32_t> body_of);
    /// Replaces the pairs of the bodies that have moved (by body: not 0).
    void replace(std::span<const NearPair> found, std::span<const std::uint32_t> body_of,
                 std::span<const std::uint8_t> has_moved);
    /// Changes after which `assign` must come before the next `replace`.
    void append(const NearPair& pair) { now_.pairs.push_back(pair); }
    template <typename IsGone>
    void erase_if(IsGone&& is_gone) {
        std::erase_if(now_.pairs, is_gone);
    }

    std::span<const NearPair> pairs() const { return now_.pairs; }
    /// By pair: its index before the last `replace`, or `none`.
    void find_sources(std::vector<std::uint32_t>& source) const;

  private:
    struct Rows {
        std::vector<NearPair> pairs;
        std::vector<std::uint32_t> begin;  ///< by body, and one more
    };
    static void sort(std::span<const NearPair> found, std::span<const std::uint32_t> body_of,
                     Rows& rows);

    Rows now_;
    Rows before_;
    Rows found_;
};

}  // namespace carom

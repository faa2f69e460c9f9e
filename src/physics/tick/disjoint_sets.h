#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace carom {

/// Disjoint sets of the nodes 0 to n - 1 (union-find with path halving). The root of a set is its
/// least node, so it does not depend on the order in which sets were united.
class DisjointSets {
  public:
    /// Each node is a set of its own.
    void reset(std::size_t nodes) {
        parent_.resize(nodes);
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::size_t size() const { return parent_.size(); }
    std::uint32_t root_of(std::uint32_t node) {
        while (parent_[node] != node)
            node = parent_[node] = parent_[parent_[node]];
        return node;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        a = root_of(a);
        b = root_of(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace carom

#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes.h"

/// A static bounding-volume hierarchy: finds the boxes that overlap a given box.
namespace carom {

/// Cost: building takes O(n log n). A query takes O(log n) for each box found, and more where long
/// boxes cross.
class BoxTree {
  public:
    explicit BoxTree(std::vector<Box> boxes);

    /// Calls `visit(index)` for each box that overlaps `box`, until a call returns false. The order
    /// depends on the boxes alone. Returns how many nodes of the tree it looked at.
    template <typename Visit>
    std::uint64_t query(const Box& box, Visit visit) const {
        if (nodes_.empty()) return 0;
        std::uint64_t looks = 0;
        std::vector<std::uint32_t>& stack = stack_;
        stack.assign(1, 0);
        while (!stack.empty()) {
            const Node node = nodes_[stack.back()];
            stack.pop_back();
            ++looks;
            if (!overlaps(node.box, box)) continue;
            if (node.count == 0) {
                stack.push_back(node.first + 1);
                stack.push_back(node.first);
                continue;
            }
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                if (overlaps(boxes_[order_[i]], box) && !visit(order_[i])) return looks;
            }
        }
        return looks;
    }

  private:
    struct Node {
        Box box;
        std::uint32_t first =
            0;  ///< index of its entries in order_, or of its two children in nodes_
        std::uint32_t count = 0;  ///< entries; 0: an inner node
    };
    void split(std::uint32_t node);

    std::vector<Box> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
    mutable std::vector<std::uint32_t> stack_;
};

}  // namespace carom

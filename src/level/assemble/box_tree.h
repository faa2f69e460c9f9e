#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes.h"

/// Which of many boxes overlap a box: a static tree, whatever the sizes of the boxes.
namespace carom {

/// Building takes n log n, a query log n for each box found, unless the boxes are long and cross.
class BoxTree {
  public:
    explicit BoxTree(std::vector<Box> boxes);

    /// Calls `visit(index)` for the boxes that overlap `box`, in a fixed order, until it returns
    /// false.
    template <typename Visit>
    void query(const Box& box, Visit visit) const {
        if (nodes_.empty()) return;
        std::vector<std::uint32_t>& stack = stack_;
        stack.assign(1, 0);
        while (!stack.empty()) {
            const Node node = nodes_[stack.back()];
            stack.pop_back();
            if (!overlaps(node.box, box)) continue;
            if (node.count == 0) {
                stack.push_back(node.first + 1);
                stack.push_back(node.first);
                continue;
            }
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                if (overlaps(boxes_[order_[i]], box) && !visit(order_[i])) return;
            }
        }
    }

  private:
    struct Node {
        Box box;
        std::uint32_t first = 0;  ///< of its entries in order_, or of its two children
        std::uint32_t count = 0;  ///< 0: it has children
    };
    void split(std::uint32_t node);

    std::vector<Box> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
    mutable std::vector<std::uint32_t> stack_;
};

}  // namespace carom

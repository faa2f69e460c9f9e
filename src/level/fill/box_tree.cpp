#include "level/fill/box_tree.h"

#include <algorithm>
#include <numeric>

namespace carom {
namespace {

constexpr std::uint32_t leaf_size = 8;

}  // namespace

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    if (boxes_.empty()) return;
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.push_back({{}, 0, static_cast<std::uint32_t>(boxes_.size())});
    // Children follow their parents in nodes_, so this loop splits every node without recursion.
    for (std::uint32_t i = 0; i < nodes_.size(); ++i)
        split(i);
}

void BoxTree::split(std::uint32_t index) {
    const std::uint32_t first = nodes_[index].first;
    const std::uint32_t count = nodes_[index].count;
    Box around = boxes_[order_[first]];
    for (std::uint32_t i = first; i < first + count; ++i)
        around = join(around, boxes_[order_[i]]);
    nodes_[index].box = around;
    if (count <= leaf_size) return;

    // Split at the median centre along the longer side. Ties go by index, so that the tree depends
    // on the boxes alone.
    const bool along_x = size(around).x >= size(around).y;
    const auto key = [&](std::uint32_t i) {
        const Vec2 middle = center(boxes_[i]);
        return along_x ? middle.x : middle.y;
    };
    const auto from = order_.begin() + first;
    const std::uint32_t half = count / 2;
    std::nth_element(from, from + half, from + count, [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(key(a), a) < std::pair(key(b), b);
    });
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    nodes_[index].first = children;
    nodes_[index].count = 0;
    nodes_.push_back({{}, first, half});
    nodes_.push_back({{}, first + half, count - half});
}

}  // namespace carom

#include "physics/capsule_cells.h"

#include <algorithm>

namespace carom {
namespace {

struct Span {
    double low = 0.0;
    double high = 0.0;
};

// The x range of the part of segment a..b whose y lies in low..high. Pre: some part does.
Span part_between(Vec2 a, Vec2 b, double low, double high) {
    if (a.y > b.y) std::swap(a, b);
    const auto x_at = [&](double y) {
        if (y <= a.y) return a.x;
        if (y >= b.y) return b.x;
        return a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
    };
    const double x0 = x_at(low);
    const double x1 = x_at(high);
    return {std::min(x0, x1), std::max(x0, x1)};
}

}  // namespace

bool is_held(const World& world, CapsuleId id) {
    return std::ranges::any_of(world.held_capsules,
                               [id](const HeldCapsule& held) { return held.id == id; });
}

bool CapsuleCells::is_current(const World& world, const CellFrame& frame, double margin) const {
    if (!(frame == frame_) || margin != margin_ || shapes_.size() != world.capsules.size())
        return false;
    if (!std::ranges::equal(held_, world.held_capsules, {}, {}, &HeldCapsule::id)) return false;
    if (held_.empty()) return shapes_ == world.capsules.shape;
    for (std::size_t i = 0; i < shapes_.size(); ++i)
        if (!(shapes_[i] == world.capsules.shape[i]) && !is_held(world, world.capsules.id[i]))
            return false;
    return true;
}

// Row by row, the cells under the part of the capsule in that row. Rows and columns at the border
// reach outwards without end.
template <typename Visit>
void CapsuleCells::for_each_cell(const Capsule& shape, Visit&& visit) const {
    const double reach = shape.radius + margin_;
    const Box box = grow(join({shape.start, shape.start}, {shape.end, shape.end}), reach);
    const int low = frame_.row(box.low.y);
    const int high = frame_.row(box.high.y);
    for (int row = low; row <= high; ++row) {
        const double bottom = frame_.origin.y + row * frame_.cell.y;
        const double from = row == 0 ? box.low.y : bottom;
        const double to = row == frame_.rows - 1 ? box.high.y : bottom + frame_.cell.y;
        // A hair wider than the row, so that rounding loses nothing.
        const double slack = reach + 1e-9 * frame_.cell.y;
        const Span part = part_between(shape.start, shape.end, from - slack, to + slack);
        const double hair = 1e-9 * frame_.cell.x;
        const int last = frame_.column(part.high + reach + hair);
        for (int column = frame_.column(part.low - reach - hair); column <= last; ++column)
            visit(frame_.index(column, row));
    }
}

void CapsuleCells::update(const World& world, const CellFrame& frame, double margin) {
    if (is_current(world, frame, margin)) return;
    frame_ = frame;
    margin_ = margin;
    shapes_ = world.capsules.shape;
    held_.clear();
    for (const HeldCapsule& held : world.held_capsules)
        held_.push_back(held.id);

    // On a torus every image that reaches the torus counts; the frame itself is walked as if it
    // ended.
    const bool wraps = frame.wraps;
    frame_.wraps = false;
    const Vec2 torus = wraps ? size(*world.model.wrap) : Vec2{};
    const Box whole = wraps ? *world.model.wrap : Box{};
    const auto for_each_entry = [&](auto&& visit) {
        for (std::uint32_t i = 0; i < shapes_.size(); ++i) {
            if (!held_.empty() && is_held(world, world.capsules.id[i])) continue;
            for (int along = wraps ? -1 : 0; along <= (wraps ? 1 : 0); ++along) {
                for (int across = wraps ? -1 : 0; across <= (wraps ? 1 : 0); ++across) {
                    Capsule image = shapes_[i];
                    const Vec2 shift{across * torus.x, along * torus.y};
                    image.start += shift;
                    image.end += shift;
                    if (wraps && !overlaps(grow(bounds(image), margin_), whole)) continue;
                    for_each_cell(image, [&](std::uint32_t cell) {
                        visit(cell, CapsuleEntry{i, static_cast<std::int8_t>(across),
                                                 static_cast<std::int8_t>(along)});
                    });
                }
            }
        }
    };
    // One place further on until the entries are in: what marks the next free one of a cell then
    // stands where the next cell begins.
    start_.assign(frame.count() + 2, 0);
    for_each_entry([&](std::uint32_t cell, CapsuleEntry) { ++start_[cell + 2]; });
    for (std::size_t i = 2; i < start_.size(); ++i)
        start_[i] += start_[i - 1];
    entries_.resize(start_.back());
    for_each_entry(
        [&](std::uint32_t cell, CapsuleEntry entry) { entries_[start_[cell + 1]++] = entry; });
    frame_.wraps = wraps;
    occupied_.clear();
    for (std::uint32_t cell = 0; cell < frame.count(); ++cell)
        if (start_[cell + 1] != start_[cell]) occupied_.push_back(cell);
}

}  // namespace carom

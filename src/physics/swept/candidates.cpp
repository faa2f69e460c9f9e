#include "physics/swept/candidates.h"

#include <algorithm>

#include "physics/memory/prefetch.h"

namespace carom {
namespace {

// Rounded up to a few binary digits, so that it seldom changes.
double rounded_to_few_bits(double value) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    return std::ldexp(std::ceil(fraction * 16.0) / 16.0, exponent);
}

// Whether one frame is nearly as good as the other.
bool are_alike(const CellFrame& a, const CellFrame& b) {
    if (a.wraps || b.wraps) return a == b;
    const auto along = [](double low_a, double cell_a, int count_a, double low_b, double cell_b,
                          int count_b) {
        const double extent_a = cell_a * count_a;
        const double extent_b = cell_b * count_b;
        const double most = 0.25 * std::min(extent_a, extent_b);
        return std::fabs(low_a - low_b) <= most && std::fabs(extent_a - extent_b) <= most &&
               4.0 * cell_a >= 3.0 * cell_b && 3.0 * cell_a <= 4.0 * cell_b;
    };
    return along(a.origin.x, a.cell.x, a.columns, b.origin.x, b.cell.x, b.columns) &&
           along(a.origin.y, a.cell.y, a.rows, b.origin.y, b.cell.y, b.rows);
}

}  // namespace

void SweptCandidates::find(const World& world) {
    const std::size_t count = world.balls().size();
    centers_.resize(count);
    reaches_.resize(count);
    double extent = 0.0;  // of a typical path; a few very fast balls must not make all cells large
    for (std::uint32_t i = 0; i < count; ++i) {
        const Disc disc = paths_.bounding_disc(world, i, 0.0);
        centers_[i] = world.model().wrap ? wrapped(disc.center, *world.model().wrap) : disc.center;
        reaches_[i] = disc.radius;
        extent += std::min(2.0 * disc.radius, 10.0 * world.balls().radius[i]);
    }
    neighbours_.build(world, centers_, reaches_);
    neighbours_.sort_pairs();
    const CellFrame frame = frame_around(
        world, count == 0 ? 1.0 : rounded_to_few_bits(extent / static_cast<double>(count)));
    // Edges stay in their cells while those still fit fairly.
    are_all_in_cells_ = false;
    changed_paths_ = 0;
    cells_.reset(are_alike(frame, cells_.frame()) ? cells_.frame() : frame, count);
    if (world.model().ball_edge && !neighbours_.has_map())
        edges_.update(world, cells_.frame(), 0.0);
}

Vec2 SweptCandidates::image_offset(const World& world, std::uint32_t ball) const {
    const Vec2 from_image = paths_.bounding_disc(world, ball, 0.0).center - centers_[ball];
    return {std::floor(from_image.x / step_.torus.x + 0.5),
            std::floor(from_image.y / step_.torus.y + 0.5)};
}

void SweptCandidates::note_change(const World& world, std::uint32_t ball, double now,
                                  bool is_first) {
    if (is_first) ++changed_paths_;
    cells_.enter(ball, paths_.bounding_box(world, ball, now), is_first && !are_all_in_cells_);
}

void SweptCandidates::merge_if_many_changed(const World& world) {
    if (are_all_in_cells_ || 4 * changed_paths_ <= paths_.size()) return;
    for (std::uint32_t i = 0; i < paths_.size(); ++i)
        if (paths_[i].version == 0) cells_.enter(i, paths_.bounding_box(world, i, 0.0), true);
    are_all_in_cells_ = true;
}

void SweptCandidates::prefetch_paths(Vec2 place) const {
    neighbours_.grid().for_each_around(place,
                                       [&](std::uint32_t ball) { prefetch_line(&paths_[ball]); });
}

}  // namespace carom

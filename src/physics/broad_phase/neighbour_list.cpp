#include "physics/broad_phase/neighbour_list.h"

#include <algorithm>

#include "geometry/closest.h"
#include "physics/memory/prefetch.h"

namespace carom {

bool overlaps_edge(const World& world, const EdgePair& pair, const Disc& disc) {
    Capsule shape = world.capsules().shape[pair.capsule];
    if (world.model().wrap) {
        const Vec2 torus = size(*world.model().wrap);
        const Vec2 shift{pair.across * torus.x, pair.along * torus.y};
        shape.start += shift;
        shape.end += shift;
    }
    const Vec2 offset = disc.center - closest_point(shape.start, shape.end, disc.center);
    const double reach = disc.radius + shape.radius;
    return length_squared(offset) < reach * reach;
}

// Few as they are; else by the first ball, counting, in about as many ranges of balls as there are
// pairs; then the few of each.
void PairOrder::sort(std::vector<BallPair>& pairs, std::size_t balls) {
    if (pairs.size() < 64) {
        std::ranges::sort(pairs);
        return;
    }
    int shift = 0;
    while (balls >> shift > 2 * pairs.size())
        ++shift;
    start_.assign((balls >> shift) + 1, 0);
    for (const BallPair& pair : pairs)
        ++start_[pair.first >> shift];
    std::uint32_t end = 0;
    for (std::uint32_t& start : start_)
        start = end += start;
    sorted_.resize(pairs.size());
    for (const BallPair& pair : pairs)
        sorted_[--start_[pair.first >> shift]] = pair;
    for (std::size_t i = 1; i < sorted_.size(); ++i) {
        const BallPair pair = sorted_[i];
        std::size_t at = i;
        for (; at > 0 && pair < sorted_[at - 1]; --at)
            sorted_[at] = sorted_[at - 1];
        sorted_[at] = pair;
    }
    pairs.swap(sorted_);
}

void Neighbours::look(const World& world, double margin) {
    const Balls& balls = world.balls();
    margin_ = margin;
    furthest_ = 0.0;
    push_ = 0.25;
    has_map_ = false;
    reference_.clear();
    radius_.clear();
    if (margin > 0.0) {
        reference_ = balls.position;
        radius_ = balls.radius;
        note_scene(world);
    }
    note(world, balls.position, balls.radius);
}

void Neighbours::look(const World& world, std::span<const Vec2> centers,
                      std::span<const double> radii) {
    margin_ = 0.0;
    push_ = 0.0;
    has_map_ = EdgeMap::suits(world);
    note(world, centers, radii);
}

void Neighbours::note(const World& world, std::span<const Vec2> centers,
                      std::span<const double> radii) {
    torus_ = world.model().wrap ? size(*world.model().wrap) : Vec2{};
    grid_.build(centers, radii, margin_, world.model().wrap);
    balls_ = centers.size();
    pairs_.clear();
    if (world.model().ball_ball)
        grid_.for_each_pair([&](std::uint32_t a, std::uint32_t b) {
            pairs_.push_back({std::min(a, b), std::max(a, b)});
        });
    others_start_.clear();
    look_for_edges(world, centers, radii);
}

void Neighbours::look_for_edges(const World& world, std::span<const Vec2> centers,
                                std::span<const double> radii) {
    for (const EdgePair& pair : edges_)
        if (pair.ball < has_edges_.size()) has_edges_[pair.ball] = 0;
    edges_.clear();
    has_edges_.resize(centers.size(), 0);
    if (!world.model().ball_edge) {
        cells_of_edges_.clear();
        return;
    }
    has_map_ ? look_on_map(world, centers, radii) : look_in_cells(world, centers, radii);
    std::sort(edges_.begin(), edges_.end());
    for (const EdgePair& pair : edges_)
        has_edges_[pair.ball] = 1;
}

void Neighbours::look_in_cells(const World& world, std::span<const Vec2> centers,
                               std::span<const double> radii) {
    // Not fewer: levels come and go with the lengths of paths.
    if (cells_of_edges_.size() < grid_.levels()) cells_of_edges_.resize(grid_.levels());
    for (std::size_t level = 0; level < grid_.levels(); ++level) {
        const CellFrame& frame = grid_.frame(level);
        CapsuleCells& cells = cells_of_edges_[level];
        cells.update(world, frame, (1.0 + push_) * grid_.reach(level));
        for (const std::uint32_t cell : cells.occupied()) {
            const int column = static_cast<int>(cell % static_cast<std::uint32_t>(frame.columns));
            const int row = static_cast<int>(cell / static_cast<std::uint32_t>(frame.columns));
            grid_.for_each_in_cell(level, column, row, [&](std::uint32_t ball) {
                for (const CapsuleEntry entry : cells.in_cell(cell)) {
                    const EdgePair pair{ball, entry.index, entry.along, entry.across};
                    const double reach = radii[ball] + edge_margin(radii[ball]);
                    if (overlaps_edge(world, pair, {centers[ball], reach})) edges_.push_back(pair);
                }
            });
        }
    }
}

void Neighbours::look_on_map(const World& world, std::span<const Vec2> centers,
                             std::span<const double> radii) {
    map_.update(world);
    for (std::uint32_t ball = 0; ball < centers.size(); ++ball) {
        const Disc disc{centers[ball], radii[ball] + edge_margin(radii[ball])};
        map_.for_each_near(bounds(disc), [&](std::uint32_t capsule) {
            const EdgePair pair{ball, capsule, 0, 0};
            if (overlaps_edge(world, pair, disc)) edges_.push_back(pair);
        });
    }
}

// The square of how far a ball has gone since the look that is now at `position`.
double Neighbours::gone(std::uint32_t ball, Vec2 position) const {
    Vec2 way = position - reference_[ball];
    if (torus_.x > 0.0) way = nearest_image(way, torus_);
    return length_squared(way);
}

bool Neighbours::covers(std::uint32_t ball, Vec2 position) const {
    return margin_ > 0.0 && gone(ball, position) <= room();
}

bool Neighbours::note_place(std::uint32_t ball, Vec2 position) {
    if (!(margin_ > 0.0)) return false;
    const double square = gone(ball, position);
    furthest_ = std::max(furthest_, square);
    return square <= room();
}

void Neighbours::note_scene(const World& world) {
    shapes_ = world.capsules().shape;
    stamp_ = world.stamps().capsules;
    held_.clear();
    for (const HeldCapsule& held : world.held_capsules())
        held_.push_back(held.id);
    meet_balls_ = world.model().ball_ball;
    meet_edges_ = world.model().ball_edge;
}

// Edges that were in hands and still are may have moved.
bool Neighbours::is_scene_of(const World& world) const {
    const Capsules& capsules = world.capsules();
    if (meet_balls_ != world.model().ball_ball || meet_edges_ != world.model().ball_edge)
        return false;
    if (shapes_.size() != capsules.size()) return false;
    if (!std::ranges::equal(held_, world.held_capsules(), {}, {}, &HeldCapsule::id)) return false;
    if (stamp_ == world.stamps().capsules) return true;
    for (std::size_t i = 0; i < shapes_.size(); ++i)
        if (shapes_[i] != capsules.shape[i] && !is_held(world, capsules.id[i])) return false;
    return true;
}

bool Neighbours::cover(const World& world) {
    const Balls& balls = world.balls();
    if (!(margin_ > 0.0) || radius_ != balls.radius) return false;
    if (torus_ != (world.model().wrap ? size(*world.model().wrap) : Vec2{})) return false;
    if (!is_scene_of(world)) return false;
    furthest_ = 0.0;
    for (std::uint32_t i = 0; i < balls.size(); ++i)
        if (!note_place(i, balls.position[i])) return false;
    return true;
}

bool Neighbours::cover_after(double way) {
    const double all = std::sqrt(furthest_) + way;
    furthest_ = all * all;
    return margin_ > 0.0 && furthest_ <= room();
}

void Neighbours::list_by_ball() {
    if (!others_start_.empty()) return;
    others_start_.assign(balls_ + 2, 0);
    for (const BallPair& pair : pairs_) {
        ++others_start_[pair.first + 2];
        ++others_start_[pair.second + 2];
    }
    for (std::size_t i = 2; i < others_start_.size(); ++i)
        others_start_[i] += others_start_[i - 1];
    others_.resize(2 * pairs_.size());
    constexpr std::size_t ahead = 16;
    const auto fetch = [&](std::uint32_t ball) { fetch_early(&others_[others_start_[ball + 1]]); };
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        if (p + ahead < pairs_.size()) {
            fetch(pairs_[p + ahead].first);
            fetch(pairs_[p + ahead].second);
        }
        const BallPair& pair = pairs_[p];
        others_[others_start_[pair.first + 1]++] = pair.second;
        others_[others_start_[pair.second + 1]++] = pair.first;
    }
}

std::span<const EdgePair> Neighbours::edges_of(std::uint32_t ball) const {
    if (!has_edges_[ball]) return {};
    const auto first = std::ranges::lower_bound(edges_, ball, {}, &EdgePair::ball);
    auto last = first;
    while (last != edges_.end() && last->ball == ball)
        ++last;
    return {first, last};
}

}  // namespace carom

#include "terminal/draw/trails.h"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

// The level of a trail one picture later: about a third remains after 25 pictures, nothing after
// 70.
std::uint8_t faded(std::uint8_t level) {
    return static_cast<std::uint8_t>(std::max(0, level - level / 24 - 1));
}

// Trails stay behind the balls: a fresh trail is two thirds as strong as a ball.
std::uint8_t shown(std::uint8_t level) {
    return static_cast<std::uint8_t>(level * 2 / 3);
}

void start_anew(Trails& trails, const Camera& camera, const Raster& raster) {
    trails.camera = camera;
    trails.across = raster.samples_across();
    trails.down = raster.samples_down();
    const auto count =
        static_cast<std::size_t>(trails.across) * static_cast<std::size_t>(trails.down);
    trails.levels.assign(count, 0);
    trails.inks.assign(count, {});
    trails.places.clear();
}

// A position on the grid of samples.
struct SamplePoint {
    double across = 0.0;
    double down = 0.0;
};

SamplePoint to_samples(const Trails& trails, Vec2 position) {
    const CellArea& area = trails.camera.area;
    const CellPoint place = to_cells(trails.camera, position);
    return {(place.column - area.column) / area.columns * trails.across,
            (place.row - area.row) / area.rows * trails.down};
}

void mark(Trails& trails, SamplePoint at, const Ink& ink) {
    if (!(at.across >= 0.0 && at.across < trails.across && at.down >= 0.0 &&
          at.down < trails.down)) {
        return;
    }
    const auto i = static_cast<std::size_t>(at.down) * static_cast<std::size_t>(trails.across) +
                   static_cast<std::size_t>(at.across);
    trails.levels[i] = 255;
    trails.inks[i] = ink;
}

void mark_way(Trails& trails, SamplePoint from, SamplePoint to, const Ink& ink) {
    const double across = to.across - from.across;
    const double down = to.down - from.down;
    const double length = std::max(std::abs(across), std::abs(down));
    const double most = trails.across + trails.down;  // longer paths leave the window
    if (!(length <= most)) return mark(trails, to, ink);
    const int steps = std::max(1, static_cast<int>(std::ceil(length)));
    for (int i = 1; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        mark(trails, {from.across + share * across, from.down + share * down}, ink);
    }
}

// Whether a ball that moved from `a` to `b` crossed a side of the torus.
bool has_wrapped(const Model& model, Vec2 a, Vec2 b) {
    if (!model.wrap) return false;
    const Vec2 half = size(*model.wrap) * 0.5;
    return std::abs(a.x - b.x) > half.x || std::abs(a.y - b.y) > half.y;
}

}  // namespace

void add_to_trails(Trails& trails, const Camera& camera, const Raster& raster, const World& world,
                   std::span<const Ink> inks) {
    const bool is_same_view = trails.camera == camera && trails.across == raster.samples_across() &&
                              trails.down == raster.samples_down();
    if (!is_same_view) start_anew(trails, camera, raster);
    if (is_same_view && trails.tick != world.tick()) {
        std::transform(trails.levels.begin(), trails.levels.end(), trails.levels.begin(), faded);
    }
    trails.tick = world.tick();

    // Both lists ascend by id, so a single pass finds each ball's last position.
    std::vector<Trails::Place> places;
    places.reserve(world.balls().size());
    auto before = trails.places.cbegin();
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const BallId id = world.balls().id[i];
        const Vec2 now = world.balls().position[i];
        while (before != trails.places.cend() && before->id < id)
            ++before;
        const bool is_known = before != trails.places.cend() && before->id == id;
        const Vec2 then =
            is_known && !has_wrapped(world.model(), before->position, now) ? before->position : now;
        mark_way(trails, to_samples(trails, then), to_samples(trails, now), inks[i]);
        places.push_back({id, now});
    }
    trails.places = std::move(places);
}

namespace {

// Characters: a row of faint points, which leaves the shapes to balls and lines.
void paint_points(Raster& raster, const Trails& trails, const Look& look) {
    constexpr int least = 40;  // an older trail is gone
    const int wide = trails.across / raster.columns();
    const int high = trails.down / raster.rows();
    for (int row = 0; row < raster.rows(); ++row) {
        for (int column = 0; column < raster.columns(); ++column) {
            std::size_t freshest = 0;
            int level = 0;
            for (int i = 0; i < wide * high; ++i) {
                const auto at = static_cast<std::size_t>((row * high + i / wide) * trails.across +
                                                         column * wide + i % wide);
                if (trails.levels[at] <= level) continue;
                level = trails.levels[at];
                freshest = at;
            }
            if (level < least) continue;
            Ink ink = trails.inks[freshest];
            if (look.has_shades())
                ink.color = dimmed(ink.color, 0.25 + 0.4 * level / 255.0, look);
            else
                ink.attributes = dim;
            raster.stamp({column + 0.5, (row + 0.5) * raster.aspect()}, ".", ink);
        }
    }
}

}  // namespace

void paint_trails(Raster& raster, const Trails& trails, const Look& look) {
    if (raster.renderer().has_regions()) return paint_points(raster, trails, look);
    std::size_t i = 0;
    for (int down = 0; down < trails.down; ++down) {
        for (int across = 0; across < trails.across; ++across, ++i) {
            if (trails.levels[i] == 0) continue;
            raster.sample(across, down, shown(trails.levels[i]), trails.inks[i]);
        }
    }
}

}  // namespace carom

#include <algorithm>
#include <cmath>

#include "geometry/closest.h"
#include "terminal/draw/ground.h"

/// Where balls vanish from the board: holes, and sinks that have a colour.
namespace carom {

std::vector<std::size_t> colored_sinks(const Scene& scene) {
    std::vector<std::size_t> sinks;
    for (std::size_t i = 0; i < scene.world.zones().size(); ++i)
        if (scene.world.zones()[i].effect == Zone::Effect::sink && color_in(scene.dress.zones, i))
            sinks.push_back(i);
    return sinks;
}

void GroundLayer::fill_holes(const Scene& scene) {
    const Color color = dress_ink(hole_color, key_->look).color;
    for (const std::uint32_t pocket : scene.pool.pockets) {
        const Capsule& shape = scene.world.zones()[pocket].shape;
        const Disc hole{shape.start, hole_share * shape.radius};
        if (key_->renderer->has_pixels() || !fill_small_hole(hole, color))
            fill_area({{}, hole, hole_color, 0}, color);
    }
}

// Samples in the middles of cells could all lie beside a small hole, or make a ragged one.
bool GroundLayer::fill_small_hole(const Disc& hole, Color color) {
    const Camera& camera = key_->camera;
    constexpr double most_rows = 2.5;
    const double across = 2.0 * hole.radius * camera.columns_per_length;
    const double down = across / camera.aspect;
    if (down >= most_rows) return false;
    const CellPoint at = to_cells(camera, hole.center);
    const auto for_each_cell = [](double middle, double size, int begin, int count, auto call) {
        const double whole = std::max(1.0, std::round(size));
        const double first = std::round(middle - 0.5 * whole) - begin;
        for (double i = std::max(0.0, first); i < std::min<double>(first + whole, count); ++i)
            call(static_cast<int>(i));
    };
    for_each_cell(at.row, down, camera.area.row, camera.area.rows, [&](int row) {
        for_each_cell(at.column, across, camera.area.column, camera.area.columns,
                      [&](int column) { sample_of_cell(column, row) = color; });
    });
    return true;
}

void GroundLayer::fill_sinks(const Scene& scene) {
    const std::vector<std::size_t> sinks = colored_sinks(scene);
    for (std::size_t i = 0; i < sinks.size(); ++i)
        fill_sink(scene.world.zones()[sinks[i]].shape, inks_.sinks[i]);
}

// The rail lies above a sink that reaches under it.
void GroundLayer::fill_sink(const Capsule& shape, Color color) {
    const Samples samples = samples_in(bounds(shape));
    for (int down = samples.top; down < samples.bottom; ++down)
        for (int across = samples.left; across < samples.right; ++across) {
            const Vec2 at = place_of(across, down);
            const Vec2 nearest = closest_point(shape.start, shape.end, at);
            if (length(at - nearest) <= shape.radius && board_->at(at) != Ground::rail)
                sample(across, down) = color;
        }
}

}  // namespace carom

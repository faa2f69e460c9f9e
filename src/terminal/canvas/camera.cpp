#include "terminal/canvas/camera.h"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

bool is_usable(double factor) {
    return std::isfinite(factor) && factor > 0.0;
}

double within_limits(double columns_per_length) {
    return std::clamp(columns_per_length, 1e-12, 1e12);
}

// Width and height of the area, in columns.
Vec2 extent(const CellArea& area, double aspect) {
    return {std::max(1.0, static_cast<double>(area.columns)),
            std::max(1.0, static_cast<double>(area.rows)) * aspect};
}

}  // namespace

Camera fit_camera(const Box& view, const CellArea& area, double aspect, double margin) {
    Camera camera;
    camera.area = area;
    camera.aspect = is_usable(aspect) ? aspect : 2.0;
    camera.center = carom::center(view);

    Vec2 world = size(view);
    const double least = std::max(world.x, world.y) > 0.0 ? 0.0 : 2.0;
    world = {std::max(world.x, least), std::max(world.y, least)};
    const Vec2 room = extent(area, camera.aspect);
    if (!(room.x > 4.0 && room.y > 4.0)) margin = 0.0;
    const double across = world.x > 0.0 ? (room.x - 2.0 * margin) / world.x : HUGE_VAL;
    const double down = world.y > 0.0 ? (room.y - 2.0 * margin) / world.y : HUGE_VAL;
    camera.columns_per_length = within_limits(std::min(across, down));
    return camera;
}

Camera fit_camera_to_part(const Box& part, const CellArea& area, double aspect) {
    const Camera whole = fit_camera(part, area, aspect);
    const auto needed = [](double cells, int most) {
        return static_cast<int>(std::clamp(std::ceil(cells + 2.0 * fit_margin), 1.0,
                                           static_cast<double>(std::max(1, most))));
    };
    const Vec2 cells = size(part) * whole.columns_per_length;
    CellArea cut = area;
    cut.columns = std::min(area.columns, needed(cells.x, area.columns));
    cut.rows = std::min(area.rows, needed(cells.y / whole.aspect, area.rows));
    cut.column += (area.columns - cut.columns) / 2;
    cut.row += (area.rows - cut.rows) / 2;
    return fit_camera(part, cut, aspect);
}

CellPoint to_cells(const Camera& camera, Vec2 point) {
    const Vec2 offset = (point - camera.center) * camera.columns_per_length;
    return {camera.area.column + 0.5 * camera.area.columns + offset.x,
            camera.area.row + 0.5 * camera.area.rows - offset.y / camera.aspect};
}

Vec2 to_world(const Camera& camera, CellPoint place) {
    const double across = place.column - camera.area.column - 0.5 * camera.area.columns;
    const double down = place.row - camera.area.row - 0.5 * camera.area.rows;
    return camera.center + Vec2{across, -down * camera.aspect} / camera.columns_per_length;
}

Box visible_box(const Camera& camera) {
    const Vec2 half = Vec2{0.5 * camera.area.columns, 0.5 * camera.area.rows * camera.aspect} /
                      camera.columns_per_length;
    return {camera.center - half, camera.center + half};
}

Camera zoomed(const Camera& camera, CellPoint fixed, double factor) {
    if (!is_usable(factor)) return camera;
    const Vec2 before = to_world(camera, fixed);
    Camera result = camera;
    result.columns_per_length = within_limits(camera.columns_per_length * factor);
    result.center += before - to_world(result, fixed);
    return result;
}

Camera panned(const Camera& camera, double columns, double rows) {
    Camera result = camera;
    result.center += Vec2{columns, -rows * camera.aspect} / camera.columns_per_length;
    return result;
}

Camera resized(const Camera& camera, const CellArea& area, double aspect) {
    Camera result = camera;
    result.area = area;
    result.aspect = is_usable(aspect) ? aspect : 2.0;
    const Vec2 before = extent(camera.area, camera.aspect);
    const Vec2 now = extent(area, result.aspect);
    result.columns_per_length =
        within_limits(camera.columns_per_length * std::min(now.x / before.x, now.y / before.y));
    return result;
}

}  // namespace carom

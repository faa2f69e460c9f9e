#include "terminal/draw/ground.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/polygon.h"
#include "terminal/canvas/color.h"
#include "terminal/canvas/legible.h"
#include "terminal/canvas/surface_colors.h"

namespace carom {

namespace {

// Where the level gives no theme.
struct GroundColors {
    Rgb24 board = 0;
    Rgb24 cushion = 0;
    Rgb24 rail = 0;
    Rgb24 plastic = 0;
};
constexpr GroundColors pool_colors{0x1a6b48, 0x12523a, 0x5c3a18, 0};
constexpr GroundColors pinball_colors{0x16203a, 0, 0x3a3f4a, 0x2f4a6b};
constexpr GroundColors plain_colors{0x20262e, 0, 0x4a4f57, 0};

constexpr char32_t cloth_glyph = U'\u2591';

Rgb rgb_of_dress(Rgb24 color) {
    return {static_cast<int>(color >> 16 & 0xffU), static_cast<int>(color >> 8 & 0xffU),
            static_cast<int>(color & 0xffU)};
}

Rgb24 scaled(Rgb24 color, double factor) {
    const auto channel = [&](int shift) {
        const double value = static_cast<double>(color >> shift & 0xffU) * factor;
        return static_cast<Rgb24>(std::clamp(value, 0.0, 255.0)) << shift;
    };
    return channel(16) | channel(8) | channel(0);
}

GroundColors colors_of(const Scene& scene) {
    const bool is_pool = is_pool_table(scene);
    GroundColors colors = is_pool                  ? pool_colors
                          : scene.table.is_empty() ? plain_colors
                                                   : pinball_colors;
    const BoardTheme& theme = scene.dress.theme;
    if (theme.board) colors.board = *theme.board;
    if (theme.board && is_pool) colors.cushion = scaled(*theme.board, 0.75);
    if (theme.rail) colors.rail = *theme.rail;
    return colors;
}

// A cell of pixels, which shows the ground already: half blocks, quadrants, sextants, octants.
bool is_mosaic(char32_t glyph) {
    return (glyph >= U'\u2580' && glyph <= U'\u259f') ||
           (glyph >= U'\U0001fb00' && glyph <= U'\U0001fbff') ||
           (glyph >= U'\U0001cc00' && glyph <= U'\U0001cebf');
}

bool is_in_pocket(const Scene& scene, Vec2 place, double margin) {
    return std::ranges::any_of(scene.pool.pockets, [&](std::uint32_t pocket) {
        const Capsule& shape = scene.world.zones()[pocket].shape;
        return length(place - shape.start) < shape.radius + margin;
    });
}

Box bounds_of(const PaintedArea& area) {
    if (area.corners.empty()) return bounds(area.disc);
    Box box{area.corners.front(), area.corners.front()};
    for (const Vec2 corner : area.corners)
        box = join(box, {corner, corner});
    return box;
}

// The last of the areas that something with these bounds may lie on; none: it lies on the board.
std::optional<std::size_t> area_below(std::span<const PaintedArea> areas, const Box& box) {
    for (std::size_t i = areas.size(); i-- > 0;)
        if (overlaps(bounds_of(areas[i]), box)) return i;
    return std::nullopt;
}

}  // namespace

Ink dress_ink(Rgb24 color, const Look& look) {
    return ink_of_color(rgb_of_dress(color), look);
}

const Board& GroundLayer::board(const Scene& scene) {
    if (!board_ || scene_hash_ != scene.text_hash) {
        board_ = std::make_shared<const Board>(scene);
        scene_hash_ = scene.text_hash;
        key_.reset();
    }
    return *board_;
}

void GroundLayer::update(const Scene& scene, const Camera& camera, const Renderer& renderer,
                         const Look& look) {
    board(scene);
    const Key key{camera, &renderer, look};
    if (key_ == key) return;
    const bool is_new_look = !key_ || !(key_->look == look);
    key_ = key;
    colors_.clear();
    cloth_.clear();
    if (is_new_look && look.has_shades()) choose_inks(scene);
    const bool has_ground = !board_->is_empty() || !scene.dress.areas.empty();
    if (look.has_shades() && has_ground) fill(scene);
    if (!look.has_shades()) weave(scene);
    paint();
}

void GroundLayer::choose_inks(const Scene& scene) {
    constexpr double lighter = 1.3;
    constexpr double chalk_share = 0.235;  // faint
    constexpr Rgb24 chalk_color = 0x7fb697;
    const GroundColors colors = colors_of(scene);
    const auto rgb = [](Rgb24 color) { return rgb_of_dress(color); };
    enum Surface : std::size_t { ground, cushion, rail, plastic, nose, chalk, areas };
    const Rgb chalk_on_board =
        rgb_of(mixed(direct_color(rgb(chalk_color)), direct_color(rgb(colors.board)), chalk_share));
    std::vector<Rgb> wanted{rgb(colors.board),
                            rgb(colors.cushion),
                            rgb(colors.rail),
                            rgb(colors.plastic),
                            rgb(scaled(colors.board, lighter)),
                            chalk_on_board};
    std::vector<Neighbours> neighbours;
    if (is_pool_table(scene))
        neighbours = {{ground, nose}, {nose, cushion}, {cushion, rail}, {ground, chalk}};
    else
        neighbours = {{ground, rail}, {ground, plastic}};
    const std::span<const PaintedArea> painted = scene.dress.areas;
    const auto add = [&](std::span<const PaintedArea> earlier, const Box& box, Rgb24 color,
                         double share) {
        const auto below = area_below(earlier, box);
        const std::size_t under = below ? areas + *below : ground;
        neighbours.emplace_back(under, wanted.size());
        wanted.push_back(
            rgb_of(mixed(direct_color(rgb(color)), direct_color(wanted[under]), share)));
    };
    for (std::size_t i = 0; i < painted.size(); ++i)
        add(painted.first(i), bounds_of(painted[i]), painted[i].color, 1.0);
    const std::vector<std::size_t> sinks = colored_sinks(scene);
    for (const std::size_t i : sinks)
        add(painted, bounds(scene.world.zones()[i].shape), *color_in(scene.dress.zones, i),
            sink_share);
    const std::vector<Color> chosen = surface_colors(wanted, neighbours, key_->look);
    const auto first_sink = chosen.end() - static_cast<std::ptrdiff_t>(sinks.size());
    inks_ = {{default_color, chosen[rail], chosen[cushion], chosen[plastic], chosen[ground]},
             chosen[nose],
             chosen[chalk],
             {chosen.begin() + areas, first_sink},
             {first_sink, chosen.end()}};
}

// With few colours, a ball could have that of the ground, so cloth is no colour but a pattern of
// dots, in the cells that are all cloth.
void GroundLayer::weave(const Scene& scene) {
    const Look& look = key_->look;
    const bool shows_cloth = look.has_colors() && look.utf8 && key_->renderer->has_pixels();
    if (!shows_cloth || board_->is_empty() || !is_pool_table(scene)) return;
    const Color color = color_of_hue(rgb_of_dress(colors_of(scene).board), look);
    const CellArea& area = key_->camera.area;
    const double half_cell = 0.5 / key_->camera.columns_per_length;
    for (int row = 0; row < area.rows; ++row)
        for (int column = 0; column < area.columns; ++column) {
            const Vec2 middle =
                to_world(key_->camera, {area.column + column + 0.5, area.row + row + 0.5});
            const bool is_cloth =
                board_->at(middle) == Ground::board && !is_in_pocket(scene, middle, half_cell);
            cloth_.push_back(is_cloth ? color : default_color);
        }
}

void GroundLayer::fill(const Scene& scene) {
    const Renderer& renderer = *key_->renderer;
    across_ = key_->camera.area.columns * renderer.across;
    down_ = key_->camera.area.rows * renderer.down;
    colors_.assign(static_cast<std::size_t>(across_) * static_cast<std::size_t>(down_),
                   default_color);
    if (!board_->is_empty()) fill_board();
    const std::vector<PaintedArea>& areas = scene.dress.areas;
    for (std::size_t i = 0; i < areas.size(); ++i)
        if (areas[i].layer == 0) fill_area(areas[i], inks_.areas[i]);
    fill_sinks(scene);
    fill_holes(scene);
}

Vec2 GroundLayer::place_of(int across, int down) const {
    const CellArea& area = key_->camera.area;
    return to_world(key_->camera, {area.column + (across + 0.5) / key_->renderer->across,
                                   area.row + (down + 0.5) / key_->renderer->down});
}

void GroundLayer::fill_board() {
    for (int down = 0; down < down_; ++down)
        for (int across = 0; across < across_; ++across)
            sample(across, down) =
                inks_.board[static_cast<std::size_t>(board_->at(place_of(across, down)))];
}

GroundLayer::Samples GroundLayer::samples_in(const Box& box) const {
    const CellPoint low = to_cells(key_->camera, {box.low.x, box.high.y});
    const CellPoint high = to_cells(key_->camera, {box.high.x, box.low.y});
    const CellArea& seen = key_->camera.area;
    const auto within = [](double cells, int per_cell, int most) {
        return static_cast<int>(std::clamp(cells * per_cell, 0.0, static_cast<double>(most)));
    };
    const Renderer& renderer = *key_->renderer;
    return {within(low.column - seen.column, renderer.across, across_),
            within(high.column - seen.column + 1.0, renderer.across, across_),
            within(low.row - seen.row, renderer.down, down_),
            within(high.row - seen.row + 1.0, renderer.down, down_)};
}

void GroundLayer::fill_area(const PaintedArea& area, Color color) {
    const Samples samples = samples_in(bounds_of(area));
    for (int down = samples.top; down < samples.bottom; ++down)
        for (int across = samples.left; across < samples.right; ++across) {
            const Vec2 at = place_of(across, down);
            const bool is_inside = area.corners.empty()
                                       ? length(at - area.disc.center) <= area.disc.radius
                                       : is_inside_polygon<Vec2>(area.corners, at);
            if (is_inside) sample(across, down) = color;
        }
}

Raster GroundLayer::raster() const {
    if (painted_) return *painted_;
    const CellArea& area = key_->camera.area;
    return Raster(*key_->renderer, area.columns, area.rows, key_->camera.aspect, key_->look);
}

void GroundLayer::paint() {
    painted_.reset();
    if (colors_.empty() || !key_->renderer->has_pixels()) return;
    Raster raster = this->raster();
    constexpr std::uint8_t full = 255;
    for (int down = 0; down < down_; ++down)
        for (int across = 0; across < across_; ++across) {
            const Color color = color_at(across, down);
            if (color != default_color) raster.sample(across, down, full, {color, plain});
        }
    painted_ = std::move(raster);
}

bool GroundLayer::is_bare(const Canvas& canvas, int column, int row) const {
    if (!canvas.holds(column, row)) return false;
    const Cell& cell = canvas.at(column, row);
    if (cell.glyph == U' ') return true;
    if (colors_.empty() || !key_->renderer->has_pixels()) return false;
    const Renderer& renderer = *key_->renderer;
    const int across = (column - key_->camera.area.column) * renderer.across;
    const int down = (row - key_->camera.area.row) * renderer.down;
    const auto is_ground = [&](Color color) {
        for (int i = 0; i < renderer.across * renderer.down; ++i)
            if (color == color_at(across + i % renderer.across, down + i / renderer.across))
                return true;
        return false;
    };
    return is_ground(cell.foreground) &&
           (cell.background == default_color || is_ground(cell.background));
}

bool GroundLayer::is_off_board(int column, int row) const {
    return !board_->is_empty() &&
           board_->at(to_world(key_->camera, {column + 0.5, row + 0.5})) == Ground::none;
}

Color GroundLayer::behind(int column, int row) const {
    const CellArea& area = key_->camera.area;
    const int across = column - area.column;
    const int down = row - area.row;
    const bool is_within =
        across >= 0 && across < area.columns && down >= 0 && down < area.rows && !colors_.empty();
    const Color ground = is_within ? color_of_cell(across, down) : default_color;
    return ground == default_color ? ground_color(key_->look) : ground;
}

void GroundLayer::lay(Canvas& canvas) const {
    const CellArea& area = key_->camera.area;
    for (std::size_t i = 0; i < cloth_.size(); ++i) {
        const int column = area.column + static_cast<int>(i) % area.columns;
        const int row = area.row + static_cast<int>(i) / area.columns;
        if (cloth_[i] == default_color || !canvas.holds(column, row)) continue;
        Cell& cell = canvas.at(column, row);
        if (cell.glyph == U' ' && cell.background == default_color)
            cell = {cloth_glyph, cloth_[i], default_color, plain};
    }
    if (colors_.empty()) return;
    for (int row = 0; row < area.rows; ++row)
        for (int column = 0; column < area.columns; ++column) {
            if (!canvas.holds(area.column + column, area.row + row)) continue;
            Cell& cell = canvas.at(area.column + column, area.row + row);
            if (cell.background != default_color) continue;
            if (key_->renderer->has_pixels() && is_mosaic(cell.glyph)) continue;
            cell.background = color_of_cell(column, row);
            cell.foreground = legible_on(cell.foreground, cell.background, key_->look);
        }
}

}  // namespace carom

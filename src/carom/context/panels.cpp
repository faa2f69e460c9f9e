#include "carom/context/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "game/session/conserved.h"
#include "lab/run/judge.h"
#include "terminal/panels/curve_panel.h"
#include "terminal/panels/histogram.h"

namespace carom {
namespace {

/// In a window at least this wide, panels are to the right of the world, else below it.
constexpr int wide = 70;
constexpr int least_panel_columns = 24;
constexpr int least_panel_rows = 7;
/// Blank columns between the world and the panels to its right.
constexpr int gap = 2;
/// Of a histogram below its bins.
constexpr int most_rows_below = 14;
constexpr int least_rows_for_below = 32;

CellArea cut_bottom(CellArea& area, int rows) {
    area.rows -= rows;
    return {area.column, area.row + area.rows, area.columns, rows};
}

CellArea cut_right(CellArea& area, int columns) {
    area.columns -= columns;
    return {area.column + area.columns, area.row, columns, area.rows};
}

void cut_left(CellArea& area, int columns) {
    area.column += columns;
    area.columns -= columns;
}

void cut_top(CellArea& area) {
    ++area.row;
    --area.rows;
}

CurvePicture picture_of(Observable what, const Observer& observer, const World& world) {
    CurvePicture picture;
    picture.title = row_of(what).title;
    const std::optional<double> value = observer.values(what, world).front().value;
    picture.has_bars = what == Observable::speeds;
    picture.value = value                  ? fmt::format("{:.4g}", *value)
                    : observer.has_begun() ? "no value yet"
                                           : fmt::format("from {:g} s on", observer.from());
    for (const CurvePoint& point : observer.curve(what).points)
        picture.points.push_back({point.x, point.y, point.expected});
    return picture;
}

// Where the world shows each bin, from left to right, in columns; the last is the right border.
std::vector<double> borders_of(const std::vector<std::uint32_t>& counters, const World& world,
                               const Camera& camera) {
    std::vector<double> borders;
    for (const std::uint32_t counter : counters) {
        const auto zone = std::ranges::find(world.zones(), counter, &Zone::counter);
        if (zone == world.zones().end()) return {};
        const Box box = bounds(zone->shape);
        borders.push_back(to_cells(camera, box.low).column);
        if (counter == counters.back()) borders.push_back(to_cells(camera, box.high).column);
    }
    return borders;
}

}  // namespace

Panels::Panels(const Scene& scene) {
    for (const Show& show : scene.shows) {
        shows_histogram_ = shows_histogram_ || show.what == Show::What::histogram;
        shows_energy_ = shows_energy_ || show.what == Show::What::energy;
        if (show.what == Show::What::observable) observables_.push_back(show.observable);
    }
}

bool Panels::toggle_speeds() {
    const auto shown = std::ranges::find(observables_, Observable::speeds);
    const bool shows = shown == observables_.end();
    if (shows)
        observables_.push_back(Observable::speeds);
    else
        observables_.erase(shown);
    return shows;
}

bool Panels::has_histogram(const Scene& scene) {
    return std::ranges::any_of(scene.shows,
                               [](const Show& show) { return show.what == Show::What::histogram; });
}

void Panels::cut(CellArea& area, const Scene& scene, bool is_split) {
    histogram_area_ = {};
    energy_area_ = {};
    observable_areas_.assign(observables_.size(), {});
    std::vector<CellArea*> panels;
    if (shows_histogram_ && has_histogram(scene)) panels.push_back(&histogram_area_);
    if (shows_energy_) panels.push_back(&energy_area_);
    for (CellArea& observed : observable_areas_)
        panels.push_back(&observed);
    if (is_split || panels.empty()) return;
    // A tall window has room for the histogram under the bins that it counts.
    if (panels.front() == &histogram_area_ && area.rows >= least_rows_for_below) {
        histogram_area_ = cut_bottom(area, std::min(most_rows_below, area.rows * 2 / 7));
        panels.erase(panels.begin());
        if (panels.empty()) return;
    }
    if (area.columns >= wide) {
        CellArea side = cut_right(area, std::max(least_panel_columns, area.columns * 2 / 5));
        cut_left(side, gap);
        for (std::size_t i = panels.size(); i-- > 1;) {
            *panels[i] = cut_bottom(side, side.rows / static_cast<int>(i + 1));
            if (panels[i]->rows > least_panel_rows) cut_top(*panels[i]);
        }
        *panels.front() = side;
    } else if (area.rows >= 2 * least_panel_rows) {
        *panels.front() = cut_bottom(area, std::max(least_panel_rows, area.rows / 3));
    }
}

void Panels::sample(std::uint64_t tick, const Totals& sums, std::optional<double> drift) {
    energy_.add({tick, sums.kinetic_energy, sums.potential_energy, length(sums.momentum), drift});
}

void Panels::draw(Canvas& canvas, const Session& session, const Observer* observer,
                  const Camera& camera, const Look& look) const {
    const World& world = session.world();
    for (std::size_t i = 0; observer && i < observable_areas_.size(); ++i)
        draw_curve(canvas, observable_areas_[i], picture_of(observables_[i], *observer, world),
                   look);
    if (energy_area_.rows > 0)
        draw_energy(canvas, energy_area_, energy_, world.tick_length(), look);
    if (histogram_area_.rows == 0) return;
    const auto show = std::ranges::find(session.scene().shows, Show::What::histogram, &Show::what);
    Histogram histogram;
    histogram.title = show->of;
    histogram.expected = show->expected;
    histogram.against = show->against;
    const std::vector<std::uint64_t> counts = census(world);
    for (const std::uint32_t counter : show->counters)
        histogram.counts.push_back(counts[counter]);
    const std::vector<double> borders = borders_of(show->counters, world, camera);
    if (histogram_area_.row >= camera.area.row + camera.area.rows && fits_below(histogram, borders))
        return draw_histogram_below(canvas, histogram_area_, histogram, borders, look);
    draw_histogram(canvas, histogram_area_, histogram, look);
}

}  // namespace carom

#include "carom/context/panels.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "game/session/conserved.h"
#include "lab/run/judge.h"
#include "physics/tick/totals.h"
#include "terminal/panels/histogram.h"

namespace carom {
namespace {

/// In a window at least this wide, panels are to the right of the world, else below it.
constexpr int wide = 70;
constexpr int least_panel_columns = 24;
constexpr int least_panel_rows = 7;

CellArea cut_bottom(CellArea& area, int rows) {
    area.rows -= rows;
    return {area.column, area.row + area.rows, area.columns, rows};
}

CellArea cut_right(CellArea& area, int columns) {
    area.columns -= columns;
    return {area.column + area.columns, area.row, columns, area.rows};
}

}  // namespace

Panels::Panels(const Scene& scene) {
    for (const Show& show : scene.shows) {
        shows_histogram_ = shows_histogram_ || show.what == Show::What::histogram;
        shows_energy_ = shows_energy_ || show.what == Show::What::energy;
    }
}

bool Panels::has_histogram(const Scene& scene) {
    return std::ranges::any_of(scene.shows,
                               [](const Show& show) { return show.what == Show::What::histogram; });
}

void Panels::cut(CellArea& area, const Scene& scene, bool is_split) {
    histogram_area_ = {};
    energy_area_ = {};
    const bool histogram = shows_histogram_ && has_histogram(scene);
    const int panels = is_split ? 0 : (histogram ? 1 : 0) + (shows_energy_ ? 1 : 0);
    if (panels > 0 && area.columns >= wide) {
        CellArea side = cut_right(area, std::max(least_panel_columns, area.columns * 2 / 5));
        if (histogram && shows_energy_) energy_area_ = cut_bottom(side, side.rows / 2);
        (histogram ? histogram_area_ : energy_area_) = side;
    } else if (panels > 0 && area.rows >= 2 * least_panel_rows) {
        CellArea bottom = cut_bottom(area, std::max(least_panel_rows, area.rows / 3));
        (histogram ? histogram_area_ : energy_area_) = bottom;
    }
}

void Panels::sample(const World& world) {
    const Totals sums = totals(world);
    energy_.add({world.tick(), sums.kinetic_energy, sums.potential_energy});
}

void Panels::draw(Canvas& canvas, const Session& session, const Look& look) const {
    const World& world = session.world();
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
    draw_histogram(canvas, histogram_area_, histogram, look);
}

}  // namespace carom

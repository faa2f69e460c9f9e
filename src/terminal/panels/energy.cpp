#include "terminal/panels/energy.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "terminal/canvas/character_width.h"
#include "terminal/canvas/raster.h"
#include "terminal/panels/curve_panel.h"
#include "terminal/panels/panel.h"

namespace carom {

namespace {

constexpr int least_panel_columns = 16;
constexpr int least_panel_rows = 4;

struct Curve {
    std::string name;
    double (*value)(const EnergyHistory::Sample&);
    Ink ink;
};

std::array<Curve, 3> curves(const Look& look) {
    using Sample = EnergyHistory::Sample;
    return {{{"kinetic", [](const Sample& s) { return s.kinetic; }, ink_of_class(0, look)},
             {"potential", [](const Sample& s) { return s.potential; }, ink_of_class(1, look)},
             {"total", [](const Sample& s) { return s.kinetic + s.potential; },
              ink_of(Role::strong, look)}}};
}

struct Range {
    double low = 0.0;
    double high = 0.0;
};

// The range of all drawn values, including 0.
Range range_of(const std::vector<EnergyHistory::Sample>& samples,
               const std::array<Curve, 3>& drawn) {
    Range range;
    for (const EnergyHistory::Sample& sample : samples) {
        for (const Curve& curve : drawn) {
            const double value = curve.value(sample);
            if (!std::isfinite(value)) continue;
            range.low = std::min(range.low, value);
            range.high = std::max(range.high, value);
        }
    }
    if (!(range.high > range.low)) range.high = range.low + 1.0;
    return range;
}

bool has_potential(const std::vector<EnergyHistory::Sample>& samples) {
    return std::any_of(samples.begin(), samples.end(),
                       [](const EnergyHistory::Sample& s) { return s.potential != 0.0; });
}

void draw_curves(Canvas& canvas, const CellArea& area, const EnergyHistory& history,
                 const std::array<Curve, 3>& drawn, const Range& range, const Look& look) {
    constexpr double aspect = 2.0;
    Raster raster(look.utf8 ? braille_renderer() : ascii_renderer(), area.columns, area.rows,
                  aspect, look);
    const auto& samples = history.samples();
    const auto first = static_cast<double>(samples.front().tick);
    const double ticks = std::max(1.0, static_cast<double>(samples.back().tick) - first);
    const double height = raster.rows() * aspect;
    const auto place = [&](const EnergyHistory::Sample& sample, const Curve& curve) {
        // Slightly inside, so that neither end of the range is cut off.
        const double share = (curve.value(sample) - range.low) / (range.high - range.low);
        return RasterPoint{
            (static_cast<double>(sample.tick) - first) / ticks * (area.columns - 0.5),
            height - 0.4 - share * (height - 0.8)};
    };
    // Without potential energy, one curve is enough.
    const std::size_t skip = has_potential(samples) ? 0 : 2;
    for (std::size_t c = skip; c < drawn.size(); ++c) {
        for (std::size_t i = 1; i < samples.size(); ++i) {
            raster.line(place(samples[i - 1], drawn[c]), place(samples[i], drawn[c]), drawn[c].ink);
        }
    }
    raster.show(canvas, area.column, area.row);
}

}  // namespace

void EnergyHistory::add(const Sample& sample) {
    while (!samples_.empty() && samples_.back().tick > sample.tick)
        samples_.pop_back();
    if (!samples_.empty() && sample.tick < samples_.back().tick + spacing_) return;
    samples_.push_back(sample);
    if (samples_.size() < capacity) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < samples_.size(); i += 2)
        samples_[kept++] = samples_[i];
    samples_.resize(kept);
    spacing_ *= 2;
}

void EnergyHistory::clear() {
    *this = {};
}

namespace {

/// A small graph over time. None where fewer than two samples have a value.
template <class Value>
std::optional<CurvePicture> small_graph(const EnergyHistory& history, double tick_length,
                                        std::string title, Value value) {
    CurvePicture picture;
    picture.title = std::move(title);
    for (const EnergyHistory::Sample& sample : history.samples())
        if (const std::optional<double> y = value(sample))
            picture.points.push_back({static_cast<double>(sample.tick) * tick_length, *y});
    if (picture.points.size() < 2) return std::nullopt;
    picture.value = fmt::format("{:.3g}", picture.points.back().y);
    return picture;
}

// Takes the room for small graphs from the bottom of `area`.
void draw_small_graphs(Canvas& canvas, CellArea& area, const EnergyHistory& history,
                       double tick_length, const Look& look) {
    constexpr int least_rows = 16;
    constexpr int least_small = 5;
    if (area.rows < least_rows) return;
    using Sample = EnergyHistory::Sample;
    const int rows = std::max(least_small, area.rows / 4);
    const auto draw = [&](const std::optional<CurvePicture>& picture) {
        if (!picture) return;
        area.rows -= rows;
        draw_curve(canvas, {area.column, area.row + area.rows, area.columns, rows}, *picture, look);
    };
    draw(small_graph(history, tick_length, "drift", [](const Sample& s) { return s.drift; }));
    draw(small_graph(history, tick_length, "momentum",
                     [](const Sample& s) { return std::optional(s.momentum); }));
}

}  // namespace

void draw_energy(Canvas& canvas, const CellArea& whole, const EnergyHistory& history,
                 double tick_length, const Look& look) {
    CellArea area = whole;
    draw_small_graphs(canvas, area, history, tick_length, look);
    if (area.columns < least_panel_columns || area.rows < least_panel_rows) return;
    canvas.clear(area);
    const std::array<Curve, 3> drawn = curves(look);
    std::vector<PanelText> legend = {{"energy", ink_of(Role::strong, look)}};
    if (has_potential(history.samples())) {
        for (const Curve& curve : drawn)
            legend.push_back({curve.name, curve.ink});
    }
    write_flowing(canvas, {area.column, area.row, area.columns, 1}, legend);
    if (history.samples().size() < 2) return;

    const Range range = range_of(history.samples(), drawn);
    const auto seconds = [&](const EnergyHistory::Sample& sample) {
        return fmt::format("{:.4g} s", static_cast<double>(sample.tick) * tick_length);
    };
    const CellArea picture =
        draw_axes(canvas, area,
                  {fmt::format("{:.4g}", range.low), fmt::format("{:.4g}", range.high),
                   seconds(history.samples().front()), seconds(history.samples().back())},
                  look);
    draw_curves(canvas, picture, history, drawn, range, look);
}

}  // namespace carom

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "terminal/panels/histogram.h"
#include "terminal/panels/panel.h"

/// Draws a histogram.
namespace carom {

namespace {

constexpr int least_histogram_columns = 12;
constexpr int least_histogram_rows = 4;

// One drawn bar: several bins where there are more bins than columns.
struct PictureBar {
    double count = 0.0;
    double expected = 0.0;
};

std::vector<PictureBar> bars_of(const Histogram& histogram, std::size_t together, double total) {
    double shares = 0.0;
    for (const double share : histogram.expected)
        shares += share;
    const double scale = shares > 0.0 ? total / shares : 0.0;
    std::vector<PictureBar> bars((histogram.counts.size() + together - 1) / together);
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        bars[i / together].count += static_cast<double>(histogram.counts[i]);
        if (i < histogram.expected.size()) {
            bars[i / together].expected += histogram.expected[i] * scale;
        }
    }
    return bars;
}

// The top of a bar. `share`: the filled part of its last cell, 0 to 1.
char32_t partial_block(double share, bool utf8) {
    if (utf8) {
        constexpr std::u32string_view blocks = U" ▁▂▃▄▅▆▇█";
        return blocks[static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * 8.0 + 0.5)];
    }
    constexpr std::u32string_view blocks = U" .:#";
    return blocks[static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * 3.0 + 0.5)];
}

// A horizontal line at this height within its cell, 0 (bottom) to 1.
char32_t level_line(double share, bool utf8) {
    if (utf8) return share < 0.33 ? U'▁' : share < 0.67 ? U'─' : U'▔';
    return share < 0.33 ? U'_' : share < 0.67 ? U'-' : U'"';
}

// A bar and its part of the curve, `first` to `last` (excluded), from the bottom of `area` upwards.
void draw_bar(Canvas& canvas, const CellArea& area, int first, int last, double height,
              std::optional<double> curve, const Look& look) {
    const Ink bar_ink = ink_of_class(1, look);
    const Ink curve_ink = ink_of(Role::expected, look);
    for (int column = std::max(first, area.column);
         column < std::min(last, area.column + area.columns); ++column)
        for (int up = 0; up < area.rows; ++up) {
            const double filled = height - up;
            // A full cell gets the colour as its background too, since blocks leave seams in many
            // fonts.
            const bool is_full = filled >= 1.0 && look.has_colors() && look.utf8;
            Cell cell{partial_block(filled, look.utf8), bar_ink.color,
                      is_full ? bar_ink.color : default_color, bar_ink.attributes};
            if (cell.glyph == U' ') cell = {};
            if (curve && up == std::min(static_cast<int>(*curve), area.rows - 1)) {
                cell.glyph = level_line(*curve - up, look.utf8);
                cell.foreground = curve_ink.color;
                cell.attributes = curve_ink.attributes;
            }
            canvas.put(column, area.row + area.rows - 1 - up, cell);
        }
}

// All bars and the curve. Pre: the area is blank.
void draw_bars(Canvas& canvas, const CellArea& area, const std::vector<PictureBar>& bars,
               const Look& look) {
    double most = 1.0;
    for (const PictureBar& bar : bars)
        most = std::max({most, bar.count, bar.expected});
    const double rows_per_count = area.rows / most;
    const int width = std::max(1, area.columns / static_cast<int>(bars.size()));
    const int gap = width > 2 ? 1 : 0;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const int first = area.column + static_cast<int>(i) * width;
        const bool has_curve = bars[i].expected > 0.0;
        draw_bar(canvas, area, first, first + width - gap, bars[i].count * rows_per_count,
                 has_curve ? std::optional(bars[i].expected * rows_per_count) : std::nullopt, look);
    }
}

// The statistics in words, the most important first.
std::vector<PanelText> statistics_texts(const Histogram& histogram, const Look& look) {
    const HistogramFit fit = fit_of(histogram);
    const Ink text = ink_of(Role::text, look);
    std::vector<PanelText> words = {{fmt::format("N {}", fit.total), text}};
    if (fit.total == 0) return words;
    std::string mean = fmt::format("mean {:.3f}", fit.mean);
    if (fit.mean_expected) mean += fmt::format(" ({:.3f})", *fit.mean_expected);
    words.push_back({mean, text});
    if (fit.variance_ratio) {
        words.push_back({fmt::format("variance x{:.3f}", *fit.variance_ratio), text});
    } else {
        words.push_back({fmt::format("variance {:.3f}", fit.variance), text});
    }
    if (fit.chi_square && fit.p_value) {
        const std::string_view name = look.utf8 ? "χ²" : "chi2";
        const Role role = *fit.p_value < 0.01 ? Role::warning : Role::good;
        words.push_back({fmt::format("{} {:.1f}/{} p {:.3f}", name, *fit.chi_square,
                                     fit.degrees_of_freedom, *fit.p_value),
                         ink_of(role, look)});
    }
    return words;
}

}  // namespace

void draw_histogram(Canvas& canvas, const CellArea& area, const Histogram& histogram,
                    const Look& look) {
    const bool is_too_small =
        area.columns < least_histogram_columns || area.rows < least_histogram_rows;
    if (is_too_small || histogram.counts.empty()) return;
    canvas.clear(area);
    const std::string title =
        histogram.against.empty() ? histogram.title : histogram.title + " / " + histogram.against;
    write_cut(canvas, area, 0, title, ink_of(Role::strong, look));

    double total = 0.0;
    for (const std::uint64_t count : histogram.counts)
        total += static_cast<double>(count);
    const auto columns = static_cast<std::size_t>(area.columns);
    const std::size_t together = (histogram.counts.size() + columns - 1) / columns;
    const std::vector<PanelText> words = statistics_texts(histogram, look);
    const int most_text = std::max(1, area.rows / 4);
    const int text_rows = std::min(most_text, rows_for(words, area.columns));
    const CellArea picture{area.column, area.row + 1, area.columns, area.rows - 1 - text_rows};
    draw_bars(canvas, picture, bars_of(histogram, together, total), look);
    write_flowing(canvas, {area.column, area.row + area.rows - text_rows, area.columns, text_rows},
                  words);
}

bool fits_below(const Histogram& histogram, std::span<const double> borders) {
    constexpr double least_width = 2.0;  // columns of a bar, with the gap beside it
    if (borders.size() != histogram.counts.size() + 1 || histogram.counts.empty()) return false;
    for (std::size_t i = 1; i < borders.size(); ++i)
        if (!(borders[i] - borders[i - 1] >= least_width) || !(borders[i] < 1e6)) return false;
    return borders.front() > -1e6;
}

void draw_histogram_below(Canvas& canvas, const CellArea& area, const Histogram& histogram,
                          std::span<const double> borders, const Look& look) {
    constexpr int least_rows_below = 5;
    if (area.rows < least_rows_below) return;
    canvas.clear(area);
    double total = 0.0;
    for (const std::uint64_t count : histogram.counts)
        total += static_cast<double>(count);
    const std::vector<PictureBar> bars = bars_of(histogram, 1, total);
    double most = 1.0;
    for (const PictureBar& bar : bars)
        most = std::max({most, bar.count, bar.expected});
    // The words, the bars, the axis, and the counts.
    const CellArea picture{area.column, area.row + 1, area.columns, area.rows - 3};
    const int axis = picture.row + picture.rows;
    const double rows_per_count = picture.rows / most;
    const Ink faint = ink_of(Role::faint, look);
    const Ink counter = ink_of(Role::counter, look);
    const auto column_of = [](double border) { return static_cast<int>(std::lround(border)); };
    int free_from = area.column;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const int first = column_of(borders[i]);
        const int last = column_of(borders[i + 1]);
        const bool has_curve = bars[i].expected > 0.0;
        draw_bar(canvas, picture, first, last - 1, bars[i].count * rows_per_count,
                 has_curve ? std::optional(bars[i].expected * rows_per_count) : std::nullopt, look);
        for (int column = std::max(first, area.column);
             column < std::min(last, area.column + area.columns); ++column)
            canvas.put(column, axis, {look.utf8 ? U'─' : U'-', faint.color});
        const std::string text = fmt::format("{}", histogram.counts[i]);
        const int width = static_cast<int>(text.size());
        const int at = (first + last - 1 - width + 1) / 2;
        if (at < free_from || at + width > area.column + area.columns) continue;
        canvas.write(at, axis + 1, text, counter.color, default_color, counter.attributes);
        free_from = at + width + 1;
    }
    std::vector<PanelText> words{
        {histogram.against.empty() ? histogram.title : histogram.title + " / " + histogram.against,
         ink_of(Role::strong, look)}};
    for (PanelText& text : statistics_texts(histogram, look))
        words.push_back(std::move(text));
    // They begin where the bars do, or as far to the left of it as they need.
    const int end = area.column + area.columns;
    int start = std::clamp(column_of(borders.front()), area.column, end);
    while (start > area.column && rows_for(words, end - start) > 1)
        --start;
    write_flowing(canvas, {start, area.row, end - start, 1}, words);
}

}  // namespace carom

#include "lab/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace carom {
namespace {

// An axis of whole decades over a number of cells.
struct Axis {
    int low = 0;  // exponents of ten
    int high = 0;
    int cells = 0;

    int cell(double value) const {
        const double share = (std::log10(value) - low) / (high - low);
        return std::clamp(static_cast<int>(std::lround(share * (cells - 1))), 0, cells - 1);
    }
    int cell_of_decade(int decade) const {
        return static_cast<int>(
            std::lround(static_cast<double>(decade - low) / (high - low) * (cells - 1)));
    }
};

struct Cell {
    int column = 0;
    int row = 0;  // from the top
};

bool is_drawable(const PlotPoint& point) {
    return std::isfinite(point.x) && point.x > 0.0 && std::isfinite(point.y) && point.y >= 0.0;
}

Axis axis_over(const std::vector<double>& values, int cells) {
    if (values.empty()) return {-1, 0, cells};
    const auto [least, most] = std::ranges::minmax(values);
    const int low = static_cast<int>(std::floor(std::log10(least)));
    const int high = static_cast<int>(std::ceil(std::log10(most)));
    return {low, std::max(high, low + 1), cells};
}

class Field {
  public:
    Field(const std::vector<PlotPoint>& points, const PlotFrame& frame) : frame_(frame) {
        std::vector<double> x;
        std::vector<double> y;
        for (const PlotPoint& point : points) {
            x.push_back(point.x);
            if (point.y > 0.0) y.push_back(point.y);
        }
        has_zero_ = y.size() < x.size();
        x_ = axis_over(x, frame.columns);
        y_ = axis_over(y, has_zero_ ? frame.rows - 1 : frame.rows);
        cells_.assign(frame.rows, std::string(frame.columns, ' '));
    }

    Cell cell_of(const PlotPoint& point) const {
        const int row = point.y > 0.0 ? y_.cells - 1 - y_.cell(point.y) : frame_.rows - 1;
        return {x_.cell(point.x), row};
    }

    void put(Cell at, char mark) { cells_[at.row][at.column] = mark; }

    // A step of the staircase: to the right at the height of `from`, then down to `to`.
    void join(Cell from, Cell to) {
        for (int column = from.column + 1; column <= to.column; ++column)
            put({column, from.row}, '.');
        for (int row = from.row + 1; row < to.row; ++row)
            put({to.column, row}, '.');
    }

    std::string text() const {
        std::vector<std::string> labels(frame_.rows);
        // Labels every decade if there is room, else every second, third, ...
        const int step = (y_.high - y_.low) / y_.cells + 1;
        for (int decade = y_.high; decade >= y_.low; decade -= step)
            labels[y_.cells - 1 - y_.cell_of_decade(decade)] = fmt::format("1e{}", decade);
        if (has_zero_) labels.back() = "0";
        std::string text = fmt::format("{:>7} {}\n", "", frame_.y_name);
        for (int row = 0; row < frame_.rows; ++row)
            text += trimmed(fmt::format("{:>7} {} {}", labels[row], labels[row].empty() ? '|' : '+',
                                        cells_[row]));
        return text + x_axis();
    }

  private:
    static std::string trimmed(std::string line) {
        line.erase(line.find_last_not_of(' ') + 1);
        return line + '\n';
    }

    std::string x_axis() const {
        std::string ticks(frame_.columns, '-');
        std::string labels(frame_.columns + 8, ' ');
        int free = 0;
        for (int decade = x_.low; decade <= x_.high; ++decade) {
            const int at = x_.cell_of_decade(decade);
            ticks[at] = '+';
            if (at < free) continue;
            const std::string label = fmt::format("1e{}", decade);
            labels.replace(at, label.size(), label);
            free = at + static_cast<int>(label.size()) + 1;
        }
        return fmt::format("{:>7} +-{}\n", "", ticks) +
               trimmed(fmt::format("{:>7}   {}", "", labels)) +
               fmt::format("{:>7}   {}\n", "", frame_.x_name);
    }

    PlotFrame frame_;
    Axis x_;
    Axis y_;
    bool has_zero_ = false;
    std::vector<std::string> cells_;
};

}  // namespace

std::string log_log_plot(std::span<const PlotPoint> points, const PlotFrame& frame) {
    std::vector<PlotPoint> drawn;
    for (const PlotPoint& point : points) {
        if (is_drawable(point)) drawn.push_back(point);
    }
    if (drawn.empty()) return {};
    Field field(drawn, frame);
    std::ranges::stable_sort(drawn, {}, &PlotPoint::x);
    std::optional<Cell> last;
    for (const PlotPoint& point : drawn) {
        if (!point.on_front) continue;
        if (last) field.join(*last, field.cell_of(point));
        last = field.cell_of(point);
    }
    for (const bool on_front : {false, true}) {
        for (const PlotPoint& point : drawn) {
            if (point.on_front == on_front) field.put(field.cell_of(point), point.mark);
        }
    }
    return field.text();
}

}  // namespace carom

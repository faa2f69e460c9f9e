#pragma once

#include <span>
#include <string>
#include <string_view>

/// Plots in characters.
namespace carom {

struct PlotPoint {
    double x = 0.0;  ///< > 0
    double y = 0.0;  ///< >= 0; values that are not finite are left out
    char mark = '*';
    bool on_front = false;  ///< drawn on top, and joined to its neighbours on the front
};

struct PlotFrame {
    int columns = 60;  ///< of the field, >= 8
    int rows = 18;     ///< of the field, >= 4
    std::string_view x_name;
    std::string_view y_name;
};

/// Both axes are logarithmic and run over whole decades, labelled 1e-3, 1e-2, ... A y of zero is
/// drawn on a separate line at the bottom, labelled 0. A staircase of dots joins the points on the
/// front: everything above it or to its right costs more for no less error. If points share a cell,
/// one on the front is drawn, else the last. Lines end with a newline. Empty if no point can be
/// drawn.
std::string log_log_plot(std::span<const PlotPoint> points, const PlotFrame& frame);

}  // namespace carom

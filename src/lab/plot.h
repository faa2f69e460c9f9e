#pragma once

#include <span>
#include <string>
#include <string_view>

/// Plots in characters.
namespace carom {

struct PlotPoint {
    double x = 0.0;  ///< > 0
    double y = 0.0;  ///< >= 0; what is not finite is left out
    char mark = '*';
    bool on_front = false;  ///< drawn on top, and joined to its neighbours on the front
};

struct PlotFrame {
    int columns = 60;  ///< of the field, >= 8
    int rows = 18;     ///< of the field, >= 4
    std::string_view x_name;
    std::string_view y_name;
};

/// Both axes are logarithmic and run over whole decades, which are labelled 1e-3, 1e-2 ... A y of
/// zero stands on a line of its own at the bottom, labelled 0. The points on the front are joined
/// by a staircase of dots: whatever is above it or to its right costs more for no less error. Where
/// points fall into one cell, one on the front is seen, else the last. Lines end with a newline.
/// Empty when no point can be drawn.
std::string log_log_plot(std::span<const PlotPoint> points, const PlotFrame& frame);

}  // namespace carom

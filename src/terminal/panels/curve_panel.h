#pragma once

#include <optional>
#include <string>
#include <vector>

#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

namespace carom {

/// A measured function with its title and its present value.
struct CurvePicture {
    struct Point {
        double x = 0.0;
        double y = 0.0;
        std::optional<double> expected{};
    };
    std::string title;
    std::string value;          ///< beside the title; may be empty
    std::vector<Point> points;  ///< ascending by x
    bool has_bars = false;      ///< a histogram: the measured values are bars
};

/// Draws into `area` the title, the value, and the curve or bars with its ranges at the side and
/// below; in another colour the expected one, where points have it. The range of y includes 0. With
/// fewer than two points it draws no curve; points that are not finite are left out. An area below
/// 16 x 4 stays untouched.
void draw_curve(Canvas& canvas, const CellArea& area, const CurvePicture& picture,
                const Look& look);

}  // namespace carom

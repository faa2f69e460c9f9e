#include "terminal/canvas/own_ground.h"

namespace carom {

void paint_own_ground(Canvas& canvas, const Look& look) {
    if (!look.has_colors()) return;
    const Color ground = ground_color(look);
    const Color text = foreground_color(look);
    for (int row = 0; row < canvas.rows(); ++row) {
        for (int column = 0; column < canvas.columns(); ++column) {
            Cell& cell = canvas.at(column, row);
            if (cell.background == default_color) cell.background = ground;
            if (cell.foreground == default_color) cell.foreground = text;
        }
    }
}

}  // namespace carom

#include "carom/context/play_view.h"

namespace carom {

void PlayView::measure(const Scene& scene) {
    const Board& board = memory.ground.board(scene);
    shown = shown_box(scene, board);
    has_board = !board.is_empty();
}

Camera PlayView::fitted(const CellArea& area, double aspect) const {
    return fit_camera(shown, area, aspect, has_board ? 0.0 : fit_margin);
}

void PlayView::zoom(CellPoint fixed, double factor) {
    camera = zoomed(camera, fixed, factor);
    is_fitted = false;
}

void PlayView::pan(double columns, double rows) {
    camera = panned(camera, columns, rows);
    is_fitted = false;
    follows = false;
}

void PlayView::fit() {
    if (is_fitted) shows_whole = !shows_whole;
    is_fitted = true;
    follows = false;
}

void PlayView::reset() {
    const Look look = options.look;
    options = defaults;
    options.look = look;
    is_fitted = true;
    shows_whole = false;
    follows = false;
}

CellPoint PlayView::middle() const {
    return {camera.area.column + camera.area.columns / 2.0,
            camera.area.row + camera.area.rows / 2.0};
}

}  // namespace carom

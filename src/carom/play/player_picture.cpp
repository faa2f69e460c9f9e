#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "carom/play/player.h"
#include "game/session/conserved.h"
#include "lab/run/judge.h"
#include "physics/broad_phase/cell_frame.h"
#include "physics/tick/totals.h"
#include "terminal/panels/histogram.h"
#include "terminal/panels/pages.h"

namespace carom {
namespace {

/// Panels stand to the right of the world in a window at least this wide, below it in others.
constexpr int wide = 70;
constexpr int least_panel_columns = 24;
constexpr int least_panel_rows = 7;

/// Cuts `rows` from the bottom, or `columns` from the right.
CellArea cut_bottom(CellArea& area, int rows) {
    area.rows -= rows;
    return {area.column, area.row + area.rows, area.columns, rows};
}

CellArea cut_right(CellArea& area, int columns) {
    area.columns -= columns;
    return {area.column + area.columns, area.row, columns, area.rows};
}

std::optional<double> relative(double change, double scale) {
    if (!(scale > 0.0)) return std::nullopt;
    return change / scale;
}

}  // namespace

bool Player::has_histogram() const {
    return std::ranges::any_of(session_.scene().shows,
                               [](const Show& show) { return show.what == Show::What::histogram; });
}

std::string_view Player::speed_unit() const {
    return session_.scene().unit == LengthUnit::natural ? "" : " m/s";
}

void Player::lay_out(const Canvas& canvas, double aspect) {
    CellArea area = world_area(canvas.columns(), canvas.rows());
    histogram_area_ = {};
    energy_area_ = {};
    const bool histogram = shows_histogram_ && has_histogram();
    const int panels = comparison_ ? 0 : (histogram ? 1 : 0) + (shows_energy_ ? 1 : 0);
    if (panels > 0 && area.columns >= wide) {
        CellArea side = cut_right(area, std::max(least_panel_columns, area.columns * 2 / 5));
        if (histogram && shows_energy_) energy_area_ = cut_bottom(side, side.rows / 2);
        (histogram ? histogram_area_ : energy_area_) = side;
    } else if (panels > 0 && area.rows >= 2 * least_panel_rows) {
        CellArea bottom = cut_bottom(area, std::max(least_panel_rows, area.rows / 3));
        (histogram ? histogram_area_ : energy_area_) = bottom;
    }
    if (table_ && !comparison_) table_->cut_panel(area);
    if (comparison_) {
        split_ = split(area, session_.scene().view, aspect);
        area = split_.first;
    }
    const bool is_fine = renderer_in_force(view_) == Renderer::braille;
    if (is_fitted_)
        camera_ = table_ && !comparison_ ? table_->look(session_, area, aspect, is_fine)
                                         : fit_camera(session_.scene().view, area, aspect);
    else if (!(camera_.area == area) || camera_.aspect != aspect)
        camera_ = resized(camera_, area, aspect);
    if (follows_ && selected_) {
        const auto index = index_of(session_.world(), *selected_);
        if (index) {
            camera_.center = session_.world().balls.position[*index];
            is_fitted_ = false;
        } else {
            follows_ = false;
        }
    }
}

Marks Player::marks() const {
    Marks marks;
    const World& world = session_.world();
    if (selected_ && index_of(world, *selected_)) marks.selected_ball = selected_;
    if (shows_cursor_) marks.cursor = pointer_;
    if (seat_) marks.pool = seat_->marks(session_, is_aiming());
    if (table_) marks.table = table_->marks(session_);
    if (!seat_ || !tool_.has_cue()) tool_.mark(world, session_.solver(), speed_unit(), marks);
    if (view_.broad_phase && world.balls.size() > 0) {
        const CellFrame frame = frame_around(world, 2.0 * largest_radius(world.balls));
        marks.broad_phase = CellGrid{frame.origin, frame.cell.x};
    }
    if (ensemble_) marks.copies = ensemble_->copies();
    if (comparison_ && comparison_->divergence()) marks.parting = comparison_->divergence()->place;
    return marks;
}

std::string Player::mode() const {
    if (is_too_small_) return {};
    std::string mode;
    const auto add = [&mode](std::string_view text) {
        mode += (mode.empty() ? "" : ", ") + std::string(text);
    };
    if (clock_.is_seeking()) add("seeking a collision");
    if (clock_.is_behind() && !clock_.is_paused()) add("slower than real");
    if (mouse_is_off_) add("mouse off");
    if (follows_ && selected_) add(fmt::format("following {}", number(*selected_)));
    return mode;
}

std::vector<KeyHelp> Player::hints() const {
    std::vector<KeyHelp> hints;
    const auto hint = [&](Action action, std::string_view what) {
        const std::string keys = keys_.hint(action);
        if (!keys.empty()) hints.push_back({keys, std::string(what)});
    };
    if (seat_ && tool_.is_empty() && !shows_cursor_) hints = pool_hints();
    if (tool_.has_cue()) {
        hint(Action::grab, "shoot");
        hint(Action::menu, "let go");
    } else if (tool_.has_new_edge()) {
        hint(Action::draw_edge, "make the edge");
        hint(Action::menu, "let go");
    } else if (!tool_.is_empty()) {
        hint(Action::grab, "drop");
        hint(Action::pause, clock_.is_paused() ? "go on" : "pause");
    } else if (clock_.is_paused()) {
        hint(Action::pause, "go on");
        hint(Action::step_forward, "step");
        hint(Action::step_back, "step back");
        hint(Action::next_collision, "next collision");
    } else {
        if (table_ && !is_watching()) add_table_hints(hints);
        hint(Action::pause, "pause");
    }
    if (tool_.is_empty() && (shows_cursor_ || selected_) && !is_watching()) {
        hint(Action::grab, "take");
        hint(Action::cue, "cue");
        hint(Action::remove, "remove");
    }
    hint(Action::help, "help");
    if (tool_.is_empty()) {
        if (session_.latest() > 0) hint(Action::restart, "again");
        if (!mouse_is_off_ && !shows_cursor_ && !is_watching() && !seat_ && !table_) {
            hints.push_back({"drag", "move"});
            hints.push_back({"right drag", "shoot"});
        }
        hint(Action::renderer, "look");
        hint(Action::menu, "menu");
        hint(Action::quit, "quit");
        if (!is_watching()) hint(Action::solver, "solver");
    }
    return hints;
}

// The experiments of the level as it stands in its file, as far as the world knows how they go.
std::vector<HudCheck> Player::checks() const {
    std::vector<HudCheck> checks;
    const Scene& scene = session_.scene();
    if (scene.overridden) return checks;
    for (const Expect& expect : scene.expects) {
        using enum QuantityKind;
        if (expect.what.kind == escaped || expect.what.kind == overlap) continue;
        // The panel says these.
        if (is_of_bins(expect.what.kind) && histogram_area_.rows > 0) continue;
        if (const auto measured = measure(expect.what, session_.world(), {}))
            checks.push_back({expect.quantity, *measured, expect.value, expect.tolerance});
    }
    return checks;
}

HudInfo Player::hud() const {
    const World& world = session_.world();
    const Totals sums = totals(world);
    HudInfo info;
    info.title = (is_watching() ? "recording: " : "") + session_.scene().title;
    if (const std::string score = score_line(); !score.empty()) info.title += ": " + score;
    info.title_comes_first = pool() != nullptr;
    if (pool()) info.title = pool_title();
    if (seat_) info.game = pool_line();
    if (table_ && !is_watching()) info.game = hold_line();
    info.solver = solver_text(session_.solver());
    info.solver_is_picked = solver_is_picked_;
    if (solver_is_picked_) info.reason = pick_solver(session_.scene().world).reason;
    info.beside = beside();
    info.time = world.time();
    info.tick = world.tick;
    info.latest_tick = session_.latest();
    info.ticks_per_second = clock_.is_paused() ? 0.0 : clock_.ticks_per_second();
    info.rate = world.rate;
    info.terms = terms_in_force(world.model);
    info.balls = world.balls.size();
    info.heaped = world.heaped.size();
    info.collisions = world.ball_ball_collisions + world.ball_edge_collisions;
    info.checks = checks();
    info.kinetic_energy = sums.kinetic_energy;
    if (world.model.gravity) info.potential_energy = sums.potential_energy;
    info.momentum = sums.momentum;
    const double energy = sums.kinetic_energy + sums.potential_energy;
    if (keeps_energy(world))
        info.energy_drift = relative(energy - reference_.energy, std::fabs(reference_.energy));
    if (keeps_momentum(world))
        info.momentum_drift =
            relative(length(sums.momentum - reference_.momentum), reference_.momentum_scale);
    info.speed = clock_.speed();
    info.is_paused = clock_.is_paused() && !clock_.is_seeking();
    info.mode = mode();
    if (const auto warning = clock_warning()) {
        info.message = *warning;
        info.message_is_error = true;
    } else if (message_seconds_ > 0.0) {
        info.message = message_;
        info.message_is_error = message_is_error_;
    } else if (problem_) {
        info.message = *problem_;
        info.message_is_error = true;
    }
    info.hints = hints();
    return info;
}

void Player::draw_panels(Canvas& canvas) {
    const World& world = session_.world();
    if (energy_area_.rows > 0) {
        draw_energy(canvas, energy_area_, energy_, world.tick_length(), view_.look);
    }
    if (histogram_area_.rows == 0) return;
    const auto show = std::ranges::find(session_.scene().shows, Show::What::histogram, &Show::what);
    Histogram histogram;
    histogram.title = show->of;
    histogram.expected = show->expected;
    histogram.against = show->against;
    const std::vector<std::uint64_t> counts = census(world);
    for (const std::uint32_t counter : show->counters)
        histogram.counts.push_back(counts[counter]);
    draw_histogram(canvas, histogram_area_, histogram, view_.look);
}

void Player::draw(Canvas& canvas, double aspect) {
    needs_draw_ = false;
    is_too_small_ = is_too_small(canvas.columns(), canvas.rows());
    if (is_too_small_) return draw_too_small(canvas);
    if (page_ != Page::none) return draw_page(canvas);
    draw_game(canvas, aspect);
}

void Player::draw_page(Canvas& canvas) {
    constexpr std::string_view footer = "any key goes back";
    const PageExtent extent =
        page_ == Page::help ? draw_help(canvas, keys_.help(), page_scroll_, footer, view_.look)
                            : draw_text_page(canvas, "How this is computed", explanation_lines(),
                                             page_scroll_, footer, view_.look);
    page_scroll_ = extent.scroll;
}

void Player::draw_game(Canvas& canvas, double aspect) {
    canvas.fill({});
    lay_out(canvas, aspect);
    if (is_watching()) watch_commands();
    if (seat_) seat_->look(session_);
    const World& world = session_.world();
    const Totals sums = totals(world);
    energy_.add({world.tick, sums.kinetic_energy, sums.potential_energy});
    draw_world(canvas, camera_, session_.scene(), world, session_.contacts(), marks(), view_,
               memory_);
    if (comparison_) draw_comparison(canvas);
    draw_panels(canvas);
    if (table_ && !comparison_) table_->draw_panel(canvas, session_, view_.look);
    draw_hud(canvas, hud(), view_.look);
}

bool Player::wants_motion() const {
    return !pressed_ && (tool_.has_cue() || tool_.has_new_edge());
}

}  // namespace carom

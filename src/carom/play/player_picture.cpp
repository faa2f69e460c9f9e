#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "carom/context/solver_choice.h"
#include "carom/play/player.h"
#include "carom/play/status.h"
#include "carom/pool/record_page.h"
#include "game/session/conserved.h"
#include "lab/run/report.h"
#include "terminal/panels/large_digits.h"
#include "terminal/panels/pages.h"

/// Draws the player's window: the world with panels and status lines, or a page that covers it.
namespace carom {
namespace {

/// Divides the window between the world and the panels.
void lay_out(PlayContext& play, const Canvas& canvas, double aspect) {
    const Scene& scene = play.session.scene();
    PlayView& view = play.view;
    view.measure(scene);
    const bool is_split = play.companion.comparison().has_value();
    CellArea area = world_area(canvas.columns(), canvas.rows());
    play.panels.cut(area, scene, is_split);
    if (is_split)
        area = play.companion.split_area(area, view.shown, aspect);
    else
        play.controller->cut_panel(play, area);
    if (view.is_fitted)
        view.camera =
            is_split ? view.fitted(area, aspect) : play.controller->fit(play, area, aspect);
    else if (!(view.camera.area == area) || view.camera.aspect != aspect)
        view.camera = resized(view.camera, area, aspect);
}

/// Keeps the selected ball in the centre.
void follow_ball(PlayContext& play) {
    PlayView& view = play.view;
    if (!view.follows || !view.selected) return;
    const World& world = play.session.world();
    const auto index = index_of(world, *view.selected);
    view.follows = index.has_value();
    if (!index) return;
    view.camera.center = world.balls().position[*index];
    view.is_fitted = false;
}

Annotations annotations_of(const PlayContext& play) {
    Annotations annotations;
    const World& world = play.session.world();
    const auto& selected = play.view.selected;
    if (selected && index_of(world, *selected)) annotations.selected_ball = selected;
    if (play.pointer.shows_cursor) annotations.cursor = play.pointer.at;
    play.controller->annotate(play, annotations);
    const CellFrame& cells = play.session.cells();
    if (!(cells == CellFrame{})) annotations.broad_phase = CellGrid{cells.origin, cells.cell.x};
    play.companion.annotate(annotations);
    if (const auto line = play.messages.line(); line && line->place)
        annotations.marks.push_back(*line->place);
    return annotations;
}

/// An explanation of how the game is computed. Each item begins with a word, which indented lines
/// continue.
std::vector<PageItem> explanation_items(const PlayContext& play) {
    const Session& session = play.session;
    const std::string text = explanation(
        session.world().model(), session.world().rate(), pick_solver(session.scene().world),
        play.solver_is_picked ? std::nullopt : std::optional(session.solver()));
    std::vector<PageItem> items;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        const std::string_view line = std::string_view(text).substr(from, end - from);
        const std::size_t left = line.find(' ');
        const std::size_t right = std::min(line.find_first_not_of(' ', left), line.size());
        if (left > 0 || items.empty()) {
            items.push_back({std::string(line.substr(0, left)), std::string(line.substr(right))});
        } else {
            items.back().text += ", " + std::string(line.substr(right));
        }
        from = end + 1;
    }
    if (const auto& other = play.companion.comparison())
        items.push_back({"beside", fmt::format("{}: {}", solver_text(other->solver()),
                                               method_of(other->solver().kind))});
    return items;
}

constexpr std::string_view back_footer = "any other key: back to the game";
constexpr std::string_view closing_footer = "any key: back to the game";

/// Names the keys that lead elsewhere from a page, each with what it does.
std::string footer_with(
    const PlayContext& play,
    std::initializer_list<std::pair<std::string_view, std::string_view>> actions) {
    std::string footer;
    for (const auto& [action_name, what] : actions)
        if (const std::string key = play.keys.hint(action_name); !key.empty())
            footer += fmt::format("{}: {}   ", key, what);
    return footer + std::string(back_footer);
}

std::vector<PageItem> about_items(const LevelWords& words) {
    std::vector<PageItem> items;
    for (const LevelWords::Item& item : words.items)
        items.push_back({item.left, item.text});
    if (items.empty() && words.goal.empty()) items.push_back({"", "The level says nothing more."});
    return items;
}

/// Whether what matters is the number of collisions: the level expects it.
bool counts_collisions(const Scene& scene) {
    return std::ranges::any_of(
        scene.expects, [](const Expect& expect) { return expect.quantity == "collisions"; });
}

/// `pool`: who plays at a pool table; null elsewhere.
void draw_page(PlayContext& play, const PoolPlayers* pool, Canvas& canvas) {
    CoveringPage& page = play.page;
    const Look& look = play.view.options.look;
    PageExtent extent;
    switch (page.kind) {
        case CoveringPage::Kind::none:
            return;
        case CoveringPage::Kind::help:
            extent = draw_help(
                canvas, play.keys.help(play.controller->kind(), play.controller->help_words(play)),
                page.scroll,
                footer_with(play, {{"about", "about this level"}, {"change-key", "change a key"}}),
                look);
            break;
        case CoveringPage::Kind::about:
            extent = draw_about(canvas, play.session.scene().title, play.words.goal,
                                about_items(play.words), page.scroll,
                                footer_with(play, {{"help", "keys"}}), look);
            break;
        case CoveringPage::Kind::record:
            extent =
                draw_text_page(canvas, "Your record at pool", record_lines(pool->record(), look),
                               page.scroll, closing_footer, look);
            break;
        case CoveringPage::Kind::explanation:
            extent = draw_about(canvas, "Solver and model", {}, explanation_items(play),
                                page.scroll, closing_footer, look);
            break;
        case CoveringPage::Kind::problems:
            extent = draw_text_page(canvas, "Errors", play.messages.problem(), page.scroll,
                                    closing_footer, look);
            break;
    }
    page.scroll = extent.scroll;
    page.most = extent.most;
}

void draw_game(PlayContext& play, Canvas& canvas, double aspect) {
    canvas.fill({});
    lay_out(play, canvas, aspect);
    follow_ball(play);
    play.controller->look(play);
    const Session& session = play.session;
    const World& world = session.world();
    const Camera& camera = play.view.camera;
    const Look& look = play.view.options.look;
    const Totals sums = totals(world);
    play.panels.sample(world.tick(), sums,
                       conserves_energy(world) ? play.reference.energy_drift(sums) : std::nullopt);
    ViewOptions options = play.view.options;
    options.counters = options.counters && !play.panels.is_histogram_drawn();
    draw_world(canvas, camera, session.scene(), world, session.contacts(), annotations_of(play),
               options, play.view.memory);
    const bool is_split = play.companion.comparison().has_value();
    if (counts_collisions(session.scene()) && !is_split)
        draw_large_count(canvas, camera.area,
                         fmt::format("{}", world.ledger().ball_ball_collisions +
                                               world.ledger().ball_edge_collisions),
                         look);
    if (is_split)
        play.companion.draw(canvas, session, camera, play.view.selected, play.view.options);
    play.panels.draw(canvas, session, play.observation->observer(), camera, look);
    if (!is_split) play.controller->draw_panel(play, canvas);
    draw_hud(canvas, status_of(play), look);
}

}  // namespace

void Player::draw(Canvas& canvas, double aspect) {
    play_.needs_draw = false;
    is_too_small_ = is_too_small(canvas.columns(), canvas.rows());
    if (is_too_small_) return draw_too_small(canvas);
    if (play_.page.is_open()) return draw_page(play_, pool_players(), canvas);
    draw_game(play_, canvas, aspect);
}

// An aim is not drawn before Controller::look() is called.
Vec2 Player::preview_size() {
    play_.view.measure(session().scene());
    return size(play_.view.shown);
}

void Player::draw_preview(Canvas& canvas, const CellArea& area, double aspect) {
    play_.needs_draw = false;
    play_.view.shows_whole = true;
    play_.view.measure(session().scene());
    play_.view.camera = play_.controller->fit(play_, area, aspect);
    ViewOptions options = view();
    options.counters = options.board_texts = false;
    draw_world(canvas, camera(), session().scene(), session().world(), session().contacts(),
               annotations_of(play_), options, play_.view.memory);
}

}  // namespace carom

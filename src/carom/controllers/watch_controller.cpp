#include "carom/controllers/watch_controller.h"

#include <utility>

#include "carom/context/view_control.h"
#include "carom/pool/pool_aim.h"
#include "carom/pool/pool_scoreboard.h"

namespace carom {
namespace {

bool is_pool(const PlayContext& play) {
    return PoolAim::is_at(play.session.scene());
}

}  // namespace

WatchController::WatchController(const Session& session) {
    if (PinballFeedback::is_at(session)) pinball_.emplace();
}

void WatchController::perform(PlayContext& play, const Action& action) {
    if (action.where != Where::anywhere)
        return say(play, "This is a recording: you can only watch.");
    if (const auto* perform = std::get_if<void (*)(PlayContext&)>(&action.perform))
        (*perform)(play);
}

void WatchController::press(PlayContext& play, const InputEvent& event) {
    start_panning(play, event);
}

void WatchController::pass(PlayContext& play, double seconds) {
    if (pinball_) pinball_->pass(play, seconds);
}

void WatchController::after_ticks(PlayContext& play, double seconds) {
    if (pinball_) pinball_->after_ticks(play, seconds, false);
    if (auto outcome = announcer_.tell(play.session, names_)) say(play, *std::move(outcome));
}

void WatchController::cut_panel(const PlayContext& play, CellArea& area) {
    if (pinball_) pinball_->cut_panel(play, area);
    if (is_pool(play)) pool_panel_ = cut_scoreboard(area, play.view.shown);
}

Camera WatchController::fit(const PlayContext& play, const CellArea& area, double aspect) {
    return pinball_ ? pinball_->fit(play, area, aspect) : Controller::fit(play, area, aspect);
}

// Commands of a recording change the energy, which is not drift.
void WatchController::look(PlayContext& play) {
    play.reference.watch_commands(play.session);
}

void WatchController::annotate(const PlayContext& play, Annotations& annotations) const {
    if (pinball_) pinball_->annotate(play, annotations);
    if (is_pool(play)) {
        annotations.pool.emplace();
        annotations.pool->numbers = numbers_of(play.session);
        annotations.pool->returned = returned_of(play.session);
    }
}

void WatchController::draw_panel(const PlayContext& play, Canvas& canvas) const {
    if (pinball_) pinball_->draw_panel(play, canvas, false);
    const ViewOptions& options = play.view.options;
    if (is_pool(play))
        draw_pool_panel(canvas, pool_panel_, scoreboard_of(play.session, names_),
                        renderer_in_force(options), play.view.camera.aspect, options.look);
}

void WatchController::add_status(const PlayContext& play, HudInfo& info) const {
    info.title = "recording: " + info.title;
    if (pinball_) pinball_->add_score(play, info);
    add_pool_title(play.session, names_, std::nullopt, info);
}

void WatchController::set_high_scores(HighScores scores) {
    if (pinball_) pinball_->scores().set(std::move(scores));
}

}  // namespace carom

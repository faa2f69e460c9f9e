#include "carom/controllers/pinball_feedback.h"

#include <fmt/format.h>

#include <utility>

#include "carom/controllers/pinball_panel.h"
#include "game/pinball/pinball.h"
#include "game/rules/rules.h"

namespace carom {
namespace {

const PinballState& state_of(const PlayContext& play) {
    return std::get<PinballState>(play.session.game());
}

}  // namespace

bool PinballFeedback::is_at(const Session& session) {
    return std::holds_alternative<PinballState>(session.game());
}

// Whoever steps back and then changes the game discards what had followed.
void PinballFeedback::note_rewind(PlayContext& play) {
    const std::uint64_t before = std::exchange(latest_, play.session.latest());
    if (latest_ == 0) return scores_.restart();
    const PinballTable& table = play.session.scene().table;
    if (latest_ >= before || !table.is_game || state_of(play).score == 0) return;
    scores_.leave_out();
    if (table.highscores > 0) say(play, "Rewound: this game is not for the high scores.");
}

void PinballFeedback::pass(PlayContext& play, double seconds) {
    note_rewind(play);
    display_.follow(play.session, seconds);
    if (!play.clock.is_paused() && scores_.pass(seconds)) play.needs_draw = true;
}

void PinballFeedback::after_ticks(PlayContext& play, double seconds, bool is_demonstrating) {
    const PinballState& state = state_of(play);
    if (bell_.rings(play.session, seconds) && play.terminal.rings) play.terminal.bell_is_due = true;
    scores_.follow(state, is_demonstrating, is_watching(play));
    if (state.message == last_message_) return;
    last_message_ = state.message;
    if (!last_message_.empty() && !display_.has_panel()) say(play, last_message_);
}

Camera PinballFeedback::fit(const PlayContext& play, const CellArea& area, double aspect) {
    // Braille has enough dots to show the ball on the whole table.
    const bool is_fine = renderer_in_force(play.view.options).down >= 4;
    return display_.look(play.session, play.view.shown, area, aspect,
                         play.view.shows_whole || is_fine);
}

void PinballFeedback::annotate(const PlayContext& play, Annotations& annotations) const {
    annotations.table = display_.annotations(play.session);
}

void PinballFeedback::draw_panel(const PlayContext& play, Canvas& canvas,
                                 bool is_demonstrating) const {
    display_.draw_panel(canvas, play.session, scores_, is_demonstrating, play.view.options.look);
}

void PinballFeedback::add_score(const PlayContext& play, HudInfo& info) const {
    const PinballState& state = state_of(play);
    const PinballTable& table = play.session.scene().table;
    if (!table.is_game || display_.has_panel()) return;
    info.title +=
        fmt::format(": score {}, ball {} of {}", grouped(state.score), state.ball, table.balls);
    if (state.multiplier > 1) info.title += fmt::format(", bonus x{}", state.multiplier);
    if (state.is_tilted) info.title += ", tilt";
    if (state.phase == PinballState::Phase::over) info.title += ", game over";
}

}  // namespace carom

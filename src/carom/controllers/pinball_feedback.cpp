#include "carom/controllers/pinball_feedback.h"

#include <fmt/format.h>

#include <algorithm>
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

bool PinballFeedback::may_enter(const PlayContext& play) const {
    const PinballTable& table = play.session.scene().table;
    const bool has_scored = std::ranges::max(scores_of(state_of(play))) > 0;  // anybody
    return table.is_game && scores_.scores().most > 0 && has_scored && !scores_.is_left_out() &&
           !is_watching(play);
}

void PinballFeedback::leave_out(PlayContext& play, const char* why) {
    if (!may_enter(play)) return;
    scores_.leave_out();
    say(play, fmt::format("{}: this game is not for the high scores.", why));
}

// Whoever steps back and then changes the game discards what had followed. In slow motion a table
// is easier to play.
void PinballFeedback::note_time(PlayContext& play) {
    const std::uint64_t before = std::exchange(latest_, play.session.latest());
    if (latest_ == 0) return scores_.restart();
    if (latest_ < before) leave_out(play, "Rewound");
    const bool is_over = state_of(play).phase == PinballState::Phase::over;
    if (latest_ > before && play.clock.speed() < 1.0 && !is_over) leave_out(play, "Slow motion");
}

void PinballFeedback::pass(PlayContext& play, double seconds) {
    note_time(play);
    display_.follow(play.session, seconds);
    listen(play);
    if (!play.clock.is_paused() && scores_.pass(seconds)) play.needs_draw = true;
}

void PinballFeedback::after_ticks(PlayContext& play, double seconds, bool is_demonstrating) {
    const PinballState& state = state_of(play);
    if (bell_.rings(play.session, seconds) && play.terminal.rings) play.terminal.bell_is_due = true;
    scores_.follow(state, is_demonstrating, is_watching(play));
    listen(play);
}

void PinballFeedback::listen(PlayContext& play) {
    if (!display_.listen(play.session)) return;
    play.needs_draw = true;
    const std::string& message = display_.messages().text();
    if (!message.empty() && !display_.has_panel()) say(play, message);
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
    // The score first: a narrow window cuts the rest.
    std::string score =
        fmt::format("{}, ball {} of {}", grouped(state.score), state.ball, table.balls);
    if (state.multiplier > 1) score += fmt::format(", bonus x{}", state.multiplier);
    if (state.is_tilted) score += ", tilt";
    if (state.phase == PinballState::Phase::over) score += ", game over";
    info.title = score + ": " + info.title;
}

}  // namespace carom

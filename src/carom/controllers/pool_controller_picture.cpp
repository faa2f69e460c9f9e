#include <fmt/format.h>

#include "carom/controllers/pool_controller.h"
#include "carom/pool/pool_scoreboard.h"
#include "carom/pool/shot_picture.h"
#include "game/referees/referee.h"

/// Draws a game of pool.
namespace carom {
namespace {

constexpr double last_seconds = 5.0;  // s of the shot clock that are announced prominently

}  // namespace

void PoolController::annotate(const PlayContext& play, Annotations& annotations) const {
    annotations.pool = aim_.annotations(play.session, is_striking(play));
    if (const CandidateShot* const shot = players_.opponent_shot(play.session))
        show_shot(play.session, *shot, *annotations.pool);
    if (!is_pulling(play)) return Controller::annotate(play, annotations);
    const MouseStroke* const push = stroke_.push();
    if (!push || !annotations.pool || !annotations.pool->stick) return;
    PoolAnnotations::Line& stick = *annotations.pool->stick;
    const Vec2 back = (stick.to - stick.from) / length(stick.to - stick.from) * push->pull();
    stick = {stick.from + back, stick.to + back};
}

// Where the rules show a part of the table, nothing beyond it is seen, such as the next hole of a
// course; `0` switches to the whole of it and back.
Camera PoolController::fit(const PlayContext& play, const CellArea& area, double aspect) {
    const ShotsState* const shots = shots_of(play.session);
    const auto part = shots ? box_to_look_at(play.session.scene(), *shots) : std::nullopt;
    return part && !play.view.shows_whole ? fit_camera_to_part(*part, area, aspect)
                                          : play.view.fitted(area, aspect);
}

void PoolController::cut_panel(const PlayContext& play, CellArea& area) {
    panel_ = cut_scoreboard(area, play.view.shown);
}

void PoolController::draw_panel(const PlayContext& play, Canvas& canvas) const {
    PoolPanel panel = scoreboard_of(play.session, players_.names());
    if (is_aiming(play)) {
        const command::Strike strike = aim_.strike(play.session);
        panel.tip = PoolPanel::Tip{strike.side, strike.follow};
    }
    const ViewOptions& options = play.view.options;
    draw_pool_panel(canvas, panel_, panel, renderer_in_force(options), play.view.camera.aspect,
                    options.look);
}

// One line: the aim of the player or of the AI player; while balls roll, the call and how the
// stroke went; then the outcome.
std::string PoolController::line(const PlayContext& play) const {
    if (const StrokeMeter* const meter = stroke_.meter())
        return meter->text(play.keys.hint("grab"), play.view.options.look);
    if (is_pulling(play) && stroke_.push())
        return stroke_.push()->pull() > 0.0 ? "stroke  now push it forward: the ball gets its speed"
                                            : "stroke  pull the mouse back from the ball";
    if (is_aiming(play)) return aim_.line(play.session, play.view.options.look);
    const std::string stroke = stroke_.last_text(play.view.options.look);
    if (const ShotsState* const shots = shots_of(play.session))
        return shots->is_shooting ? stroke : shots->message;
    const PoolPlay* const pool = pool_of(play.session);
    if (!pool) return "";
    if (players_.is_opponents_turn(play.session)) return players_.opponent_text();
    if (!pool->is_shooting) return outcome_text(*pool, players_.names());
    const std::string called = call_text(play.session.scene(), pool->call);
    if (called.empty()) return stroke;
    return "called: " + called + (stroke.empty() ? "" : "  " + stroke);
}

void PoolController::add_status(const PlayContext& play, HudInfo& info) const {
    const auto left = players_.time_left(play.session);
    add_pool_title(play.session, players_.names(), left, info);
    info.game = line(play);
    const PoolPlay* const pool = pool_of(play.session);
    if (pool && !players_.is_opponents_turn(play.session))
        for (const PoolChoice choice : pool->rules.choices)
            info.choices.push_back({fmt::format("{}", info.choices.size() + 1),
                                    std::string(choice_text(pool->rules, choice))});
    // The last seconds for the shot, or for the choice.
    if (!left || *left > last_seconds || players_.is_opponents_turn(play.session)) return;
    info.message = fmt::format("{} left", clock_text(*left));
    info.message_is_error = true;
}

std::vector<HelpWords> PoolController::help_words(const PlayContext& play) const {
    const PoolPlay* const pool = pool_of(play.session);
    if (!pool) return {};
    return {{"call", pool->rules.referee->declarations()}};
}

void PoolController::add_hints(const PlayContext& play, std::vector<KeyHelp>& hints) const {
    if (is_pulling(play)) {
        hints.push_back(stroke_.push() ? KeyHelp{"push forward", "strike"}
                                       : KeyHelp{"let go", "shoot"});
        hints.push_back({play.keys.hint("menu"), "cancel"});
        return;
    }
    if (play.pointer.shows_cursor && play.pointer.tool.has_ball()) {
        hints.push_back({"arrows", "move the ball"});
        hints.push_back({play.keys.hint("grab"), "put it down"});
        return;
    }
    if (!play.pointer.tool.is_empty() || play.pointer.shows_cursor) return;
    const auto hint = [&](std::string_view action_name, std::string_view what) {
        const std::string keys = play.keys.hint(action_name);
        if (!keys.empty()) hints.push_back({keys, std::string(what)});
    };
    const PoolPlay* const pool = pool_of(play.session);
    if (pool && pool->rules.phase == PoolPhase::over)
        hint("grab", match_winner(*pool) ? "the next match" : "the next frame");
    const bool is_over = pool && pool->rules.phase == PoolPhase::over;
    const ShotsState* const shots = shots_of(play.session);
    if (shots && shots->is_over) hint("grab", "a new game");
    if (is_over || (shots && shots->is_over)) hint("keep-recording", "keep a recording");
    if (are_rolling(play)) return hint("to-rest", "skip until they rest");
    if (stroke_.meter()) {
        hint("grab", "strike");
        hint("menu", "no stroke");
    }
    if (!is_aiming(play)) return;
    const bool in_match = players_.is_match(play.session);
    hint("grab", in_match ? "stroke" : "shoot");
    const bool is_new = pool ? !pool->shooter : !shots || shots->shots == 0 || shots->is_over;
    if (aim_.may_place(play.session)) hint("place-cue-ball", "place the ball");
    if (pool && pool->rules.may_push_out) hint("call", "push out");
    if (pool && is_new && !in_match) hint("opponent", "opponent");
    if (aim_.may_choose(play.session)) hint("next-ball", "next of your balls");
    if (!play.terminal.mouse_is_off && !has_turns(play.session))
        hints.push_back({"drag", "place a ball"});
    hints.push_back({"arrows", "aim, power"});
    const bool has_pockets = !play.session.scene().pool.pockets.empty();
    hint("next-pot", in_match || !has_pockets ? "next ball" : "next pot");
    if (!play.terminal.mouse_is_off) hints.push_back({"pull the cue", "shoot"});
    hints.push_back({"shift-arrows", "tip"});
    if (shots && is_new) hint("opponent", in_match ? "practice" : "for real");
    if (in_match) return;
    hint("aids", "lines");
    if (pool) hint("coach", "coach");
    if (pool && players_.opponent() == 0 && !is_new) hint("opponent", "opponent");
}

}  // namespace carom

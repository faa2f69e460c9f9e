#include "carom/pool/pool_scoreboard.h"

#include <fmt/format.h>

#include <algorithm>

#include "game/referees/eight_ball.h"
#include "game/referees/referee.h"

namespace carom {
namespace {

constexpr int last_ball = 15;
constexpr int eight = 8;

PoolPanel::Player player_of(const PoolPlay& play, int player, const PlayerNames& names) {
    PoolPanel::Player shown;
    const auto index = static_cast<std::size_t>(player);
    shown.name = names[index];
    shown.frames = play.frames[index];
    shown.is_turn = play.rules.player == player && play.rules.phase != PoolPhase::over;
    if (!play.rules.referee->score_text(play.rules).empty())
        shown.group = fmt::format("{} {}", play.rules.score[index],
                                  play.rules.score[index] == 1 ? "point" : "points");
    const auto group = group_of_player(play.rules, player);
    if (!group) return shown;
    shown.group = *group == PoolGroup::solids ? "solids" : "stripes";
    for (int ball = 1; ball <= last_ball; ++ball)
        if (group_of(ball) == group && !is_down(play.rules, ball)) shown.left.push_back(ball);
    if (shown.left.empty() && !is_down(play.rules, eight)) shown.left.push_back(eight);
    return shown;
}

// Its score, and where each player has a cue ball, that and the inning.
PoolPanel::Player player_of(const Scene& scene, const ShotsState& shots, std::uint32_t player,
                            const PlayerNames& names) {
    PoolPanel::Player shown;
    shown.name = names[player];
    shown.frames = shots.players[player].score;
    const std::vector<Cue>& cues = scene.pool.cues;
    const std::uint32_t innings = shots.players[player].innings;
    if (cues.size() > 1) shown.group = cue_name(scene, cues[player % cues.size()]);
    if (cues.size() > 1 && innings > 0) shown.group += fmt::format(", inning {}", innings);
    shown.is_turn = shots.rules.player == player && !shots.is_over;
    return shown;
}

}  // namespace

PoolPanel scoreboard_of(const Session& session, const PlayerNames& names) {
    PoolPanel panel;
    if (const auto* play = std::get_if<PoolPlay>(&session.game())) {
        panel.players = {player_of(*play, 0, names), player_of(*play, 1, names)};
        panel.race = play->race;
        for (int ball = 1; ball <= last_ball && play->rules.referee->has_numbers(); ++ball)
            if (is_down(play->rules, ball)) panel.tray.push_back(ball);
        return panel;
    }
    if (const auto* shots = std::get_if<ShotsState>(&session.game());
        shots && shots->players.size() == 2)
        panel.players = {player_of(session.scene(), *shots, 0, names),
                         player_of(session.scene(), *shots, 1, names)};
    for (const Rack& rack : session.scene().pool.racks)
        for (std::size_t i = 0; i < rack.balls.size(); ++i)
            if (!index_of(session.world(), rack.balls[i]))
                panel.tray.push_back(static_cast<int>(i) + 1);
    return panel;
}

CellArea cut_scoreboard(CellArea& area, const Box& shown) {
    constexpr double aspect = 2.0;  // of most terminals: this only decides where the panel is
    const Vec2 extent = size(shown);
    return extent.y > 0.0 ? cut_pool_panel(area, extent.x / extent.y, aspect) : CellArea{};
}

}  // namespace carom

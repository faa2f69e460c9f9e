#include "carom/controllers/pinball_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "game/pinball/pinball.h"
#include "game/rules/rules.h"

namespace carom {
namespace {

std::string ball_line(const Session& session) {
    const auto& state = std::get<PinballState>(session.game());
    std::string line = fmt::format("ball {} of {}", state.ball, session.scene().table.balls);
    if (state.extra_balls > 0) line += fmt::format(", {} extra", state.extra_balls);
    return line;
}

std::string bonus_line(const Session& session) {
    const auto& state = std::get<PinballState>(session.game());
    if (state.bonus <= 0) return "bonus 0";
    std::string line =
        fmt::format("bonus {} x {}", state.bonus, grouped(session.scene().table.bonus));
    if (state.multiplier > 1) line += fmt::format(" x {}", state.multiplier);
    return line;
}

/// The players' scores, if there are several, the one whose turn it is marked.
std::vector<std::string> player_lines(const Session& session) {
    const auto& state = std::get<PinballState>(session.game());
    std::vector<std::string> lines;
    const std::vector<std::int64_t> scores = scores_of(state);
    for (std::size_t i = 0; scores.size() > 1 && i < scores.size(); ++i)
        lines.push_back(fmt::format("{} player {}  {}", i == state.rules.player ? ">" : " ", i + 1,
                                    grouped(scores[i])));
    return lines;
}

/// What the last game of people scored, while carom plays; empty: nobody has played.
std::string last_game_line(const PinballScores& scores) {
    std::string line;
    for (const std::int64_t score : scores.last_game())
        line += (line.empty() ? "last game: " : ", ") + grouped(score);
    return line;
}

/// What the score reaches next: a place in the table of high scores, or the award of an extra ball.
std::string target_line(const Session& session, const PinballScores& scores) {
    const auto& state = std::get<PinballState>(session.game());
    const HighScore* next = nullptr;
    for (const HighScore& score : scores.scores().lines)
        if (score.score >= state.score) next = &score;
    const std::int64_t replay = session.scene().table.replay;
    if (!state.has_replay && state.score < replay && (!next || replay <= next->score))
        return fmt::format("extra ball at {}", grouped(replay));
    if (next) return fmt::format("to beat: {} by {}", grouped(next->score), next->initials);
    return scores.scores().lines.empty() ? "" : "the best score so far";
}

// The inserts with a name. Those of one statement have one name between them.
std::vector<ScoreLight> lights_of(const Session& session) {
    const auto& state = std::get<PinballState>(session.game());
    const Scene& scene = session.scene();
    const std::span<const std::uint32_t> wanted = shots_to_make(scene, session.world(), state);
    std::vector<ScoreLight> lights;
    std::vector<std::uint32_t> told;  // an insert may be in several groups
    const auto add = [&](std::uint32_t group, std::uint32_t named,
                         const std::vector<std::uint32_t>& devices) {
        if (std::ranges::count(told, named) > 0) return;
        told.push_back(named);
        const DeviceDress& dress = scene.dress.devices[named];
        ScoreLight light{dress.text, {}, std::ranges::count(wanted, group) > 0, {}};
        for (const std::uint32_t device : devices)
            light.lamps.push_back(state.is_lit[device] != 0);
        if (dress.color)
            light.color = Rgb{static_cast<int>(*dress.color >> 16 & 0xffU),
                              static_cast<int>(*dress.color >> 8 & 0xffU),
                              static_cast<int>(*dress.color & 0xffU)};
        lights.push_back(std::move(light));
    };
    for (std::uint32_t group = 0; group < scene.table.groups.size(); ++group) {
        const std::vector<std::uint32_t>& devices = scene.table.groups[group].devices;
        std::vector<std::uint32_t> named;
        for (const std::uint32_t device : devices)
            if (scene.dress.devices[device].is_insert && !scene.dress.devices[device].text.empty())
                named.push_back(device);
        if (named.size() == 1) add(group, named.front(), devices);
        for (const std::uint32_t device : named)
            if (named.size() > 1) add(group, device, {device});
    }
    return lights;
}

/// Lights that go out by themselves: "GETAWAY 18 s". Gates and posts that shut are no lights.
std::vector<std::string> timer_lines(const Session& session) {
    const auto& state = std::get<PinballState>(session.game());
    const Scene& scene = session.scene();
    std::vector<std::string> lines;
    std::vector<std::uint32_t> told;
    for (std::size_t i = 0; i < scene.table.devices.size(); ++i) {
        const std::uint64_t until = state.lit_until[i];
        const std::uint64_t tick = session.world().tick();
        const std::uint32_t group = scene.table.devices[i].group;
        if (traits(scene.table.devices[i].kind).light == DeviceLight::opening) continue;
        if (state.is_lit[i] == 0 || until <= tick || std::ranges::count(told, group) > 0) continue;
        told.push_back(group);
        const std::string& text = scene.dress.devices[i].text;
        lines.push_back(
            fmt::format("{}  {:.0f} s", text.empty() ? scene.table.groups[group].name : text,
                        std::ceil(static_cast<double>(until - tick) / session.world().rate())));
    }
    return lines;
}

// As on real tables, the ball saver works for a moment after its light has gone out: who sees the
// ball drain just then would else feel cheated.
constexpr double saver_grace = 2.0;  // s

/// Tilt, or the ball saver and warnings; empty if there are none.
std::string safety_line(const Session& session) {
    const auto& state = std::get<PinballState>(session.game());
    const std::uint64_t tick = session.world().tick();
    if (state.is_tilted) return "TILT";
    std::string line;
    const auto saved = static_cast<double>(state.save_until - std::min(tick, state.save_until));
    const double left = saved / session.world().rate() - saver_grace;
    if (left > 0.0 && state.phase != PinballState::Phase::over)
        line = fmt::format("ball saver {:.0f} s", std::ceil(left));
    if (state.warnings == 0) return line;
    return fmt::format("{}warning {} of {}", line.empty() ? "tilt " : line + ", ", state.warnings,
                       session.scene().table.warnings);
}

}  // namespace

ScorePanel score_panel(const Session& session, const PinballScores& scores, bool is_demonstrating) {
    const auto& state = std::get<PinballState>(session.game());
    const std::optional<std::string>& initials = scores.initials();
    ScorePanel panel;
    panel.title = session.scene().title;
    panel.score = grouped(state.score);
    if (session.scene().table.is_game)
        panel.lines = {ball_line(session), bonus_line(session), target_line(session, scores),
                       safety_line(session)};
    const std::vector<std::string> players = player_lines(session);
    panel.lines.insert(panel.lines.begin(), players.begin(), players.end());
    for (std::string& line : timer_lines(session))
        panel.lines.push_back(std::move(line));
    if (state.phase == PinballState::Phase::playing)
        panel.task = task_text(session.scene(), session.world(), state);
    panel.message = state.message;
    panel.lights = lights_of(session);
    if (initials)
        panel.call =
            (scores.player() == 0 ? "YOUR INITIALS: "
                                  : fmt::format("PLAYER {}, INITIALS: ", scores.player())) +
            *initials + std::string(3 - initials->size(), '_');
    else if (state.phase == PinballState::Phase::over)
        panel.call = "PRESS ENTER TO START";
    else if (is_demonstrating)
        panel.call = "DEMONSTRATION";
    if (const std::string last = last_game_line(scores); is_demonstrating && !last.empty())
        panel.lines.insert(panel.lines.begin(), last);
    int rank = 0;
    for (const HighScore& score : scores.scores().lines)
        panel.high_scores.push_back({fmt::format("{}", ++rank), score.initials,
                                     grouped(score.score), scores.newest() == score});
    if (session.scene().table.is_game && panel.high_scores.empty())
        panel.high_scores.push_back({"", "none yet", "", false});
    return panel;
}

}  // namespace carom

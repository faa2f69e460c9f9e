#include "lab/games/demo_games.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "game/ai/demo_player.h"
#include "game/session/game_state.h"

namespace carom {
namespace {

constexpr double longest_ball = 3600.0;  // s
constexpr std::size_t bars = 14;
constexpr std::size_t bar_columns = 40;

bool is_outside(const World& world, const Box& table) {
    return std::ranges::any_of(world.balls().position, [&](Vec2 at) {
        return !(at.x > table.low.x && at.x < table.high.x && at.y > table.low.y &&
                 at.y < table.high.y);
    });
}

// 1, 2 or 5 times a power of ten.
double round_up(double width) {
    double round = 1.0;
    while (round < width) {
        if (2.0 * round >= width) return 2.0 * round;
        if (5.0 * round >= width) return 5.0 * round;
        round *= 10.0;
    }
    return round;
}

// The last bar counts all larger values.
std::string histogram(std::vector<double> values, std::string_view title) {
    if (values.empty()) return {};
    std::ranges::sort(values);
    const double most = values[values.size() - 1 - values.size() / 50];
    const double width = round_up(most / static_cast<double>(bars));
    std::vector<std::size_t> counts(bars, 0);
    for (const double value : values)
        ++counts[std::min(bars - 1, static_cast<std::size_t>(value / width))];
    const std::size_t highest = *std::ranges::max_element(counts);
    std::string text = fmt::format("{}\n", title);
    for (std::size_t i = 0; i < bars; ++i) {
        const std::size_t length = (counts[i] * bar_columns + highest - 1) / highest;
        const double from = width * static_cast<double>(i);
        text += fmt::format("{:>9.0f}{} {:>6} {}\n", from, i + 1 == bars ? '+' : ' ', counts[i],
                            std::string(length, '#'));
    }
    return text;
}

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

double median_of(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::ranges::sort(values);
    return values[values.size() / 2];
}

}  // namespace

DemoGames play_demo_games(const Scene& scene, const SolverSettings& settings, std::uint64_t balls,
                          const std::function<bool()>& keep_going) {
    DemoGames games;
    World world = scene.world;
    GameState game = begin_game(scene);
    const auto& state = std::get<PinballState>(game);
    Solver solver(settings);
    DemoPlayer player;
    const Box table = grow(scene.view, 0.1 * world.balls().radius[0]);
    std::map<std::uint32_t, std::uint64_t> served;  // tick, by ball
    std::size_t removals = 0;
    std::uint64_t last_drain = 0;
    bool was_over = false;
    while (state.drained < balls) {
        for (const command::Press& press : player.play(scene, world, state))
            execute(scene, world, game, press);
        solver.tick(world);
        update_game(scene, world, game, solver.contacts());
        for (const BallId id : world.balls().id)
            served.try_emplace(number(id), world.tick());
        if (is_outside(world, table)) ++games.outside;
        for (; removals < world.removed().size(); ++removals) {
            const Removal& gone = world.removed()[removals];
            const auto since = served.find(number(gone.id));
            if (gone.zone >= 0 && since != served.end())
                games.ball_times.push_back(static_cast<double>(gone.tick - since->second) /
                                           world.rate());
            last_drain = gone.tick;
            if (keep_going && !keep_going()) return games;
        }
        const bool is_over = state.phase == PinballState::Phase::over;
        if (is_over && !was_over) games.scores.push_back(state.score);
        was_over = is_over;
        if (static_cast<double>(world.tick() - last_drain) > longest_ball * world.rate()) break;
    }
    games.searches = state.searches;
    games.lost = state.lost;
    games.seconds = world.time();
    return games;
}

std::string demo_games_text(const DemoGames& games) {
    const std::vector<double> scores(games.scores.begin(), games.scores.end());
    const double best = scores.empty() ? 0.0 : *std::ranges::max_element(scores);
    std::string text = fmt::format(
        "balls {}, games {}, {:.1f} hours of play\n"
        "freed by a search {}, lost {}, ticks with a ball outside {}\n"
        "a ball lasts {:.1f} s (median {:.1f}); a game gives {:.0f} points (median {:.0f}, best "
        "{:.0f})\n\n",
        games.ball_times.size(), games.scores.size(), games.seconds / 3600.0, games.searches,
        games.lost, games.outside, mean_of(games.ball_times), median_of(games.ball_times),
        mean_of(scores), median_of(scores), best);
    text += histogram(scores, "   points   games") + "\n";
    text += histogram(games.ball_times, "  seconds   balls");
    return text;
}

}  // namespace carom

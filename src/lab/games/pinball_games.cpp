#include "lab/games/pinball_games.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

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

// The lower pair of flippers, between whose pivots balls drain in the middle.
struct FlipperPair {
    Vec2 left;
    Vec2 right;
};

FlipperPair lower_pair(const World& world) {
    std::vector<Vec2> pivots;
    for (const Flipper& flipper : world.flippers())
        if (const auto capsule = index_of(world, flipper.capsule))
            pivots.push_back(world.capsules().shape[*capsule].start);
    std::ranges::sort(pivots, {}, [](Vec2 at) { return at.y; });
    if (pivots.size() < 2) return {};
    return pivots[0].x < pivots[1].x ? FlipperPair{pivots[0], pivots[1]}
                                     : FlipperPair{pivots[1], pivots[0]};
}

// Remembers on which side of the flippers each ball was when it last came down past their pivots.
class DrainWatch {
  public:
    explicit DrainWatch(const World& world) : pair_(lower_pair(world)) {}

    void note(const World& world) {
        for (std::size_t i = 0; i < world.balls().size(); ++i) {
            const auto ball = static_cast<std::size_t>(number(world.balls().id[i]));
            if (places_.size() <= ball) places_.resize(ball + 1, DrainPlace::middle);
            const Vec2 at = world.balls().position[i];
            if (at.y < std::max(pair_.left.y, pair_.right.y)) continue;
            places_[ball] = at.x < pair_.left.x    ? DrainPlace::left_outlane
                            : at.x > pair_.right.x ? DrainPlace::right_outlane
                                                   : DrainPlace::middle;
        }
    }
    DrainPlace of(BallId ball) const {
        const auto index = static_cast<std::size_t>(number(ball));
        return index < places_.size() ? places_[index] : DrainPlace::middle;
    }

  private:
    FlipperPair pair_;
    std::vector<DrainPlace> places_;  // by the ball's id
};

}  // namespace

PinballGames play_pinball(const Scene& scene, const SolverSettings& settings, std::uint64_t balls,
                          const PinballPlayer& player, const std::function<bool()>& keep_going,
                          double seconds) {
    using Phase = PinballState::Phase;
    PinballGames games;
    World world = scene.world;
    GameState game = begin_game(scene);
    const auto& state = std::get<PinballState>(game);
    Solver solver(settings);
    DrainWatch watch(world);
    const Box table = grow(scene.view, 0.1 * world.balls().radius[0]);
    std::size_t removals = 0;
    std::uint64_t launched = 0;
    std::uint64_t ended = 0;
    bool was_launched = false;
    Phase before = state.phase;
    while (games.ball_times.size() < balls && world.time() < seconds) {
        for (const command::Press& press : player(scene, world, state))
            execute(scene, world, game, press);
        if (!std::exchange(was_launched, state.is_launched) && state.is_launched)
            launched = world.tick();
        watch.note(world);
        solver.tick(world);
        update_game(scene, world, game, solver.contacts());
        if (is_outside(world, table)) ++games.outside;
        for (; removals < world.ledger().removed.size(); ++removals) {
            const Removal& gone = world.ledger().removed[removals];
            if (gone.zone < 0) continue;
            ++games.drains[static_cast<std::size_t>(watch.of(gone.id))];
            if (state.phase == Phase::playing && gone.tick <= state.save_until) ++games.saved;
        }
        const Phase phase = state.phase;
        if (phase != before && before == Phase::playing) {
            games.ball_times.push_back(static_cast<double>(world.tick() - launched) / world.rate());
            ended = world.tick();
        }
        if (phase != before && phase == Phase::over) games.scores.push_back(state.score);
        const bool has_ended = phase != before && before == Phase::playing;
        before = phase;
        if (has_ended && keep_going && !keep_going()) break;
        if (static_cast<double>(world.tick() - ended) > longest_ball * world.rate()) break;
    }
    games.searches = state.searches;
    games.lost = state.lost;
    games.seconds = world.time();
    return games;
}

double mean_ball_time(const PinballGames& games) {
    return mean_of(games.ball_times);
}

double share_under(const PinballGames& games, double seconds) {
    const auto under =
        std::ranges::count_if(games.ball_times, [&](double t) { return t < seconds; });
    return games.ball_times.empty()
               ? 0.0
               : static_cast<double>(under) / static_cast<double>(games.ball_times.size());
}

double outlane_share(const PinballGames& games) {
    const auto [left, middle, right] = games.drains;
    const std::uint64_t all = left + middle + right;
    return all == 0 ? 0.0 : static_cast<double>(left + right) / static_cast<double>(all);
}

std::string pinball_games_text(const PinballGames& games) {
    const std::vector<double> scores(games.scores.begin(), games.scores.end());
    const double best = scores.empty() ? 0.0 : *std::ranges::max_element(scores);
    const auto [left, middle, right] = games.drains;
    std::string text = fmt::format(
        "balls {}, games {}, {:.1f} hours of play\n"
        "freed by a search {}, lost {}, ticks with a ball outside {}\n"
        "a ball lasts {:.1f} s (median {:.1f}); {:.1f} % last less than 8 s\n"
        "drains: left outlane {}, middle {}, right outlane {} (outlanes {:.0f} %); saved {}\n"
        "a game gives {:.0f} points (median {:.0f}, best {:.0f})\n\n",
        games.ball_times.size(), games.scores.size(), games.seconds / 3600.0, games.searches,
        games.lost, games.outside, mean_ball_time(games), median_of(games.ball_times),
        100.0 * share_under(games, 8.0), left, middle, right, 100.0 * outlane_share(games),
        games.saved, mean_of(scores), median_of(scores), best);
    if (games.shots_tried > 0)
        text += fmt::format(
            "shots from a cradle {}, made {} ({:.0f} %)\n\n", games.shots_tried, games.shots_made,
            100.0 * static_cast<double>(games.shots_made) / static_cast<double>(games.shots_tried));
    text += histogram(scores, "   points   games") + "\n";
    text += histogram(games.ball_times, "  seconds   balls");
    return text;
}

}  // namespace carom
